#include "view/overlay_places.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fingerpad::overlay_places_test {
namespace {

using enum Corner;

std::vector<Placed> usual_boxes(const Layout& layout) {
  const double em = layout.em;
  return {{14.5 * em, 20 * em, {top_left, top_right, bottom_right}},
          {layout.inset.width, layout.inset.height, {top_right, bottom_right, top_left, bottom_left}},
          {15.5 * em, 9 * em, {bottom_left, bottom_right, top_left}}};
}

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right() && b.left < a.right() && a.bottom < b.top() && b.bottom < a.top();
}

TEST(OverlayPlaces, NoBoxHidesTheContactOrAnotherBoxWhereverItIs) {
  for (const auto& [width, height] : {std::pair(1280, 800), std::pair(640, 480), std::pair(420, 320)}) {
    const Layout layout = layout_for(width, height, true, true);
    OverlayPlaces places;
    int shown = 0, asked = 0;
    for (double x = layout.scene.left; x < layout.scene.right(); x += 23) {
      for (double y = layout.scene.bottom; y < layout.scene.top(); y += 19) {
        const auto boxes = places.place(layout, usual_boxes(layout), Vec2(x, y));
        for (std::size_t i = 0; i < boxes.size(); ++i) {
          ++asked;
          if (boxes[i].width == 0) continue;
          ++shown;
          EXPECT_FALSE(boxes[i].holds(x, y)) << i << " at " << x << ", " << y;
          for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(boxes[k].width > 0 && overlap(boxes[i], boxes[k]));
        }
      }
    }
    if (width < 1280) continue;
    EXPECT_GT(shown, 0.95 * asked) << "there is room for all of them nearly everywhere";
  }
}

TEST(OverlayPlaces, WordsKeepClearOfTheFingerWhereThereIsRoom) {
  for (const auto& [width, height] : {std::pair(1280, 800), std::pair(900, 600)}) {
    const Layout layout = layout_for(width, height, true, false);
    const Box usual = words_place(layout, 26 * layout.em, std::nullopt);
    for (double y = layout.scene.bottom; y < layout.scene.top(); y += 7) {
      const Vec2 finger(layout.scene.centre().x(), y);
      const Box place = words_place(layout, 26 * layout.em, finger);
      EXPECT_FALSE(place.holds(finger.x(), finger.y())) << y;
      EXPECT_GE(place.bottom, usual.bottom) << "the foot is the legend's";
      EXPECT_LT(place.top(), layout.scene.top());
      const bool far = std::abs(y - usual.centre().y()) > 0.4 * layout.scene.height;
      EXPECT_TRUE(!far || place.bottom == usual.bottom);
    }
  }
}

TEST(OverlayPlaces, WordsStandBesideTheReadings) {
  const Layout layout = layout_for(1000, 700, true, false);
  const double em = layout.em;
  const Box hud{layout.scene.left + 0.7 * em, layout.scene.top() - 28 * em, 15 * em, 27 * em};
  for (double y = layout.scene.bottom; y < layout.scene.top(); y += 7) {
    const Box place = words_place(layout, 22 * em, Vec2(layout.scene.centre().x(), y), {hud});
    EXPECT_FALSE(overlap(place, hud)) << y;
    EXPECT_LT(place.right(), layout.scene.right());
  }
}

TEST(OverlayPlaces, ABoxStaysUntilTheContactIsNear) {
  const Layout layout = layout_for(1280, 800, true, false);
  OverlayPlaces places;
  const Box first = places.place(layout, usual_boxes(layout), std::nullopt)[0];
  const auto left_at = [&](double beside_em) {
    return places
        .place(layout, usual_boxes(layout),
               Vec2(first.right() + beside_em * layout.em, first.centre().y()))[0]
        .left;
  };
  EXPECT_EQ(left_at(2), first.left) << "not near enough to go";
  EXPECT_GT(left_at(0.5), first.left);
  EXPECT_GT(left_at(2), first.left) << "not far enough to come back";
  EXPECT_EQ(left_at(4), first.left);
}

TEST(OverlayPlaces, NoBoxLiesOverTheAxesInTheCorner) {
  for (const auto& [width, height] : {std::pair(1280, 800), std::pair(640, 480)}) {
    const Layout layout = layout_for(width, height, true, true);
    OverlayPlaces places;
    // The contact where the close-up mostly stands: it makes way to the lower right.
    const auto boxes = places.place(layout, usual_boxes(layout), layout.inset.centre());
    // Middle of the axes, the longest of them upwards, and half a letter.
    const double top = layout.scene.bottom + (3.6 + 2.7 + 0.5) * layout.em;
    for (const Box& box : boxes) {
      if (box.width > 0 && box.right() > layout.scene.right() - 7 * layout.em) {
        EXPECT_GE(box.bottom, top);
      }
    }
  }
}

TEST(Layout, ASmallWindowDropsItsCharts) {
  EXPECT_GT(layout_for(640, 480, true, true).charts.width, 0);
  EXPECT_EQ(layout_for(500, 480, true, true).charts.width, 0);
  EXPECT_EQ(layout_for(500, 480, true, true).scene.width, 500);
}

}  // namespace
}  // namespace fingerpad::overlay_places_test
