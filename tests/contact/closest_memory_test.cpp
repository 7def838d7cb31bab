#include "contact/closest_memory.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "contact/tree_trials.hpp"
#include "support/effort.hpp"

namespace fingerpad::closest_memory_test {
namespace {

using test::expect_same_bits;
using test::samples;

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// A path that goes on in a way for a while, then in another: of steps of any length from a millionth of the
/// part to more than all of it, standing still, trembling, near the surface, inside and far off.
class Wander {
 public:
  Wander(const Part& part, std::uint64_t seed) : part_(part), random_(seed) {}

  Vec3 next() {
    if (left_-- == 0) turn();
    heading_ += 0.1 * test::random_point(random_, 1);
    at_ += step_m_ * heading_;
    if (tremble_) return at_ + 0.3 * test::random_point(random_, step_m_);
    return at_;
  }

 private:
  void turn() {
    left_ = 5 + static_cast<int>(150 * random_.uniform());
    heading_ = test::random_point(random_, 1);
    tremble_ = random_.uniform() < 0.2;
    step_m_ = random_.uniform() < 0.1 ? 0 : part_.size_m() * std::pow(10.0, -6 * random_.uniform());
    const int t = static_cast<int>(random_.uniform() * part_.triangle_count());
    const Vec3 on = part_.vertices.col(part_.triangles(0, t));
    const double away = random_.uniform();
    if (away < 0.8) at_ = on + test::random_point(random_, part_.size_m() * std::pow(10.0, -5 * away));
    if (away < 0.01) at_ = 1e5 * at_;  // beyond the tree's range
    if (away > 0.95) at_ = on;
  }

