#pragma once

#include "contact/closest_point.hpp"
#include "contact/facet_rule.hpp"

namespace fingerpad {

// Lets memory that will be read soon come nearer while other things are done: of a large part each array
// would be waited for in turn. For speed alone. (Always inlined: g++ takes a function that does no more than
// this for one that does nothing, and leaves out its calls.)

/// Of a value that may lie in two cache lines.
template <typename Value>
[[gnu::always_inline]] inline void let_come(const Value* value, std::size_t count) noexcept {
  __builtin_prefetch(value);
  __builtin_prefetch(reinterpret_cast<const char*>(value + count) - 1);
}

/// What a tick asks of the triangle that it touches.
[[gnu::always_inline]] inline void let_come(const Part& part, int t) noexcept {
  let_come(part.facet_normals.col(t).data(), 3);
  let_come(part.corner_normals.col(Eigen::Index{3} * t).data(), 9);
  let_come(part.triangles.col(t).data(), 3);
  let_come(part.neighbours.col(t).data(), 3);
  __builtin_prefetch(&part.creases[static_cast<std::size_t>(t)]);
  __builtin_prefetch(&part.file_triangle[static_cast<std::size_t>(t)]);
}

/// The same where its closest point lies on this feature.
[[gnu::always_inline]] inline void let_come(const Part& part, int t, Feature feature) noexcept {
  if (is_edge(feature))
    let_come(part.edge_pseudonormals.col(Eigen::Index{3} * t + edge_of(feature)).data(), 3);
  let_come(part, t);
}

/// The same of its neighbours, one of which is likely touched next.
[[gnu::always_inline]] inline void let_come_around(const Part& part, int t) noexcept {
  for (int k = 0; k < 3; ++k) {
    const int next = part.neighbours(k, t);
    if (next < 0) continue;
    let_come(part, next);
    let_come(part.edge_pseudonormals.col(Eigen::Index{3} * next).data(), 9);
  }
}

}  // namespace fingerpad
