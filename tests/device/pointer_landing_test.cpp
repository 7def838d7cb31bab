#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <utility>

#include "device/pointed_worlds.hpp"
#include "support/effort.hpp"
#include "touch/parts_ball.hpp"
#include "touch/resting_finger.hpp"

namespace fingerpad::pointer_landing_test {
namespace {

using test::PointedWorld;
using test::Spot;

/// A pointer that hovers over a spot, moves on a little while the finger is still on its way, rests and
/// presses without moving.
class HoverAndPress {
 public:
  HoverAndPress(const PointedWorld& pointed, std::uint64_t seed)
      : pointed_(pointed),
        random_(seed),
        finger_({pointed.scene, pointed.world, resting_finger(*pointed.world, pointed.scene)}),
        touch_(pointed.world, pointed.scene),
        around_(pointed.world, pointed.scene) {
    do towards_eye_W_ = Vec3(random_.normal(), random_.normal(), random_.normal());
    while (towards_eye_W_.norm() < 0.1 || towards_eye_W_.z() < 0);
    if (seed % 4 != 0) towards_eye_W_ = usual_view_W;  // else from anywhere above
    towards_eye_W_.normalize();
    at_ = Eigen::Vector2d(random_.uniform(), random_.uniform()) * 1.6 - Eigen::Vector2d(0.8, 0.8);
  }

  /// @returns how much farther from the spot than it hovered the finger was before it touched [m]; nothing
  /// where it does not hover over the spot or the way down is not free
  std::optional<double> farther_m() {
    if (!hovers()) return std::nullopt;
    point(1);
    farthest_m_ = 0;
    const double hover_m = (at_W_ - touching_W_).norm();
    go(0.8);
    return farthest_m_ - hover_m;
  }
  bool touched() const { return touched_; }

  /// @returns the greatest force of a click that asks for 1 N for so long [N], and of what comes half a
  /// second after it; nothing where it does not hover over the spot or the way down is not free
  std::optional<std::pair<double, double>> clicked_n(double held_s) {
    if (!hovers()) return std::nullopt;
    most_n_ = 0;
    point(1);
    go(held_s);
    point(0);
    go(0.5);
    const double clicked_n = std::exchange(most_n_, 0);
    go(0.2);
    return std::pair(clicked_n, most_n_);
  }

 private:
  bool hovers() {
    if (!point(0)) return false;
    go(0.25 + 0.2 * random_.uniform());
    at_ += 0.1 * Eigen::Vector2d(random_.normal(), random_.normal());
    if (!point(0)) return false;
    go(0.9 + random_.uniform());
    return (at_W_ - hover_W_).norm() <= 0.01 * pointed_.radius_m && is_free_down();
  }

  bool point(double press_n) {
    const Vec3 right_W = towards_eye_W_.unitOrthogonal(), up_W = towards_eye_W_.cross(right_W);
    const Vec3 from_W =
        pointed_.middle_W + pointed_.radius_m * (4 * towards_eye_W_ + at_.x() * right_W + at_.y() * up_W);
    const auto spot = spot_under(pointed_, from_W, -towards_eye_W_);
    if (!spot) return false;
    touching_W_ = spot->point_W + pointed_.scene.finger.radius_m * spot->normal_W;
    hover_W_ = touching_W_ + 0.05 * pointed_.radius_m * spot->normal_W;
    FingerSample target;
    target.t_s = t_s_;
    target.p_WQ = press_n > 0 ? touching_W_ : hover_W_;
    if (press_n > 0) target.push_W_n = -press_n * spot->normal_W;
    finger_.look_from(towards_eye_W_);
    finger_.set_target(target);
    return true;
  }

  void go(double seconds) {
    const double dt_s = 1 / pointed_.scene.motion.rate_hz, end_s = t_s_ + seconds;
    for (; t_s_ < end_s; t_s_ += dt_s) {
      FingerSample sample = finger_.advance(dt_s);
      sample.t_s = t_s_;
      const TickRecord row = touch_.tick(sample);
      finger_.feel(row);
      at_W_ = sample.p_WQ;
      touched_ |= row.walls > 0;
      most_n_ = std::max(most_n_, row.normal_force_n);
      if (!touched_) farthest_m_ = std::max(farthest_m_, (at_W_ - touching_W_).norm());
    }
  }

  bool is_free_down() {
    for (const double share : {0.1, 0.25, 0.5, 0.75, 1.0}) {
      const Vec3 place_W = touching_W_ + share * (at_W_ - touching_W_);
      if (around_.at(place_W, 1).free_m < 0.3 * share * (at_W_ - touching_W_).norm()) return false;
    }
    return true;
  }

  const PointedWorld& pointed_;
  RandomStream random_;
  PointerFinger finger_;
  Touch touch_;
  Surroundings around_;
  Vec3 towards_eye_W_ = Vec3::UnitZ(), hover_W_ = Vec3::Zero(), touching_W_ = Vec3::Zero(),
       at_W_ = Vec3::Zero();
  Eigen::Vector2d at_ = Eigen::Vector2d::Zero();
  double t_s_ = 0, farthest_m_ = 0, most_n_ = 0;
  bool touched_ = false;
};

const int landing_count = test::sanitized() ? 20 : 300;

// Some two seconds. The finger's goal sets out as slowly as the pointer's event is played: one that had
// rested was taken for one that is held up, and flew up over the parts and down again.
TEST(PointerLanding, AHoveringFingerThatIsPressedComesStraightDown) {
  const auto worlds = test::pointed_worlds();
  int asked = 0, landed = 0;
  for (int k = 0; k < landing_count; ++k) {
    const PointedWorld& pointed = worlds[static_cast<std::size_t>(k) % worlds.size()];
    SCOPED_TRACE(fmt::format("path {} over {}", k, pointed.name));
    HoverAndPress hand(pointed, 9000 + static_cast<std::uint64_t>(k));
    const auto farther_m = hand.farther_m();
    if (!farther_m) continue;
    ++asked;
    landed += hand.touched() ? 1 : 0;
    // What the flight keeps from the parts: so far it may be pushed away from one that is beside it.
    EXPECT_LE(*farther_m, 0.01 * pointed.radius_m);
  }
  fmt::print("{} of {} landed\n", landed, asked);
  EXPECT_GT(asked, landing_count / 5);
  EXPECT_EQ(landed, asked);
}

// A button is let go sooner than the finger is down.
TEST(PointerLanding, AClickHoweverShortIsFeltAndEnds) {
  const auto worlds = test::pointed_worlds();
  int asked = 0;
  for (int k = 0; k < landing_count; ++k) {
    const PointedWorld& pointed = worlds[static_cast<std::size_t>(k) % worlds.size()];
    SCOPED_TRACE(fmt::format("path {} over {}", k, pointed.name));
    HoverAndPress hand(pointed, 9000 + static_cast<std::uint64_t>(k));
    const auto clicked_n = hand.clicked_n(0.001 + 0.03 * (k % 5));
    if (!clicked_n) continue;
    ++asked;
    EXPECT_GE(clicked_n->first, 0.5);
    EXPECT_LE(clicked_n->first, 1.5);
    EXPECT_EQ(clicked_n->second, 0);
  }
  EXPECT_GT(asked, landing_count / 5);
}

}  // namespace
}  // namespace fingerpad::pointer_landing_test
