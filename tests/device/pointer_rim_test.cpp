// Spots that a finger is too large for: in slots, holes and corners. It presses on the rim before them, and
// keeps its contact while the pointer goes on over them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "device/pointer_finger.hpp"
#include "device/pointer_hand.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/touch.hpp"

namespace fingerpad::pointer_rim_test {
namespace {

using test::PointedWorld;

constexpr double radius_m = 0.007;

/// A closed part of bars along y, `bar_m` wide and `gap_m` apart, 30 mm deep below z = 0, with a gap about
/// x = 0; beside them a plate goes on. Wide bars and one gap are a plate with a slot.
TriangleSoup grill_soup(double bar_m, double gap_m, int bars_a_side) {
  constexpr double depth_m = 0.03, along_m = 0.1, plate_m = 0.06;
  const double pitch_m = bar_m + gap_m, end_m = gap_m / 2 + bars_a_side * pitch_m + plate_m / 2;
  const auto bar = [&](double middle_m, double width_m) {
    return test::moved(test::box_soup({width_m, along_m, depth_m}), {middle_m, 0, -depth_m / 2});
  };
  TriangleSoup soup = test::joined(bar(-end_m, plate_m), bar(end_m, plate_m));
  for (int i = 0; i < bars_a_side; ++i) {
    const double middle_m = gap_m / 2 + bar_m / 2 + i * pitch_m;
    soup = test::joined(soup, test::joined(bar(-middle_m, bar_m), bar(middle_m, bar_m)));
  }
  return soup;
}

/// A floor whose top is z = 0, and a wall on it whose face is x = 0; the corner lies along y.
TriangleSoup corner_soup() {
  return test::joined(test::moved(test::box_soup({0.16, 0.1, 0.02}), {0, 0, -0.01}),
                      test::moved(test::box_soup({0.02, 0.1, 0.06}), {-0.01, 0, 0.0299}));
}

PointedWorld pointed_world(const TriangleSoup& soup) {
  Scene scene = test::plane_scene("none");
  scene.contact.method = "proxy";
  scene.finger.radius_m = radius_m;
  World world = *test::world_of(soup);
  world.verdicts.emplace_back().closed = true;
  return {"made", scene, std::make_shared<World>(world)};
}

/// A finger under a pointer that presses what it sees under itself.
class Pressing {
 public:
  Pressing(const PointedWorld& pointed, const Vec3& towards_eye_W, const Vec3& start_W, double press_n)
      : pointed_(pointed),
        towards_eye_W_(towards_eye_W.normalized()),
        press_n_(press_n),
        finger_({pointed.scene, pointed.world, at(start_W)}),
        touch_(pointed.world, pointed.scene) {}

  /// Points at what is seen where the eye's line through a place meets the part.
  void point(const Vec3& through_W) {
    const auto spot = spot_under(pointed_, through_W + 0.2 * towards_eye_W_, -towards_eye_W_);
    ASSERT_TRUE(spot);
    press(spot->point_W, spot->normal_W);
  }
  void press(const Vec3& spot_W, const Vec3& normal_W) {
    FingerSample target = at(spot_W + radius_m * normal_W);
    target.push_W_n = -press_n_ * normal_W;
    target.t_s = t_s_;
    finger_.look_from(towards_eye_W_);
    finger_.set_target(target);
  }
  std::vector<TickRecord> go(double seconds) {
    std::vector<TickRecord> rows;
    constexpr double dt_s = 1e-3;
    for (const double end_s = t_s_ + seconds; t_s_ < end_s; t_s_ += dt_s) {
      rows.push_back(touch_.tick(finger_.advance(dt_s)));
      finger_.feel(rows.back());
    }
    return rows;
  }

 private:
  static FingerSample at(const Vec3& place_W) {
    FingerSample finger;
    finger.p_WQ = place_W;
    return finger;
  }

