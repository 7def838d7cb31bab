#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "friction/law_table.hpp"

namespace fingerpad::test {

/// Plays the part of touch/ on a flat plane under a given load: hands a law its motion, and knows where the
/// stick centre is.
struct PlaneContact {
  const FrictionLaw& law;
  TangentialMotion motion{};  ///< load, coefficients, tick and finger pose; set freely between ticks
  FrictionState state{};
  Vec2 centre_m{0, 0};  ///< where the state is stick
  Vec2 at_m{0, 0};
  bool touched = false;

  /// The next tick with the finger at `p_m`. Velocity is the step over the tick, zero on the first one.
  Friction move_to(const Vec2& p_m) {
    return move_to(p_m, touched ? Vec2((p_m - at_m) / motion.dt_s) : Vec2(Vec2::Zero()));
  }

  /// The next tick with the velocity given, as a device reports it.
  Friction move_to(const Vec2& p_m, const Vec2& velocity_m_per_s) {
    motion.velocity_m_per_s = velocity_m_per_s;
    motion.step_m = touched ? Vec2(p_m - at_m) : Vec2(Vec2::Zero());
    Friction answer = law.tick(motion, state);
    if (answer.centre_moved) centre_m = p_m - answer.stretch_m;
    at_m = p_m;
    touched = true;
    return answer;
  }

  /// Comes sliding from far away, faster than v_min, and is at `p_m` now.
  Friction slide_to(const Vec2& p_m, const Vec2& velocity_m_per_s) {
    constexpr int ticks_to_rupture = 40;
    touched = false;
    state = {};
    Friction answer;
    for (int k = ticks_to_rupture; k >= 0; --k)
      answer = move_to(p_m - k * motion.dt_s * velocity_m_per_s, velocity_m_per_s);
    return answer;
  }
};

/// A tick's input under a load, at rest, at a rate; coefficients 0.3 and 0.2.
inline TangentialMotion pressed(double normal_force_n, double rate_hz) {
  TangentialMotion motion;
  motion.normal_force_n = normal_force_n;
  motion.dt_s = 1 / rate_hz;
  return motion;
}

inline LawSettings settings_of(std::map<std::string, double, std::less<>> numbers) {
  LawSettings settings;
  settings.numbers = std::move(numbers);
  return settings;
}

/// Settings by which rupture and restick are looked for at ticks only.
inline LawSettings at_ticks(std::map<std::string, double, std::less<>> numbers = {}) {
  LawSettings settings = settings_of(std::move(numbers));
  settings.events = Events::tick;
  return settings;
}

/// A law by name; the name must be known.
inline std::unique_ptr<FrictionLaw> make_law(std::string_view name, const LawSettings& settings = {}) {
  return find_law(name)->make(settings);
}

inline Vec2 unit_at(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

}  // namespace fingerpad::test
