#pragma once

#include <algorithm>
#include <array>

#include "contact/contact_method.hpp"
#include "fingerpad/surface_properties.hpp"

namespace fingerpad {

/// What holds the finger in one direction: the holds of a contact that lie on one smooth surface, taken
/// together, so that friction does not feel where one facet ends and the next begins.
struct Wall {
  int surface = -1;               ///< index into the world's surfaces
  int triangle = -1;              ///< of its greatest hold; -1: a plane
  Vec3 point_W = Vec3::Zero();    ///< S: of its greatest hold [m]
  Vec3 normal_W = Vec3::UnitZ();  ///< as felt: outward, unit
  double share_m = 0;             ///< its part of the depth: the sum of its holds'
  Vec3 push_m = Vec3::Zero();     ///< the same as a vector, each hold's along its own normal as felt
  double normal_force_n = 0;      ///< of its own spring and damper, once Touch has worked it out
};

struct Walls {
  int count = 0;
  std::array<Wall, 3> walls;  ///< greatest share first

  const Wall& operator[](int i) const noexcept { return walls[static_cast<std::size_t>(i)]; }
  Wall* begin() noexcept { return walls.data(); }
  Wall* end() noexcept { return walls.data() + count; }
};

/// The force of a wall's own spring and damper, which acts along the wall's own normal: then no motion takes
/// energy out of a corner. A wall of a smaller share than the greatest is damped by less, so that one which
/// comes or goes makes no jump. A damper may soften a wall's push, never pull the finger in.
/// @param surface     the wall's
/// @param velocity_W  of the finger
inline double spring_force_n(const Wall& wall, const Wall& greatest, const SurfaceProperties& surface,
                             const Vec3& velocity_W) noexcept {
  const double leaving_m_per_s = wall.normal_W.dot(velocity_W) * (wall.share_m / greatest.share_m);
  return std::max(0.0,
                  surface.stiffness_n_per_m * wall.share_m - surface.damping_n_s_per_m * leaving_m_per_s);
}

/// The walls of a contact. Holds of one surface whose normals are within 30 degrees are one wall. Where the
/// contact's normal is shaded, the holds' normals turn with it, so that their pushes sum up to its depth
/// along its normal. Of walls that all but face each other none pushes by more than four times its share,
/// and all together by no more than some ten times the contact's depth.
/// @param walls  written up to its count; the caller keeps it from tick to tick, as making three anew costs
/// time
/// @pre contact.hold_count > 0. noexcept, allocates nothing.
void find_walls(const Contact& contact, Walls& walls) noexcept;

}  // namespace fingerpad
