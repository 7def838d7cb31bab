#include "view/overlay_words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fingerpad {

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

std::vector<std::string> wrapped(const std::string& words, double size, double width) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t from = 0; from < words.size();) {
    const std::size_t space = std::min(words.find(' ', from), words.size());
    const std::string word = words.substr(from, space - from);
    const std::string longer = line.empty() ? word : fmt::format("{} {}", line, word);
    if (!line.empty() && text_width(longer, size) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
    from = space + 1;
  }
  if (!line.empty()) lines.push_back(line);
  for (std::string& one : lines) one = fitted(one, size, false, width);
  return lines;
}

double pill_width(const std::string& words, double em) {
  return text_width(words, em, true) + 2.4 * em;
}

void paint_pill(Drawing& drawing, const Vec2& centre, const std::string& words, double em) {
  const double width = pill_width(words, em), height = 2.2 * em;
  drawing.box({centre.x() - width / 2, centre.y() - height / 2, width, height},
              colours::ink.with_opacity(0.85));
  drawing.text(centre, words,
               {.size = em,
                .colour = colours::white,
                .across = Across::centre,
                .upright = Upright::middle,
                .bold = true});
}

}  // namespace fingerpad
