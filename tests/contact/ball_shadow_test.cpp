#include "contact/ball_shadow.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>
#include <vector>

#include "base/random_stream.hpp"
#include "contact/bare_part.hpp"
#include "contact/triangle_tree.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

namespace fingerpad::ball_shadow_test {
namespace {

using Corners = std::array<Vec3, 3>;

/// Some ten roundings of coordinates up to 2, in the shadow's sums and in this test's.
constexpr double rounding_m = 1e-14;

Vec3 random_way(RandomStream& random) {
  return Vec3(random.normal(), random.normal(), random.normal()).normalized();
}

/// From 1 down to 10^-decades, as often in each decade.
double magnitude(RandomStream& random, double decades) {
  return std::pow(10.0, -decades * random.uniform());
}

/// A ball about a place, and a point that it keeps clear of.
struct Stand {
  KeptPoint kept;
  Vec3 place;
  double reach_m;

  Vec3 way() const { return (place - kept.point).normalized(); }
  double least_m() const { return kept.clearance_m - kept.missed_m; }
};

/// Balls from a point's skin to a third of the part; at rest, near by, too near, and far off.
Stand random_stand(RandomStream& random, int i) {
  const double clearance_m = 0.3 * magnitude(random, 7.5);
  Stand s;
  s.kept = {0.3 * random_way(random), clearance_m, i % 3 == 0 ? 0 : clearance_m / 8 * magnitude(random, 6)};
  s.reach_m = i % 7 == 0 ? 0 : clearance_m / 2 * (i % 2 == 0 ? random.uniform() : magnitude(random, 9));
  const double far_m = std::min(20 * clearance_m, 0.5);
  const std::array<double, 5> distances_m{
      clearance_m, s.least_m() + 1e-3 * s.reach_m, s.least_m() + s.reach_m * (2 * random.uniform() - 1),
      clearance_m + s.reach_m * random.uniform(), clearance_m + far_m * random.uniform()};
  s.place = s.kept.point + distances_m[static_cast<std::size_t>(i % 5)] * random_way(random);
  return s;
}

/// The place nearest to `t` of those within reach that keep clear of the point: in the plane of t and the
/// axis it is t itself, or the nearest on one of two circles, or where these meet.
/// @returns  false where there is none
bool nearest_free(const Stand& s, const Vec3& t, Vec3& nearest) {
  const Vec3 n = s.way(), from_c = t - s.kept.point;
  const Vec3 aside = from_c - from_c.dot(n) * n;
  const Vec3 e = aside.norm() > 1e-12 * from_c.norm() ? Vec3(aside.normalized()) : n.unitOrthogonal();
  const double D = (s.place - s.kept.point).norm(), L = s.least_m(), r = s.reach_m;
  std::vector<Vec3> candidates{t, s.place + r * (t - s.place).normalized()};
  if (from_c.norm() > 0) candidates.push_back(s.kept.point + L * from_c.normalized());
  const double height = (D * D + L * L - r * r) / (2 * D);
  if (std::abs(height) <= L)
    candidates.push_back(s.kept.point + height * n + std::sqrt(L * L - height * height) * e);
  double least_m = std::numeric_limits<double>::infinity();
  for (const Vec3& q : candidates) {
    if ((q - s.place).norm() > r + rounding_m / 4 || (q - s.kept.point).norm() < L - rounding_m / 4) continue;
    if ((q - t).norm() >= least_m) continue;
    least_m = (q - t).norm();
    nearest = q;
  }
  return std::isfinite(least_m);
}

/// How near a free ball's centre comes to a triangle: from points all over it towards each other.
double nearest_m(const Stand& s, const Corners& corners) {
  double least_m = std::numeric_limits<double>::infinity();
  const auto look_from = [&](Vec3 t) {
    for (int turn = 0; turn < 3; ++turn) {
      Vec3 q;
      if (!nearest_free(s, t, q)) return;
      double distance_m = 0;
      t = test::brute_closest_on(corners[0], corners[1], corners[2], q, &distance_m);
      least_m = std::min(least_m, distance_m);
    }
  };
  for (const Vec3& corner : corners) look_from(corner);
  look_from((corners[0] + corners[1] + corners[2]) / 3);
  double distance_m = 0;
  for (const Vec3& from : {s.place, s.kept.point})
    look_from(test::brute_closest_on(corners[0], corners[1], corners[2], from, &distance_m));
  return least_m;
}

/// A point within some reach of a ball: beside the kept point near its plane, or anywhere about the place.
Vec3 point_about(const Stand& s, RandomStream& random, int i) {
  const double R = s.kept.clearance_m;
  if (i % 3 == 0) return s.place + 1.5 * R * random.uniform() * random_way(random);
  const Vec3 n = s.way(), beside = n.cross(random_way(random)).normalized();
  // Below the sphere of the clearance about a place straight above, or a little above that.
  const double d = 1.5 * R * magnitude(random, 5), h = d * d / (2 * R) * (1.5 * random.uniform() - 0.2);
  return s.kept.point + d * beside + (i % 3 == 1 ? h : -R * magnitude(random, 8)) * n;
}

/// Any shape: ordinary, slivers, without area; some touch the kept point.
Corners triangle_about(const Stand& s, RandomStream& random, int i) {
  const double size_m = s.kept.clearance_m * magnitude(random, 4);
  const Vec3 a = point_about(s, random, i), flat = s.way().cross(random_way(random)).normalized();
  const Vec3 b = a + size_m * (i % 2 == 0 ? flat : random_way(random));
  switch (i % 5) {
    case 0:
      return {a, b, a};
    case 1:
      return {a, b, a + random.uniform() * (b - a) + 1e-9 * size_m * random_way(random)};
    case 2:
      return {a, b, i % 4 == 0 ? s.kept.point : Vec3(2 * s.kept.point - a)};
    default:
      return {a, b, a + size_m * (i % 4 < 2 ? s.way().cross(flat) : random_way(random))};
  }
}

Corners scaled(const Corners& corners, double scale) {
  return {scale * corners[0], scale * corners[1], scale * corners[2]};
}

TEST(BallShadow, CoversNoTriangleThatAFreeBallComesNear) {
  RandomStream random(1);
  long covered = 0, clear = 0, tight = 0;
  for (int i = 0; i < test::samples(20000); ++i) {
    const Stand s = random_stand(random, i);
    if (!BallShadow::is_cast(s.place, s.reach_m, s.kept)) continue;
    const double scale = i % 2 == 0 ? 1 : 0.25;
    const BallShadow shadow(s.place, s.reach_m, s.kept, scale);
    for (int j = 0; j < 8; ++j) {
      const Corners corners = triangle_about(s, random, j + i);
      const double least_m = nearest_m(s, corners);
      if (least_m >= s.kept.clearance_m) ++clear;
      if (!shadow.covers(scaled(corners, scale))) continue;
      ++covered;
      if (least_m < s.kept.clearance_m * (1 + 1e-2)) ++tight;
      ASSERT_GE(least_m, s.kept.clearance_m - rounding_m)
          << "case " << i << ", triangle " << j << ": " << corners[0].transpose();
    }
  }
  // It leaves out most of what may be left out, and the test looks where it only just may.
  EXPECT_GT(covered, clear / 2);
  EXPECT_GT(tight, test::samples(20000) / 4);
}

TEST(BallShadow, CoversNothingBetweenAFarPlaceAndThePoint) {
  RandomStream random(2);
  for (int i = 0; i < test::samples(20000); ++i) {
    Stand s;
    s.kept = {0.3 * random_way(random), 0.01, 0};
    s.place = s.kept.point + 0.1 * random_way(random);
    s.reach_m = 0.004 * random.uniform();
    ASSERT_TRUE(BallShadow::is_cast(s.place, s.reach_m, s.kept));
    // Its corners' sum stands on the axis, so that which way it is beside that is rounding alone.
    const Vec3 middle = s.place - 0.009 * s.way(), e = 0.003 * s.way().cross(random_way(random));
    const Vec3 f = s.way().cross(e);
    const Corners corners{middle + e, middle - e / 2 + f, middle - e / 2 - f};
    ASSERT_FALSE(BallShadow(s.place, s.reach_m, s.kept, 1).covers(corners)) << "case " << i;
  }
}

TEST(BallShadow, IsCastOnlyWhereAFreePlaceIsWithinReach) {
  const Vec3 place(0, 0, 1);
  EXPECT_TRUE(BallShadow::is_cast(place, 0.1, {Vec3::Zero(), 1, 0}));
  EXPECT_TRUE(BallShadow::is_cast(place, 0.1, {Vec3::Zero(), 1.05, 0}));
  EXPECT_TRUE(BallShadow::is_cast(place, 0, {Vec3::Zero(), 1.05, 0.1}));
  EXPECT_FALSE(BallShadow::is_cast(place, 0.1, {Vec3::Zero(), 1.2, 0}));
  EXPECT_FALSE(BallShadow::is_cast(place, -0.1, {Vec3::Zero(), 0.8, 0}));
  EXPECT_FALSE(BallShadow::is_cast(place, 0.1, {Vec3::Zero(), 1, 1.5}));
  EXPECT_FALSE(BallShadow::is_cast(place, 0.1, {place, 1, 0}));
}

/// Eight triangles: in a plane, bent, or any; small ones and one that is larger.
Part patch(RandomStream& random, const Stand& s, int i) {
  Points vertices(3, 3 * packet_width);
  IndexTriples triangles(3, packet_width);
  const double size_m = s.kept.clearance_m * magnitude(random, 4),
               bend = i % 2 == 0 ? 0 : magnitude(random, 9);
  const Vec3 at = point_about(s, random, i);
  const Vec3 z = i % 5 < 3 ? s.way() : random_way(random), x = z.cross(random_way(random)).normalized();
  for (int t = 0; t < packet_width; ++t) {
    for (int k = 0; k < 3; ++k) {
      const double u = random.uniform() - 0.5, v = random.uniform() - 0.5;
      const double w = i % 7 == 6 ? random.uniform() - 0.5 : bend * (u * u - v * v);
      vertices.col(3 * t + k) = at + size_m * (u * x + v * z.cross(x) + w * z);
    }
    if (t % 4 == 3) vertices.col(3 * t + 2) = vertices.col(3 * t + 1);
    triangles.col(t) << 3 * t, 3 * t + 1, 3 * t + 2;
  }
  Part part = test::bare_part(vertices, triangles);
  part.half_extent = Vec3::Ones();
  return part;
}

constexpr std::int32_t all_lanes[] = {0, 1, 2, 3, 4, 5, 6, 7};

TEST(BallShadow, CoversNoPacketThatAFreeBallComesNear) {
  RandomStream random(3);
  long covered = 0;
  for (int i = 0; i < test::samples(20000); ++i) {
    const Stand s = random_stand(random, i);
    if (!BallShadow::is_cast(s.place, s.reach_m, s.kept)) continue;
    constexpr double scale = 0.5;
    const Part part = patch(random, s, i / 5);
    if (!BallShadow(s.place, s.reach_m, s.kept, scale).covers(make_packet(part, all_lanes, scale))) continue;
    ++covered;
    for (int t = 0; t < packet_width; ++t) {
      const Corners corners{part.vertices.col(3 * t), part.vertices.col(3 * t + 1),
                            part.vertices.col(3 * t + 2)};
      ASSERT_GE(nearest_m(s, corners), s.kept.clearance_m - rounding_m) << "case " << i << ", triangle " << t;
    }
  }
  EXPECT_GT(covered, test::samples(20000) / 8);
}

TEST(TrianglePacket, NoCornerStandsHigherThanItSays) {
  RandomStream random(4);
  double flattest = 1;
  for (int i = 0; i < test::samples(20000); ++i) {
    const Stand s = random_stand(random, i);
    Part part = patch(random, s, i);
    if (i % 4 == 0) {  // needles along their own mean normal, so that they are as thick as they are long
      const Vec3 up = random_way(random);
      for (int k = 1; k < 3 * packet_width; ++k)
        part.vertices.col(k) = part.vertices.col(0) + 0.1 * k * k * up;
    }
    const TrianglePacket packet = make_packet(part, all_lanes, 0.5);
    const Vec3 across = Vec3(packet.across[0], packet.across[1], packet.across[2]).normalized();
    for (int j = 0; j < 6; ++j) {
      const Vec3 way = j == 0  ? across
                       : j < 3 ? Vec3((across + magnitude(random, 9) * random_way(random)).normalized())
                       : j < 5 ? random_way(random)
                               : Vec3((part.vertices.col(23) / 2 - packet.origin).normalized());
      double highest = 0;
      for (Eigen::Index k = 0; k < part.vertices.cols(); ++k)
        highest = std::max(highest, way.dot(part.vertices.col(k) / 2 - packet.origin));
      ASSERT_GE(packet.highest(way), highest - 1e-16) << "case " << i << ", way " << j;
      if (j == 0) flattest = std::min(flattest, packet.highest(way) / static_cast<double>(packet.radius));
    }
  }
  EXPECT_LT(flattest, 1e-4);  // else a flat packet would be taken for a ball
}

TEST(TriangleTree, LeavesOutWhatStandsInTheShadowAndNoMore) {
  RandomStream random(5);
  const auto list = [](void* found, int triangle) { static_cast<std::set<int>*>(found)->insert(triangle); };
  for (const TriangleSoup& soup : {test::torus_soup(1, 0.4, 120, 80), test::square_soup(2, 90)}) {
    const auto part = std::make_shared<const Part>(make_part(soup, 0.5));
    const TriangleTree tree(part);
    long left_out = 0, seen = 0;
    for (int i = 0; i < test::samples(100); ++i) {
      Stand s;
      const double clearance_m = 0.3 * random.uniform() + 0.05;
      const Vec3 from = random_way(random).cwiseProduct(Vec3(1, 1, 0.5));
      const Vec3 point = tree.closest(from, -1, 10).at.point;
      s.kept = {point, clearance_m, 1e-9};
      s.place = point + clearance_m * (from - point).normalized();
      s.reach_m = clearance_m / 16 * random.uniform();
      const double reach_m = clearance_m + s.reach_m;
      std::set<int> all, lit;
      tree.each_within(s.place, reach_m, list, &all);
      SearchLimit limit{1 << 20, 1 << 20};
      ASSERT_TRUE(tree.each_within(s.place, reach_m, &s.kept, limit, list, &lit));
      seen += static_cast<long>(lit.size());
      for (const int t : lit) ASSERT_TRUE(all.contains(t));
      for (const int t : all) {
        if (lit.contains(t)) continue;
        ++left_out;
        Corners corners;
        for (int k = 0; k < 3; ++k)
          corners[static_cast<std::size_t>(k)] = part->vertices.col(part->triangles(k, t));
        ASSERT_GE(nearest_m(s, corners), clearance_m - rounding_m) << "case " << i << ", triangle " << t;
      }
    }
    EXPECT_GT(left_out, seen / 4);
  }
}

}  // namespace
}  // namespace fingerpad::ball_shadow_test
