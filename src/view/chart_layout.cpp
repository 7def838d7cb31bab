#include "view/chart_layout.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace fingerpad {
namespace {

constexpr double page_frame_width = 620, page_frame_height = 440;

struct Range {
  double min = HUGE_VAL, max = -HUGE_VAL;
  void take(double value, bool logarithmic) {
    if (!std::isfinite(value) || (logarithmic && !(value > 0))) return;
    min = std::min(min, value);
    max = std::max(max, value);
  }
  bool empty() const { return !(max >= min); }
  /// Widens what spans less than an axis may. A range that begins at zero goes on to.
  void widen(double least, bool from_zero) {
    if (empty() || max - min >= least) return;
    if (from_zero && min == 0) {
      max = least;
      return;
    }
    const double centre = min + (max - min) / 2, half = std::max(least / 2, 0.05 * std::abs(centre));
    min = centre - half;
    max = centre + half;
  }
};

/// Ends beyond the values by a share of their span, so that curves keep clear of the frame.
Axis clear_axis(Range range, std::string_view label, bool logarithmic, double share, bool from_zero,
                int most_marks) {
  if (logarithmic) {
    if (range.empty()) return log_axis(1, 10, most_marks);
    // A floor of rounding says nothing: eight decades are kept, of a power, which is a square, more.
    range.min = std::max(range.min, range.max * (label.ends_with("/Hz]") ? 1e-14 : 1e-8));
    const double pad = std::max(std::pow(range.max / range.min, share), 1.1);
    return log_axis(range.min / pad, range.max * pad, most_marks);
  }
  if (from_zero) range.take(0, false);
  if (range.empty()) return linear_axis(0, 1, most_marks);
  range.widen(least_span(label), from_zero);
  const double span = range.max > range.min ? range.max - range.min : std::max(std::abs(range.max), 1e-3);
  const bool foot = from_zero && range.min == 0;
  return linear_axis(foot ? 0 : range.min - share * span, range.max + share * span, most_marks);
}

Axis x_axis(const Chart& chart, const ChartPanel& panel, int most_marks) {
  Range range;
  const auto take = [&](const ChartPanel& one) {
    for (const ChartCurve& curve : one.curves) {
      for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
        if (chart.stacked || std::isfinite(curve.y[i])) range.take(curve.x[i], panel.log_x);
      }
    }
  };
  if (!chart.stacked) {
    take(panel);
    return clear_axis(range, panel.x_label, panel.log_x, panel.log_x ? 0.05 : 0.02, false, most_marks);
  }
  for (const ChartPanel& one : chart.panels) take(one);
  if (range.empty() || !(range.max > range.min)) return linear_axis(0, 1, most_marks);
  return panel.log_x ? log_axis(range.min, range.max, most_marks)
                     : linear_axis(range.min, range.max, most_marks);
}

/// Widens a span that is less than anybody would call a signal: upwards from zero, else to both sides.
void widen(Range& range, const ChartPanel& panel) {
  if (panel.log_y || range.empty()) return;
  const double lacking = panel.least_y_span - (range.max - range.min);
  if (!(lacking > 0)) return;
  const bool upwards = panel.y_from_zero && range.min >= 0;
  range.max += upwards ? lacking : lacking / 2;
  range.min -= upwards ? 0 : lacking / 2;
}

Axis y_axis(const ChartPanel& panel, int most_marks) {
  Range range;
  for (const ChartCurve& curve : panel.curves) {
    for (const double y : curve.y) range.take(y, panel.log_y);
  }
  for (const ChartLevel& level : panel.levels) range.take(level.y, panel.log_y);
  if (panel.y_from_zero) range.take(0, panel.log_y);
  widen(range, panel);
  return clear_axis(range, panel.y_label, panel.log_y, 0.05, panel.y_from_zero, most_marks);
}

/// Widens the axis that has fewer units a pixel.
void make_equal(ChartLayout::Panel& panel, double em) {
  const Box& frame = panel.frame;
  const double per_px =
      std::max((panel.x.max - panel.x.min) / frame.width, (panel.y.max - panel.y.min) / frame.height);
  const auto widened = [per_px](const Axis& axis, double length_px, int marks) {
    const double centre = (axis.min + axis.max) / 2, half = per_px * length_px / 2;
    return linear_axis(centre - half, centre + half, marks);
  };
  panel.x = widened(panel.x, frame.width, marks_along_x(frame.width, em));
  panel.y = widened(panel.y, frame.height, marks_along_y(frame.height, em));
}

double widest(const std::vector<std::string>& texts, double size) {
  double width = 0;
  for (const std::string& words : texts) width = std::max(width, text_width(words, size));
  return width;
}

/// From the left edge to the frame: the y label, the widest number, and the gaps beside them.
double left_of_frame(const ChartLayout& layout) {
  double numbers = 0;
  for (const ChartLayout::Panel& panel : layout.panels) {
    numbers = std::max(numbers, widest(panel.y.labels, layout.em));
  }
  return std::ceil(1.3 * layout.em + 0.55 * layout.em + numbers + 0.45 * layout.em);
}

constexpr double beside_frame_ems = 9;  // about: how wide the axis' numbers are is not known yet

double further_lines_px(int lines, double em) {
  return std::ceil(legend_line_ems * (lines - 1) * em);
}

}  // namespace

double further_legend_lines_px(const Chart& chart, double box_width_px, double em) {
  double sum = 0;
  for (const int lines : legend_rows(chart, box_width_px - beside_frame_ems * em, em))
    sum += further_lines_px(lines, em);
  return sum;
}

