#include "app/study_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "view/axis.hpp"
#include "view/plot.hpp"

namespace fingerpad {
namespace {

constexpr double em = 16;  // size of labels [px]
constexpr double margin = 1.2 * em;
constexpr double panel_width = 620, panel_height = 440;
constexpr double left_of_panel = 6.2 * em, below_panel = 4.2 * em, above_panel = 2.2 * em;
constexpr const char* front_name = "Pareto front";

Colour colour_of(const SeriesStyle& style) {
  constexpr Colour palette[] = {colours::blue,           colours::vermillion, colours::bluish_green,
                                colours::reddish_purple, colours::orange,     colours::ink,
                                colours::sky_blue,       colours::grey};
  return palette[static_cast<std::size_t>(style.colour) % std::size(palette)];
}

Stroke stroke_of(const SeriesStyle& style) {
  const double width = 2 * style.weight;
  switch (style.dash) {
    case SeriesDash::dashed:
      return {colour_of(style), width, 5 * width, 3 * width};
    case SeriesDash::dotted:
      return {colour_of(style), width, 1.2 * width, 2 * width};
    case SeriesDash::dash_dot:
      return {colour_of(style), width, 8 * width, 2 * width};
    case SeriesDash::none:
    case SeriesDash::solid:
      break;
  }
  return {colour_of(style), width};
}

void draw_marker(Drawing& drawing, const Vec2& at, const SeriesStyle& style) {
  const double r = 5 * style.weight;
  const Colour colour = colour_of(style);
  switch (style.marker) {
    case SeriesMarker::none:
      return;
    case SeriesMarker::disc:
      drawing.disc(at, r, colour);
      return;
    case SeriesMarker::square:
      drawing.box({at.x() - 0.85 * r, at.y() - 0.85 * r, 1.7 * r, 1.7 * r}, colour);
      return;
    case SeriesMarker::triangle:
      drawing.area({at + Vec2(0, 1.15 * r), at + Vec2(-r, -0.7 * r), at + Vec2(r, -0.7 * r)}, colour);
      return;
    case SeriesMarker::diamond:
      drawing.area(
          {at + Vec2(0, 1.2 * r), at + Vec2(-1.2 * r, 0), at - Vec2(0, 1.2 * r), at + Vec2(1.2 * r, 0)},
          colour);
      return;
    case SeriesMarker::ring: {
      std::vector<Vec2> points;
      for (int i = 0; i <= 24; ++i) {
        const double angle = 2 * std::numbers::pi * i / 24;
        points.emplace_back(at + r * Vec2(std::cos(angle), std::sin(angle)));
      }
      drawing.line(std::move(points), {colour, 2});
      return;
    }
    case SeriesMarker::cross:
      drawing.line(at + Vec2(-r, -r), at + Vec2(r, r), {colour, 2.2});
      drawing.line(at + Vec2(-r, r), at + Vec2(r, -r), {colour, 2.2});
  }
}

/// A logarithmic axis that ends near its values, marked at 1, 2 and 5 where there is room, else at decades.
Axis log_axis(double min, double max) {
  const double pad = std::max(std::pow(max / min, 0.05), 1.1);
  Axis axis{min / pad, max * pad, true, {}, {}};
  const double decades = std::log10(axis.max / axis.min);
  const int every = std::max(1, static_cast<int>(decades / 7));
  for (int k = static_cast<int>(std::floor(std::log10(axis.min))); k <= std::log10(axis.max); ++k) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double mark = step * std::pow(10.0, k);
      const bool wanted = decades < 2.6 || (step == 1 && k % every == 0);
      if (!wanted || mark < axis.min || mark > axis.max) continue;
      axis.marks.push_back(mark);
      axis.labels.push_back(k < -3 || k > 5 ? plain_number(step) + "e" + std::to_string(k)
                                            : plain_number(mark));
    }
  }
  return axis;
}

