#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "motion/finger_path.hpp"
#include "scene/scene.hpp"
#include "study/contact_surfaces.hpp"
#include "study/studies.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// A finger that goes over a world for which `auto` chooses, without friction.
struct JudgedCase {
  std::string name;
  Scene scene;                         ///< leaves method and normals open
  std::shared_ptr<const World> world;  ///< with its choice
  std::vector<FingerPath> ways = {};   ///< each begins anew, away from where the last ended
  /// The force on the finger where the surface is known exactly [N]; else empty.
  std::function<Vec3(const Vec3& p_WQ)> exact_force_n = {};
  bool is_exact_all_over = false;   ///< that force is known wherever a finger may touch the part
  int trial_strokes = 24;           ///< with each press in each region in which the promise is tried
                                    ///< (promise_trial.hpp)
  bool judges_all_variants = true;  ///< else the chosen one and the most complete: what the word asks for
};

/// Takes one case after the other, as soon as it is made.
using TakeCase = std::function<void(const JudgedCase&)>;

/// Tessellations of the surfaces that are known exactly, each under a point and a ball, pressed lightly and
/// hard.
/// @param surface  the name of one of them; none: all
void take_exact_cases(const TakeCase& take, const std::string& surface = "", int most_levels = all_levels);

/// Scene files of a folder and of its gallery, each part and motion once, with method and normals left open.
/// Scenes that are refused or have no mesh are passed over; a [hand] does not act.
void take_scene_cases(const std::string& folder, const TakeCase& take);

/// A mesh, its unit a millimetre, under a point and a ball that make so many short strokes all over it; none
/// of a file that cannot be touched. A part less than 20 mm wide is touched to its scale: by a smaller ball,
/// more slowly, and it is as much stiffer.
void take_part_cases(const std::string& file, int strokes, const TakeCase& take);

/// How much smaller than usual a finger and its motion are on a part less than 20 mm wide; 1 on others.
double touch_scale(const Part& part) noexcept;

/// Those files of a folder whose ending `is_one` takes, by name.
std::vector<std::string> files_of(const std::string& folder, bool (*is_one)(const std::string& ending));

/// How hard strokes are pressed.
enum class StrokePress {
  mixed,     ///< every other with a tenth of the greatest force, the lightest touch that must be true, where
             ///< facets that cut in count the most; the others with that to the greatest
  lightest,  ///< with a tenth
  hard,      ///< with a third of the greatest to the greatest
  greatest,  ///< with that
};

/// Which strokes, and how many.
struct StrokePlan {
  int count = 0;
  double scale = 1;            ///< of their length and speeds, 1 at the most
  unsigned seed = 11;          ///< of the places
  int region = -1;             ///< in which they begin (region_of); -1: anywhere
  double longest_m = 1;        ///< along the surface, a leg
  int legs = 1;                ///< along the surface, one after the other, each its own way
  double down_m_per_s = 0.05;  ///< and up
  bool starts_low = false;     ///< just over the surface, as hollows ask for; else by its own width higher
  StrokePress press = StrokePress::mixed;
};

/// Strokes over a part: straight down onto places all over its outside, along for a while and up again. The
/// same at every run. Fewer where too few places are free.
/// @param surface  a part in its place
std::vector<FingerPath> strokes_over(const Surface& surface, const Scene& scene, const StrokePlan& plan);

/// A way through these places, one a tick.
FingerPath way_through(const std::vector<Vec3>& places_W, const Scene& scene);

}  // namespace fingerpad
