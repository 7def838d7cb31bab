#pragma once

#include <gp_Pnt.hxx>
#include <vector>

namespace fingerpad::parts {

/// Where a finger is led over the grip, in free space near it; its foot on the surface is the path [mm].
/// @param along  0 .. 1
gp_Pnt rim_guide(double along);   ///< weaves over the rounded rim and round a corner: top, fillet, sides
gp_Pnt boss_guide(double along);  ///< weaves between top and boss through the concave fillet

}  // namespace fingerpad::parts
