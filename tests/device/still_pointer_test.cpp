#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <optional>

#include "device/pointed_worlds.hpp"
#include "device/pointer_limits.hpp"
#include "support/effort.hpp"
#include "touch/resting_finger.hpp"

namespace fingerpad::still_pointer_test {
namespace {

using test::PointedWorld;
using test::Spot;

const Vec3 towards_eye_W = Vec3(0.35, -0.6, 0.72).normalized();

/// A finger under a pointer that presses on one spot and rests there.
class StillPointer {
 public:
  StillPointer(const PointedWorld& pointed, const Spot& spot, double press_n)
      : dt_s_(1 / pointed.scene.motion.rate_hz),
        finger_({pointed.scene, pointed.world, resting_finger(*pointed.world, pointed.scene)}),
        touch_(pointed.world, pointed.scene) {
    finger_.look_from(towards_eye_W);
    point(pointed, spot, press_n);
  }

  void point(const PointedWorld& pointed, const Spot& spot, double press_n) {
    FingerSample target;
    target.t_s = t_s_;
    target.p_WQ = spot.point_W + pointed.scene.finger.radius_m * spot.normal_W;
    target.push_W_n = -press_n * spot.normal_W;
    finger_.set_target(target);
  }

  /// How far apart the places are where it is in so many seconds.
  double roams_m(double seconds) {
    Eigen::AlignedBox3d places;
    most_step_m_ = 0;
    for (const double end_s = t_s_ + seconds; t_s_ < end_s; t_s_ += dt_s_) {
      FingerSample sample = finger_.advance(dt_s_);
      sample.t_s = t_s_;
      last_ = touch_.tick(sample);
      finger_.feel(last_);
      if (!places.isEmpty()) most_step_m_ = std::max(most_step_m_, (sample.p_WQ - last_W_).norm());
      last_W_ = sample.p_WQ;
      places.extend(sample.p_WQ);
    }
    return places.diagonal().norm();
  }
  const TickRecord& last() const { return last_; }
  /// Of a tick, in the last roams_m().
  double most_step_m() const { return most_step_m_; }
  double tick_s() const { return dt_s_; }

