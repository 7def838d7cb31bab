#include <algorithm>
#include <cmath>

#include "view/chart_layout.hpp"
#include "view/chart_marks.hpp"

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

/// Entries side by side from the left. Where they do not fit, marks (Dash::none) stand behind lines and
/// levels, and what does not fit is shortened, or left out.
void add_stacked_legend(Drawing& drawing, const ChartPanel& panel, const ChartLayout::Panel& placed,
                        double em) {
  const double size = 0.92 * em, key = 1.6 * em;
  double x = placed.frame.left;
  const auto entry = [&](const std::string& whole_name, const auto& look) {
    const double room = placed.frame.right() + em - (x + key + 0.3 * em);
    const std::string name = fitted_name(whole_name, size, room);
    if (name.empty()) return;
    const double width = key + 0.3 * em + text_width(name, size);
    draw_key(drawing, look, {x, placed.title_y}, key, em);
    drawing.text({x + key + 0.3 * em, placed.title_y}, name, {.size = size, .upright = Upright::middle});
    x += width + 0.9 * em;
  };
  double whole = 0;
  const auto measure = [&](const auto& one) { whole += key + 1.2 * em + text_width(one.name, size); };
  std::for_each(panel.curves.begin(), panel.curves.end(), measure);
  std::for_each(panel.levels.begin(), panel.levels.end(), measure);
  const bool fits = whole - 0.9 * em <= placed.frame.width + em;
  const auto is_late = [fits](const ChartCurve& curve) { return !fits && curve.style.dash == Dash::none; };
  for (const ChartCurve& curve : panel.curves) {
    if (!is_late(curve)) entry(curve.name, curve.style);
  }
  for (const ChartLevel& level : panel.levels) entry(level.name, level);
  for (const ChartCurve& curve : panel.curves) {
    if (is_late(curve)) entry(curve.name, curve.style);
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
      add_stacked_legend(drawing, chart.panels[i], layout.panels[i], em);
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
