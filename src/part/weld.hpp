#pragma once

#include <vector>

#include "base/types.hpp"

namespace fingerpad {

/// Which points are one vertex: `id[i]` for point i, numbered by first appearance from 0.
struct Welding {
  std::vector<int> id;
  int count = 0;
};

/// Welds points whose three coordinates are equal (0 and -0 are). O(n).
Welding weld_equal(const Points& points);

/// Welds further: of the candidates, those within `reach` of each other become one vertex (also through a
/// chain of such pairs). Grid hashing with neighbour cells: O(n). Where the candidates crowd (more than 64
/// pairs each) nothing is merged.
/// @param welding     of `points`, left as it is
/// @param candidates  one point of each vertex that may be merged
/// @param reach       in the points' unit, > 0
Welding weld_near(const Points& points, const Welding& welding, const std::vector<int>& candidates,
                  double reach);

}  // namespace fingerpad
