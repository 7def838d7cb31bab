#include "study/judged_runs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/contact_method_table.hpp"
#include "contact/curved_closest.hpp"
#include "contact/facet_rule.hpp"
#include "replay/pop_throughs.hpp"
#include "study/stretch_run.hpp"

namespace fingerpad {
namespace {

/// Of a rounding's radius: so deep a finger is held. Exact surfaces are pressed no deeper either.
constexpr double deepest_share = 0.8;
constexpr double cos_same_wall = 0.86602540378443865;  // 30 degrees, the default crease

/// The force of the curved patches at a foot on the facets; false where that foot, or the one found from
/// there, lies on an edge, or they are no one wall's.
/// @param foot_P  on the facets; as q, relative to the part's centre
/// @param normal_P  of the wall
bool patch_force(const Surface& surface, const Vec3& foot_P, const Vec3& normal_P, const Vec3& q,
                 double radius_m, Vec3& force_W_n) {
  const Part& part = *surface.part;
  ClosestTriangle facets = surface.tree->closest(foot_P, -1, HUGE_VAL);
  if (facets.triangle < 0 || !is_smooth(part, facets.triangle, facets.at.feature)) return false;
  facets.at.distance2_m2 = (q - facets.at.point).squaredNorm();
  const CurvedPoint found = closest_on_curved({part, surface.tree->curved_normals()}, facets, q);
  if (found.triangle < 0 || !is_smooth(part, found.triangle, found.at.feature)) return false;
  const Vec3 out = q - found.at.point;
  const double distance_m = out.norm(), before_m = (q - foot_P).norm();
  // Of one wall both are nearest; then their distances differ by no more than the patches stand off the
  // facets, and by about what they do at the foot, and 15 degrees of tilt make of the distance.
  const CurvedPatch patch = curved_patch({part, surface.tree->curved_normals()}, facets.triangle);
  const double sag_m = (evaluate(patch, facets.at.barycentric).x - facets.at.point).norm();
  const double most_m = std::min(found.deviation_m, 2 * sag_m + 0.034 * before_m) + 1e-9 * part.size_m();
  if (std::abs(distance_m - before_m) > most_m) return false;
  if (found.normal_P.dot(normal_P) < cos_same_wall) return false;
  const double depth_m = radius_m + (out.dot(found.normal_P) < 0 ? distance_m : -distance_m);
  force_W_n = surface.properties.stiffness_n_per_m * std::max(0.0, depth_m) * (surface.R_WP * found.normal_P);
  return true;
}

Vec3 in_part(const Surface& surface, const Vec3& p_W) {
  return surface.R_WP.transpose() * (p_W - surface.p_WP) - surface.part->centre_P;
}

/// How fast a facet's corner normals spread along its edges, at the most.
double rounding_per_m(const Part& part, int t) {
  double most_per_m = 0;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const Vec3 edge = part.vertices.col(part.triangles(next, t)) - part.vertices.col(part.triangles(k, t));
    const Vec3 turn = part.corner_normals.col(3 * t + next) - part.corner_normals.col(3 * t + k);
    most_per_m = std::max(most_per_m, turn.dot(edge) / edge.squaredNorm());
  }
  return most_per_m;
}

/// What holds the finger, where that is one part alone.
const Surface* only_part(const JudgedCase& judged, const TickRecord& record) {
  if (record.walls != 1) return nullptr;
  const Surface& surface = judged.world->surfaces[static_cast<std::size_t>(record.surface)];
  return surface.is_plane() ? nullptr : &surface;
}

/// Whether a finger has been pressed so near the middle of the rounding that it stands on that it slips
/// round.
bool slips_round(const JudgedCase& judged, const TickRecord& record) {
  const Surface* const held_by = only_part(judged, record);
  if (held_by == nullptr) return false;
  const Surface& surface = *held_by;
  const Vec3 foot_P = in_part(surface, record.contact_W), q = in_part(surface, record.p_WQ);
  const double under_m = (foot_P - q).dot(surface.R_WP.transpose() * record.normal_W);
  if (under_m <= 0) return false;
  const ClosestTriangle at = surface.tree->closest(foot_P, -1, HUGE_VAL);
  return at.triangle >= 0 && under_m * rounding_per_m(*surface.part, at.triangle) > deepest_share;
}

/// That of a finger that is clear of all facets: where they cut in, the patch over them stands out farther.
Vec3 force_over_facets(const JudgedCase& judged, const TickRecord& record) {
  const double radius_m = judged.scene.finger.radius_m;
  Vec3 largest_W_n = Vec3::Zero();
  for (const Surface& surface : judged.world->surfaces) {
    if (surface.is_plane()) continue;
    const Vec3 q = in_part(surface, record.p_WQ);
    const ClosestTriangle nearest = surface.tree->closest(q, -1, HUGE_VAL);
    if (nearest.triangle < 0) continue;
    const Vec3 normal_P = surface.part->facet_normals.col(nearest.triangle);
    if ((q - nearest.at.point).dot(normal_P) < 0)
      continue;  // behind it: of an open part, or inside of a body
    Vec3 force_W_n;
    if (patch_force(surface, nearest.at.point, normal_P, q, radius_m, force_W_n) &&
        force_W_n.squaredNorm() > largest_W_n.squaredNorm())
      largest_W_n = force_W_n;
  }
  return largest_W_n;
}

/// The reference's force in a tick of the most complete method.
Vec3 complete_force(const JudgedCase& judged, const TickRecord& record) {
  const Vec3 raw_W_n = record.force_W_n - record.friction_W_n;
  if (record.walls == 0) return force_over_facets(judged, record);
  const Surface* const surface = only_part(judged, record);
  if (surface == nullptr) return raw_W_n;
  Vec3 force_W_n;
  return patch_force(*surface, in_part(*surface, record.contact_W),
                     surface->R_WP.transpose() * record.normal_W, in_part(*surface, record.p_WQ),
                     judged.scene.finger.radius_m, force_W_n)
             ? force_W_n
             : raw_W_n;
}

MotionStretch whole(const FingerPath& way) {
  // The last tick counts too.
  return {way.start_s(), way.start_s(),
          way.start_s() + static_cast<double>(way.tick_count()) / way.rate_hz()};
}

}  // namespace

