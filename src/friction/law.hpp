#pragma once

#include "base/types.hpp"
#include "fingerpad/phase.hpp"

namespace fingerpad {

/// What a law is told about one tick of contact. All 2-vectors are in frame C (Cx, Cy), which is transported
/// along the surface, so a component means the same from tick to tick.
struct TangentialMotion {
  double dt_s = 1e-3;
  double normal_force_n = 0;    ///< >= 0
  double mu_static = 0.3;       ///< >= mu_dynamic
  double mu_dynamic = 0.2;      ///< >= 0
  Vec2 velocity_m_per_s{0, 0};  ///< of the device relative to the part, tangential part
  Vec2 step_m{0, 0};            ///< motion of the contact point S since the last tick; zero at first touch
  Vec2 from_centre_m{0, 0};  ///< displacement of S from the stick centre that the law last set; zero if none
  double inclination_rad = 0;  ///< finger against the tangent plane, 0 .. pi/2
  Vec2 longitudinal{0, 1};     ///< unit: the finger's direction projected into the tangent plane
  Vec2 applied_force_n{0, 0};  ///< what pushes the finger along the surface, where a hand is simulated
  double surface_stiffness_n_per_m = 1000;  ///< normal force per depth; for laws that work with the depth
};

/// A law's memory of one contact. Value-initialised: no contact yet.
struct FrictionState {
  Phase phase = Phase::free;      ///< of the last tick
  Vec2 slip_direction{0, 0};      ///< unit, of the last slip tick; for laws that restick
  Vec2 deflection_m{0, 0};        ///< for laws with a bristle of their own, in frame C
  double last_speed_m_per_s = 0;  ///< for laws that tell a fall through v_min
  double slip_force_scale = 1;    ///< what the caller multiplied the last slip tick's force by before writing
                                ///< it (slip vibration): a stick that follows starts at the force as written
};

/// A law's answer to one tick.
struct Friction {
  Vec2 force_n{0, 0};         ///< on the finger
  Phase phase = Phase::slip;  ///< stick or slip
  Vec2 from_centre_m{0, 0};   ///< in stick: displacement of S from the stick centre
  bool centre_moved = false;  ///< the law has set a new stick centre, from_centre_m behind S
  bool remedied = false;      ///< a StickRemedy has changed the force
};

/// A friction law: one tick of tangential contact to a force. Immutable, shared by all contacts of a scene.
class FrictionLaw {
 public:
  virtual ~FrictionLaw() = default;
  /// @pre inputs finite. Result finite, for any state and input. noexcept, O(1), allocates nothing.
  virtual Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept = 0;
  /// Whether the law reads TangentialMotion::step_m; a caller need not work out what nothing reads.
  virtual bool reads_step() const noexcept { return true; }
};

}  // namespace fingerpad
