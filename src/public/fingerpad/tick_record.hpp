#pragma once

#include <limits>

#include "fingerpad/phase.hpp"
#include "fingerpad/types.hpp"

namespace fingerpad {

/// What happened in one tick: a row of a trace. Positions and forces in W; forces act on the finger.
struct TickRecord {
  /// A quaternion's numbers, w first.
  using Wxyz = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();  ///< where there is no number

  double t_s = 0;                             ///< time [s]
  Vec3 p_WQ = Vec3::Zero();                   ///< finger [m]
  Phase phase = Phase::free;                  ///< free, stick or slip
  double depth_m = 0;                         ///< radius less signed distance, where positive [m]
  Vec3 contact_W = Vec3::Constant(nan);       ///< S [m]; nan while free
  Vec3 normal_W = Vec3::Constant(nan);        ///< nan while free
  double normal_force_n = 0;                  ///< the sum of the walls' [N]; several do not push one way
  Vec3 force_W_n = Vec3::Zero();              ///< whole force on the finger [N]
  Vec3 friction_W_n = Vec3::Zero();           ///< its friction part [N]
  Vec3 torque_W_n_m = Vec3::Zero();           ///< of friction about the finger's centre; not in traces
  double mu = 0;                              ///< |friction| / normal force, 0 while free; see walls
  Vec3 stick_centre_W = Vec3::Constant(nan);  ///< nan unless sticking
  double inclination_rad = nan;               ///< asin |direction . n|; nan while free
  int walls = 0;                              ///< how many hold the finger; 0 while free
  int ruptures = 0;                           ///< how often stick gave way in this tick
  int surface = -1;                           ///< parts, then planes, from 0; -1 while free
  int triangle = -1;                          ///< number in the file; -1 on a plane and while free
  /// What the tick was told beyond the finger's place, for whoever repeats it; nan where it was told no more.
  Vec3 encoded_W = Vec3::Constant(nan);     ///< where the device's encoders put a hand's finger [m]
  Vec3 push_W_n = Vec3::Constant(nan);      ///< what a hand pushed with [N]
  Vec3 velocity_W = Vec3::Constant(nan);    ///< of the finger, as friction was told it [m/s]
  Vec3 direction_W = Vec3::Constant(nan);   ///< of a finger that turns
  Wxyz attitude = Wxyz::Constant(nan);      ///< of a finger whose attitude is known: a unit quaternion
  Vec3 sent_W_n = Vec3::Constant(nan);      ///< what a device with motors was sent, within its limits [N]
  Vec3 residual_W_n = Vec3::Constant(nan);  ///< force_W_n less the force that was measured there [N]
  Vec3 turn_W = Vec3::Zero();               ///< the finger's since the last tick [rad]; not in traces
  bool remedied = false;  ///< a remedy for a stick spring too stiff for the loop has acted; not in traces
  bool started_inside = false;  ///< the finger began inside of a part, or a proxy found no place where it
                                ///< fits; not in traces
  bool unsettled = false;  ///< the proxy stopped before it was at rest, so that the tick's work has a bound,
                           ///< and goes on in the next; not in traces
};

}  // namespace fingerpad
