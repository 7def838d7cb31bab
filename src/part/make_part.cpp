#include <algorithm>
#include <future>
#include <numeric>
#include <utility>

#include "part/build_part.hpp"
#include "part/connected_mesh.hpp"
#include "part/edge_table.hpp"
#include "part/in_parallel.hpp"
#include "part/index.hpp"
#include "part/normals.hpp"
#include "part/repair.hpp"
#include "part/volume.hpp"

namespace fingerpad {
namespace {

IndexTriples neighbours_of(const EdgeTable& edges, int triangle_count) {
  IndexTriples neighbours = IndexTriples::Constant(3, triangle_count, -1);
  for (int e = 0; e < edges.edge_count(); ++e) {
    const auto on = edges.on_edge(e);
    if (on.size() != 2) continue;
    neighbours(on[0] % 3, on[0] / 3) = on[1] / 3;
    neighbours(on[1] % 3, on[1] / 3) = on[0] / 3;
  }
  return neighbours;
}

std::vector<bool> without_area(const Centred& mesh) {
  const int n = static_cast<int>(mesh.triangles.cols());
  std::vector<char> flat(at(n));
  in_parallel(n, [&](int begin, int end) {
    for (int t = begin; t < end; ++t) {
      flat[at(t)] = has_no_area(shape_of(mesh.points, mesh.triangles, t), mesh.largest_coordinate) ? 1 : 0;
    }
  });
  return {flat.begin(), flat.end()};
}

/// A part on its way: some triangles of a soup and how they hang together.
struct Draft {
  std::vector<int> from_soup;
  Centred mesh;
  Connected links;
  std::vector<bool> flat;  // without area
};

/// @param repair  where to count what was repaired; null for a part as it is
Draft first_draft(const TriangleSoup& soup, RepairCounts* repair) {
  Draft draft;
  draft.from_soup.resize(at(static_cast<int>(soup.triangles.cols())));
  std::iota(draft.from_soup.begin(), draft.from_soup.end(), 0);
  draft.mesh = centred(soup, draft.from_soup);
  draft.links = repair != nullptr ? weld_all(draft.mesh, *repair) : weld(draft.mesh);
  draft.flat = without_area(draft.mesh);
  return draft;
}

/// The draft with the triangles `kept` (numbers in it) alone. The welding is inherited.
Draft reduced(const TriangleSoup& soup, const Draft& draft, const std::vector<int>& kept) {
  Draft result;
  Connected& links = result.links;
  links.welded.resize(3, static_cast<Eigen::Index>(kept.size()));
  links.weld_distance = draft.links.weld_distance;
  std::vector<int> number(at(draft.links.welded_count), -1);
  for (std::size_t t = 0; t < kept.size(); ++t) {
    result.from_soup.push_back(draft.from_soup[at(kept[t])]);
    for (int k = 0; k < 3; ++k) {
      int& id = number[at(draft.links.welded(k, kept[t]))];
      if (id < 0) id = links.welded_count++;
      links.welded(k, static_cast<Eigen::Index>(t)) = id;
    }
  }
  links.edges = make_edge_table(links.welded, links.welded_count);
  result.mesh = centred(soup, result.from_soup);
  result.flat = without_area(result.mesh);
  return result;
}

/// Counts what the whole soup holds and lists what goes into the part.
std::vector<int> take_census(const Draft& draft, Census& census) {
  const Connected& links = draft.links;
  const std::vector<bool> duplicate = find_duplicates(links.edges, links.welded);
  census.components = component_count(links.welded, links.welded_count);
  census.boundary_edges = links.counts.boundary;
  census.nonmanifold_edges = links.counts.nonmanifold;
  census.inconsistent_edges = links.counts.inconsistent;
  census.weld_distance_m = links.weld_distance;
  std::vector<int> kept;
  for (int t = 0; t < links.welded.cols(); ++t) {
    const bool collapsed = is_collapsed(links.welded, t);
    if (collapsed || draft.flat[at(t)]) ++census.degenerate;
    if (duplicate[at(t)]) ++census.duplicate;
    if (!collapsed && !duplicate[at(t)]) kept.push_back(t);
  }
  return kept;
}

/// The part without creases, pseudonormals and corner normals. Takes the draft's arrays.
Part assembled(const TriangleSoup& soup, Draft& draft) {
  Part part;
  part.centre_P = draft.mesh.centre_P;
  part.half_extent = draft.mesh.half_extent;
  part.vertices = std::move(draft.mesh.points);
  part.triangles = std::move(draft.mesh.triangles);
  part.welded = std::move(draft.links.welded);
  part.welded_count = draft.links.welded_count;
  part.file_triangle.reserve(draft.from_soup.size());
  for (const int t : draft.from_soup) {
    part.file_triangle.push_back(soup.file_triangle.empty() ? t : soup.file_triangle[at(t)]);
  }
  part.neighbours = neighbours_of(draft.links.edges, part.triangle_count());
  return part;
}

/// The triangles with a side: those without area that no edge joins to one with area have none.
std::vector<int> sided(const Draft& draft) {
  const Points normals =
      facet_normals(draft.mesh.points, draft.mesh.triangles, draft.links.edges, draft.flat);
  std::vector<int> kept;
  for (int t = 0; t < normals.cols(); ++t) {
    if (!normals.col(t).isZero(0)) kept.push_back(t);
  }
  return kept;
}

/// Winds the draft and counts its edges anew.
void wind_draft(Draft& draft, Census& census) {
  Connected& links = draft.links;
  links.edges = wind(draft.mesh.points, draft.mesh.triangles, links.welded, links.welded_count,
                     std::move(links.edges), census.repair);
  const EdgeCounts counts = count_edges(links.edges, links.welded);
  census.boundary_edges = counts.boundary;
  census.nonmanifold_edges = counts.nonmanifold;
  census.inconsistent_edges = counts.inconsistent;
  census.components = component_count(links.welded, links.welded_count);
}

BuiltPart build(const TriangleSoup& soup, double crease_rad, bool repair, const LoadProgress& progress) {
  BuiltPart built;
  tell(progress, "joining triangles", 0);
  Draft draft = first_draft(soup, repair ? &built.census.repair : nullptr);
  std::vector<int> kept = take_census(draft, built.census);
  if (kept.size() < draft.from_soup.size()) draft = reduced(soup, draft, kept);
  // Leaving triangles out moves the centre, and with it what rounding makes of the others: look again.
  while (std::find(draft.flat.begin(), draft.flat.end(), true) != draft.flat.end()) {
    kept = sided(draft);
    if (kept.size() == draft.from_soup.size()) break;
    draft = reduced(soup, draft, kept);
  }
  if (repair) wind_draft(draft, built.census);
  tell(progress, "making normals", 0.45);
  Part& part = built.part;
  part = assembled(soup, draft);
  const EdgeTable& edges = draft.links.edges;
  part.facet_normals = facet_normals(part.vertices, part.triangles, edges, draft.flat);
  // Beside each other: they touch nothing of each other's. Worth a thread for large parts only.
  constexpr int large = 50000;
  const auto how = part.triangle_count() < large ? std::launch::deferred : std::launch::async;
  auto bodies = std::async(how, [&] { measure_bodies(part, edges, built.census); });
  auto corners_at = std::async(how, [&] { return corners_at_vertices(part); });
  fill_creases(part, crease_rad);
  const Points angles = corner_angles(part);
  fill_edge_pseudonormals(part, edges, draft.flat);
  const CornersAtVertices corners = corners_at.get();
  for (int v = 0; v < part.welded_count; ++v)
    part.largest_fan = std::max(part.largest_fan, static_cast<int>(corners.at(v).size()));
  fill_vertex_pseudonormals(part, corners, angles);
  fill_corner_normals(part, corners, angles);
  bodies.get();
  return built;
}

}  // namespace

BuiltPart build_part(const TriangleSoup& soup, double crease_rad, const LoadProgress& progress) {
  return build(soup, crease_rad, false, progress);
}

BuiltPart build_repaired_part(const TriangleSoup& soup, double crease_rad, const LoadProgress& progress) {
  return build(soup, crease_rad, true, progress);
}

Part make_part(const TriangleSoup& soup, double crease_rad, double* weld_distance_m) {
  BuiltPart built = build_part(soup, crease_rad);
  if (weld_distance_m != nullptr) *weld_distance_m = built.census.weld_distance_m;
  return std::move(built.part);
}

Bounds bounds_P(const Part& part) {
  return {part.centre_P - part.half_extent, part.centre_P + part.half_extent};
}

}  // namespace fingerpad
