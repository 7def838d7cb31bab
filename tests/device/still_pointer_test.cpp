#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <optional>

#include "device/pointed_worlds.hpp"
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
    FingerSample target;
    target.p_WQ = spot.point_W + pointed.scene.finger.radius_m * spot.normal_W;
    target.push_W_n = -press_n * spot.normal_W;
    finger_.look_from(towards_eye_W);
    finger_.set_target(target);
  }

  /// How far apart the places are where it is in so many seconds.
  double roams_m(double seconds) {
    Eigen::AlignedBox3d places;
    for (const double end_s = t_s_ + seconds; t_s_ < end_s; t_s_ += dt_s_) {
      FingerSample sample = finger_.advance(dt_s_);
      sample.t_s = t_s_;
      last_ = touch_.tick(sample);
      finger_.feel(last_);
      places.extend(sample.p_WQ);
    }
    return places.diagonal().norm();
  }
  const TickRecord& last() const { return last_; }

 private:
  double dt_s_, t_s_ = 0;
  PointerFinger finger_;
  Touch touch_;
  TickRecord last_;
};

/// What is under the pointer in a window that the part fills, at column and row of so many.
std::optional<Spot> spot_at(const PointedWorld& pointed, int column, int row, int of) {
  const Vec3 right_W = towards_eye_W.unitOrthogonal(), up_W = towards_eye_W.cross(right_W);
  const double x = 2 * (column + 0.5) / of - 1, y = 2 * (row + 0.5) / of - 1;
  const Vec3 from_W = pointed.middle_W + pointed.radius_m * (4 * towards_eye_W + x * right_W + y * up_W);
  return spot_under(pointed, from_W, -towards_eye_W);
}

PointedWorld dashboard() {
  const Scene scene = read_scene_file((test::source_dir() / "scenes/dashboard.toml").string()).scene;
  return {"dashboard", scene, load_world(scene)};
}

// 10 N press a fingertip of 7 mm 10 mm deep: over an edge it turns about this as a lever, and where its
// centre is deeper than the surface is round, no place holds it. It went to and fro by millimetres, without
// end, at one spot in fifteen.
TEST(StillPointer, PressesDeepWithAStillFinger) {
  const PointedWorld pointed = dashboard();
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
  const PointedWorld pointed = dashboard();
  const auto spot = spot_at(pointed, 28, 27, 60);
  ASSERT_TRUE(spot);
  StillPointer pointer(pointed, *spot, 3);
  pointer.roams_m(1.5);
  EXPECT_LT(pointer.roams_m(1), 0.1e-3);
  EXPECT_NEAR(pointer.last().normal_force_n, 3, 0.1);
  EXPECT_GT((pointer.last().contact_W - spot->point_W).norm(), pointed.scene.finger.radius_m)
      << "it got there: look for another spot";
}

}  // namespace
}  // namespace fingerpad::still_pointer_test
