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

bool meets_any(const Box& box, const std::vector<Box>& taken) {
  return std::any_of(taken.begin(), taken.end(),
                     [&](const Box& other) { return other.width > 0 && meet(box, other); });
}

/// Where words may stand at one height: in the middle, or beside the boxes that stand there.
std::vector<Box> words_places_at(const Layout& layout, const Vec2& size_px, double bottom,
                                 const std::vector<Box>& taken) {
  const double gap = 0.7 * layout.em;
  std::vector<double> lefts = {layout.scene.centre().x() - size_px.x() / 2};
  for (const Box& box : taken) {
    if (box.width > 0) lefts.insert(lefts.end(), {box.right() + gap, box.left - gap - size_px.x()});
  }
  std::vector<Box> places;
  for (const double left : lefts) {
    const Box place{left, bottom, size_px.x(), size_px.y()};
    if (within(place, layout.scene) && !meets_any(place, taken)) places.push_back(place);
    if (left == lefts.front() && !places.empty()) break;
  }
  return places;
}

}  // namespace

std::optional<Box> words_place(const Layout& layout, const Vec2& size_px,
                               const std::optional<Vec2>& finger_px, const std::vector<Box>& taken) {
  const double em = layout.em, clear = 3 * em, gap = 0.7 * em, foot = layout.scene.bottom;
  const double usual = foot + std::max(0.3 * layout.scene.height, 6 * em) - 1.1 * em;
  std::vector<double> bottoms = {usual, usual + size_px.y() + 2 * clear};
  for (const Box& box : taken) {
    if (box.width > 0) bottoms.push_back(box.bottom - gap - size_px.y());
  }
  // At the very foot stand the legend and the scale: only a small scene has no other room.
  bottoms.push_back(foot + gap);
  for (const bool clear_of_finger : {true, false}) {
    for (const double bottom : bottoms) {
      for (const Box& place : words_places_at(layout, size_px, bottom, taken)) {
        const bool hides = finger_px && widened(place, clear).holds(finger_px->x(), finger_px->y());
        if (!clear_of_finger || !hides) return place;
      }
    }
  }
  return std::nullopt;
}

Vec2 marks_words_place(const std::vector<Vec2>& marks_px, double width_px, const Layout& layout,
                       const std::vector<Box>& taken) {
  const double em = layout.em, half_height = 1.1 * em, away = 1.9 * em;
  const Vec2 half(width_px / 2, half_height);
  Vec2 middle(0, 0);
  double top = marks_px.front().y();
  for (const Vec2& mark : marks_px) {
    middle += mark / static_cast<double>(marks_px.size());
    top = std::max(top, mark.y());
  }
  const auto is_free = [&](const Vec2& at) {
    const Box box{at.x() - half.x(), at.y() - half.y(), 2 * half.x(), 2 * half.y()};
    return within(box, layout.scene) && !meets_any(box, taken) &&
           std::none_of(marks_px.begin(), marks_px.end(),
                        [&](const Vec2& mark) { return widened(box, 0.5 * em).holds(mark.x(), mark.y()); });
  };
  const double aside = half.x() + 0.8 * em;
  for (const Vec2& way : {Vec2(0, away), Vec2(0, -away), Vec2(aside, 0), Vec2(-aside, 0)}) {
    if (is_free(middle + way)) return middle + way;
  }
  std::optional<Vec2> nearest;
  const Box& scene = layout.scene;
  for (double y = scene.bottom + half.y(); y <= scene.top() - half.y(); y += em) {
    for (double x = scene.left + half.x(); x <= scene.right() - half.x(); x += em) {
      const Vec2 at(x, y);
      const bool is_nearer = !nearest || (at - middle).squaredNorm() < (*nearest - middle).squaredNorm();
      if (is_nearer && is_free(at)) nearest = at;
    }
  }
  return nearest.value_or(Vec2(middle.x(), top + away));
}

/// Where it was, unless the contact comes near; else where it is clear of it by more.
/// @param is_free  (box, how far from the contact [em], also clear of the tips)
template <class IsFree>
Box OverlayPlaces::choose(const Layout& layout, const Placed& box, std::optional<Corner>& before,
                          const IsFree& is_free) {
  constexpr double near_em = 1, far_em = 3;
  for (const bool clear_of_tips : {true, false}) {
    if (before && *before == box.liked.front() &&
        is_free(in_corner(layout, box, *before), near_em, clear_of_tips)) {
      return in_corner(layout, box, *before);
    }
    for (const double clear_em : {far_em, near_em}) {
      for (const Corner corner : box.liked) {
        if (!is_free(in_corner(layout, box, corner), clear_em, clear_of_tips)) continue;
        before = corner;
        return in_corner(layout, box, corner);
      }
    }
  }
  return {};
}

std::vector<Box> OverlayPlaces::place(const Layout& layout, const std::vector<Placed>& boxes,
                                      const std::optional<Vec2>& contact_px, const std::vector<Box>& taken,
                                      const std::vector<Vec2>& tips_px) {
  before_.resize(boxes.size());
  std::vector<Box> places;
  const auto meets = [](const Box& box) {
    return [&box](const Box& other) { return other.width > 0 && meet(box, other); };
  };
  const auto is_free = [&](const Box& box, double clear_em, bool clear_of_tips) {
    const auto hides = [&](const Vec2& px, double by_em) {
      return widened(box, by_em * layout.em).holds(px.x(), px.y());
    };
    constexpr double tip_share = 0.5;  // of what a contact is kept clear by
    const bool hides_tip = clear_of_tips && std::any_of(tips_px.begin(), tips_px.end(), [&](const Vec2& tip) {
                             return hides(tip, tip_share * clear_em);
                           });
    return !(contact_px && hides(*contact_px, clear_em)) && !hides_tip && within(box, layout.scene) &&
           std::none_of(places.begin(), places.end(), meets(box)) &&
           std::none_of(taken.begin(), taken.end(), meets(box));
  };
  for (std::size_t i = 0; i < boxes.size(); ++i)
    places.push_back(boxes[i].width > 0 ? choose(layout, boxes[i], before_[i], is_free) : Box{});
  return places;
}

}  // namespace fingerpad
