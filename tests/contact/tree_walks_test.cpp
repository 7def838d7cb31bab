#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/random_stream.hpp"
#include "contact/closest_memory.hpp"
#include "contact/segment_crossing.hpp"
#include "contact/triangle_approach.hpp"
#include "contact/triangle_tree.hpp"
#include "support/shapes.hpp"

// Searches that are bounded or in pieces, against those that are neither.

namespace fingerpad::tree_walks_test {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

std::vector<TriangleTree> trees() {
  std::vector<TriangleTree> trees;
  for (const TriangleSoup& soup :
       {test::box_soup(Vec3(1, 2, 3)), test::torus_soup(1, 0.4, 60, 40), test::sphere_soup(0.7, 4)})
    trees.emplace_back(std::make_shared<const Part>(make_part(soup, 0.5)));
  return trees;
}

Vec3 any(RandomStream& random, double scale) {
  return scale * Vec3(random.normal(), random.normal(), random.normal());
}

void add(void* list, int t) {
  static_cast<std::vector<int>*>(list)->push_back(t);
}

std::vector<int> all_within(const TriangleTree& tree, const Vec3& q, double reach_m) {
  std::vector<int> found;
  tree.each_within(q, reach_m, add, &found);
  std::sort(found.begin(), found.end());
  return found;
}

TEST(TreeWalks, FindTheSameTrianglesInPiecesAsAtOnce) {
  RandomStream random(5);
  for (const TriangleTree& tree : trees()) {
    for (int k = 0; k < 100; ++k) {
      const Vec3 q = any(random, k % 10 == 0 ? 3e4 : 1);
      const double reach_m = k % 3 == 0 ? unbounded : q.norm() - 1 + random.uniform();
      std::vector<int> found;
      std::size_t next = 0;
      int pieces = 1;
      Looks looks(k % 2 == 0 ? 1 : 50);
      while (!tree.each_within(q, reach_m, next, looks, nullptr, add, &found)) {
        ASSERT_LE(looks.spent(), 50 + 300) << "a packet too many at most, and the clusters on the way to it";
        looks.renew();
        ++pieces;
      }
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, all_within(tree, q, reach_m));
      if (found.size() > 100) {
        EXPECT_GT(pieces, 1);
      }
    }
  }
}

TEST(TreeWalks, FindAllThatAWayComesNearInPieces) {
  RandomStream random(15);
  for (const TriangleTree& tree : trees()) {
    long near = 0, passed_on = 0;
    for (int k = 0; k < 200; ++k) {
      const Vec3 q = any(random, 1), way = any(random, std::pow(0.1, k % 5));
      const double reach_m = 0.1 * random.uniform();
      std::vector<int> found;
      std::size_t next = 0;
      Looks looks(50);
      while (!tree.each_beside(q, way, reach_m, next, looks, nullptr, add, &found)) looks.renew();
      std::sort(found.begin(), found.end());
      ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "each once";
      passed_on += static_cast<long>(found.size());
      for (int i = 0; i <= 20; ++i) {
        const std::vector<int> here = all_within(tree, q + i / 20.0 * way, reach_m);
        ASSERT_TRUE(std::includes(found.begin(), found.end(), here.begin(), here.end())) << k;
        near += static_cast<long>(here.size());
      }
    }
    EXPECT_GT(near, 100);
    EXPECT_LT(passed_on, 200L * tree.part().triangle_count() / 4 + 1200) << "and few others";
  }
}

TEST(TreeWalks, FindTheClosestTriangleAmongTheNearestPackets) {
  RandomStream random(16);
  for (const TriangleTree& tree : trees()) {
    for (int k = 0; k < 200; ++k) {
      const Vec3 q = any(random, 1);
      const double reach_m = k % 5 == 0 ? 0.3 : unbounded;
      const ClosestTriangle closest = tree.closest(q, -1, reach_m);
      Looks all(Looks::unlimited), few(200);
      const ClosestTriangle found = tree.about_closest(q, -1, reach_m, tree.part().triangle_count(), all);
      ASSERT_EQ(found.triangle, closest.triangle) << k;
      ASSERT_EQ(found.at.distance2_m2, closest.at.distance2_m2);
      const ClosestTriangle about = tree.about_closest(q, -1, reach_m, 2, few);
      EXPECT_LE(few.spent(), 200 + 100) << "a packet too many at most, and the clusters on the way to it";
      if (about.triangle < 0) continue;
      ASSERT_GE(about.at.distance2_m2, closest.at.distance2_m2);
      ASSERT_EQ(about.at.distance2_m2, closest_on_triangle(tree.part(), about.triangle, q).distance2_m2);
    }
  }
}

