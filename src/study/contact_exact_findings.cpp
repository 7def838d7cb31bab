#include "study/contact_exact_findings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/surface_point.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {
namespace {

constexpr std::array strike_speeds_m_per_s{0.2, 1.0, 5.0};
constexpr std::size_t strike_every = 2;  // samples

void add_path(const std::shared_ptr<const World>& world, const ExactPath& path,
              std::vector<PathCurve>& curves) {
  const Rub deep = rub_along(path, rub_depth_m, 0), near = rub_along(path, 0, rub_radius_m);
  for (std::size_t v = 0; v < contact_variants().size(); ++v) {
    const ContactVariant& variant = contact_variants()[v];
    PathCurve& curve = curves[v];
    curve.deep.push_back(rub_error(world, variant, deep));
    curve.near.push_back(rub_error(world, variant, near));
    curve.tick_ns.push_back(rub_tick_ns(world, variant, deep, "finger-pad"));
    curve.contact_ns.push_back(rub_tick_ns(world, variant, deep, "none"));
  }
}

}  // namespace

SampleError sample_error(const ExactSet& set, const ExactMesh& mesh, const TriangleTree& tree,
                         Normals normals) {
  SampleError error;
  for (const ExactSample& sample : set.samples) {
    const SurfacePoint near = nearest_surface_point(tree, sample.query, normals, -1, HUGE_VAL);
    const double off_m = std::abs(near.signed_distance_m - sample.signed_distance_m);
    error.distance_rms_m += off_m * off_m;
    error.distance_worst_m = std::max(error.distance_worst_m, off_m);
    // Nearer to a sharp edge the tessellation may have its nearest point on the edge's other side.
    if (!sample.on_face || sample.sharp_edge_m < std::abs(sample.signed_distance_m) + mesh.facet_m) continue;
    const double turned_rad =
        std::atan2(near.normal_P.cross(sample.normal).norm(), near.normal_P.dot(sample.normal));
    error.normal_rms_rad += turned_rad * turned_rad;
    error.normal_worst_rad = std::max(error.normal_worst_rad, turned_rad);
    ++error.normals;
  }
  error.distance_rms_m = std::sqrt(error.distance_rms_m / static_cast<double>(set.samples.size()));
  error.normal_rms_rad = std::sqrt(error.normal_rms_rad / std::max(1, error.normals));
  return error;
}

StrikeCount strike_samples(const ExactSet& set, const std::shared_ptr<const World>& world,
                           const ContactVariant& variant) {
  constexpr double from_m = 1e-3, strike_depth_m = 2.4e-3, off_edges_m = 3e-3;
  StrikeCount count;
  for (std::size_t i = 0; i < set.samples.size(); i += strike_every) {
    const ExactSample& sample = set.samples[i];
    if (!sample.on_face || sample.sharp_edge_m < off_edges_m) continue;
    for (const double speed : strike_speeds_m_per_s) {
      const Strike strike{speed, 0, Vec2::Zero(), 0, from_m, strike_depth_m};
      count.pops += pops_through(world, variant, strike, sample.foot, sample.normal) ? 1 : 0;
      ++count.strikes;
    }
  }
  return count;
}

ExactFindings exact_findings(const ExactSet& set) {
  ExactFindings found;
  for (const ExactPath& path : set.paths) found.path_names.push_back(path.name);
  found.sample_count = static_cast<double>(set.samples.size());
  found.paths.assign(set.paths.size(), std::vector<PathCurve>(contact_variants().size()));
  found.samples.resize(normals_table().size());
  found.strikes.resize(contact_variants().size());
  for (const ExactMesh& mesh : set.meshes) {
    const auto world = world_of_part(mesh.part, "CAD part");
    found.facet_mm.push_back(1000 * mesh.facet_m);
    found.triangles.push_back(mesh.part->triangle_count());
    for (std::size_t n = 0; n < found.samples.size(); ++n)
      found.samples[n].push_back(sample_error(set, mesh, *world->surfaces[0].tree, normals_table()[n]));
    found.chosen.push_back(automatic_choice(*world, 0, rub_force_n));
    for (std::size_t v = 0; v < contact_variants().size(); ++v)
      found.strikes[v].push_back(strike_samples(set, world, contact_variants()[v]));
    for (std::size_t p = 0; p < set.paths.size(); ++p) add_path(world, set.paths[p], found.paths[p]);
  }
  return found;
}

}  // namespace fingerpad
