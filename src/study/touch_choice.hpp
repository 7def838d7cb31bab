#pragma once

#include <string>
#include <vector>

#include "contact/normals.hpp"
#include "friction/law_settings.hpp"

namespace fingerpad {

struct Scene;
struct World;

/// One way to touch a scene: everything that trades speed for accuracy.
struct TouchChoice {
  std::string method;  ///< a row of contact_method_table()
  Normals normals = Normals::smooth;
  double rate_hz = 1000;
  Events events = Events::exact;

  /// "proxy, curved, 1000 Hz, events exact"
  std::string name() const;
  bool operator==(const TouchChoice&) const = default;
};

/// As scenes write it.
std::string_view events_word(Events events) noexcept;

/// The rates at which choices are compared, and the model's, a whole multiple of each [Hz].
inline constexpr double choice_rates_hz[] = {250, 500, 1000, 2000, 4000, 10000, 20000};
inline constexpr double model_rate_hz = 40000;

/// All choices that a scene has: every method with every kind of normals, every rate, and both readings of
/// `events` where the law has them. A world of planes alone searches for nothing: there the first method and
/// the first normals stand for all.
std::vector<TouchChoice> touch_choices(const Scene& scene, const World& world);

/// The most complete model there is: the last rows of both tables, events between ticks, 40 kHz.
TouchChoice model_choice();

/// The scene touched in this way, without slip vibration: noise of two runs cannot be compared tick by tick.
Scene touched_by(Scene scene, const TouchChoice& choice);

/// Makes ready what any kind of normals needs, so that no tick has to.
void prepare_normals(const World& world);

}  // namespace fingerpad
