#include "view/drawing.hpp"

#include <cmath>
#include <numbers>

#include "base/printable_text.hpp"

namespace fingerpad {

void Drawing::line(std::vector<Vec2> points, const Stroke& stroke) {
  if (points.size() > 1) marks_.emplace_back(Line{std::move(points), stroke});
}

void Drawing::area(std::vector<Vec2> points, const Colour& fill) {
  if (points.size() > 2) marks_.emplace_back(Area{std::move(points), fill});
}

void Drawing::box(const Box& box, const Colour& fill) {
  area({{box.left, box.bottom}, {box.right(), box.bottom}, {box.right(), box.top()}, {box.left, box.top()}},
       fill);
}

void Drawing::frame(const Box& box, const Stroke& stroke) {
  line({{box.left, box.bottom},
        {box.right(), box.bottom},
        {box.right(), box.top()},
        {box.left, box.top()},
        {box.left, box.bottom}},
       stroke);
}

void Drawing::disc(const Vec2& centre, double radius, const Colour& fill) {
  std::vector<Vec2> points;
  for (int i = 0; i < 24; ++i) {
    const double angle = 2 * std::numbers::pi * i / 24;
    points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  area(std::move(points), fill);
}

void Drawing::text(const Vec2& at, const std::string& words, const TextStyle& style) {
  if (!words.empty()) marks_.emplace_back(Text{at, printable(words), style});
}

void Drawing::append(const Drawing& other) {
  marks_.insert(marks_.end(), other.marks_.begin(), other.marks_.end());
}

}  // namespace fingerpad