/// How far along a segment it goes through a triangle, from either side; infinite where it does not.
double crossing_of(const Part& part, int t, const SegmentCrossing& segment) {
  const TriangleCorners f = corners_of(part, t);
  return std::min(segment.entry(f.a, f.b, f.c), segment.entry(f.a, f.c, f.b));
}

TEST(TreeWalks, FindAboutWhatAWayMeetsFirst) {
  RandomStream random(17);
  for (const TriangleTree& tree : trees()) {
    const Part& part = tree.part();
    int met = 0, cut_short = 0;
    for (int k = 0; k < 2000; ++k) {
      const Vec3 from = any(random, 1), to = any(random, k % 2 == 0 ? 1 : 0.2);
      const SegmentCrossing segment(from, to);
      double first = unbounded;
      for (int t = 0; t < part.triangle_count(); ++t) first = std::min(first, crossing_of(part, t, segment));
      Looks looks(Looks::unlimited);
      const TriangleMet found = tree.about_first_met(from, to - from, looks);
      // By rounding a neighbour may be told that the way passes by, within about as much.
      constexpr double rounding = 1e-4;
      ASSERT_EQ(found.triangle >= 0, first < unbounded) << k;
      if (found.triangle < 0) continue;
      ++met;
      ASSERT_NEAR(found.along, first, rounding) << k;
      const Vec3 at = from + found.along * (to - from);
      ASSERT_LT(std::sqrt(closest_on_triangle(part, found.triangle, at).distance2_m2), rounding) << k;
      Looks few(30);
      tree.about_first_met(from, to - from, few);
      EXPECT_LE(few.spent(), 30 + 300) << "a packet too many at most, and the clusters on the way to it";
      cut_short += few.spent() < looks.spent() ? 1 : 0;
    }
    EXPECT_GT(met, 300);
    if (part.triangle_count() > 100) {
      EXPECT_GT(cut_short, met / 2);
    }
  }
}

TEST(TreeWalks, FindNothingOnAWayFromNowhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const TriangleTree& tree : trees()) {
    Looks looks(Looks::unlimited);
    EXPECT_LT(tree.about_first_met(Vec3(nan, 0, 0), Vec3(1, 0, 0), looks).triangle, 0);
    EXPECT_LT(tree.about_first_met(Vec3(0, 0, 5), Vec3(0, 0, unbounded), looks).triangle, 0);
    EXPECT_LT(tree.about_first_met(Vec3(0, 0, 1e30), Vec3(0, 0, 1), looks).triangle, 0);
    EXPECT_LT(tree.about_first_met(Vec3(0, 0, 5), Vec3::Zero(), looks).triangle, 0);
    const TriangleCorners f = corners_of(tree.part(), 0);
    EXPECT_LT(tree.about_first_met(f.a, 0.1 * (f.b - f.a), looks).triangle, tree.part().triangle_count())
        << "in its own plane: whatever is told";
    EXPECT_EQ(tree.about_first_met((f.a + f.b + f.c) / 3 + 1e-3 * f.normal, -2e-3 * f.normal, looks).triangle,
              0);
  }
}

TEST(TreeWalks, FindTheSameClosestTriangleInPiecesAsAtOnce) {
  RandomStream random(6);
  for (const TriangleTree& tree : trees()) {
    ClosestTriangle last;
    for (int k = 0; k < 200; ++k) {
      // Among them the middle, from where a sphere's triangles are all as near.
      const Vec3 q = k % 20 == 0 ? Vec3::Zero() : any(random, k % 3 == 0 ? 0.1 : 1);
      const double reach_m = k % 5 == 0 ? 0.3 : unbounded;
      const ClosestTriangle at_once = tree.closest(q, -1, reach_m);
      ClosestWalk walk{k % 2 == 0 ? -1 : last.triangle, 0};
      Looks looks(k % 4 == 0 ? 1 : 40);
      auto in_pieces = tree.closest(q, reach_m, walk, looks);
      for (int piece = 0; !in_pieces; ++piece) {
        ASSERT_LT(piece, tree.part().triangle_count());
        looks.renew();
        in_pieces = tree.closest(q, reach_m, walk, looks);
      }
      ASSERT_EQ(in_pieces->triangle, at_once.triangle) << k;
      ASSERT_EQ(in_pieces->at.distance2_m2, at_once.at.distance2_m2);
      looks.renew();
      const auto again = tree.closest(q, reach_m, walk, looks);
      ASSERT_TRUE(again);
      ASSERT_EQ(again->triangle, at_once.triangle) << "asked again after its end";
      last = at_once;
    }
  }
}