  const Part& part_;
  RandomStream random_;
  int left_ = 0;
  bool tremble_ = false;
  double step_m_ = 0;
  Vec3 at_ = Vec3::Zero(), heading_ = Vec3::Zero();
};

TEST(ClosestMemory, ChangesNoBitOfAnAnswerOnAnyPath) {
  for (const auto& part : {test::torus(24, 12), test::torus(150, 90), test::torus(64, 8, 1e-4),
                           test::torus(80, 50, 1e5), test::soup_of_slivers(3000)}) {
    const TriangleTree tree(part);
    Wander wander(*part, 5);
    ClosestMemory memory;
    int listed = 0;
    for (int i = 0; i < samples(20000); ++i) {
      const Vec3 q = wander.next();
      expect_same_bits(tree.closest(q, memory, unbounded), tree.closest(q, -1, unbounded));
      if (HasFatalFailure()) FAIL() << "query " << i;
      listed += memory.packet_count() > 0 ? 1 : 0;
    }
    EXPECT_GT(listed, samples(4000));  // else nothing but the tree was tested
  }
}

TEST(ClosestMemory, ChangesNoBitWithinAReach) {
  const auto part = test::torus(100, 60);
  const TriangleTree tree(part);
  for (const double reach_m : {0.0, 1e-3, 0.05, 0.6}) {
    Wander wander(*part, 6);
    ClosestMemory memory;
    int found = 0;
    for (int i = 0; i < samples(30000); ++i) {
      const Vec3 q = wander.next();
      const ClosestTriangle answer = tree.closest(q, memory, reach_m);
      expect_same_bits(answer, tree.closest(q, -1, reach_m));
      if (HasFatalFailure()) FAIL() << "query " << i;
      found += answer.triangle >= 0 ? 1 : 0;
    }
    EXPECT_GT(found, reach_m > 0 ? 0 : -1) << reach_m;
    EXPECT_LT(found, samples(30000)) << reach_m;
  }
}

TEST(ClosestMemory, OfABriefSearchLeadsNoFartherOffThanNone) {
  // Asked now and then, from a triangle beside the point: what the memory holds is older and farther off, and
  // a search that may look at little is broken off at what it has found.
  const auto part = test::torus(150, 90);
  const TriangleTree tree(part);
  for (const long most_looks : {5L, 200L}) {
    Wander wander(*part, 11);
    ClosestMemory memory;
    int beside = 0;
    for (int i = 0; i < samples(20000); ++i) {
      const Vec3 q = wander.next();
      if (i % 40 == 20) beside = tree.closest(q, -1, unbounded).triangle;
      if (i % 40 != 23) continue;
      BriefSearch with{most_looks, beside, &memory}, without{most_looks, beside};
      const double distance2_m2 = tree.closest(q, with, unbounded).at.distance2_m2;
      ASSERT_LE(distance2_m2, tree.closest(q, without, unbounded).at.distance2_m2) << "query " << i;
    }
  }
}

TEST(ClosestMemory, OfAnotherPathBesideAnswersABriefSearch) {
  const auto part = test::torus(150, 90);
  const TriangleTree tree(part);
  Wander wander(*part, 12);
  RandomStream random(13);
  ClosestMemory finger, own;
  int answered = 0, answered_alone = 0;
  for (int i = 0; i < samples(30000); ++i) {
    const Vec3 q = wander.next();
    const ClosestTriangle foot = tree.closest(q, finger, unbounded);
    if (foot.triangle < 0 || i % 5 != 0) continue;
    const Vec3 beside = foot.at.point + test::random_point(random, 0.01);
    own = ClosestMemory();
    ClosestMemory fresh;
    // It may look at nothing: what is right was found among the finger's packets.
    BriefSearch search{0, foot.triangle, &own, &finger}, alone{0, foot.triangle, &fresh};
    const ClosestTriangle truth = tree.closest(beside, -1, unbounded);
    const ClosestTriangle found = tree.closest(beside, search, unbounded);
    const ClosestTriangle without = tree.closest(beside, alone, unbounded);
    ASSERT_LE(found.at.distance2_m2, without.at.distance2_m2);
    const bool is_right = found.triangle == truth.triangle;
    if (is_right) expect_same_bits(found, truth);
    answered += is_right ? 1 : 0;
    answered_alone += without.triangle == truth.triangle ? 1 : 0;
  }
  EXPECT_GT(answered, answered_alone + samples(500)) << "of " << samples(6000);
  // Whatever it holds: also that of another tree.
  const TriangleTree other(test::torus(24, 12));
  Wander again(*part, 14);
  for (int i = 0; i < samples(5000); ++i) {
    const Vec3 q = again.next();
    tree.closest(q, finger, unbounded);
    own = ClosestMemory();
    const ClosestTriangle truth = other.closest(q, -1, unbounded);
    BriefSearch search{1000000, i % 2 == 0 ? truth.triangle : 0, &own, &finger};
    expect_same_bits(other.closest(q, search, unbounded), truth);
    if (HasFatalFailure()) FAIL() << "query " << i;
  }
}

TEST(ClosestMemory, ReachesThatChangeFromQueryToQueryAreKept) {
  const auto part = test::torus(100, 60);
  const TriangleTree tree(part);
  Wander wander(*part, 7);
  RandomStream random(8);
  ClosestMemory memory;
  for (int i = 0; i < samples(30000); ++i) {
    const Vec3 q = wander.next();
    const double reach_m = i % 3 == 0 ? unbounded : std::pow(10.0, -4 * random.uniform());
    expect_same_bits(tree.closest(q, memory, reach_m), tree.closest(q, -1, reach_m));
    if (HasFatalFailure()) FAIL() << "query " << i;
  }
}

TEST(ClosestMemory, OfAnotherTreeIsForgotten) {
  const auto big = test::torus(150, 90), small = test::torus(24, 12);
  const TriangleTree first(big);
  auto second = std::make_unique<TriangleTree>(small);
  Wander wander(*big, 9);
  ClosestMemory memory;
  for (int i = 0; i < samples(20000); ++i) {
    const Vec3 q = wander.next();
    if (i % 100 == 0) second = std::make_unique<TriangleTree>(small);  // perhaps where the last one was
    const TriangleTree& tree = i / 50 % 2 == 0 ? first : *second;
    expect_same_bits(tree.closest(q, memory, unbounded), tree.closest(q, -1, unbounded));
    if (HasFatalFailure()) FAIL() << "query " << i;
  }
}

/// A flat packet, and a much smaller one that ends in a tip a gap away from it, near the flat one's end: a
/// float tells heights over a plane worst there, and the flat packet's disc is no thicker than rounding.
class TipOverPlate {
 public:
  explicit TipOverPlate(RandomStream& random)
      : turn_(Eigen::AngleAxisd(3 * random.uniform(), test::random_point(random, 1).normalized())),
        at_(random.uniform() < 0.5 ? 0.9 : -0.9, 0.02 * random.uniform(), 0) {
    soup_.vertices_P.resize(3, 18);
    soup_.triangles.resize(3, 16);
    const Mat3 upright = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitY()).toRotationMatrix();
    add(0, Mat3::Identity(), Vec3::Zero(), 1);
    add(1, upright, at_ + (gap_m + tip_m) * Vec3::UnitZ(), tip_m);
  }

