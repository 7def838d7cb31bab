#include "view/frame_labels.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fingerpad::frame_labels_test {
namespace {

constexpr double em = 12;
const Box scene{0, 0, 600, 500};
const Vec2 foot(300, 250);

ScreenArrow arrow(double angle_rad, double length) {
  return {foot, foot + length * Vec2(std::cos(angle_rad), std::sin(angle_rad))};
}

bool overlap(const OverlayFacts::Label& a, const OverlayFacts::Label& b) {
  return std::abs(a.at.x() - b.at.x()) < em && std::abs(a.at.y() - b.at.y()) < em;
}

/// The least distance of a place from an arrow.
double distance(const Vec2& at, const ScreenArrow& arrow) {
  const Vec2 along = arrow.second - arrow.first;
  const double share = std::clamp((at - arrow.first).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (at - arrow.first - share * along).norm();
}

TEST(FrameLabels, StandClearOfOneAnotherAndOfTheForces) {
  int placed = 0;
  for (double turn = 0; turn < 6.28; turn += 0.1) {
    const NamedAxis axes[] = {{"n", arrow(1.5, 40)}, {"Cx", arrow(turn, 30)}, {"Cy", arrow(turn + 0.3, 20)}};
    const ScreenArrow forces[] = {arrow(1.5, 120), arrow(turn + 3, 25), arrow(1.7, 122)};
    const auto labels = frame_labels(axes, forces, {}, scene, em);
    placed += static_cast<int>(labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
      for (const ScreenArrow& force : forces) EXPECT_GT(distance(labels[i].at, force), 0.4 * em) << turn;
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(labels[i], labels[k])) << turn;
    }
  }
  EXPECT_GT(placed, 0.9 * 3 * 63) << "there is room beside the arrows";
}

TEST(FrameLabels, KeepOffTheBoxesAndOutOfAnAxisSeenFromItsEnd) {
  const NamedAxis axes[] = {{"n", arrow(0, 3)}, {"Cx", arrow(0, 30)}};
  const Box box{310, 200, 200, 100};
  const auto labels = frame_labels(axes, {}, std::span(&box, 1), scene, em);
  for (const auto& label : labels) {
    EXPECT_EQ(label.words, "Cx");
    EXPECT_FALSE(box.holds(label.at.x(), label.at.y()));
  }
  EXPECT_EQ(frame_labels(axes, {}, {}, scene, em).size(), 1u);
}

}  // namespace
}  // namespace fingerpad::frame_labels_test
