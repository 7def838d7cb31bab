#pragma once

#include "contact/part_measures.hpp"

namespace fingerpad {

/// By how much the float32 coordinates of a part's file are rounded, at the most [m].
double rounding_of(const Part& part);

/// Whether a part stands more than ten times as far from its file's origin as it reaches from its own middle:
/// what its numbers are rounded by may then be felt, and is no matter of its shape.
bool is_far_off(const Part& part);

/// The height over its longest edge from which a facet's normal is believed [m].
double trusted_height_of(const Part& part);

/// What all of a part's edges say: PartMeasures' edges, volume, turns, sag and hollow.
PartMeasures measured_edges(const Part& part, double trusted_height_m);

}  // namespace fingerpad
