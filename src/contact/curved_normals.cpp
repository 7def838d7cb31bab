#include "contact/curved_normals.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
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

/// A fan's round normal (fan_shape.hpp), zero where there is none, and whether the fan is closed. An open
/// fan's leans towards its facets.
struct RoundNormal {
  Vec3 normal = Vec3::Zero();
  bool is_closed = false;
};

/// What the fans of a part share, in tables, or reckoned where it is asked for: to the same bits.
struct FanTables {
  FaceAreas areas;
  const std::vector<int>* lowest = nullptr;  ///< of each corner's fan the lowest corner, -1 where none
  const std::vector<RoundNormal>* rounds = nullptr;  ///< of each fan, by its lowest corner
  const Points* inners = nullptr;                    ///< likewise

  RoundNormal round_normal(PartCorner at) const noexcept;
  Vec3 inner_normal(PartCorner at) const noexcept;  ///< of a closed fan, zero of any other
};

/// How unlike the fan's edges are curved at their two ends, where the normals are round ones: the largest
/// difference over edges of facets that count, of the largest curvature. A closed fan's edges to an open one,
/// whose round normal leans, tell nothing; where the others are curved by less than half as much as these, as
/// on a strip of a cylinder between two rims, nothing is told: then it is 1.
double unevenness(const FanTables& shared, const SmoothFan& around, const FanShape& shape) noexcept {
  const std::span<const FanFacet> fan = around.facets();
  constexpr double least_told = 0.5;
  double largest = 0, told = 0, differ = 0;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    for (const int k : {1, 2}) {
      const Vec3& edge = k == 1 ? fan[i].first : fan[i].second;
      const double length2 = edge.squaredNorm();
      if (!(length2 > 0)) continue;
      const PartCorner end{fan[i].at.triangle, (fan[i].at.corner + k) % 3};
      const RoundNormal at_end = shared.round_normal(end);
      const double here = -2 * shape.round_normal.dot(edge) / length2,
                   there = 2 * at_end.normal.dot(edge) / length2;
      largest = std::max(largest, shape.counts[i] * std::abs(here));
      if (around.is_closed() && !at_end.is_closed) continue;
      told = std::max(told, shape.counts[i] * std::max(std::abs(here), std::abs(there)));
      differ = std::max(differ, shape.counts[i] * std::abs(here - there));
    }
  }
  if (!(told > least_told * largest)) return largest > 0 ? 1 : 0;
  return differ / told;
}

/// By its own facets alone.
Vec3 own_normal(const FanTables& shared, const SmoothFan& fan, const FanShape& shape) noexcept {
  if ((shape.wide_normal - shape.round_normal).norm() <= alike_rad) return shape.wide_normal;
  const double round = smoothstep(uneven, even, unevenness(shared, fan, shape));
  return unit_or_zero((1 - round) * shape.wide_normal + round * shape.round_normal);
}

/// Of a closed fan; zero of any other.
Vec3 fan_inner_normal(const FanTables& shared, PartCorner lowest) noexcept {
  SmoothFan fan;
  if (!fan.gather(shared.areas.part, lowest) || !fan.is_closed()) return Vec3::Zero();
  return own_normal(shared, fan, fan_shape(shared.areas, fan.facets()));
}

/// What the closed fan at a corner says of the open ones beside it.
struct Beside {
  Vec3 normal = Vec3::Zero();  ///< zero: nothing
  double unsure = 0;  ///< the distance between its wide normal and its round one: the second is right on a
                      ///< sphere, along a cylinder's axis the first
  double trust = 0;   ///< 0 .. 1, 0 where its edges are curved unlike at their ends: beside a flat strip that
                      ///< ends there it is turned half into the fillet on its other side
};

Beside beside_rim(const FanTables& shared, PartCorner at) noexcept {
  const auto lowest = SmoothFan::lowest(shared.areas.part, at);
  SmoothFan fan;
  if (!lowest || !fan.gather(shared.areas.part, *lowest) || !fan.is_closed()) return {};
  const FanShape shape = fan_shape(shared.areas, fan.facets());
  return {shared.inner_normal(at), (shape.wide_normal - shape.round_normal).norm(),
          smoothstep(even, even / 2, unevenness(shared, fan, shape))};
}

/// Whether a normal leans off none of a fan's facets by more than others of it do.
bool leans_as_facets_do(std::span<const FanFacet> fan, const Vec3& normal) noexcept {
  return std::ranges::all_of(fan, [&](const FanFacet& facet) {
    double most = 0;
    for (const FanFacet& other : fan) most = std::max(most, (facet.normal - other.normal).norm());
    return (facet.normal - normal).norm() <= most;
  });
}

