#include "contact/curved_normals.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace fingerpad {
namespace {

constexpr std::size_t most_triangles = 64;
/// Of a flat face's area: beside it a fillet's facet with less does not count, with more it does.
constexpr double ignored_share = 0.5, full_share = 1;
/// How much more the surface turns on beyond a facet than from the face to it: half a facet's turn to the
/// first facet of a fillet, a whole one from each to the next; among strips of a round face as much, whatever
/// their widths.
constexpr double round_turns_on = 1.25, fillet_turns_on = 1.75;
/// Facets whose normals differ by less are of one plane, by more of two [rad]: float32 files tell them to
/// some 1e-5.
constexpr double one_plane_rad = 1e-4, two_planes_rad = 1e-3;

/// A corner on the way around a vertex, and the edge at which its triangle will be left.
struct Step {
  int triangle, corner, edge;
};

/// The next corner around, -1 behind a crease.
Step crossed(const Part& part, const Step& at) noexcept {
  const int other = part.neighbours(at.edge, at.triangle);
  if (other < 0 || (part.creases[static_cast<std::size_t>(at.triangle)] >> at.edge & 1) != 0)
    return {-1, 0, 0};
  const int vertex = part.welded(at.corner, at.triangle);
  const int far_vertex = part.welded(at.edge == at.corner ? (at.corner + 1) % 3 : at.edge, at.triangle);
  int corner = 0;
  while (corner < 3 && part.welded(corner, other) != vertex) ++corner;
  if (corner == 3) return {-1, 0, 0};
  const bool came_by_own_edge = part.welded((corner + 1) % 3, other) == far_vertex;
  return {other, corner, came_by_own_edge ? (corner + 2) % 3 : corner};
}

/// atan(y/x) for x, y >= 0, to 1e-5 (Abramowitz & Stegun 4.4.49): the same on every machine, and quick.
double rough_angle(double y, double x) noexcept {
  const double ratio = y <= x ? y / x : x / y, s = ratio * ratio;
  const double angle =
      ratio * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
  return y <= x ? angle : std::numbers::pi / 2 - angle;
}

/// 0 up to `from`, 1 from `to` on; either may be the larger.
double smoothstep(double from, double to, double x) noexcept {
  const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

/// 1 where a neighbour lies in the facet's plane, as the other half of a quad does, 0 where none does.
double shares_plane(const Part& part, int t) noexcept {
  double nearest_rad = two_planes_rad;
  for (int k = 0; k < 3; ++k) {
    const int other = part.neighbours(k, t);
    if (other < 0) continue;
    nearest_rad = std::min(nearest_rad, (part.facet_normals.col(t) - part.facet_normals.col(other)).norm());
  }
  return smoothstep(two_planes_rad, one_plane_rad, nearest_rad);
}

/// Twice the area that narrow facets beside this one are held against.
double doubled_face_area(const Part& part, int t) noexcept {
  const double shares = shares_plane(part, t);
  if (!(shares > 0)) return 0;
  const Vec3 p = part.vertices.col(part.triangles(0, t));
  const Vec3 a = part.vertices.col(part.triangles(1, t)) - p, b = part.vertices.col(part.triangles(2, t)) - p;
  return shares * a.cross(b).norm();
}

/// A part with doubled_face_area() of every facet, or without: then it is reckoned where it is asked for, to
/// the same bits.
struct Faces {
  const Part& part;
  const std::vector<double>* doubled_areas = nullptr;

  double doubled_area(int t) const noexcept {
    return doubled_areas != nullptr ? (*doubled_areas)[static_cast<std::size_t>(t)]
                                    : doubled_face_area(part, t);
  }
};

/// A facet at a vertex: its angle there and its area, each up to a factor common to all, and the area that
/// others are held against.
struct FanFacet {
  Vec3 normal;
  double angle, area, area_of_face;
  int triangle;
};

FanFacet fan_facet(const Faces& faces, int t, int corner) noexcept {
  const Part& part = faces.part;
  const Vec3 p = part.vertices.col(part.triangles(corner, t));
  const Vec3 a = part.vertices.col(part.triangles((corner + 1) % 3, t)) - p;
  const Vec3 b = part.vertices.col(part.triangles((corner + 2) % 3, t)) - p;
  const double doubled_area = a.cross(b).norm();
  if (!(doubled_area > 0)) return {Vec3::Zero(), 0, 0, 0, t};
  const double half_angle =
      rough_angle(doubled_area, std::sqrt(a.squaredNorm() * b.squaredNorm()) + a.dot(b));
  return {part.facet_normals.col(t), half_angle, doubled_area, faces.doubled_area(t), t};
}

/// The smooth fan around a corner.
struct Fan {
  std::array<FanFacet, most_triangles> facets;
  std::size_t count = 0;

  std::span<const FanFacet> all() const noexcept { return std::span(facets).first(count); }
};

/// False where it has too many.
bool gather(const Faces& faces, int t, int corner, Fan& fan) noexcept {
  fan.facets[fan.count++] = fan_facet(faces, t, corner);
  for (const int edge : {corner, (corner + 2) % 3}) {
    Step step = crossed(faces.part, {t, corner, edge});
    while (step.triangle >= 0 && step.triangle != t) {
      if (fan.count == fan.facets.size()) return false;
      fan.facets[fan.count++] = fan_facet(faces, step.triangle, step.corner);
      step = crossed(faces.part, step);
    }
    if (step.triangle == t) break;
  }
  return true;
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
      if (other < 0 || (part.creases[static_cast<std::size_t>(facet)] >> k & 1) != 0) continue;
      const Vec3 on = part.facet_normals.col(other) - normal;
      most = std::max(most, on.dot(turn) / turn2);
      if (on.squaredNorm() < two_planes_rad * two_planes_rad) look_on(other);
    }
  };
  look_beyond(t, [&](int other) { look_beyond(other, [](int) {}); });
  return most;
}

