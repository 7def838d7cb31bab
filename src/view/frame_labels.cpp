#include "view/frame_labels.hpp"

#include <algorithm>

namespace fingerpad {
namespace {

/// Half the height of a letter, and what is left free about it [em].
constexpr double half_letter_em = 0.55, arrow_em = 0.3;

Vec2 half_size(const std::string& name, double em) {
  return {text_width(name, 0.95 * em) / 2, half_letter_em * em};
}

bool meet(const Vec2& a, const Vec2& half_a, const Vec2& b, const Vec2& half_b) {
  return std::abs(a.x() - b.x()) < half_a.x() + half_b.x() &&
         std::abs(a.y() - b.y()) < half_a.y() + half_b.y();
}

/// Whether a line passes a box, by the parts of the line between its sides (Liang & Barsky 1984).
bool crosses(const ScreenArrow& arrow, const Vec2& centre, const Vec2& half) {
  const Vec2 along = arrow.second - arrow.first;
  double from = 0, to = 1;
  for (int i = 0; i < 2; ++i) {
    const double low = centre[i] - half[i] - arrow.first[i], high = low + 2 * half[i];
    if (along[i] == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    from = std::max(from, std::min(low / along[i], high / along[i]));
    to = std::min(to, std::max(low / along[i], high / along[i]));
  }
  return from <= to;
}

/// Where letters may stand: beyond the tip, then on either side of it, then farther out.
std::vector<Vec2> candidates(const ScreenArrow& axis, double em) {
  const Vec2 along = (axis.second - axis.first).normalized(), aside(-along.y(), along.x());
  std::vector<Vec2> places;
  for (const double away : {0.9, 1.5, 2.2}) {
    places.emplace_back(axis.second + away * em * along);
    for (const double side : {1.0, -1.0}) {
      places.emplace_back(axis.second + em * (0.5 * along + side * away * aside));
      places.emplace_back(axis.second + em * (-0.4 * along + side * away * aside));
    }
  }
  return places;
}

}  // namespace

std::vector<OverlayFacts::Label> frame_labels(std::span<const NamedAxis> axes,
                                              std::span<const ScreenArrow> arrows, std::span<const Box> boxes,
                                              const Box& within, double em) {
  std::vector<OverlayFacts::Label> labels;
  const auto is_free = [&](const Vec2& at, const Vec2& half) {
    const Vec2 clear = half + Vec2(arrow_em, arrow_em) * em;
    const auto hides = [&](const Box& box) {
      return box.width > 0 && meet(at, half, box.centre(), {box.width / 2, box.height / 2});
    };
    const auto covers = [&](const OverlayFacts::Label& label) {
      return meet(at, clear, label.at, half_size(label.words, em));
    };
    return within.holds(at.x(), at.y()) && std::none_of(boxes.begin(), boxes.end(), hides) &&
           std::none_of(labels.begin(), labels.end(), covers) &&
           std::none_of(arrows.begin(), arrows.end(),
                        [&](const ScreenArrow& arrow) { return crosses(arrow, at, clear); }) &&
           std::none_of(axes.begin(), axes.end(),
                        [&](const NamedAxis& axis) { return crosses(axis.on_screen, at, half); });
  };
  for (const NamedAxis& axis : axes) {
    if ((axis.on_screen.second - axis.on_screen.first).norm() < 0.6 * em) continue;
    const Vec2 half = half_size(axis.name, em);
    const std::vector<Vec2> places = candidates(axis.on_screen, em);
    const auto place =
        std::find_if(places.begin(), places.end(), [&](const Vec2& at) { return is_free(at, half); });
    if (place != places.end()) labels.push_back({*place, axis.name});
  }
  return labels;
}

}  // namespace fingerpad
