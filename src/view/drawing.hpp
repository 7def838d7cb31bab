#pragma once

#include <string>
#include <variant>
#include <vector>

#include "base/colour.hpp"
#include "base/types.hpp"

namespace fingerpad {

/// A rectangle of a drawing, in its units (pixels); y points up.
struct Box {
  double left = 0, bottom = 0, width = 0, height = 0;
  double right() const { return left + width; }
  double top() const { return bottom + height; }
  Vec2 centre() const { return {left + width / 2, bottom + height / 2}; }
  bool holds(double x, double y) const { return x >= left && x <= right() && y >= bottom && y <= top(); }
};

struct Stroke {
  Colour colour;
  double width = 1;
  double dash = 0, gap = 0;  ///< lengths along the line; dash 0: unbroken
};

enum class Across { left, centre, right };   ///< which part of a text stands at its point
enum class Upright { bottom, middle, top };  ///< bottom: the baseline

struct TextStyle {
  double size = 12;
  Colour colour = colours::ink;
  Across across = Across::left;
  Upright upright = Upright::bottom;
  bool bold = false;
  bool turned = false;  ///< reads upwards
};

/// A flat drawing as a list of marks, back to front: what charts and the head-up display are made of. Painted
/// by VTK over a picture, or written as SVG.
class Drawing {
 public:
  struct Line {
    std::vector<Vec2> points;
    Stroke stroke;
  };
  struct Area {
    std::vector<Vec2> points;  ///< of a convex polygon
    Colour fill;
  };
  struct Text {
    Vec2 at;
    std::string words;
    TextStyle style;
  };
  using Mark = std::variant<Line, Area, Text>;

  /// Fewer than two points draw nothing. @pre points finite
  void line(std::vector<Vec2> points, const Stroke& stroke);
  void line(const Vec2& from, const Vec2& to, const Stroke& stroke) { line({from, to}, stroke); }
  void area(std::vector<Vec2> points, const Colour& fill);
  void box(const Box& box, const Colour& fill);
  void frame(const Box& box, const Stroke& stroke);
  void disc(const Vec2& centre, double radius, const Colour& fill);
  /// What a file says stands as printable() has it.
  void text(const Vec2& at, const std::string& words, const TextStyle& style);

  /// Adds another drawing's marks in front of this one's.
  void append(const Drawing& other);

  const std::vector<Mark>& marks() const noexcept { return marks_; }

 private:
  std::vector<Mark> marks_;
};

/// How wide a text is as the pictures draw it, measured in their font; SVG asks its viewer for the same one.
double text_width(const std::string& words, double size, bool bold = false);

}  // namespace fingerpad