int marks_along_x(double length_px, double em) {
  return std::clamp(static_cast<int>(length_px / (4.3 * em)), 2, 12);
}

int marks_along_y(double length_px, double em) {
  return std::clamp(static_cast<int>(length_px / (2 * em)), 2, 7);
}

const std::string& fitting_y_label(const ChartPanel& panel, double height_px, double em) {
  const bool fits = panel.short_y_label.empty() || text_width(panel.y_label, em) < height_px + em;
  return fits ? panel.y_label : panel.short_y_label;
}

ChartLayout stacked_layout(const Chart& chart, const Box& box, double em, double least_left) {
  ChartLayout layout;
  layout.em = em;
  layout.page = box;
  const auto count = static_cast<int>(chart.panels.size());
  layout.rows = std::max(1, count);
  const std::vector<int> rows = legend_rows(chart, box.width - beside_frame_ems * em, em);
  const double above = std::ceil(1.75 * em), foot = std::ceil(2.9 * em);
  const double top = std::floor(box.top() - (chart.band ? 2.6 * em : 0));
  const double bottom = std::ceil(box.bottom + foot);
  const double legends = further_legend_lines_px(chart, box.width, em);
  const double height = std::max(2.0, std::floor((top - bottom - legends) / layout.rows - above));
  layout.gutter_y = above + (rows.size() > 1 ? further_lines_px(rows.back(), em) : 0);
  double frame_bottom = top;
  for (int i = 0; i < count; ++i) {
    const ChartPanel& panel = chart.panels[static_cast<std::size_t>(i)];
    const int lines = rows[static_cast<std::size_t>(i)];
    frame_bottom -= above + further_lines_px(lines, em) + height;
    layout.panels.push_back({{0, frame_bottom, 0, height},
                             {},
                             y_axis(panel, marks_along_y(height, em)),
                             i + 1 == count,
                             0,
                             0,
                             lines});
  }
  double left = left_of_frame(layout);
  if (chart.band) left = std::max(left, std::ceil(text_width(chart.band->title, em) + 0.8 * em));
  left = std::max(left + std::ceil(box.left), std::ceil(least_left));
  const double width = std::max(2.0, std::floor(box.right() - 1.1 * em) - left);
  for (std::size_t i = 0; i < layout.panels.size(); ++i) {
    ChartLayout::Panel& panel = layout.panels[i];
    panel.frame.left = left;
    panel.frame.width = width;
    panel.x = x_axis(chart, chart.panels[i], marks_along_x(width, em));
    panel.y_label_x = box.left + 0.75 * em;
    panel.title_y = panel.frame.top() + 0.75 * em;
  }
  if (chart.band) layout.strip = {left, box.top() - 2.3 * em, width, 0.75 * em};
  return layout;
}

ChartLayout page_layout(const Chart& chart) {
  ChartLayout layout;
  const double em = layout.em = chart_page_em;
  const double margin = std::ceil(1.2 * em);
  const auto count = static_cast<int>(chart.panels.size());
  layout.columns = std::max(1, chart.columns);
  layout.rows = std::max(1, (count + layout.columns - 1) / layout.columns);
  for (const ChartPanel& panel : chart.panels) {
    ChartLayout::Panel placed{{0, 0, page_frame_width, page_frame_height},
                              x_axis(chart, panel, marks_along_x(page_frame_width, em)),
                              y_axis(panel, marks_along_y(page_frame_height, em))};
    if (panel.equal_scales) make_equal(placed, em);
    layout.panels.push_back(std::move(placed));
  }
  const bool titled = std::any_of(chart.panels.begin(), chart.panels.end(),
                                  [](const ChartPanel& panel) { return !panel.title.empty(); });
  const double header = std::ceil(2.6 * em + 1.5 * em * static_cast<double>(chart.notes.size()));
  const double left = left_of_frame(layout), above = std::ceil((titled ? 2.2 : 0.9) * em),
               below = std::ceil(3.7 * em);
  layout.gutter_x = left + std::ceil(1.5 * em);
  layout.gutter_y = above + below;
  const double frames_width = layout.columns * page_frame_width + (layout.columns - 1) * layout.gutter_x;
  const double frames_height = layout.rows * page_frame_height + (layout.rows - 1) * layout.gutter_y;
  const double bottom = below + std::ceil(0.2 * em), top = bottom + frames_height;
  for (int i = 0; i < count; ++i) {
    ChartLayout::Panel& panel = layout.panels[static_cast<std::size_t>(i)];
    const int row = i / layout.columns, column = i % layout.columns;
    panel.frame.left = margin + left + column * (page_frame_width + layout.gutter_x);
    panel.frame.bottom = top - page_frame_height - row * (page_frame_height + layout.gutter_y);
    panel.y_label_x = panel.frame.left - left + 0.65 * em;
    panel.title_y = panel.frame.top() + 0.55 * em;
  }
  const double frames_right = margin + left + frames_width;
  layout.legend = {frames_right + 1.5 * margin, top - em};
  const double words = widest(chart.notes, em);
  const double width =
      std::max({frames_right + 1.5 * margin + legend_width(chart, em) + margin,
                text_width(chart.title, chart_title_ems * em, true) + 2 * margin, words + 2 * margin});
  layout.page = {0, 0, std::ceil(width), top + above + header};
  return layout;
}

}  // namespace fingerpad
