#include "view/overlay_help.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "view/colours.hpp"
#include "view/overlay_words.hpp"

namespace fingerpad {
namespace {

constexpr double help_column_em = 34;

/// The page's head, in which is told what has just been done: the page lies where that is told else.
void paint_help_head(Drawing& drawing, const OverlayFacts& facts, const Box& page, double em, bool is_cut) {
  const double height = 2.4 * em, line = 1.1 * em, middle = page.top() - height / 2;
  if (facts.message.empty()) {
    const std::string words =
        is_cut ? fitted("too small: enlarge it", 1.2 * em, true, page.width - em) : "keys and mouse";
    drawing.text({page.centre().x(), middle}, words,
                 {.size = 1.2 * em, .across = Across::centre, .upright = Upright::middle, .bold = true});
    return;
  }
  drawing.box({page.left, page.top() - height, page.width, height}, colours::ink);
  std::vector<std::string> lines = wrapped(facts.message, em, page.width - em, true);
  for (; lines.size() > 2; lines.pop_back()) lines[1] += "...";
  double y = middle + line * (static_cast<double>(lines.size()) - 1) / 2;
  for (const std::string& words : lines) {
    drawing.text({page.centre().x(), y}, fitted(words, em, true, page.width - em),
                 {.size = em,
                  .colour = colours::white,
                  .across = Across::centre,
                  .upright = Upright::middle,
                  .bold = true});
    y -= line;
  }
}

/// How the help page's lines lie in its room.
struct HelpLines {
  double size, line, columns;  ///< letters and lines [px]
  double per_column;           ///< so many lines
};

HelpLines lines_in(const OverlayFacts& facts, const Box& room, double height, double em) {
  constexpr double line_em = 1.6, least_line_em = 1.1, least_size = 0.7;
  const auto rows = static_cast<double>(facts.help.size());
  const double line = line_em * em, columns = std::ceil(rows / std::max(1.0, std::floor(height / line)));
  // Rather close to each other, and a little smaller, than cut: two columns may be too narrow.
  const double size = std::min(em, height / rows / least_line_em);
  const bool is_narrow = help_column_em * em * columns > room.width;
  if (is_narrow && size >= least_size * em) return {size, std::min(line, height / rows), 1, rows};
  // In columns that are narrower than this nothing can be read: rather fewer lines.
  constexpr double least_column_em = 20;
  const double room_for = std::max(1.0, std::floor(room.width / (least_column_em * em)));
  if (columns <= room_for) return {em, line, columns, std::ceil(rows / columns)};
  const double close = least_line_em * em, most = std::max(1.0, std::floor(height / close));
  return {em, close, room_for, std::min(most, std::ceil(rows / room_for))};
}

/// The lines that there is room for; of the rest, how many they are.
std::vector<std::string> shown_lines(const OverlayFacts& facts, const HelpLines& lie) {
  std::vector<std::string> lines = facts.help;
  const auto most = static_cast<std::size_t>(lie.columns * lie.per_column);
  if (lines.size() <= most) return lines;
  const std::size_t left_out = lines.size() - most + 1;
  lines.resize(most);
  lines.back() = fmt::format("{} more: enlarge this", left_out);
  return lines;
}

/// Where in a line stands what a key does, and how much is left free before it and at the end.
double does_px(double size) {
  return 11 * size;
}
double gap_px(double size) {
  return 0.4 * size;
}

/// Whether a line of the page has not room for all of its words.
bool is_cut(const std::string& entry, double size, double width) {
  const std::size_t colon = entry.find(": ");
  return colon != std::string::npos &&
         text_width(entry.substr(colon + 2), size) > width - does_px(size) - gap_px(size);
}

/// "key: what it does".
void paint_help_entry(Drawing& drawing, const Vec2& at, const std::string& entry, double size, double width) {
  const std::size_t colon = entry.find(": ");
  const double does = does_px(size), gap = gap_px(size);
  drawing.text(at, fitted(entry.substr(0, colon), size, true, does - gap),
               {.size = size, .upright = Upright::middle, .bold = true});
  if (colon == std::string::npos) return;
  drawing.text({at.x() + does, at.y()}, fitted(entry.substr(colon + 2), size, false, width - does - gap),
               {.size = size, .upright = Upright::middle});
}

}  // namespace

void paint_help(Drawing& drawing, const OverlayFacts& facts, const Box& room, double em) {
  const double head = 3.2 * em, foot = 0.6 * em;
  const HelpLines lie = lines_in(facts, room, room.height - head - foot - 0.4 * em, em);
  const auto& [size, line, columns, per_column] = lie;
  const double height = line * per_column + head + foot;
  const double width = std::min(help_column_em * em * columns, room.width - em);
  const Box box{room.centre().x() - width / 2, room.centre().y() - height / 2, width, height};
  drawing.box(box, colours::white);  // charts and readings lie beneath
  drawing.frame(box, {colours::ink, 0.12 * em});
  const double column_width = (width - em) / columns;
  const std::vector<std::string> entries = shown_lines(facts, lie);
  const bool any_is_cut =
      entries.size() < facts.help.size() ||
      std::ranges::any_of(entries, [&](const auto& entry) { return is_cut(entry, lie.size, column_width); });
  paint_help_head(drawing, facts, box, em, any_is_cut);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double column = std::floor(static_cast<double>(i) / per_column);
    const double left = box.left + em + column * column_width;
    const double y = box.top() - head + line / 2 - line * (static_cast<double>(i + 1) - column * per_column);
    paint_help_entry(drawing, {left, y}, entries[i], size, column_width);
  }
}

}  // namespace fingerpad