 private:
  double dt_s_, t_s_ = 0;
  PointerFinger finger_;
  Touch touch_;
  TickRecord last_;
  Vec3 last_W_ = Vec3::Zero();
  double most_step_m_ = 0;
};

/// What is under the pointer in a window that the part fills, at column and row of so many.
std::optional<Spot> spot_at(const PointedWorld& pointed, int column, int row, int of) {
  const Vec3 right_W = towards_eye_W.unitOrthogonal(), up_W = towards_eye_W.cross(right_W);
  const double x = 2 * (column + 0.5) / of - 1, y = 2 * (row + 0.5) / of - 1;
  const Vec3 from_W = pointed.middle_W + pointed.radius_m * (4 * towards_eye_W + x * right_W + y * up_W);
  return spot_under(pointed, from_W, -towards_eye_W);
}

PointedWorld scene_of(const std::string& name) {
  const Scene scene = read_scene_file((test::source_dir() / "scenes" / (name + ".toml")).string()).scene;
  return {name, scene, load_world(scene)};
}

// 10 N press a fingertip of 7 mm 10 mm deep: over an edge it turns about this as a lever, and where its
// centre is deeper than the surface is round, no place holds it. It went to and fro by millimetres, without
// end, at one spot in fifteen.
TEST(StillPointer, PressesDeepWithAStillFinger) {
  const PointedWorld pointed = scene_of("dashboard");
  constexpr int columns = 24;
  int spots = 0, roaming = 0, touching = 0;
  for (int k = 0; k < columns * columns; ++k) {
    const auto spot = spot_at(pointed, k / columns, k % columns, columns);
    if (!spot || (test::sanitized() && k % 4 != 0)) continue;
    SCOPED_TRACE(fmt::format("at {}, {}", k / columns, k % columns));
    StillPointer pointer(pointed, *spot, 10);
    pointer.roams_m(1.5);
    const double roams_m = pointer.roams_m(0.5);
    ++spots;
    touching += pointer.last().walls > 0 ? 1 : 0;
    roaming += roams_m > 0.1e-3 ? 1 : 0;
    EXPECT_LT(roams_m, 2e-3);
  }
  fmt::print("{} spots, at {} it roams, at {} it touches\n", spots, roaming, touching);
  EXPECT_GT(spots, 20);
  EXPECT_LE(roaming, spots / 50);
  EXPECT_EQ(touching, spots);
}

// Deep in a recess, where the way down is too narrow for the finger: it went up above all parts and down
// again, two times a second, as long as it was pressed.
TEST(StillPointer, RestsWhereNoWayLeads) {
  const PointedWorld pointed = scene_of("dashboard");
  const auto spot = spot_at(pointed, 28, 27, 60);
  ASSERT_TRUE(spot);
  StillPointer pointer(pointed, *spot, 3);
  pointer.roams_m(1.5);
  EXPECT_LT(pointer.roams_m(1), 0.1e-3);
  EXPECT_NEAR(pointer.last().normal_force_n, 3, 0.1);
  EXPECT_GT((pointer.last().contact_W - spot->point_W).norm(), pointed.scene.finger.radius_m)
      << "it got there: look for another spot";
}

/// Whether the finger stays where it is for so long, to what nobody sees, about as hard as wished.
void expect_rests(StillPointer& pointer, double for_s, double wished_n) {
  constexpr double seen_m = 0.2e-3, about = 0.2;
  EXPECT_LT(pointer.roams_m(for_s), seen_m);
  EXPECT_NEAR(pointer.last().normal_force_n, wished_n, about * wished_n);
}

/// A place of the grid that spot_at() lays over the window.
struct GridPlace {
  int column, row, of;
};

// On its way down to a counterbore's wall the finger passes by a gusset, and to others by an edge, by less
// than counts as room: these do not stop it.
TEST(StillPointer, ComesDownPastWhatHardlyStopsIt) {
  const PointedWorld pointed = scene_of("bracket");
  for (const GridPlace at : {GridPlace{28, 55, 110}, {29, 58, 110}, {41, 52, 90}, {60, 17, 90}}) {
    SCOPED_TRACE(testing::Message() << "at " << at.column << ", " << at.row);
    const auto spot = spot_at(pointed, at.column, at.row, at.of);
    ASSERT_TRUE(spot);
    StillPointer pointer(pointed, *spot, 3);
    pointer.roams_m(1);
    expect_rests(pointer, 0.3, 3);
  }
}

// Pressed 9 mm deep into a pocket's corner: as the walls change there, no place gives just the wished force.
TEST(StillPointer, GoesNoFartherForItsForceThanItNeed) {
  const PointedWorld pointed = scene_of("bracket");
  const auto spot = spot_at(pointed, 28, 33, 90);
  ASSERT_TRUE(spot);
  StillPointer pointer(pointed, *spot, 10);
  pointer.roams_m(1);
  expect_rests(pointer, 1, 10);
}

// The spot is seen over a wall's rim, past which a finger does not fit.
TEST(StillPointer, PressesOnTheRimThatItCannotPass) {
  const PointedWorld pointed = scene_of("housing");
  const auto beside = spot_at(pointed, 10, 8, 24), spot = spot_at(pointed, 10, 7, 24);
  ASSERT_TRUE(spot && beside);
  StillPointer pointer(pointed, *beside, 5);
  pointer.roams_m(0.6);
  pointer.point(pointed, *spot, 5);
  pointer.roams_m(2.5);
  expect_rests(pointer, 0.2, 5);
}

/// So far a finger goes in a tick.
double fastest_m(const PointedWorld& pointed, const StillPointer& pointer) {
  const double along_m_per_s = pointer_limits::fastest_per_s * pointed.radius_m;
  return std::max(pointer_limits::lifting_m_per_s, along_m_per_s) * pointer.tick_s();
}

// Ten times less, by the wheel: from one tick to the next that is a way of 9 mm.
TEST(StillPointer, GoesOutNoFasterWhereLessIsAskedFor) {
  const PointedWorld pointed = scene_of("bracket");
  const auto spot = spot_at(pointed, 28, 33, 90);
  ASSERT_TRUE(spot);
  StillPointer pointer(pointed, *spot, 10);
  pointer.roams_m(1);
  ASSERT_GT(pointer.last().depth_m, 5e-3);
  pointer.point(pointed, *spot, 1);
  pointer.roams_m(0.1);
  EXPECT_LT(pointer.most_step_m(), 1.01 * fastest_m(pointed, pointer));
  EXPECT_NEAR(pointer.last().normal_force_n, 1, 0.2);
}

// Also from 10 mm deep.
TEST(StillPointer, IsLetGoNoFasterThanItGoesElsewhere) {
  const PointedWorld pointed = scene_of("bracket");
  const auto spot = spot_at(pointed, 28, 33, 90);
  ASSERT_TRUE(spot);
  StillPointer pointer(pointed, *spot, 10);
  pointer.roams_m(1);
  ASSERT_GT(pointer.last().depth_m, 5e-3);
  pointer.point(pointed, *spot, 0);
  pointer.roams_m(0.1);
  EXPECT_EQ(pointer.last().walls, 0);
  EXPECT_LT(pointer.most_step_m(), 1.01 * fastest_m(pointed, pointer));
}

}  // namespace
}  // namespace fingerpad::still_pointer_test
