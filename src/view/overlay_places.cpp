#include "view/overlay_places.hpp"

#include <algorithm>

namespace fingerpad {
namespace {

Box in_corner(const Layout& layout, const Placed& box, Corner corner) {
  const double gap = 0.7 * layout.em;
  // The axes and the scale bar stand in the lower right corner.
  const double foot = corner == Corner::bottom_right ? axes_foot_em * layout.em : gap;
  const bool left = corner == Corner::top_left || corner == Corner::bottom_left;
  const bool top = corner == Corner::top_left || corner == Corner::top_right;
  return {left ? layout.scene.left + gap : layout.scene.right() - gap - box.width,
          top ? layout.scene.top() - gap - box.height : layout.scene.bottom + foot, box.width, box.height};
}

Box widened(const Box& box, double by) {
  return {box.left - by, box.bottom - by, box.width + 2 * by, box.height + 2 * by};
}

bool meet(const Box& a, const Box& b) {
  return a.left < b.right() && b.left < a.right() && a.bottom < b.top() && b.bottom < a.top();
}

bool within(const Box& box, const Box& around) {
  return box.left >= around.left && box.right() <= around.right() && box.bottom >= around.bottom &&
         box.top() <= around.top();
}

}  // namespace

Box words_place(const Layout& layout, double width_px, const std::optional<Vec2>& finger_px,
                const std::vector<Box>& taken) {
  const double em = layout.em, clear = 3 * em, height = 5.2 * em, foot = layout.scene.bottom;
  const double usual = foot + std::max(0.3 * layout.scene.height, 6 * em) - 1.1 * em;
  const auto at = [&](double bottom) {
    Box place{layout.scene.centre().x() - width_px / 2, bottom, width_px, height};
    for (const Box& box : taken) {
      const double beside = box.right() + 0.7 * em;
      if (box.width > 0 && meet(place, box) && beside + width_px < layout.scene.right()) place.left = beside;
    }
    return place;
  };
  if (!finger_px) return at(usual);
  // At the very foot stand the legend and the scale: only a small scene has no other room.
  for (const double bottom : {usual, usual + height + 2 * clear, foot + 0.7 * em}) {
    const bool fits = bottom + height < layout.scene.top();
    if (fits && !widened(at(bottom), clear).holds(finger_px->x(), finger_px->y())) return at(bottom);
  }
  return at(usual);
}

std::vector<Box> OverlayPlaces::place(const Layout& layout, const std::vector<Placed>& boxes,
                                      const std::optional<Vec2>& contact_px, const std::vector<Box>& taken) {
  before_.resize(boxes.size());
  std::vector<Box> places;
  const auto meets = [](const Box& box) {
    return [&box](const Box& other) { return other.width > 0 && meet(box, other); };
  };
  const auto is_free = [&](const Box& box, double clear_em) {
    const bool hides =
        contact_px && widened(box, clear_em * layout.em).holds(contact_px->x(), contact_px->y());
    return !hides && within(box, layout.scene) && std::none_of(places.begin(), places.end(), meets(box)) &&
           std::none_of(taken.begin(), taken.end(), meets(box));
  };
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    Box chosen;
    const Placed& box = boxes[i];
    if (box.width > 0) {
      constexpr double near_em = 1, far_em = 3;
      // Where it was, unless the contact comes near; else where it is clear of it by more.
      if (before_[i] && *before_[i] == box.liked.front() &&
          is_free(in_corner(layout, box, *before_[i]), near_em)) {
        chosen = in_corner(layout, box, *before_[i]);
      }
      for (const double clear_em : {far_em, near_em}) {
        for (const Corner corner : box.liked) {
          if (chosen.width > 0 || !is_free(in_corner(layout, box, corner), clear_em)) continue;
          chosen = in_corner(layout, box, corner);
          before_[i] = corner;
        }
      }
    }
    places.push_back(chosen);
  }
  return places;
}

}  // namespace fingerpad