  std::shared_ptr<const Part> part() const { return std::make_shared<const Part>(make_part(soup_, 0.5)); }
  /// A place in the gap, in the frame of the part's arrays.
  /// @param share  0 at the plate, 1 at the tip
  Vec3 in_gap(const Part& part, double share) const {
    return turn_ * (at_ + share * gap_m * Vec3::UnitZ()) - part.centre_P;
  }

 private:
  static constexpr double gap_m = 1e-4, tip_m = 0.03;

  /// Eight triangles about a middle, longest along x.
  void add(int k, const Mat3& turn, const Vec3& middle, double size_m) {
    constexpr double corners[8][2] = {{1, 0},  {.5, .25},   {0, .25},  {-.5, .25},
                                      {-1, 0}, {-.5, -.25}, {0, -.25}, {.5, -.25}};
    soup_.vertices_P.col(9 * k) = turn_ * middle;
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner = size_m * Vec3(corners[i][0], corners[i][1], 0);
      soup_.vertices_P.col(9 * k + 1 + i) = turn_ * (middle + turn * corner);
      soup_.triangles.col(8 * k + i) << 9 * k, 9 * k + 1 + i, 9 * k + 1 + (i + 1) % 8;
    }
  }

  Mat3 turn_;
  Vec3 at_;
  TriangleSoup soup_;
};

TEST(ClosestMemory, FindsWhatIsNearerByLessThanItsDiscsCanTell) {
  // A path crosses the middle of a narrow gap: what is nearest now is so by less than a float's rounding.
  RandomStream random(15);
  int crossed = 0;
  for (int trial = 0; trial < samples(2000); ++trial) {
    const TipOverPlate gap(random);
    const auto part = gap.part();
    const TriangleTree tree(part);
    ClosestMemory memory;
    int nearest = 0;
    for (const double share : {0.51, 0.5098, 0.5096, 0.5 + 1e-6, 0.5 - 1e-6}) {
      const Vec3 q = gap.in_gap(*part, share);
      const ClosestTriangle answer = tree.closest(q, memory, unbounded);
      expect_same_bits(answer, tree.closest(q, -1, unbounded));
      if (HasFatalFailure()) FAIL() << "trial " << trial << ", at " << share;
      crossed += nearest >= 8 && answer.triangle < 8 && memory.packet_count() == 2 ? 1 : 0;
      nearest = answer.triangle;
    }
  }
  EXPECT_GT(crossed, samples(1900));
}

TEST(ClosestMemory, TiesGoToTheLowestTriangleAsWithout) {
  // Along edges and over vertices of a flat grid every answer is a tie.
  const auto part = test::torus(40, 30);
  const TriangleTree tree(part);
  ClosestMemory memory;
  for (int t = 0; t < part->triangle_count(); ++t) {
    const Vec3 a = part->vertices.col(part->triangles(0, t)), b = part->vertices.col(part->triangles(1, t));
    for (int k = 0; k <= 8; ++k) {
      const Vec3 q = a + k / 8.0 * (b - a);
      expect_same_bits(tree.closest(q, memory, unbounded), tree.closest(q, -1, unbounded));
      if (HasFatalFailure()) FAIL() << "triangle " << t;
    }
  }
  EXPECT_GT(memory.packet_count(), 0);
}

TEST(ClosestMemory, WhatIsNoPointIsAnsweredAndForgotten) {
  const auto part = test::torus(24, 12);
  const TriangleTree tree(part);
  ClosestMemory memory;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 100; ++i) {
    const Vec3 q(1.4 + 1e-3 * i, 0, 0);
    EXPECT_EQ(tree.closest({nan, 0, 0}, memory, unbounded).triangle, -1);
    EXPECT_EQ(tree.closest({0, unbounded, 0}, memory, unbounded).triangle, -1);
    EXPECT_EQ(tree.closest(q, memory, nan).triangle, -1);
    EXPECT_EQ(tree.closest(q, memory, -1).triangle, -1);
    expect_same_bits(tree.closest(q, memory, unbounded), tree.closest(q, -1, unbounded));
  }
}

}  // namespace
}  // namespace fingerpad::closest_memory_test
