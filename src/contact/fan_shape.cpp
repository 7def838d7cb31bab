#include "contact/fan_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/smoothstep.hpp"
#include "base/unit_vector.hpp"
#include "contact/facet_rule.hpp"

namespace fingerpad {
namespace {

/// Of a flat face's area: beside it a fillet's facet with less does not count, with more it does.
constexpr double ignored_share = 0.5, full_share = 1;
/// How much more the surface turns on beyond a facet than from the face to it: half a facet's turn to the
/// first facet of a fillet, a whole one from each to the next; among strips of a round face as much, whatever
/// their widths.
constexpr double round_turns_on = 1.25, fillet_turns_on = 1.75;
/// Facets whose normals differ by less are of one plane, by more of two [rad]: float32 files tell them to
/// some 1e-5.
constexpr double one_plane_rad = 1e-4, two_planes_rad = 1e-3;

/// atan(y/x) for x, y >= 0, to 1e-5 (Abramowitz & Stegun 4.4.49): the same on every machine, and quick.
double rough_angle(double y, double x) noexcept {
  const double ratio = y <= x ? y / x : x / y, s = ratio * ratio;
  const double angle =
      ratio * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
  return y <= x ? angle : std::numbers::pi / 2 - angle;
}

double doubled_area_m2(const Part& part, int t) noexcept {
  const Vec3 p = part.vertices.col(part.triangles(0, t));
  const Vec3 a = part.vertices.col(part.triangles(1, t)) - p, b = part.vertices.col(part.triangles(2, t)) - p;
  return a.cross(b).norm();
}

/// How much more the surface turns on beyond facet t, the way that it turns from a face to it, than there:
/// the most over the smooth edges of t and of what lies in its plane. 0 where t lies in the face's plane.
double turns_on(const Part& part, int t, const Vec3& face_normal) noexcept {
  const Vec3 normal = part.facet_normals.col(t), turn = normal - face_normal;
  const double turn2 = turn.squaredNorm();
  if (!(turn2 > two_planes_rad * two_planes_rad)) return 0;
  double most = 0;
  const auto look_beyond = [&](int facet, const auto& look_on) {
    for (int k = 0; k < 3; ++k) {
      const int other = part.neighbours(k, facet);
      if (other < 0 || has_crease(part, facet, k)) continue;
      const Vec3 on = part.facet_normals.col(other) - normal;
      most = std::max(most, on.dot(turn) / turn2);
      if (on.squaredNorm() < two_planes_rad * two_planes_rad) look_on(other);
    }
  };
  look_beyond(t, [&](int other) { look_beyond(other, [](int) {}); });
  return most;
}

/// @param face_areas  that the fan's facets are held against, in their order
double count_in(std::span<const FanFacet> fan, std::span<const double> face_areas, const FanFacet& facet,
                const Part& part) noexcept {
  double counts = 1;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    if (!(facet.doubled_area_m2 < full_share * face_areas[i])) continue;
    const double wide = 1 - smoothstep(ignored_share, full_share, facet.doubled_area_m2 / face_areas[i]);
    const double fillet =
        smoothstep(round_turns_on, fillet_turns_on, turns_on(part, facet.at.triangle, fan[i].normal));
    counts = std::min(counts, 1 - wide * fillet);
  }
  return counts;
}

}  // namespace

double doubled_face_area_m2(const Part& part, int t) noexcept {
  const Vec3 normal = part.facet_normals.col(t);
  const double own = doubled_area_m2(part, t);
  double largest = 0;
  const auto look_beyond = [&](int facet, const auto& look_on) {
    for (int k = 0; k < 3; ++k) {
      const int other = part.neighbours(k, facet);
      if (other < 0 || other == t) continue;
      const double off_rad = (part.facet_normals.col(other) - normal).norm();
      if (off_rad > two_planes_rad) continue;
      const double area = std::max(own, doubled_area_m2(part, other));
      largest = std::max(largest, smoothstep(two_planes_rad, one_plane_rad, off_rad) * area);
      look_on(other);
    }
  };
  look_beyond(t, [&](int other) { look_beyond(other, [](int) {}); });
  return largest;
}

FanShape fan_shape(const FaceAreas& areas, std::span<const FanFacet> fan) noexcept {
  FanShape shape;
  Vec3 wide = Vec3::Zero(), round = Vec3::Zero();
  std::array<double, SmoothFan::most_facets> face_areas;
  for (std::size_t i = 0; i < fan.size(); ++i) face_areas[i] = areas.of(fan[i].at.triangle);
  for (std::size_t i = 0; i < fan.size(); ++i) {
    const FanFacet& facet = fan[i];
    const double counts = shape.counts[i] =
        count_in(fan, std::span(face_areas).first(fan.size()), facet, areas.part);
    if (!(facet.doubled_area_m2 > 0)) continue;
    const double lengths2 = facet.first.squaredNorm() * facet.second.squaredNorm();
    const double half_angle =
        rough_angle(facet.doubled_area_m2, std::sqrt(lengths2) + facet.first.dot(facet.second));
    wide += counts * half_angle * facet.doubled_area_m2 * facet.normal;
    round += counts * facet.doubled_area_m2 / lengths2 * facet.normal;
  }
  shape.wide_normal = unit_or_zero(wide);
  shape.round_normal = unit_or_zero(round);
  return shape;
}

}  // namespace fingerpad
