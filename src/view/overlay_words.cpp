#include "view/overlay_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace fingerpad {
namespace {

constexpr double pill_line_em = 1.5;

}  // namespace

void draw_panel(Drawing& drawing, const Box& box) {
  drawing.box(box, panel_colour);
  drawing.frame(box, {colours::pale_grey, 1});
}

std::string fitted(const std::string& words, double size, bool bold, double width) {
  if (text_width(words, size, bold) <= width) return words;
  std::string cut = words;
  while (!cut.empty() && text_width(cut + "...", size, bold) > width) {
    cut.pop_back();
    // Not within a letter of several bytes.
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80) cut.pop_back();
    if (!cut.empty() && static_cast<unsigned char>(cut.back()) >= 0xC0) cut.pop_back();
  }
  return cut.empty() ? "" : cut + "...";
}

std::string fitted_in_middle(const std::string& words, double size, bool bold, double width) {
  if (text_width(words, size, bold) <= width) return words;
  std::vector<std::string> letters;  // of one byte or several
  for (const char byte : words) {
    if (letters.empty() || (static_cast<unsigned char>(byte) & 0xC0) != 0x80) letters.emplace_back();
    letters.back() += byte;
  }
  const auto with = [&](std::size_t kept) {
    const auto middle = letters.begin() + static_cast<std::ptrdiff_t>((kept + 1) / 2);
    const auto rest = letters.end() - static_cast<std::ptrdiff_t>(kept / 2);
    return fmt::format("{}...{}", fmt::join(letters.begin(), middle, ""), fmt::join(rest, letters.end(), ""));
  };
  std::size_t fits = 0, too_many = letters.size();
  while (too_many - fits > 1) {
    const std::size_t kept = (fits + too_many) / 2;
    (text_width(with(kept), size, bold) <= width ? fits : too_many) = kept;
  }
  return fits == 0 ? "" : with(fits);
}

std::vector<std::string> wrapped(const std::string& words, double size, double width, bool bold) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t from = 0; from < words.size();) {
    const std::size_t space = std::min(words.find(' ', from), words.size());
    const std::string word = words.substr(from, space - from);
    const std::string longer = line.empty() ? word : fmt::format("{} {}", line, word);
    if (!line.empty() && text_width(longer, size, bold) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
    from = space + 1;
  }
  if (!line.empty()) lines.push_back(line);
  for (std::string& one : lines) one = fitted(one, size, bold, width);
  return lines;
}

Vec2 pill_size(const std::vector<std::string>& lines, double em) {
  if (lines.empty()) return {0, 0};
  double width = 0;
  for (const std::string& line : lines) width = std::max(width, text_width(line, em, true));
  return {width + 2.4 * em, (2.2 + pill_line_em * (static_cast<double>(lines.size()) - 1)) * em};
}

void paint_pill(Drawing& drawing, const Vec2& centre, const std::vector<std::string>& lines, double em) {
  if (lines.empty()) return;
  const Vec2 size = pill_size(lines, em);
  drawing.box({centre.x() - size.x() / 2, centre.y() - size.y() / 2, size.x(), size.y()},
              colours::ink.with_opacity(0.85));
  double y = centre.y() + pill_line_em * em * (static_cast<double>(lines.size()) - 1) / 2;
  for (const std::string& line : lines) {
    drawing.text({centre.x(), y}, line,
                 {.size = em,
                  .colour = colours::white,
                  .across = Across::centre,
                  .upright = Upright::middle,
                  .bold = true});
    y -= pill_line_em * em;
  }
}

}  // namespace fingerpad
