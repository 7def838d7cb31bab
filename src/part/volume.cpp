#include "part/volume.hpp"

#include <Eigen/Geometry>
#include <vector>

namespace fingerpad {
namespace {

struct Body {
  double volume_m3 = 0;
  Eigen::AlignedBox3d box;
  bool sound = true;  // closed and consistently wound
};

}  // namespace

void measure_bodies(const Part& part, const EdgeTable& edges, Census& census) {
  census.closed = census.boundary_edges == 0 && census.nonmanifold_edges == 0;
  int count = 0;
  const std::vector<int> component = component_of(edges, part.triangle_count(), &count);
  std::vector<Body> bodies(static_cast<std::size_t>(count));
  for (int t = 0; t < part.triangle_count(); ++t) {
    Body& body = bodies[static_cast<std::size_t>(component[static_cast<std::size_t>(t)])];
    const Vec3 a = part.vertices.col(part.triangles(0, t)), b = part.vertices.col(part.triangles(1, t)),
               c = part.vertices.col(part.triangles(2, t));
    body.volume_m3 += a.dot(b.cross(c)) / 6;
    body.box.extend(a).extend(b).extend(c);
  }
  for (int e = 0; e < edges.edge_count(); ++e) {
    const auto on = edges.on_edge(e);
    const bool sound = on.size() == 2 && edge_from(part.welded, on[0]) != edge_from(part.welded, on[1]);
    if (!sound)
      bodies[static_cast<std::size_t>(component[static_cast<std::size_t>(on[0] / 3)])].sound = false;
  }
  for (const Body& body : bodies) census.volume_m3 += body.volume_m3;
  constexpr int few_enough = 1000;  // bodies to compare in pairs
  if (count > few_enough) return;
  for (const Body& inward : bodies) {
    if (!inward.sound || inward.volume_m3 >= 0) continue;
    bool enclosed = false;  // then it is a cavity and rightly wound
    for (const Body& outer : bodies) {
      enclosed = enclosed || (outer.volume_m3 > 0 && outer.box.contains(inward.box));
    }
    if (!enclosed) ++census.inward_bodies;
  }
}

}  // namespace fingerpad
