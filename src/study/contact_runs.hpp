#pragma once

#include <memory>
#include <string>
#include <vector>

#include "study/contact_surfaces.hpp"
#include "study/report.hpp"
#include "touch/touch.hpp"

namespace fingerpad {

/// One way to make contact: how the surface holds the finger, and whose normal is felt.
struct ContactVariant {
  Normals normals;
  std::string method_name, normals_name;
  CurveStyle style;
  std::string name() const { return method_name + ", " + normals_name; }
};

/// Every row of the table of methods with every row of that of normals; a style each, the same on every
/// chart.
const std::vector<ContactVariant>& contact_variants();

/// One part at the origin of 1000 N/m, with creases at 30 degrees.
/// @param name  in what is said of it
std::shared_ptr<const World> world_of_mesh(const TriangleSoup& soup, const std::string& name);
/// The same of a part that is made already.
std::shared_ptr<const World> world_of_part(std::shared_ptr<const Part> part, const std::string& name);

/// A scene that touches it in this way, with a point finger, a tick of 1 ms and this friction law.
Scene scene_of_variant(const ContactVariant& variant, const std::string& law);

/// What `auto` chooses for this world and finger, method and normals both, where a press of at most this
/// force is expected, and why.
struct AutomaticChoice {
  const ContactVariant* variant = nullptr;
  std::string reason;
};
AutomaticChoice automatic_choice(const World& world, double finger_radius_m, double greatest_force_n);

/// Of the rubs of every study of contact: how deep a point goes, and the finger that stays on the surface.
constexpr double rub_depth_m = 1e-3, rub_radius_m = 1e-3;
/// What `auto` is told of there: its default.
constexpr double rub_force_n = 10;

/// Positions of the finger, one a tick: its centre along a surface's way at `under_m` under it, after it has
/// come down to its start from outside over `approach_ticks`.
struct Rub {
  std::vector<Vec3> positions;
  std::vector<ExactFoot> exact;  ///< where each position stands against the exact surface
  std::size_t approach_ticks = 0;
  double radius_m = 0;  ///< of the finger
};
Rub rub_under(const ExactSurface& surface, double under_m, double radius_m);

/// How far the answers over a rub are off the exact surface's: root mean square, and the worst. Ticks on
/// which contact was lost count as errors of the whole force.
struct RubError {
  double position_rms_m = 0, position_worst_m = 0;    ///< the surface point off the exact surface
  double normal_rms_rad = 0, normal_worst_rad = 0;    ///< between the contact's normal and the exact one
  double force_rms_share = 0, force_worst_share = 0;  ///< of the exact force
  double step_share = 0;        ///< largest change of force from tick to tick, of the exact force
  double exact_step_share = 0;  ///< that of the exact surface over the same rub
  long lost_ticks = 0;
};
RubError rub_error(const std::shared_ptr<const World>& world, const ExactSurface& surface,
                   const ContactVariant& variant, const Rub& rub);
/// The same where the exact surface is known at the rub's positions alone: there `position` is how far the
/// depth is off the exact one, which is how far the tessellation lies off the surface under the finger.
RubError rub_error(const std::shared_ptr<const World>& world, const ContactVariant& variant, const Rub& rub);

/// Mean time of a whole tick over a rub with this friction law [ns]: of each piece of the rub the best of
/// several runs, so that what else the machine does counts little.
double rub_tick_ns(const std::shared_ptr<const World>& world, const ContactVariant& variant, const Rub& rub,
                   const std::string& law);

/// The slowest tick of the same rub [ns], where each tick counts as the best of several runs: what takes so
/// long is the tick's own work.
double rub_slowest_tick_ns(const std::shared_ptr<const World>& world, const ContactVariant& variant,
                           const Rub& rub, const std::string& law);

/// A point presses 3 mm into a block and slides off over its right-angled edge at this speed: the largest
/// change of force from tick to tick, as a share of the 3 N.
double edge_step_share(const std::shared_ptr<const World>& block, const ContactVariant& variant,
                       double speed_m_per_s);

/// A strike: from `from_m` above down along -z at a constant speed, until a finger of this radius is
/// `depth_m` deep under z = 0, then held there for 20 ticks of 1 ms.
struct Strike {
  double speed_m_per_s = 1;
  double radius_m = 0;
  Vec2 at_m = Vec2::Zero();
  double phase = 0;  ///< of the ticks, 0 .. 1
  double from_m = 0.01, depth_m = 5.5e-3;
};
/// Whether the finger is not pushed back up at its end with half of the force that its depth explains.
bool pops_through(const std::shared_ptr<const World>& world, const ContactVariant& variant,
                  const Strike& strike);
/// The same along -normal (unit) at a point of a surface, instead of under strike.at_m.
bool pops_through(const std::shared_ptr<const World>& world, const ContactVariant& variant,
                  const Strike& strike, const Vec3& surface_m, const Vec3& normal);

}  // namespace fingerpad
