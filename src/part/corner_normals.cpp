#include <utility>
#include <vector>

#include "part/normals.hpp"

namespace fingerpad {
namespace {

/// A corner on its way around a vertex: triangle, corner, and the edge at which it will be left.
struct Step {
  int triangle, corner, edge;
};

/// The same vertex's corner across the edge at which `step` is left; triangle -1 where a crease or no
/// neighbour is.
///
/// Works whatever way the neighbour is wound.
Step crossed(const Part& part, const Step& step) {
  if (part.creases[static_cast<std::size_t>(step.triangle)] >> step.edge & 1) return {-1, 0, 0};
  const int vertex = part.welded(step.corner, step.triangle);
  const int far_corner = step.edge == step.corner ? (step.corner + 1) % 3 : step.edge;
  const int far_vertex = part.welded(far_corner, step.triangle);
  const int other = part.neighbours(step.edge, step.triangle);
  int corner = 0;
  while (part.welded(corner, other) != vertex) ++corner;
  // Corner c stands between edge c, which leads to corner c + 1, and edge c - 1: leave by the one not come in
  // by.
  const bool came_by_own_edge = part.welded((corner + 1) % 3, other) == far_vertex;
  return {other, corner, came_by_own_edge ? (corner + 2) % 3 : corner};
}

}  // namespace

void fill_corner_normals(Part& part, const Points& angles) {
  const int n = part.triangle_count();
  part.corner_normals = Points::Zero(3, Eigen::Index(3) * n);
  std::vector<bool> done(static_cast<std::size_t>(3 * n), false);
  std::vector<int> fan;
  for (int start = 0; start < 3 * n; ++start) {
    if (done[static_cast<std::size_t>(start)]) continue;
    Vec3 sum = Vec3::Zero();
    fan.clear();
    const auto enter = [&](const Step& step) {
      const int column = 3 * step.triangle + step.corner;
      if (done[static_cast<std::size_t>(column)]) return false;
      done[static_cast<std::size_t>(column)] = true;
      fan.push_back(column);
      sum += angles(step.corner, step.triangle) * part.facet_normals.col(step.triangle);
      return true;
    };
    const Step first{start / 3, start % 3, start % 3};
    enter(first);
    for (const int edge : {first.edge, (first.edge + 2) % 3}) {
      Step step = crossed(part, {first.triangle, first.corner, edge});
      while (step.triangle >= 0 && enter(step)) step = crossed(part, step);
    }
    const bool vanishes = sum.norm() <= 1e-12;
    for (const int column : fan) {
      part.corner_normals.col(column) =
          vanishes ? Vec3(part.facet_normals.col(column / 3)) : sum.normalized();
    }
  }
}

}  // namespace fingerpad