/// The normal n of an open fan, whose own leans towards its facets, all on one side of the vertex. Along an
/// edge e to a vertex whose fan is closed, with normal m, an arc of a circle has (n + m) e = 0: n is the own
/// normal with the least turn that comes nearest to that, in least squares over such edges. What an m is
/// unsure of is not taken for a lack, nor is what it is not trusted with, and the turn is no larger than such
/// normals differ from the own, nor than lets it lean as the facets do (Proxy promises that of what it
/// shades).
/// @param normal  own_normal
Vec3 rim_normal(const FanTables& shared, std::span<const FanFacet> fan, const Vec3& normal) noexcept {
  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  Eigen::Matrix2d sums = Eigen::Matrix2d::Zero();
  Eigen::Vector2d lacks = Eigen::Vector2d::Zero();
  double most = 0;
  for (const FanFacet& facet : fan) {
    for (const int k : {1, 2}) {
      const Beside inner = beside_rim(shared, {facet.at.triangle, (facet.at.corner + k) % 3});
      const Vec3& edge = k == 1 ? facet.first : facet.second;
      const double length = edge.norm();
      if (inner.normal.isZero() || !(length > 0)) continue;
      const Eigen::Vector2d along = Eigen::Vector2d(edge.dot(u), edge.dot(v)) / length;
      sums += along * along.transpose();
      const double lack = -(normal + inner.normal).dot(edge) / length;
      lacks += inner.trust * std::copysign(std::max(0.0, std::abs(lack) - inner.unsure), lack) * along;
      most = std::max(most, (normal - inner.normal).norm());
    }
  }
  // Across a single edge, or several that are nearly one, nothing is said.
  constexpr double one_way = 0.02, two_ways = 0.1;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> ways(sums);
  const Eigen::Vector2d& said = ways.eigenvalues();
  if (!(said[1] > 0)) return normal;
  Eigen::Vector2d turn = ways.eigenvectors().col(1).dot(lacks) / said[1] * ways.eigenvectors().col(1);
  const double across = smoothstep(one_way, two_ways, said[0] / said[1]);
  if (across > 0)
    turn += across * ways.eigenvectors().col(0).dot(lacks) / said[0] * ways.eigenvectors().col(0);
  const Vec3 whole = (turn.norm() > most ? most / turn.norm() : 1) * (turn[0] * u + turn[1] * v);
  const auto turned = [&](double share) -> Vec3 { return unit_or_zero(normal + share * whole); };
  if (leans_as_facets_do(fan, turned(1))) return turned(1);
  double share = 0;
  for (double step = 0.5; step > 1e-6; step /= 2)
    if (leans_as_facets_do(fan, turned(share + step))) share += step;
  return turned(share);
}

/// By all that is known of the fan; zero where that is nothing.
Vec3 told_normal(const FanTables& shared, PartCorner lowest) noexcept {
  const Vec3 inner = shared.inner_normal(lowest);
  if (!inner.isZero()) return inner;
  SmoothFan fan;
  if (!fan.gather(shared.areas.part, lowest)) return Vec3::Zero();
  const Vec3 own = own_normal(shared, fan, fan_shape(shared.areas, fan.facets()));
  return fan.is_closed() || own.isZero() ? own : rim_normal(shared, fan.facets(), own);
}

/// Of the fan with this lowest corner. Part::corner_normals where it gives nothing, folded upon itself, or
/// one that is turned off that by over 60 degrees.
Vec3 fan_normal(const FanTables& shared, PartCorner lowest) noexcept {
  const Vec3 otherwise = shared.areas.part.corner_normals.col(lowest.column());
  const Vec3 normal = told_normal(shared, lowest);
  return normal.dot(otherwise) > 0.5 ? normal : otherwise;
}

RoundNormal fan_round_normal(const FaceAreas& areas, PartCorner lowest) noexcept {
  SmoothFan fan;
  if (!fan.gather(areas.part, lowest)) return {};
  return {fan_shape(areas, fan.facets()).round_normal, fan.is_closed()};
}

RoundNormal FanTables::round_normal(PartCorner at) const noexcept {
  if (rounds != nullptr) {
    const int fan = (*lowest)[static_cast<std::size_t>(at.column())];
    return fan < 0 ? RoundNormal() : (*rounds)[static_cast<std::size_t>(fan)];
  }
  const auto fan = SmoothFan::lowest(areas.part, at);
  return fan ? fan_round_normal(areas, *fan) : RoundNormal();
}

Vec3 FanTables::inner_normal(PartCorner at) const noexcept {
  if (inners != nullptr) {
    const int fan = (*lowest)[static_cast<std::size_t>(at.column())];
    return fan < 0 ? Vec3::Zero() : Vec3(inners->col(fan));
  }
  const auto fan = SmoothFan::lowest(areas.part, at);
  return fan ? fan_inner_normal(*this, *fan) : Vec3::Zero();
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
  std::vector<RoundNormal> rounds(3 * static_cast<std::size_t>(n));
  const FaceAreas areas{part, &face_areas};
  each_fan([&](int i) { rounds[static_cast<std::size_t>(i)] = fan_round_normal(areas, {i / 3, i % 3}); });
  FanTables tables{areas, &lowest, &rounds};
  Points inners(3, Eigen::Index{3} * n);
  each_fan([&](int i) { inners.col(i) = fan_inner_normal(tables, {i / 3, i % 3}); });
  tables.inners = &inners;
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
