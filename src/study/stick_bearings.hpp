#pragma once

#include <string>
#include <vector>

#include "study/stick_paths.hpp"

namespace fingerpad {

/// How far from its centre stick reaches at each of 24 bearings at which it was pushed: the mean of the
/// farthest tenth there.
std::vector<Vec2> farthest_by_bearing_m(const std::vector<const StickPath*>& paths);

/// Along which lines through its centre stick was pushed.
struct PushedLines {
  /// By bearing, in [0, 180): 0 across the finger, 90 along it (without a direction: tangent axes 1 and 2).
  /// Of those within the same 15 degrees the mean.
  std::vector<double> bearing_deg;

  /// Whether points along them tell both axes of an ellipse about the finger: one line does not, nor do two
  /// that lie alike to either side of an axis.
  bool tell_ellipse() const;
  /// "at 45 deg", "at 0, 45 and 90 deg", "all ways round".
  std::string words() const;
};
PushedLines pushed_lines(const std::vector<const StickPath*>& paths);

}  // namespace fingerpad
