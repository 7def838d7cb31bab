#pragma once

#include <cstdint>
#include <vector>

#include "part/part.hpp"

namespace fingerpad {

/// The part's triangles in an order in which every eight that follow one another are neighbours: each
/// 8 k .. 8 k + 7 a packet, the last perhaps not full, and ascending within it.
///
/// Splits by the surface-area heuristic (MacDonald & Booth 1990), always at a multiple of eight, down to
/// eight: binned for many triangles, exact for few. On all threads; the same order on any number of them.
std::vector<std::int32_t> packet_order(const Part& part);

}  // namespace fingerpad
