#include "fingerpad/touch_world.hpp"

#include <fmt/format.h>

#include <Eigen/LU>

#include "base/error.hpp"
#include "public/finger_scene.hpp"
#include "public/part_surface_impl.hpp"
#include "public/touch_world_impl.hpp"

namespace fingerpad {
namespace {

/// As the scene's own limit of places: farther off, a step of a finger is lost in rounding.
constexpr double farthest_m = 1e9;

void refuse_far(const std::string& where, const Vec3& p_m) {
  if (!(p_m.cwiseAbs().maxCoeff() <= farthest_m && p_m.allFinite()))
    throw refused(where, fmt::format("({}, {}, {}) m is no place; each must be within {} m", p_m.x(), p_m.y(),
                                     p_m.z(), farthest_m));
}

void refuse_bent(const Mat3& rotation) {
  constexpr double rounding = 1e-9;
  const Mat3 left = rotation * rotation.transpose() - Mat3::Identity();
  if (!(left.allFinite() && left.cwiseAbs().maxCoeff() <= rounding && rotation.determinant() > 0))
    throw refused("Pose",
                  "its matrix is no rotation: the rows must be of length 1, at right angles, and "
                  "right-handed");
}

}  // namespace

TouchWorld::TouchWorld() : impl_(std::make_shared<Impl>()) {}

void TouchWorld::add(const PartSurface& part, const SurfaceProperties& properties, const Pose& pose) {
  refuse_impossible(properties);
  refuse_far("Pose", pose.position_m);
  refuse_bent(pose.rotation);
  auto changed = std::make_shared<Impl>(*impl_);  // others keep the world as it was
  Surface surface;
  surface.part = part.impl_->part;
  surface.tree = part.impl_->tree;
  surface.p_WP = pose.position_m;
  surface.R_WP = pose.rotation;
  surface.properties = properties;
  surface.mesh = part.impl_->verdict.file;
  if (surface.mesh.empty()) surface.mesh = fmt::format("part {}", changed->parts.size());
  surface.mesh_hash = part.impl_->hash;
  changed->parts.push_back({part.impl_, std::move(surface)});
  impl_ = std::move(changed);
}

void TouchWorld::add_plane(const Vec3& point_m, const Vec3& normal, const SurfaceProperties& properties) {
  refuse_impossible(properties);
  refuse_far("plane", point_m);
  const double length = normal.stableNorm();
  if (!(length > 0 && normal.allFinite())) throw refused("plane", "its normal has no direction");
  auto changed = std::make_shared<Impl>(*impl_);
  Surface surface;
  surface.plane_point_W = point_m;
  surface.plane_normal_W = normal.stableNormalized();
  surface.properties = properties;
  changed->planes.push_back(std::move(surface));
  impl_ = std::move(changed);
}

}  // namespace fingerpad
