#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fingerpad/finger_sample.hpp"
#include "fingerpad/tick_record.hpp"
#include "fingerpad/touch_world.hpp"

namespace fingerpad {

/// A friction law by its name, with what is to differ from its defaults.
struct FrictionChoice {
  std::string law = "finger-pad";  ///< one of friction_laws()
  /// The law's own keys, as a scene's [friction] has them: {{"v_min_m_per_s", 0.05}}.
  std::map<std::string, double, std::less<>> parameters = {};
};

/// A finger, and how its touch is worked out. What is not here (a pad's profile, vibration, remedies), a
/// scene file can say: Finger::of_scene.
struct FingerOptions {
  double radius_m = 0;                  ///< of the fingertip; 0: a point [m]
  double rate_hz = 1000;                ///< ticks a second
  std::string contact_method = "auto";  ///< "closest-point", "proxy", or "auto": the cheapest that will do
  std::string normals = "smooth";       ///< "facet", "smooth", "curved" or "auto"
  FrictionChoice friction = {};         ///< the law
};

/// A number that a friction law reads.
struct FrictionParameter {
  std::string key;           ///< with its unit in the name
  double default_value = 0;  ///< in SI
  std::string meaning;       ///< in a line
};

/// A friction law that can be chosen.
struct FrictionLawInfo {
  std::string name;                           ///< for FrictionChoice
  std::string summary;                        ///< who, year, in a line
  std::vector<FrictionParameter> parameters;  ///< its own
};

/// All friction laws.
std::vector<FrictionLawInfo> friction_laws();

/// One finger that touches one world. Each tick takes where the finger is and gives the force on it.
class Finger {
 public:
  /// Throws Error (refused) for an option that cannot be, with those that can.
  explicit Finger(const TouchWorld& world, const FingerOptions& options = {});
  /// The finger and the world of a scene file. Its motion and its simulated hand are left out: the caller
  /// moves the finger. Throws Error (refused) at the line and column of what is wrong.
  static Finger of_scene(const std::string& scene_path);
  /// Lets go.
  ~Finger();
  /// Takes another's place; that one may only be destroyed or assigned to.
  Finger(Finger&&) noexcept;
  /// Takes another's place; that one may only be destroyed or assigned to.
  Finger& operator=(Finger&&) noexcept;

  /// One tick, 1/rate_hz after the last. noexcept, allocates nothing, so it may stand in a servo loop; no
  /// force is ever non-finite, whatever the sample.
  TickRecord tick(const FingerSample& sample) noexcept;
  /// Forgets the contact and the last position, as before the first tick.
  void reset() noexcept;

  /// Ticks a second.
  double rate_hz() const noexcept;
  /// The contact method that serves, where "auto" was asked for too.
  std::string contact_method() const;
  /// Why, where "auto" was asked for: a line a part.
  const std::vector<std::string>& reasons() const noexcept;

 private:
  friend class TraceRecorder;
  struct Impl;
  explicit Finger(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fingerpad