/// The axis that holds one coordinate of every drawn point; logarithmic ones keep seven decades at most.
Axis axis_of(const StudyPanel& panel, bool is_x) {
  const bool logarithmic = is_x ? panel.log_x : panel.log_y;
  double min = HUGE_VAL, max = -HUGE_VAL;
  for (const StudySeries& series : panel.series) {
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      const double value = is_x ? series.x[i] : series.y[i];
      if (!std::isfinite(series.y[i]) || (logarithmic && !(value > 0))) continue;
      min = std::min(min, value);
      max = std::max(max, value);
    }
  }
  if (!(max >= min)) return logarithmic ? log_axis(1, 10) : linear_axis(0, 1, 6);
  if (logarithmic) return log_axis(std::max(min, max * 1e-7), max);
  const double pad = is_x ? 0.02 * (max - min) : 0.04 * (max - min);
  return linear_axis(min - pad, max + pad, is_x ? 9 : 7);
}

/// Paints one panel into its box (the frame, without labels).
class PanelPainter {
 public:
  PanelPainter(Drawing& drawing, const StudyPanel& panel, const Box& box)
      : drawing_(drawing), panel_(panel), box_(box), x_(axis_of(panel, true)), y_(axis_of(panel, false)) {
    if (panel.equal_scales) make_equal();
  }

  void paint() {
    paint_grid();
    if (panel_.pareto_front.size() > 1) paint_front();
    for (const StudySeries& series : panel_.series) paint_series(series);
    drawing_.frame(box_, {colours::grey, 1.3});
    const TextStyle centred{.size = em, .across = Across::centre};
    drawing_.text({box_.centre().x(), box_.top() + 0.5 * em}, panel_.title, centred);
    drawing_.text({box_.centre().x(), box_.bottom - 2.9 * em}, panel_.x_label, centred);
    TextStyle turned = centred;
    turned.turned = true;
    turned.upright = Upright::middle;
    drawing_.text({box_.left - 4.6 * em, box_.centre().y()}, panel_.y_label, turned);
  }

 private:
  /// Widens the axis that has fewer units a pixel.
  void make_equal() {
    const double per_px = std::max((x_.max - x_.min) / box_.width, (y_.max - y_.min) / box_.height);
    const auto widened = [per_px](const Axis& axis, double length_px, int marks) {
      const double centre = (axis.min + axis.max) / 2, half = per_px * length_px / 2;
      return linear_axis(centre - half, centre + half, marks);
    };
    x_ = widened(x_, box_.width, 9);
    y_ = widened(y_, box_.height, 7);
  }

  bool is_drawn(double x, double y) const {
    return std::isfinite(x) && std::isfinite(y) && (!x_.logarithmic || x >= x_.min) &&
           (!y_.logarithmic || y >= y_.min);
  }
  Vec2 place(double x, double y) const {
    return {box_.left + box_.width * std::clamp(x_.share(x), 0.0, 1.0),
            box_.bottom + box_.height * std::clamp(y_.share(y), 0.0, 1.0)};
  }

  void paint_grid() {
    const Stroke grid{colours::pale_grey, 1};
    for (std::size_t i = 0; i < x_.marks.size(); ++i) {
      const double x = box_.left + box_.width * x_.share(x_.marks[i]);
      drawing_.line({x, box_.bottom}, {x, box_.top()}, grid);
      drawing_.text({x, box_.bottom - 0.5 * em}, x_.labels[i],
                    {.size = 0.92 * em, .across = Across::centre, .upright = Upright::top});
    }
    for (std::size_t i = 0; i < y_.marks.size(); ++i) {
      const double y = box_.bottom + box_.height * y_.share(y_.marks[i]);
      drawing_.line({box_.left, y}, {box_.right(), y}, grid);
      drawing_.text({box_.left - 0.45 * em, y}, y_.labels[i],
                    {.size = 0.92 * em, .across = Across::right, .upright = Upright::middle});
    }
  }

  void paint_front() {
    std::vector<Vec2> points;
    for (const auto& [x, y] : panel_.pareto_front) {
      if (is_drawn(x, y)) points.push_back(place(x, y));
    }
    drawing_.line(std::move(points), {colours::yellow.with_opacity(0.75), 12});
  }

  void paint_series(const StudySeries& series) {
    std::vector<Vec2> run;
    const auto flush = [&] {
      if (series.style.dash != SeriesDash::none) drawing_.line(run, stroke_of(series.style));
      for (const Vec2& at : run) draw_marker(drawing_, at, series.style);
      run.clear();
    };
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (is_drawn(series.x[i], series.y[i])) {
        run.push_back(place(series.x[i], series.y[i]));
      } else {
        flush();
      }
    }
    flush();
  }

  Drawing& drawing_;
  const StudyPanel& panel_;
  Box box_;
  Axis x_, y_;
};