/// How much a facet counts in its fan, 0 .. 1: less where it is a narrow first one of a fillet beside a face.
double counts_in(std::span<const FanFacet> fan, const FanFacet& facet, const Part& part) noexcept {
  double counts = 1;
  for (const FanFacet& face : fan) {
    if (!(facet.area < full_share * face.area_of_face)) continue;
    const double wide = 1 - smoothstep(ignored_share, full_share, facet.area / face.area_of_face);
    const double fillet =
        smoothstep(round_turns_on, fillet_turns_on, turns_on(part, facet.triangle, face.normal));
    counts = std::min(counts, 1 - wide * fillet);
  }
  return counts;
}

Vec3 corner_normal(const Faces& faces, int t, int corner) noexcept {
  Vec3 otherwise = faces.part.corner_normals.col(Eigen::Index{3} * t + corner);
  Fan fan;
  if (!gather(faces, t, corner, fan)) return otherwise;
  Vec3 sum = Vec3::Zero();
  for (const FanFacet& facet : fan.all())
    sum += counts_in(fan.all(), facet, faces.part) * facet.angle * facet.area * facet.normal;
  const double length = sum.norm();
  Vec3 normal = sum / length;
  // A fan folded upon itself sums to nothing.
  return length > 0 && normal.dot(otherwise) > 0.5 ? normal : otherwise;
}

}  // namespace

Vec3 curved_corner_normal(const Part& part, int t, int corner) noexcept {
  return corner_normal({part}, t, corner);
}

Points curved_corner_normals(const Part& part) {
  const int n = part.triangle_count();
  std::vector<double> doubled_areas(static_cast<std::size_t>(n));
  tbb::parallel_for(0, n,
                    [&](int t) { doubled_areas[static_cast<std::size_t>(t)] = doubled_face_area(part, t); });
  const Faces faces{part, &doubled_areas};
  Points normals(3, Eigen::Index{3} * n);
  tbb::parallel_for(0, n, [&](int t) {
    for (int k = 0; k < 3; ++k) normals.col(Eigen::Index{3} * t + k) = corner_normal(faces, t, k);
  });
  return normals;
}

}  // namespace fingerpad
