#include "part/volume.hpp"

#include "part/bodies.hpp"

namespace fingerpad {

void measure_bodies(const Part& part, const EdgeTable& edges, Census& census) {
  census.closed = census.boundary_edges == 0 && census.nonmanifold_edges == 0;
  const Bodies bodies = find_bodies(part.vertices, part.triangles, part.welded, edges);
  census.inside_out = true;
  for (const Body& body : bodies.all) {
    census.inside_out = census.inside_out && bodies.is_inside_out(body);
    census.volume_m3 += body.volume_m3;
    if (!bodies.depths_known || !bodies.is_inside_out(body)) continue;
    ++(body.depth % 2 == 0 ? census.inward_bodies : census.outward_cavities);
  }
}

}  // namespace fingerpad