JudgedRun judged_run(const JudgedCase& judged, const ContactVariant& variant, int turns) {
  const TouchChoice choice{variant.method_name, variant.normals, judged.scene.motion.rate_hz, Events::tick};
  JudgedRun run;
  double all_ns = 0;
  for (const FingerPath& way : judged.ways) {
    StretchRun best = run_stretch(judged.world, judged.scene, way, choice, whole(way));
    for (int turn = 1; turn < turns; ++turn) {
      const StretchRun again = run_stretch(judged.world, judged.scene, way, choice, whole(way));
      for (std::size_t k = 0; k < best.tick_ns.size(); ++k)
        best.tick_ns[k] = std::min(best.tick_ns[k], again.tick_ns[k]);
    }
    all_ns = std::accumulate(best.tick_ns.begin(), best.tick_ns.end(), all_ns);
    run.force_W_n.insert(run.force_W_n.end(), best.force_W_n.begin(), best.force_W_n.end());
    run.pop_throughs.push_back(best.pop_throughs);
  }
  run.tick_ns = all_ns / static_cast<double>(run.force_W_n.size());
  return run;
}

JudgedReference judged_reference(const JudgedCase& judged) {
  JudgedReference reference;
  const TouchChoice complete{std::string(contact_method_table().back().name), normals_table().back(),
                             judged.scene.motion.rate_hz, Events::tick};
  for (const FingerPath& way : judged.ways) {
    Touch touch(judged.world, touched_by(judged.scene, complete));
    PopThroughs pop_throughs(judged.world, judged.scene.finger.radius_m);
    for (long k = 0; k < way.tick_count(); ++k) {
      const FingerSample sample = way.at(k);
      if (judged.exact_force_n) {
        reference.force_W_n.push_back(judged.exact_force_n(sample.p_WQ));
        reference.slips.push_back(false);
        continue;
      }
      const TickRecord& record = touch.tick(sample);
      pop_throughs.observe(record);
      reference.complete.force_W_n.push_back(record.force_W_n);
      reference.force_W_n.push_back(complete_force(judged, record));
      reference.slips.push_back(slips_round(judged, record));
    }
    if (!judged.exact_force_n) reference.complete.pop_throughs.push_back(pop_throughs.count());
  }
  return reference;
}

}  // namespace fingerpad
