#include "contact/curved_normals.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/smoothstep.hpp"
#include "base/unit_vector.hpp"
#include "contact/fan_shape.hpp"

namespace fingerpad {
namespace {

/// By how much an edge's curvature at its one end differs from that at its other, of the largest there: below
/// `even` both ends are of one surface, above `uneven` of two, as a fillet's and its face's are, or too rough
/// to tell.
constexpr double even = 0.2, uneven = 0.4;
/// Two normals that differ by less are one [rad].
constexpr double alike_rad = 1e-6;

/// What the fans of a part share, in tables, or reckoned where it is asked for: to the same bits.
struct FanTables {
  FaceAreas areas;
  const std::vector<int>* lowest = nullptr;  ///< of each corner's fan the lowest corner, -1 where none
  const Points* round_normals = nullptr;     ///< of each fan, by its lowest corner

  Vec3 round_normal(PartCorner at) const noexcept;  ///< zero where there is none
};

/// How unlike the fan's edges are curved at their two ends, where the normals are round ones: the largest
/// difference over edges of facets that count, of the largest curvature.
double unevenness(const FanTables& shared, std::span<const FanFacet> fan, const FanShape& shape) noexcept {
  double largest = 0, differ = 0;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    for (const int k : {1, 2}) {
      const Vec3& edge = k == 1 ? fan[i].first : fan[i].second;
      const double length2 = edge.squaredNorm();
      if (!(length2 > 0)) continue;
      const PartCorner end{fan[i].at.triangle, (fan[i].at.corner + k) % 3};
      const double here = -2 * shape.round_normal.dot(edge) / length2,
                   there = 2 * shared.round_normal(end).dot(edge) / length2;
      largest = std::max(largest, shape.counts[i] * std::max(std::abs(here), std::abs(there)));
      differ = std::max(differ, shape.counts[i] * std::abs(here - there));
    }
  }
  return largest > 0 ? differ / largest : 0;
}

/// Of the fan with this lowest corner. Part::corner_normals where it gives nothing, folded upon itself, or
/// one that is turned off that by over 60 degrees.
Vec3 fan_normal(const FanTables& shared, PartCorner lowest) noexcept {
  const Part& part = shared.areas.part;
  const Vec3 otherwise = part.corner_normals.col(lowest.column());
  SmoothFan fan;
  if (!fan.gather(part, lowest)) return otherwise;
  const FanShape shape = fan_shape(shared.areas, fan.facets());
  Vec3 normal = shape.wide_normal;
  if ((shape.wide_normal - shape.round_normal).norm() > alike_rad) {
    const double round = smoothstep(uneven, even, unevenness(shared, fan.facets(), shape));
    normal = unit_or_zero((1 - round) * shape.wide_normal + round * shape.round_normal);
  }
  return normal.dot(otherwise) > 0.5 ? normal : otherwise;
}

Vec3 fan_round_normal(const FaceAreas& areas, PartCorner lowest) noexcept {
  SmoothFan fan;
  return fan.gather(areas.part, lowest) ? fan_shape(areas, fan.facets()).round_normal : Vec3::Zero();
}

Vec3 FanTables::round_normal(PartCorner at) const noexcept {
  if (round_normals != nullptr) {
    const int fan = (*lowest)[static_cast<std::size_t>(at.column())];
    return fan < 0 ? Vec3::Zero() : Vec3(round_normals->col(fan));
  }
  const auto fan = SmoothFan::lowest(areas.part, at);
  return fan ? fan_round_normal(areas, *fan) : Vec3::Zero();
}

/// Of each corner the lowest of its fan, -1 where there is none.
std::vector<int> lowest_corners(const Part& part) {
  std::vector<int> lowest(3 * static_cast<std::size_t>(part.triangle_count()));
  tbb::parallel_for(std::size_t{0}, lowest.size(), [&](std::size_t i) {
    const int at = static_cast<int>(i);
    const auto found = SmoothFan::lowest(part, {at / 3, at % 3});
    lowest[i] = found ? static_cast<int>(found->column()) : -1;
  });
  // In a mesh whose neighbours are not each other's a corner may not be reached from its lowest one.
  for (int& at : lowest)
    if (at >= 0 && lowest[static_cast<std::size_t>(at)] != at) at = -1;
  return lowest;
}

}  // namespace

Vec3 curved_corner_normal(const Part& part, int t, int corner) noexcept {
  const PartCorner at{t, corner};
  const auto lowest = SmoothFan::lowest(part, at);
  return lowest ? fan_normal({{part}}, *lowest) : Vec3(part.corner_normals.col(at.column()));
}

Points curved_corner_normals(const Part& part) {
  const int n = part.triangle_count();
  std::vector<double> face_areas(static_cast<std::size_t>(n));
  tbb::parallel_for(0, n,
                    [&](int t) { face_areas[static_cast<std::size_t>(t)] = doubled_face_area_m2(part, t); });
  const std::vector<int> lowest = lowest_corners(part);
  const auto each_fan = [&](const auto& make) {
    tbb::parallel_for(0, 3 * n, [&](int i) {
      if (lowest[static_cast<std::size_t>(i)] == i) make(i);
    });
  };
  Points rounds(3, Eigen::Index{3} * n);
  const FaceAreas areas{part, &face_areas};
  each_fan([&](int i) { rounds.col(i) = fan_round_normal(areas, {i / 3, i % 3}); });
  const FanTables tables{areas, &lowest, &rounds};
  Points normals(3, Eigen::Index{3} * n);
  each_fan([&](int i) { normals.col(i) = fan_normal(tables, {i / 3, i % 3}); });
  tbb::parallel_for(0, 3 * n, [&](int i) {
    const int from = lowest[static_cast<std::size_t>(i)];
    if (from < 0)
      normals.col(i) = part.corner_normals.col(i);
    else if (from != i)
      normals.col(i) = normals.col(from);
  });
  return normals;
}

}  // namespace fingerpad
