#include "view/overlay_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

/// Of two lines of words, so many em wide.
Vec2 two_lines(double width_em, const Layout& layout) {
  return Vec2(width_em, 5.2) * layout.em;
}

TEST(OverlayPlaces, WordsKeepClearOfTheFingerWhereThereIsRoom) {
  for (const auto& [width, height] : {std::pair(1280, 800), std::pair(900, 600)}) {
    const Layout layout = layout_for(width, height, true, false);
    const Box usual = words_place(layout, two_lines(26, layout), std::nullopt).value();
    for (double y = layout.scene.bottom; y < layout.scene.top(); y += 7) {
      const Vec2 finger(layout.scene.centre().x(), y);
      const Box place = words_place(layout, two_lines(26, layout), finger).value();
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
    const Vec2 finger(layout.scene.centre().x(), y);
    const Box place = words_place(layout, two_lines(22, layout), finger, {hud}).value();
    EXPECT_FALSE(overlap(place, hud)) << y;
    EXPECT_LT(place.right(), layout.scene.right());
  }
}

/// Lists of a material and of parts, one under the other at the upper right.
std::vector<Box> two_lists(const Layout& layout) {
  const double em = layout.em, width = 21 * em, left = layout.scene.right() - 0.7 * em - width;
  const double middle = layout.scene.top() - 20.8 * em;
  return {{left, middle, width, 20.1 * em}, {left, middle - 7 * em, width, 6.3 * em}};
}

TEST(OverlayPlaces, WordsAndMeasuresLieOverNoList) {
  for (const auto& [width, height] : {std::pair(1280, 800), std::pair(700, 500), std::pair(400, 300)}) {
    const Layout layout = layout_for(width, height, true, false);
    const double em = layout.em;
    const std::vector<Box> lists = two_lists(layout);
    const auto lies_on_one = [&](const Box& place) {
      return std::any_of(lists.begin(), lists.end(), [&](const Box& list) { return overlap(place, list); });
    };
    for (double y = layout.scene.bottom; y < layout.scene.top(); y += 11) {
      for (double x = layout.scene.left; x < layout.scene.right(); x += 13) {
        const auto place = words_place(layout, two_lines(16, layout), Vec2(x, y), lists);
        ASSERT_TRUE(place) << width;
        EXPECT_FALSE(lies_on_one(*place)) << width << " at " << x << ", " << y;
        const double wide = 11 * em;
        const Vec2 at = marks_words_place({{x, y}, {x + 2 * em, y}}, wide, layout, lists);
        EXPECT_FALSE(lies_on_one({at.x() - wide / 2, at.y() - 1.1 * em, wide, 2.2 * em}))
            << width << " marks at " << x << ", " << y;
      }
    }
  }
  const Layout small = layout_for(400, 300, true, false);
  EXPECT_FALSE(words_place(small, two_lines(30, small), std::nullopt, two_lists(small)))
      << "too long for the room: to be parted into lines";
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

TEST(OverlayPlaces, ABoxMakesWayForTheTipOfAnArrowWhereItCan) {
  const Layout layout = layout_for(1280, 800, true, false);
  const Vec2 contact = layout.scene.centre();
  OverlayPlaces places;
  const Box before = places.place(layout, usual_boxes(layout), contact)[1];
  const Vec2 tip = before.centre();
  const Box after = places.place(layout, usual_boxes(layout), contact, {}, {tip})[1];
  ASSERT_GT(after.width, 0);
  EXPECT_FALSE(after.holds(tip.x(), tip.y()));
  // Tips in every corner: then it stands where it would without them.
  std::vector<Vec2> everywhere;
  for (double x = layout.scene.left + 5; x < layout.scene.right(); x += 20) {
    for (double y = layout.scene.bottom + 5; y < layout.scene.top(); y += 20) everywhere.emplace_back(x, y);
  }
  EXPECT_EQ(OverlayPlaces().place(layout, usual_boxes(layout), contact, {}, everywhere)[1].left, before.left);
}

TEST(OverlayPlaces, WhatIsToldOfMarksLiesOnNoneOfThem) {
  const Layout layout = layout_for(900, 600, false, false);
  const double em = layout.em, width = 9 * em;
  const Vec2 middle = layout.scene.centre();
  for (int turn = 0; turn < 24; ++turn) {
    for (const double apart_em : {0.0, 1.0, 3.8, 4.5, 9.0}) {
      const double angle = turn * 3.14159265358979 / 24;
      const Vec2 half = 0.5 * apart_em * em * Vec2(std::cos(angle), std::sin(angle));
      for (const double up : {-1.0, 0.0, 1.0}) {
        const Vec2 at = middle + Vec2(0, up * (0.5 * layout.scene.height - 6 * em));
        const Vec2 words = marks_words_place({at + half, at - half}, width, layout);
        for (const Vec2& mark : {Vec2(at + half), Vec2(at - half)}) {
          EXPECT_FALSE(std::abs(words.x() - mark.x()) < width / 2 &&
                       std::abs(words.y() - mark.y()) < 1.1 * em)
              << apart_em << " em apart, turned by " << angle;
        }
        EXPECT_TRUE(layout.scene.holds(words.x(), words.y()));
      }
    }
  }
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