  const PointedWorld& pointed_;
  Vec3 towards_eye_W_;
  double press_n_, t_s_ = 0;
  PointerFinger finger_;
  Touch touch_;
};

struct Forces {
  double least_n = 1e9, most_n = 0;
  int without_contact = 0;
};

Forces forces_of(const std::vector<TickRecord>& rows) {
  Forces forces;
  for (const TickRecord& row : rows) {
    forces.least_n = std::min(forces.least_n, row.normal_force_n);
    forces.most_n = std::max(forces.most_n, row.normal_force_n);
    forces.without_contact += row.walls == 0 ? 1 : 0;
  }
  return forces;
}

// It hung over the slot and touched nothing, however hard the press: the spot on the slot's wall was aside
// of it and behind, so it never came down.
TEST(PointerRim, APressOnTheWallOfASlotThatIsTooNarrowRestsOnTheSlotsRim) {
  constexpr double gap_m = 0.009;
  const PointedWorld pointed = pointed_world(grill_soup(0.02, gap_m, 1));
  for (const double below_m : {0.001, 0.004, 0.008}) {
    for (const double press_n : {0.2, 1.0, 5.0}) {
      SCOPED_TRACE(testing::Message() << below_m << " m below the rim, " << press_n << " N");
      Pressing pressing(pointed, Vec3(-0.5, 0, 1), Vec3(-0.03, 0, 0.03), press_n);
      pressing.press({gap_m / 2, 0, -below_m}, -Vec3::UnitX());
      pressing.go(1.5);
      const auto rows = pressing.go(0.5);
      const Forces forces = forces_of(rows);
      EXPECT_EQ(forces.without_contact, 0);
      EXPECT_NEAR(forces.least_n, press_n, 0.02 * press_n);
      EXPECT_NEAR(forces.most_n, press_n, 0.02 * press_n);
      EXPECT_LT((rows.back().p_WQ - rows.front().p_WQ).norm(), 1e-5) << "at rest";
      EXPECT_GT(rows.back().normal_W.z(), 0.5) << "held out of the slot";
      EXPECT_LT(std::abs(rows.back().contact_W.x()), gap_m / 2 + 1e-3) << "on the rim";
    }
  }
}

// It went round the bars, to a floor where the pointer is not.
TEST(PointerRim, APressThroughASlotOntoAFloorRestsOnTheSlotsRim) {
  constexpr double gap_m = 0.009, press_n = 2;
  const TriangleSoup floor = test::moved(test::box_soup({0.3, 0.3, 0.01}), {0, 0, -0.06});
  const PointedWorld pointed = pointed_world(test::joined(grill_soup(0.02, gap_m, 1), floor));
  Pressing pressing(pointed, Vec3::UnitZ(), Vec3(-0.03, 0, 0.03), press_n);
  pressing.point({0.001, 0, 0});
  pressing.go(1.5);
  const auto rows = pressing.go(0.2);
  EXPECT_EQ(forces_of(rows).without_contact, 0);
  EXPECT_NEAR(rows.back().normal_force_n, press_n, 0.02 * press_n);
  EXPECT_GT(rows.back().contact_W.z(), -1e-3);
  EXPECT_LT(std::abs(rows.back().contact_W.x()), gap_m / 2 + 1e-3) << "on the rim";
}

// Beside the corner the spot's place is in the other wall. There the finger came no nearer, let go, and could
// not land again.
TEST(PointerRim, ASlowPointerInACornerKeepsTheForce) {
  const PointedWorld pointed = pointed_world(corner_soup());
  for (const double press_n : {1.0, 10.0}) {
    SCOPED_TRACE(press_n);
    Pressing pressing(pointed, Vec3(1, 0.3, 1), Vec3(0.05, 0, 0.05), press_n);
    pressing.point({0, 0, 0.02});
    pressing.go(1);
    std::vector<TickRecord> rows;
    // Down the wall, into the corner, and out along the floor.
    for (int i = 0; i <= 80; ++i) {
      const double on_m = 0.02 - 5e-4 * i;
      pressing.point(on_m > 0 ? Vec3(0, 0, on_m) : Vec3(-on_m, 0, 0));
      for (const TickRecord& row : pressing.go(0.05)) rows.push_back(row);
    }
    const Forces forces = forces_of(rows);
    EXPECT_EQ(forces.without_contact, 0);
    EXPECT_GT(forces.least_n, 0.7 * press_n);
    EXPECT_LT(forces.most_n, 1.5 * press_n);
    EXPECT_NEAR(rows.back().normal_force_n, press_n, 0.02 * press_n);
    EXPECT_NEAR(rows.back().contact_W.x(), 0.02, 1e-3) << "it has followed";
  }
}

// What the pointer sees are the bars' tops and walls in turn, whose places are a finger's radius above and
// beside: it let go at the walls.
TEST(PointerRim, AFingerThatIsTooLargeForTheSlotsRidesOverTheirEdges) {
  const PointedWorld pointed = pointed_world(grill_soup(0.0015, 0.003, 3));
  for (const double press_n : {0.3, 1.0, 3.0}) {
    SCOPED_TRACE(press_n);
    Pressing pressing(pointed, Vec3(-0.7, 0.2, 0.7), Vec3(-0.03, 0, 0.03), press_n);
    pressing.point({-0.025, 0, 0});
    pressing.go(1);
    std::vector<TickRecord> rows;
    double deepest_m = 1;
    for (int i = 0; i <= 100; ++i) {
      pressing.point({-0.025 + 5e-4 * i, 0, 0});
      for (const TickRecord& row : pressing.go(0.03)) {
        rows.push_back(row);
        deepest_m = std::min(deepest_m, row.p_WQ.z() + row.depth_m * row.normal_W.z());
      }
    }
    const Forces forces = forces_of(rows);
    EXPECT_EQ(forces.without_contact, 0);
    EXPECT_GT(forces.least_n, 0.6 * press_n);
    EXPECT_LT(forces.most_n, 1.5 * press_n);
    EXPECT_NEAR(rows.back().contact_W.x(), 0.025, 1e-3) << "it has come over";
    // A ball on two edges 3 mm apart.
    EXPECT_GT(deepest_m, std::sqrt(radius_m * radius_m - 0.0015 * 0.0015) - 1e-4);
  }
}

}  // namespace
}  // namespace fingerpad::pointer_rim_test
