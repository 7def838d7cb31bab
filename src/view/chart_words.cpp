#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "view/chart_layout.hpp"
#include "view/chart_marks.hpp"
#include "view/overlay_words.hpp"

namespace fingerpad {
namespace {

constexpr const char* front_name = "Pareto front";
constexpr double key_em = 2.6, key_gap_em = 0.6, line_em = 1.6;  // of a page's legend

/// Every name once, in the order of first use; only curves with something to show.
std::vector<const ChartCurve*> legend_of(const Chart& chart) {
  std::vector<const ChartCurve*> entries;
  for (const ChartPanel& panel : chart.panels) {
    for (const ChartCurve& curve : panel.curves) {
      const bool known = std::any_of(entries.begin(), entries.end(),
                                     [&](const ChartCurve* entry) { return entry->name == curve.name; });
      const bool shows = std::any_of(curve.y.begin(), curve.y.end(),
                                     [&](double y) { return std::isfinite(y) && (!panel.log_y || y > 0); });
      if (!known && shows && !curve.name.empty()) entries.push_back(&curve);
    }
  }
  return entries;
}

bool has_front(const Chart& chart) {
  return std::any_of(chart.panels.begin(), chart.panels.end(),
                     [](const ChartPanel& panel) { return panel.pareto_front.size() > 1; });
}

void add_page_legend(Drawing& drawing, const Chart& chart, const ChartLayout& layout) {
  const double em = layout.em;
  Vec2 at = layout.legend;
  const auto entry = [&](const std::string& name) {
    drawing.text(at + Vec2((key_em + key_gap_em) * em, 0), name, {.size = em, .upright = Upright::middle});
    at.y() -= line_em * em;
  };
  if (has_front(chart)) {
    draw_front_key(drawing, at, key_em * em, em);
    entry(front_name);
  }
  for (const ChartCurve* curve : legend_of(chart)) {
    draw_key(drawing, curve->style, at, key_em * em, em);
    entry(curve->name);
  }
}

/// A curve's name, without what it explains where that is too long.
std::string fitted_name(const std::string& name, double size, double room) {
  for (const char* from : {"", " (", " along "}) {
    const std::string shown = *from == '\0' ? name : name.substr(0, name.find(from));
    if (text_width(shown, size) <= room) return shown;
  }
  return "";
}

/// An entry of a legend whose entries stand side by side.
struct StackedKey {
  std::string name;
  bool is_mark;  ///< which may be left out
  std::function<void(const Vec2&)> draw;
};

/// In their order; where they do not fit, marks (Dash::none) stand behind lines and levels.
/// @param width  of a key, its gap and the gap behind its name
std::vector<StackedKey> stacked_keys(Drawing& drawing, const ChartPanel& panel, double size, double width,
                                     double room, double em) {
  double whole = 0;
  const auto measure = [&](const auto& one) { whole += width + text_width(one.name, size); };
  std::for_each(panel.curves.begin(), panel.curves.end(), measure);
  std::for_each(panel.levels.begin(), panel.levels.end(), measure);
  const bool fits = whole - 0.9 * em <= room;
  std::vector<StackedKey> keys;
  const auto add = [&](const std::string& name, const auto& look, bool is_mark) {
    if (name.empty()) return;
    keys.push_back(
        {name, is_mark, [&drawing, look, em](const Vec2& at) { draw_key(drawing, look, at, 1.6 * em, em); }});
  };
  const auto is_late = [fits](const ChartCurve& curve) { return !fits && curve.style.dash == Dash::none; };
  for (const ChartCurve& curve : panel.curves) {
    if (!is_late(curve)) add(curve.name, curve.style, curve.style.dash == Dash::none);
  }
  for (const ChartLevel& level : panel.levels) add(level.name, level, false);
  for (const ChartCurve& curve : panel.curves) {
    if (is_late(curve)) add(curve.name, curve.style, true);
  }
  return keys;
}

/// The names, each shortened where the room behind those before it asks for that, and of marks none where
/// there is none; of no key, where another than a mark would have none.
std::vector<std::string> names_in_turn(const std::vector<StackedKey>& keys, double size, double width,
                                       double room) {
  std::vector<std::string> names;
  double left = room;
  for (const StackedKey& key : keys) {
    names.push_back(fitted_name(key.name, size, left - width));
    if (!names.back().empty())
      left -= width + text_width(names.back(), size);
    else if (!key.is_mark)
      return {};
  }
  return names;
}

/// The names, all cut to one width; where that is too little, fewer, and how many more there are.
std::vector<std::string> names_of_one_width(const std::vector<StackedKey>& keys, double size, double width,
                                            double room) {
  constexpr double least_ems = 4;
  const auto most = static_cast<std::size_t>(std::max(2.0, room / (width + least_ems * size)));
  const std::size_t shown = keys.size() <= most ? keys.size() : most - 1;
  const double each = room / static_cast<double>(std::min(keys.size(), most)) - width;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < shown; ++i) {
    const std::string name = fitted_name(keys[i].name, size, each);
    names.push_back(name.empty() ? fitted_in_middle(keys[i].name, size, false, each) : name);
  }
  if (shown < keys.size()) names.push_back("and " + std::to_string(keys.size() - shown) + " more");
  return names;
}

/// Where whole entries stand that go on in a further line where one is full: each one's line, from the top.
/// @param width  of a key, its gap and the gap behind its name
template <typename NameOf>
std::vector<int> lines_of_entries(std::size_t count, const NameOf& name_of, double size, double width,
                                  double room) {
  std::vector<int> lines;
  double left = room;
  int line = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double takes = width + text_width(name_of(i), size);
    if (takes > left && left < room) {
      ++line;
      left = room;
    }
    left -= takes;
    lines.push_back(line);
  }
  return lines;
}

