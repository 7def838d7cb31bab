#include <span>
#include <vector>

#include "base/large_pages.hpp"
#include "part/in_parallel.hpp"
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

/// The fans around one vertex. Corners of different vertices have nothing in common, so that vertices can be
/// done side by side.
class Fans {
 public:
  Fans(Part& part, const Points& angles, std::vector<char>& done)
      : part_(part), angles_(angles), done_(done) {}

  void fill(std::span<const int> corners) {
    for (const int column : corners) {
      if (done_[static_cast<std::size_t>(column)] == 0) fill_fan(column);
    }
  }

 private:
  void fill_fan(int start) {
    fan_.clear();
    sum_ = Vec3::Zero();
    const Step first{start / 3, start % 3, start % 3};
    enter(first);
    for (const int edge : {first.edge, (first.edge + 2) % 3}) {
      Step step = crossed(part_, {first.triangle, first.corner, edge});
      while (step.triangle >= 0 && enter(step)) step = crossed(part_, step);
    }
    const bool vanishes = sum_.norm() <= 1e-12;
    const Vec3 unit = sum_.normalized();
    for (const int column : fan_)
      part_.corner_normals.col(column) = vanishes ? Vec3(part_.facet_normals.col(column / 3)) : unit;
  }

  bool enter(const Step& step) {
    const int column = 3 * step.triangle + step.corner;
    if (done_[static_cast<std::size_t>(column)] != 0) return false;
    done_[static_cast<std::size_t>(column)] = 1;
    fan_.push_back(column);
    sum_ += angles_(step.corner, step.triangle) * part_.facet_normals.col(step.triangle);
    return true;
  }

  Part& part_;
  const Points& angles_;
  std::vector<char>& done_;  // a byte a corner: bits would be shared between threads
  std::vector<int> fan_;
  Vec3 sum_ = Vec3::Zero();
};

}  // namespace

void fill_corner_normals(Part& part, const CornersAtVertices& corners, const Points& angles) {
  part.corner_normals.resize(3, Eigen::Index(3) * part.triangle_count());
  prefer_large_pages(part.corner_normals);
  std::vector<char> done(corners.columns.size(), 0);
  in_parallel(part.welded_count, [&](int begin, int end) {
    Fans fans(part, angles, done);
    for (int v = begin; v < end; ++v) fans.fill(corners.at(v));
  });
}

}  // namespace fingerpad
