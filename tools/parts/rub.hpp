#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "rolling_sphere.hpp"

namespace fingerpad::parts {

/// One stretch of a rub: where the finger goes meanwhile, and what it has come to at the end. Lengths in mm.
struct Stroke {
  enum class Kind { straight, around };
  Kind kind = Kind::straight;
  double seconds = 0;
  Eigen::Vector2d point;        ///< straight: the end, seen from above; around: the centre
  double turns = 0;             ///< around: counterclockwise, in full turns
  double depth_mm = 0;          ///< at the end: how deep the pad is pressed; negative: lifted off
  double inclination_deg = 45;  ///< at the end: of the finger to the horizontal
  double heading_deg = 0;       ///< at the end: of the finger from +y towards +x
};

/// A rub over a part, written down as a hand would be told to do it.
struct Recipe {
  std::string name;
  std::string mesh;  ///< file name of the mesh whose surface the finger follows
  Stroke start;      ///< only its point, depth and angles count
  std::vector<Stroke> strokes;
};

struct RubSample {
  double t_s;
  Eigen::Vector3d centre_mm;  ///< of the round fingertip
  Eigen::Vector3d direction;  ///< unit, towards the tip
};

/// Every recipe of scenes/motions.
std::vector<Recipe> rub_recipes();

/// Carries out a recipe: strokes start and end at rest (minimum jerk), the pad follows the surface at the
/// told depth as far as a hand can (it does not dive steeper than 2:1 and evens out what is shorter than some
/// 10 ms), the pressing hand wavers slowly and the finger trembles at some 9 Hz by a few hundredths of a mm.
std::vector<RubSample> rub(const Recipe& recipe, const RollingSphere& surface, double rate_hz);

}  // namespace fingerpad::parts