/// Sizes of a stacked legend: of its words, of a key, of the gap behind that and of the one behind a name.
struct StackedSizes {
  explicit StackedSizes(double em) : size(0.92 * em), key(1.6 * em), gap(0.3 * em), apart(0.9 * em) {}
  double size, key, gap, apart;
  double beside_name() const { return key + gap + apart; }
};

/// Entries in several lines: whole, or cut to one width where they take more than there are.
void add_legend_lines(Drawing& drawing, const std::vector<StackedKey>& keys, const ChartLayout::Panel& placed,
                      int rows, double room, double em) {
  const StackedSizes sizes(em);
  const auto name_of = [&](std::size_t i) -> const std::string& { return keys[i].name; };
  const auto count = keys.size(), lines = static_cast<std::size_t>(rows),
             a_line = (count + lines - 1) / lines;
  std::vector<int> line_of = lines_of_entries(count, name_of, sizes.size, sizes.beside_name(), room);
  const bool are_whole = line_of.back() < rows;
  const int last_line = are_whole ? line_of.back() : rows - 1;  // which stands upon the frame
  const double each = room / static_cast<double>(a_line) - sizes.beside_name();
  double x = placed.frame.left;
  for (std::size_t i = 0; i < count; ++i) {
    const int line = are_whole ? line_of[i] : static_cast<int>(i / a_line);
    const bool is_first = i == 0 || line != (are_whole ? line_of[i - 1] : static_cast<int>((i - 1) / a_line));
    if (is_first) x = placed.frame.left;
    const double y = placed.title_y + legend_line_ems * em * (last_line - line);
    const std::string name =
        are_whole ? keys[i].name : fitted_in_middle(keys[i].name, sizes.size, false, each);
    keys[i].draw({x, y});
    drawing.text({x + sizes.key + sizes.gap, y}, name, {.size = sizes.size, .upright = Upright::middle});
    x += sizes.beside_name() + (are_whole ? text_width(name, sizes.size) : each);
  }
}

