#pragma once

#include <vector>

#include "touch/tick_record.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// What the camera of a close-up looks at: down onto the contact, along its normal.
struct CloseUpSight {
  Vec3 contact_W = Vec3::Constant(TickRecord::nan), normal_W = Vec3::UnitZ();
  double reach_m = 0,
         across_m = 0;  ///< from the contact to the farthest corner in sight, and across the sight
  bool operator==(const CloseUpSight&) const = default;
};

/// The triangles of a part that such a camera sees, in their order, and few others: of those within reach of
/// the contact all that come near its line of sight; all there are where the part has no tree.
/// @pre the surface has a part
std::vector<int> triangles_in_sight(const Surface& surface, const CloseUpSight& sight);

}  // namespace fingerpad
