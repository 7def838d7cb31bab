#include "view/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/printable_text.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

std::string escaped(const std::string& words) {
  std::string out;
  for (const char c : words) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) out += c;
    }
  }
  return out;
}

/// Marks the points between `first` and `last` that a line within `tolerance` of all of them needs (Douglas &
/// Peucker 1973).
void mark_needed(const std::vector<Vec2>& points, std::size_t first, std::size_t last, double tolerance,
                 std::vector<bool>& needed) {
  const Vec2 along = points[last] - points[first];
  const double length = along.norm();
  double farthest = tolerance;
  std::size_t split = 0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const Vec2 from_first = points[i] - points[first];
    const double share = length > 0 ? std::clamp(from_first.dot(along) / (length * length), 0.0, 1.0) : 0;
    const double distance = (from_first - share * along).norm();
    if (distance > farthest) {
      farthest = distance;
      split = i;
    }
  }
  if (split == 0) return;
  needed[split] = true;
  mark_needed(points, first, split, tolerance, needed);
  mark_needed(points, split, last, tolerance, needed);
}

/// The points that can be told apart on a screen: thousands of samples make a file that nobody can send.
std::vector<Vec2> simplified(const std::vector<Vec2>& points) {
  constexpr double tolerance_px = 0.15;
  if (points.size() < 3) return points;
  std::vector<bool> needed(points.size());
  needed.front() = needed.back() = true;
  mark_needed(points, 0, points.size() - 1, tolerance_px, needed);
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (needed[i]) kept.push_back(points[i]);
  }
  return kept;
}

/// Writes marks as elements. SVG's y points down.
struct ElementWriter {
  std::string& out;
  double height;

  auto end() { return std::back_inserter(out); }

  std::string coordinates(const std::vector<Vec2>& points) const {
    std::string list;
    for (const Vec2& p : simplified(points)) {
      fmt::format_to(std::back_inserter(list), "{:.1f},{:.1f} ", p.x(), height - p.y());
    }
    if (!list.empty()) list.pop_back();
    return list;
  }

  static std::string paint(const char* name, const Colour& colour) {
    std::string text = fmt::format("{}=\"#{:02x}{:02x}{:02x}\"", name, colour.red, colour.green, colour.blue);
    if (colour.opacity < 1) text += fmt::format(" {}-opacity=\"{:.3g}\"", name, colour.opacity);
    return text;
  }

  void operator()(const Drawing::Line& line) {
    fmt::format_to(end(), "<polyline points=\"{}\" fill=\"none\" {} stroke-width=\"{:.2f}\"",
                   coordinates(line.points), paint("stroke", line.stroke.colour), line.stroke.width);
    if (line.stroke.dash > 0) {
      fmt::format_to(end(), " stroke-dasharray=\"{:.2f} {:.2f}\"", line.stroke.dash, line.stroke.gap);
    }
    out += " stroke-linejoin=\"round\"/>\n";
  }

  void operator()(const Drawing::Area& area) {
    fmt::format_to(end(), "<polygon points=\"{}\" {}/>\n", coordinates(area.points),
                   paint("fill", area.fill));
  }

  void operator()(const Drawing::Text& text) {
    const TextStyle& style = text.style;
    constexpr const char* anchors[] = {"start", "middle", "end"};
    // The height of a capital is .72 em; renderers differ in dominant-baseline, so it is reckoned here.
    const double drop = style.upright == Upright::top      ? 0.72 * style.size
                        : style.upright == Upright::middle ? 0.36 * style.size
                                                           : 0;
    const double x = text.at.x() + (style.turned ? drop : 0);
    const double y = height - text.at.y() + (style.turned ? 0 : drop);
    fmt::format_to(end(), "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\" text-anchor=\"{}\" {}", x, y,
                   style.size, anchors[static_cast<int>(style.across)], paint("fill", style.colour));
    if (style.bold) out += " font-weight=\"bold\"";
    if (style.turned) fmt::format_to(end(), " transform=\"rotate(-90 {:.2f} {:.2f})\"", x, y);
    fmt::format_to(end(), ">{}</text>\n", escaped(text.words));
  }
};

}  // namespace

std::string svg_page(const Drawing& drawing, int width, int height, const std::string& title) {
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"DejaVu Sans, Verdana, Arial, Helvetica, sans-serif\">\n<title>{2}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      width, height, escaped(printable(title)));
  ElementWriter writer{out, static_cast<double>(height)};
  for (const auto& mark : drawing.marks()) std::visit(writer, mark);
  out += "</svg>\n";
  return out;
}

void write_svg(const Drawing& drawing, int width, int height, const std::string& title,
               const std::string& path) {
  OutputFile file(path);
  file.write(svg_page(drawing, width, height, title));
  file.commit();
}

}  // namespace fingerpad