TEST(TreeWalks, TellTheSameInsideInPiecesAsAtOnce) {
  RandomStream random(9);
  int inside = 0;
  for (const TriangleTree& tree : trees()) {
    for (int k = 0; k < 100; ++k) {
      const Vec3 q = any(random, 0.6);
      WindingWalk walk;
      Looks looks(k % 2 == 0 ? 1 : 100);
      auto in_pieces = tree.encloses(q, walk, looks);
      for (int piece = 0; !in_pieces; ++piece) {
        ASSERT_LT(piece, 4 * tree.part().triangle_count());
        looks.renew();
        in_pieces = tree.encloses(q, walk, looks);
      }
      ASSERT_EQ(*in_pieces, tree.encloses(q));
      inside += *in_pieces ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 30);
}

TEST(TreeWalks, ABriefSearchWithAMemoryOfItsPathAnswersAsWithout) {
  const TriangleTree tree(std::make_shared<const Part>(make_part(test::sphere_soup(0.7, 4), 0.5)));
  for (const double reach_m : {0.02, unbounded}) {
    ClosestMemory memory;
    int listed = 0, found = 0;
    for (int k = 0; k < 2000; ++k) {
      const double angle = 1e-3 * k, height_m = 0.7 + 0.03 * std::sin(20 * angle);
      const Vec3 q(height_m * std::cos(angle), height_m * std::sin(angle), 0.1);
      BriefSearch brief{1000000, -1, &memory};
      const ClosestTriangle answer = tree.closest(q, brief, reach_m);
      const ClosestTriangle plain = tree.closest(q, -1, reach_m);
      ASSERT_EQ(answer.triangle, plain.triangle) << k;
      ASSERT_EQ(answer.at.distance2_m2, plain.at.distance2_m2) << k;
      listed += memory.packet_count() > 0 ? 1 : 0;
      found += answer.triangle >= 0 ? 1 : 0;
    }
    EXPECT_GT(listed, 500);
    EXPECT_GT(found, 300);
  }
}

TEST(TreeWalks, ABriefSearchAnswersWithTheClosestOfWhatItLookedAt) {
  const TriangleTree tree(std::make_shared<const Part>(make_part(test::sphere_soup(0.7, 4), 0.5)));
  RandomStream random(7);
  int same = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec3 q = k % 10 == 0 ? Vec3::Zero() : any(random, 0.5);
    const ClosestTriangle exact = tree.closest(q, -1, unbounded);
    BriefSearch brief{100}, ample{1000000};
    const ClosestTriangle found = tree.closest(q, brief, unbounded);
    ASSERT_GE(found.triangle, 0);
    EXPECT_EQ(found.at.distance2_m2, closest_on_triangle(tree.part(), found.triangle, q).distance2_m2);
    EXPECT_GE(found.at.distance2_m2, exact.at.distance2_m2);
    same += found.triangle == exact.triangle ? 1 : 0;
    EXPECT_EQ(tree.closest(q, ample, unbounded).triangle, exact.triangle);
    EXPECT_EQ(tree.closest(Vec3(9, 0, 0), brief, 0.1).triangle, -1) << "out of reach";
  }
  EXPECT_GT(same, 100);
  EXPECT_LT(same, 200) << "100 looks are too few for the middle";
}

/// Whatever is broken off tells about how far the part is: else a finger in its hole would be far inside.
TEST(TreeWalks, ABriefSearchFromNothingBeginsNearTheAnswer) {
  const TriangleTree tree(
      std::make_shared<const Part>(make_part(test::torus_soup(0.06, 0.025, 400, 200), 0.5)));
  RandomStream random(17);
  for (int k = 0; k < 200; ++k) {
    const double angle = 6.3 * random.uniform(), out_m = 0.03 * random.uniform();
    const Vec3 q(out_m * std::cos(angle), out_m * std::sin(angle), 0.03 * random.uniform() - 0.015);
    BriefSearch brief{400};
    const ClosestTriangle found = tree.closest(q, brief, unbounded), exact = tree.closest(q, -1, unbounded);
    EXPECT_LT(found.at.distance2_m2, 2 * exact.at.distance2_m2) << q.transpose();
  }
}

