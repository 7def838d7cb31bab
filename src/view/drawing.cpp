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

double text_width(const std::string& words, double size, bool bold) {
  double ems = 0;
  for (const char c : words) {
    if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;  // the rest of a character of several bytes
    if (std::string_view("il.,:;'|!()[]/ fjt").find(c) != std::string_view::npos) {
      ems += 0.34;
    } else if (std::string_view("mwMW@%").find(c) != std::string_view::npos) {
      ems += 0.92;
    } else {
      ems += c >= 'A' && c <= 'Z' ? 0.72 : 0.6;
    }
  }
  return ems * size * (bold ? 1.08 : 1);
}

}  // namespace fingerpad
