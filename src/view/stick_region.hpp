#pragma once

#include <optional>
#include <vector>

#include "friction/law_table.hpp"
#include "scene/scene.hpp"
#include "touch/tick_record.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// The stick region of a scene's law on a surface, at a finger's inclination [rad]: LawEntry::stick_axes.
/// Nothing for laws that have no region of this kind.
std::optional<StickAxes> stick_axes(const FrictionSettings& friction, const SurfaceProperties& surface,
                                    double inclination_rad);

/// The stick region in space at one tick. In stick its centre is the stick centre; in slip it is where the
/// centre would be if stick began now (paper, eq. 2-3: the spring would pull with the present friction).
struct StickRegion {
  StickAxes axes;
  Vec3 centre_W = Vec3::Zero();
  Vec3 lateral_W = Vec3::UnitX(), longitudinal_W = Vec3::UnitY();  ///< unit, in the tangent plane
};

/// The region at a tick. Nothing while free, or where the law has none.
std::optional<StickRegion> stick_region(const Scene& scene, const SurfaceProperties& surface,
                                        const TickRecord& row);

/// The finger's direction at a tick: the scene's, raised to the inclination that the tick recorded.
Vec3 finger_direction(const Vec3& scene_direction_W, const TickRecord& row);

/// `count` points of the region's rim, in order, `share` of the way from its centre [m].
std::vector<Vec3> rim_points(const StickRegion& region, int count, double share);

/// The region as rings of points from its centre to its rim, laid onto the surface where that can be
/// searched.
/// @returns rings of equal size, the last one the rim
std::vector<std::vector<Vec3>> region_rings(const StickRegion& region, const Surface& surface);

}  // namespace fingerpad