/// Entries side by side from the left.
void add_stacked_legend(Drawing& drawing, const ChartPanel& panel, const ChartLayout::Panel& placed, int rows,
                        double em) {
  const auto [size, key, gap, apart] = StackedSizes(em);
  const double room = placed.frame.width + em + apart, width = key + gap + apart;
  const std::vector<StackedKey> keys = stacked_keys(drawing, panel, size, width, room - apart, em);
  if (rows > 1 && !keys.empty()) {
    add_legend_lines(drawing, keys, placed, rows, room, em);
    return;
  }
  std::vector<std::string> names = names_in_turn(keys, size, width, room);
  if (names.empty()) names = names_of_one_width(keys, size, width, room);
  double x = placed.frame.left;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) continue;
    const bool is_key = i + 1 < names.size() || names.size() == keys.size();
    if (is_key) keys[i].draw({x, placed.title_y});
    const double text_x = is_key ? x + key + gap : x;
    drawing.text({text_x, placed.title_y}, names[i], {.size = size, .upright = Upright::middle});
    x = text_x + text_width(names[i], size) + apart;
  }
}

void add_band_words(Drawing& drawing, const ChartBand& band, const ChartLayout& layout) {
  const double em = layout.em, size = 0.92 * em;
  const Box& strip = layout.strip;
  const double middle = layout.page.top() - 0.75 * em;
  double x = strip.left;
  for (const ChartBand::Key& key : band.keys) {
    drawing.box({x, middle - 0.4 * em, 0.8 * em, 0.8 * em}, key.colour);
    drawing.text({x + 1.1 * em, middle}, key.name, {.size = size, .upright = Upright::middle});
    x += 2.3 * em + text_width(key.name, size);
  }
  drawing.text({strip.left - 0.45 * em, strip.centre().y()}, band.title,
               {.size = em, .across = Across::right, .upright = Upright::middle});
}

}  // namespace

std::vector<int> legend_rows(const Chart& chart, double width_px, double em) {
  const StackedSizes sizes(em);
  std::vector<int> rows;
  for (const ChartPanel& panel : chart.panels) {
    std::vector<std::string> names;
    for (const ChartCurve& curve : panel.curves) {
      if (!curve.name.empty()) names.push_back(curve.name);
    }
    rows.push_back(1);
    if (names.empty() || chart.legend_rows < 2) continue;
    const auto name_of = [&](std::size_t i) -> const std::string& { return names[i]; };
    const int last =
        lines_of_entries(names.size(), name_of, sizes.size, sizes.beside_name(), width_px).back();
    rows.back() = std::min(1 + last, chart.legend_rows);
  }
  // Panels that stand evenly apart have as much room as the one with the most lines takes.
  if (rows.size() > 1)
    std::fill(rows.begin() + 1, rows.end(), *std::max_element(rows.begin() + 1, rows.end()));
  return rows;
}

double legend_width(const Chart& chart, double em) {
  double widest = has_front(chart) ? text_width(front_name, em) : 0;
  for (const ChartCurve* entry : legend_of(chart)) widest = std::max(widest, text_width(entry->name, em));
  return widest > 0 ? (key_em + key_gap_em) * em + widest : 0;
}

Drawing chart_words(const Chart& chart, const ChartLayout& layout) {
  Drawing drawing;
  const double em = layout.em;
  if (chart.stacked) {
    for (std::size_t i = 0; i < layout.panels.size(); ++i) {
      add_stacked_legend(drawing, chart.panels[i], layout.panels[i], layout.panels[i].legend_rows, em);
    }
    if (chart.band) add_band_words(drawing, *chart.band, layout);
    return drawing;
  }
  const double margin = 1.2 * em;
  double y = layout.page.top() - 1.9 * em;
  drawing.text({margin, y}, chart.title, {.size = chart_title_ems * em, .bold = true});
  for (const std::string& note : chart.notes) {
    y -= 1.5 * em;
    drawing.text({margin, y}, note, {.size = em, .colour = colours::grey});
  }
  for (std::size_t i = 0; i < layout.panels.size(); ++i) {
    const ChartLayout::Panel& placed = layout.panels[i];
    drawing.text({placed.frame.centre().x(), placed.title_y}, chart.panels[i].title,
                 {.size = em, .across = Across::centre});
  }
  add_page_legend(drawing, chart, layout);
  return drawing;
}

}  // namespace fingerpad