TEST(TreeWalks, FromTheMiddleOfAFineBallTheNearestPacketsCostNoMoreThanTheLooks) {
  const TriangleTree tree(std::make_shared<const Part>(make_part(test::sphere_soup(0.02, 6), 0.5)));
  RandomStream random(18);
  for (int k = 0; k < 50; ++k) {
    Looks looks(200);
    const Vec3 q = k == 0 ? Vec3::Zero() : any(random, 1e-3);
    EXPECT_GE(tree.about_closest(q, -1, unbounded, 8, looks).triangle, 0);
    // The last packet, and the way down to it.
    EXPECT_LE(looks.spent(), 200 + LookCosts::closest + LookCosts::passed_over + LookCosts::opened * 30);
  }
}

TEST(TreeWalks, FromTheMiddleOfAFineBallAHintIsHadForFewLooks) {
  const TriangleTree tree(std::make_shared<const Part>(make_part(test::sphere_soup(0.02, 6), 0.5)));
  RandomStream random(19);
  for (int k = 0; k < 50; ++k) {
    Looks looks(Looks::unlimited);
    constexpr int most_packets = 40;
    EXPECT_GE(tree.about_closest(any(random, 1e-4), -1, unbounded, most_packets, looks).triangle, 0);
    EXPECT_LE(looks.spent(),
              300 * (LookCosts::opened + LookCosts::passed_over) + (most_packets + 1) * LookCosts::closest);
  }
}

/// From (0, 0, 0) to a circle of 1 m.
TriangleSoup fan_soup(int slivers) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, slivers + 1);
  soup.triangles.resize(3, slivers);
  soup.vertices_P.col(slivers).setZero();
  for (int k = 0; k < slivers; ++k) {
    const double angle = 2 * std::numbers::pi * k / slivers;
    soup.vertices_P.col(k) = Vec3(std::cos(angle), std::sin(angle), 0);
    soup.triangles.col(k) << k, (k + 1) % slivers, slivers;
  }
  return soup;
}

TEST(TreeWalks, WhatAWayMeetsFirstIsTakenFromNoMoreThanAFewHundredPackets) {
  const TriangleTree tree(std::make_shared<const Part>(make_part(fan_soup(1 << 14), 0.5)));
  const auto met = [&tree](double from_middle) {
    Looks looks(Looks::unlimited);
    const TriangleMet found = tree.about_first_met(Vec3(from_middle, 0, 0.1), Vec3(0, 0, -0.2), looks);
    return std::pair(found.triangle, looks.spent());
  };
  EXPECT_GE(met(0.99).first, 0);
  // The spheres around packets of slivers reach far beside them.
  EXPECT_LT(met(0.3).first, 0);
  EXPECT_LT(met(0.3).second, 257 * LookCosts::packet_cold + 1000 * LookCosts::beside);
}

TEST(TreeWalks, ALimitIsExceededWhereMoreIsWithinReach) {
  RandomStream random(8);
  int exceeded = 0;
  for (const TriangleTree& tree : trees()) {
    for (int k = 0; k < 200; ++k) {
      const Vec3 q = any(random, 1);
      const double reach_m = random.uniform();
      const auto expected = all_within(tree, q, reach_m);
      std::vector<int> found;
      SearchLimit limit{20, 1000};
      const bool is_whole = tree.each_within(q, reach_m, limit, add, &found);
      ASSERT_EQ(is_whole, expected.size() <= 20);
      ASSERT_LE(found.size(), 20U);
      std::sort(found.begin(), found.end());
      if (is_whole) {
        ASSERT_EQ(found, expected);
        SearchLimit fewer{1000, std::max(0, limit.packets - 1)};
        EXPECT_EQ(tree.each_within(q, reach_m, fewer, add, &found), limit.packets == 0);
      }
      exceeded += is_whole ? 0 : 1;
    }
  }
  EXPECT_GT(exceeded, 50);
}

}  // namespace
}  // namespace fingerpad::tree_walks_test
