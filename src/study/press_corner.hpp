#pragma once

#include <cstddef>
#include <span>

namespace fingerpad {

/// Whether a force stands level within [from, to) and leaves that level in corners, as that of a finger which
/// comes down on a plate or is lifted from it: told by which of two curves leaves plainly less of it, a level
/// with a ramp at each end, or one parabola, along which a load that only swings goes through its least.
/// @param force_n  evenly sampled, from where it is plainly above the level before to where it is after;
/// begins
///                 with the level where `from` is 0, and ends with it where `to` is its size
/// @param reach    how much later than the level's end as it is told a ramp may begin, in samples
bool leaves_in_corners(std::span<const double> force_n, std::size_t from, std::size_t to, std::size_t reach);

}  // namespace fingerpad
