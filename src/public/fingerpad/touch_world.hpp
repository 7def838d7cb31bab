#pragma once

#include <memory>

#include "fingerpad/part_surface.hpp"
#include "fingerpad/surface_properties.hpp"

namespace fingerpad {

/// Where a part stands in the world: p_W = rotation * p_P + position_m.
struct Pose {
  Vec3 position_m = Vec3::Zero();    ///< of the part's origin [m]
  Mat3 rotation = Mat3::Identity();  ///< from the part's frame to the world's
};

/// What can be touched: parts and planes. TickRecord::surface numbers the parts in the order in which they
/// were added, from 0, and the planes after them.
///
/// A copy may be changed by itself; fingers keep the world as it was when they were made.
class TouchWorld {
 public:
  /// An empty world.
  TouchWorld();

  /// Adds a part. Throws Error (refused) for properties or a pose that cannot be.
  void add(const PartSurface& part, const SurfaceProperties& properties = {}, const Pose& pose = {});

  /// Adds a plane; the half space behind it is solid. Throws Error (refused) as `add` does.
  /// @param point_m  any point of it [m]
  /// @param normal   outward; of any length
  /// @param properties  how it answers touch
  void add_plane(const Vec3& point_m, const Vec3& normal, const SurfaceProperties& properties = {});

 private:
  friend class Finger;
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace fingerpad
