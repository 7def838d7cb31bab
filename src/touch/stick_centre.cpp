#include "touch/stick_centre.hpp"

#include "base/tangent_frame.hpp"

namespace fingerpad {
namespace {

/// What the centre may miss of the way asked for: it is carried on as a remainder, so that nothing is lost
/// but the centre's own place.
constexpr double near_enough = 1e-3;

Vec2 tangential(const Mat3& frame_WC, const Vec3& vector_W) noexcept {
  return {frame_WC.col(0).dot(vector_W), frame_WC.col(1).dot(vector_W)};
}

}  // namespace

Vec2 StickCentre::displacement(const Vec3& contact_W, const Mat3& frame_WC) const noexcept {
  if (!is_set_) return Vec2::Zero();
  const Vec3 along = surface_displacement(point_W_, normal_W_, contact_W, frame_WC.col(2));
  return tangential(frame_WC, along) + remainder_m_;
}

void StickCentre::place(const PlacedSurface& surface, const Vec3& contact_W, const Mat3& frame_WC,
                        const Vec2& from_centre_m, Normals normals, bool on_surface,
                        int contact_triangle) noexcept {
  is_set_ = true;
  normal_W_ = frame_WC.col(2);
  remainder_m_ = Vec2::Zero();
  point_W_ = contact_W - frame_WC.leftCols<2>() * from_centre_m;
  const double distance = from_centre_m.norm();
  if (!on_surface || surface.is_plane() || distance == 0) return;

  // Seek the point of the surface that lies `from_centre_m` behind S: step, look where the surface is,
  // correct by what is missing. On a surface of radius R the error falls by about (distance/R)^2 a round.
  Vec2 guess = from_centre_m;
  double best_miss = 0.1 * distance;  // worse than this, the tangent plane's point is the better centre
  for (int round = 0; round < 5; ++round) {
    const Vec3 target = contact_W - frame_WC.leftCols<2>() * guess;
    // Mostly the centre comes to lie on the facet that S is on: then nothing need be searched.
    WorldPoint near = nearest_on_facet(surface, contact_triangle, target, normals);
    if (!near.found) near = nearest_point(surface, target, normals, contact_triangle, 2 * distance);
    if (!near.found) return;
    const Vec3 along = surface_displacement(near.point_W, near.normal_W, contact_W, frame_WC.col(2));
    const Vec2 missing = from_centre_m - tangential(frame_WC, along);
    const double miss = missing.norm();
    if (miss < best_miss) {
      best_miss = miss;
      point_W_ = near.point_W;
      normal_W_ = near.normal_W;
      remainder_m_ = missing;
    }
    if (miss < near_enough * distance || miss > distance) return;
    guess += missing;
  }
}

}  // namespace fingerpad
