#pragma once

#include <array>
#include <span>
#include <vector>

#include "touch/world.hpp"
#include "view/draw_space.hpp"

namespace fingerpad {

/// Surfaces as few triangles: enough to be recognised in a small picture or a page, not to be measured.
struct SmallShape {
  std::vector<Vec3> points_W;
  std::vector<std::array<int, 3>> triangles;
};

/// The parts in at most some `most_triangles`, planes as a square about `about`. Of several parts each gets
/// its share by the triangles that it has. The same for the same surfaces.
SmallShape small_shape(std::span<const Surface> surfaces, int most_triangles, const Ball& about);

}  // namespace fingerpad
