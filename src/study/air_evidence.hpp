#pragma once

#include <vector>

#include "study/recorded_trial.hpp"

namespace fingerpad {

/// Samples [from, to) of a trial in which the force is low and as still as its noise: without contact, or
/// pressed lightly and evenly.
struct StillRun {
  Eigen::Index from, to;
  double normal_n;  ///< mean normal force, as sensed
};

/// Runs that are not known to be pressed, in order.
struct AirRuns {
  std::vector<StillRun> surely;   ///< told by height
  std::vector<StillRun> perhaps;  ///< nothing tells
  bool presses_on = false;        ///< others are pressed
  /// Of these, one is where the force has fallen, or rises, within one sample: of a finger that was lifted so
  /// fast and then keeps its height, what its height tells looks alike.
  bool falls_at_once = false;
};

/// Tells a finger that rests or rubs on the plate from one that is off it, over all of the moment in which
/// the normal force stays low:
/// - by its height: one that leaves the plate rises while its force stays as it is; one that presses on keeps
///   its height, but for what the pad yields by so little;
/// - by its friction: the force along the plate changes while the normal force does not; and in all runs
///   together, of which there must be four, what is left of the force along the plate opposes the motion in
///   some one way and in others the other way. (Of runs that all go one way an offset of the sensor looks
///   alike.)
/// @param noise_n  standard deviation of the normal force's noise
/// @param press_n  how hard the plate is pressed in the trial
AirRuns runs_in_the_air(const RecordedTrial& trial, const std::vector<StillRun>& runs, double noise_n,
                        double press_n);

}  // namespace fingerpad