struct LegendEntry {
  std::string name;
  SeriesStyle style;
};

/// Every name once, in the order of first use; only series with something to show.
std::vector<LegendEntry> legend_of(const StudyChart& chart) {
  std::vector<LegendEntry> entries;
  for (const StudyPanel& panel : chart.panels) {
    for (const StudySeries& series : panel.series) {
      const bool known = std::any_of(entries.begin(), entries.end(),
                                     [&](const LegendEntry& entry) { return entry.name == series.name; });
      const bool shows = std::any_of(series.y.begin(), series.y.end(),
                                     [&](double y) { return std::isfinite(y) && (!panel.log_y || y > 0); });
      if (!known && shows && !series.name.empty()) entries.push_back({series.name, series.style});
    }
  }
  return entries;
}

bool has_front(const StudyChart& chart) {
  return std::any_of(chart.panels.begin(), chart.panels.end(),
                     [](const StudyPanel& panel) { return panel.pareto_front.size() > 1; });
}

void draw_legend(Drawing& drawing, const StudyChart& chart, double left, double top) {
  double y = top;
  const TextStyle words{.size = em, .upright = Upright::middle};
  if (has_front(chart)) {
    drawing.line({left, y}, {left + 2.6 * em, y}, {colours::yellow.with_opacity(0.75), 12});
    drawing.text({left + 3.2 * em, y}, front_name, words);
    y -= 1.6 * em;
  }
  for (const LegendEntry& entry : legend_of(chart)) {
    if (entry.style.dash != SeriesDash::none) {
      drawing.line({left, y}, {left + 2.6 * em, y}, stroke_of(entry.style));
    }
    draw_marker(drawing, {left + 1.3 * em, y}, entry.style);
    drawing.text({left + 3.2 * em, y}, entry.name, words);
    y -= 1.6 * em;
  }
}

double legend_width(const StudyChart& chart) {
  double widest = text_width(front_name, em);
  for (const LegendEntry& entry : legend_of(chart)) widest = std::max(widest, text_width(entry.name, em));
  return 3.2 * em + widest + 2 * margin;
}

}  // namespace

void draw_study_chart(const StudyChart& chart, const std::string& path) {
  const int columns = std::max(1, chart.columns);
  const int rows = (static_cast<int>(chart.panels.size()) + columns - 1) / columns;
  const double header = 2.6 * em + 1.5 * em * static_cast<double>(chart.notes.size());
  const double panels_width = columns * (left_of_panel + panel_width);
  const double notes_width = std::accumulate(
      chart.notes.begin(), chart.notes.end(), text_width(chart.title, 1.35 * em, true),
      [](double widest, const std::string& note) { return std::max(widest, text_width(note, em)); });
  const double width = std::max(margin + panels_width + legend_width(chart), notes_width + 2 * margin);
  const double height = header + rows * (above_panel + panel_height + below_panel) + margin;

  Drawing drawing;
  drawing.box({0, 0, width, height}, colours::white);
  double y = height - 1.9 * em;
  drawing.text({margin, y}, chart.title, {.size = 1.35 * em, .bold = true});
  for (const std::string& note : chart.notes) {
    y -= 1.5 * em;
    drawing.text({margin, y}, note, {.size = em, .colour = colours::grey});
  }
  const double top = height - header;
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    const int row_index = static_cast<int>(i) / columns, column_index = static_cast<int>(i) % columns;
    const double row = row_index, column = column_index;
    const Box box{margin + column * (left_of_panel + panel_width) + left_of_panel,
                  top - row * (above_panel + panel_height + below_panel) - above_panel - panel_height,
                  panel_width, panel_height};
    PanelPainter(drawing, chart.panels[i], box).paint();
  }
  draw_legend(drawing, chart, margin + panels_width + 1.5 * margin, top - above_panel - em);
  write_drawing(drawing, static_cast<int>(std::ceil(width)), static_cast<int>(std::ceil(height)), chart.title,
                path);
}

}  // namespace fingerpad
