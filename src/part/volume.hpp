#pragma once

#include "part/build_part.hpp"
#include "part/edge_table.hpp"

namespace fingerpad {

/// Fills the census' closed, volume_m3, inward_bodies and outward_cavities: signed tetrahedra over the part's
/// centre.
void measure_bodies(const Part& part, const EdgeTable& edges, Census& census);

}  // namespace fingerpad
