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
  Vec2 velocity_m_per_s{0, 0};  ///< of the finger's skin over the part
  Vec2 step_m{0, 0};            ///< how far the skin has moved over the part since the last tick; zero at
                                ///< first touch
  double inclination_rad = 0;   ///< finger against the tangent plane, 0 .. pi/2
  Vec2 longitudinal{0, 1};      ///< unit: the finger's direction projected into the tangent plane
  Vec2 applied_force_n{0, 0};   ///< what pushes the finger along the surface, where a hand is simulated
  double surface_stiffness_n_per_m = 1000;  ///< normal force per depth; for laws that work with the depth
};

/// A law's memory of one contact. Value-initialised: no contact yet.
struct FrictionState {
  Phase phase = Phase::free;         ///< of the last tick
  Vec2 stretch_m{0, 0};              ///< z: of the law's spring or bristle, in frame C
  Vec2 slip_direction{0, 0};         ///< unit, of the last slip tick; for laws that restick
  Vec2 last_step_m{0, 0};            ///< the last tick's step
  Vec2 last_velocity_m_per_s{0, 0};  ///< the last tick's, for laws that tell a fall through v_min
  double event_share = 0;       ///< of the last tick: when its last rupture or restick was; 0: it had none
  double softening = 1;         ///< what a remedy has softened the spring to
  double slip_force_scale = 1;  ///< what the caller multiplied the last slip tick's force by before writing
                                ///< it (slip vibration): a stick that follows starts at the force as written
};

/// A law's answer to one tick.
struct Friction {
  Vec2 force_n{0, 0};         ///< on the finger
  Phase phase = Phase::slip;  ///< stick or slip, at the end of the tick
  Vec2 stretch_m{0, 0};       ///< in stick: z, from the stick centre to where the skin is now
  int ruptures = 0;           ///< of this tick: where stick gave way
  bool centre_moved = false;  ///< stick has begun anew in this tick, or its centre was dragged along
  bool remedied = false;      ///< a StickRemedy has changed the force
};

/// A friction law: one tick of tangential contact to a force. Immutable, shared by all contacts of a scene.
class FrictionLaw {
 public:
  virtual ~FrictionLaw() = default;
  /// @pre inputs finite. Result finite, for any state and input. noexcept, O(1), allocates nothing.
  virtual Friction tick(const TangentialMotion& motion, FrictionState& state) const noexcept = 0;
};

}  // namespace fingerpad
