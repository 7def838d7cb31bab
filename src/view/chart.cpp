#include "view/chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "view/axis.hpp"

namespace fingerpad {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// The finite values of a panel that its axis must hold.
Axis y_axis(const Panel& panel, double height, double text_size) {
  double min = panel.from_zero ? 0 : inf;
  double max = panel.from_zero ? 0 : -inf;
  const auto take = [&](double y) {
    if (!std::isfinite(y) || (panel.logarithmic && y <= 0)) return;
    min = std::min(min, y);
    max = std::max(max, y);
  };
  for (const Curve& curve : panel.curves) std::for_each(curve.y.begin(), curve.y.end(), take);
  for (const Level& level : panel.levels) take(level.y);
  const int most_marks = std::clamp(static_cast<int>(height / (2.2 * text_size)), 2, 6);
  if (panel.logarithmic) {
    if (!(max > 0)) return decade_axis(1, 10, most_marks);
    // A spectrum's floor of rounding says nothing: eight decades are kept.
    return decade_axis(std::max(min, max * 1e-8), max, most_marks);
  }
  if (!(max >= min)) return linear_axis(0, 1, most_marks);
  // Curves keep clear of the frame, but for a foot at zero.
  const double margin = 0.06 * (max > min ? max - min : std::max(std::abs(max), 1e-3));
  return linear_axis(panel.from_zero && min == 0 ? 0 : min - margin, max + margin, most_marks);
}

/// Draws one chart; holds what its parts share.
class ChartPainter {
 public:
  ChartPainter(Drawing& drawing, const Chart& chart, const Box& box, double text_size)
      : drawing_(drawing), chart_(chart), box_(box), em_(text_size) {
    const double first = chart.x.empty() ? 0 : chart.x.front();
    const double last = chart.x.empty() ? 1 : chart.x.back();
    const double left = box.left + 4.9 * em_;
    inner_ = {left, box.bottom + 2.9 * em_, box.right() - 1.1 * em_ - left, 0};
    inner_.height = box.top() - inner_.bottom;
    const int most_marks = std::max(2, static_cast<int>(inner_.width / (4.5 * em_)));
    x_axis_ =
        chart.logarithmic_x ? decade_axis(first, last, most_marks) : linear_axis(first, last, most_marks);
  }

  ChartPlace paint() {
    double top = inner_.top();
    if (chart_.band) top = paint_band(top);
    const auto count = static_cast<double>(std::max<std::size_t>(1, chart_.panels.size()));
    const double share = (top - inner_.bottom) / count;
    ChartPlace place{{}, x_axis_.min, x_axis_.max};
    for (std::size_t i = 0; i < chart_.panels.size(); ++i) {
      const double header = 1.75 * em_;
      const Box panel{inner_.left, top - share * static_cast<double>(i + 1), inner_.width, share - header};
      paint_panel(chart_.panels[i], panel, i + 1 == chart_.panels.size());
      place.panels.push_back(panel);
    }
    drawing_.text({inner_.centre().x(), box_.bottom + 0.35 * em_}, chart_.x_label,
                  {.size = em_, .across = Across::centre});
    return place;
  }

 private:
  double px(double x) const { return inner_.left + inner_.width * x_axis_.share(x); }

  /// Entries side by side from the left; those that no longer fit are left out.
  void paint_legend(const Panel& panel, double middle) {
    double x = inner_.left;
    const double size = 0.92 * em_;
    const auto entry = [&](const std::string& label, const Stroke& stroke, CurveStyle style) {
      const double width = 1.9 * em_ + text_width(label, size);
      if (label.empty() || x + width > inner_.right() + em_) return;
      if (style == CurveStyle::rings) {
        paint_ring({x + 0.8 * em_, middle}, stroke.colour);
      } else {
        drawing_.line({x, middle}, {x + 1.6 * em_, middle}, stroke);
      }
      drawing_.text({x + 1.9 * em_, middle}, label, {.size = size, .upright = Upright::middle});
      x += width + 0.9 * em_;
    };
    for (const Curve& curve : panel.curves) entry(curve.label, stroke_of(curve), curve.style);
    for (const Level& level : panel.levels) entry(level.label, stroke_of(level), CurveStyle::dashed);
  }

  const std::string& y_label_of(const Panel& panel, double height) const {
    const bool fits = text_width(panel.y_label, em_) < height + em_;
    return fits || panel.short_y_label.empty() ? panel.y_label : panel.short_y_label;
  }

  Stroke stroke_of(const Curve& curve) const {
    const double width = 0.14 * em_;
    switch (curve.style) {
      case CurveStyle::dotted:
        return {curve.colour, 1.25 * width, 1.4 * width, 1.7 * width};
      case CurveStyle::dashed:
        return {curve.colour, width, 5 * width, 3 * width};
      case CurveStyle::solid:
      case CurveStyle::rings:
        break;
    }
    return {curve.colour, width};
  }
  Stroke stroke_of(const Level& level) const { return {level.colour, 0.09 * em_, 0.5 * em_, 0.35 * em_}; }

  void paint_ring(const Vec2& at, const Colour& colour) {
    constexpr int sides = 12;
    std::vector<Vec2> points;
    for (int i = 0; i <= sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      points.emplace_back(at + 0.38 * em_ * Vec2(std::cos(angle), std::sin(angle)));
    }
    drawing_.line(std::move(points), {colour, 0.14 * em_});
  }

  void paint_panel(const Panel& panel, const Box& box, bool lowest) {
    const Axis axis = y_axis(panel, box.height, em_);
    if (chart_.band) paint_band_behind(box);
    const Stroke grid{colours::pale_grey, std::max(1.0, 0.06 * em_)};
    const double tick = 0.35 * em_;
    for (std::size_t i = 0; i < axis.marks.size(); ++i) {
      const double y = box.bottom + box.height * axis.share(axis.marks[i]);
      drawing_.line({box.left, y}, {box.right(), y}, grid);
      drawing_.text({box.left - tick, y}, axis.labels[i],
                    {.size = em_, .across = Across::right, .upright = Upright::middle});
    }
    for (std::size_t i = 0; i < x_axis_.marks.size(); ++i) {
      const double x = px(x_axis_.marks[i]);
      drawing_.line({x, box.bottom}, {x, box.top()}, grid);
      if (lowest) {
        drawing_.text({x, box.bottom - tick}, x_axis_.labels[i],
                      {.size = em_, .across = Across::centre, .upright = Upright::top});
      }
    }
    for (const Level& level : panel.levels) {
      const double y = box.bottom + box.height * axis.share(level.y);
      drawing_.line({box.left, y}, {box.right(), y}, stroke_of(level));
    }
    for (const Curve& curve : panel.curves) paint_curve(curve, box, axis);
    drawing_.frame(box, {colours::grey, std::max(1.0, 0.08 * em_)});
    drawing_.text({box_.left + 0.95 * em_, box.centre().y()}, y_label_of(panel, box.height),
                  {.size = em_, .across = Across::centre, .upright = Upright::middle, .turned = true});
    paint_legend(panel, box.top() + 0.75 * em_);
  }

  /// Runs of finite points; where several points fall on one column only its ends, least and greatest stay.
  void paint_curve(const Curve& curve, const Box& box, const Axis& axis) {
    if (curve.style == CurveStyle::rings) {
      for (std::size_t i = 0; i < std::min(chart_.x.size(), curve.y.size()); ++i) {
        if (!std::isfinite(curve.y[i])) continue;
        paint_ring({px(chart_.x[i]), box.bottom + box.height * std::clamp(axis.share(curve.y[i]), 0.0, 1.0)},
                   curve.colour);
      }
      return;
    }
    std::vector<Vec2> run, column;
    const auto flush_column = [&] {
      const auto by_y = [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); };
      if (column.size() <= 4) {
        run.insert(run.end(), column.begin(), column.end());
      } else {
        auto least = std::min_element(column.begin(), column.end(), by_y);
        auto greatest = std::max_element(column.begin(), column.end(), by_y);
        if (greatest < least) std::swap(least, greatest);
        run.insert(run.end(), {column.front(), *least, *greatest, column.back()});
      }
      column.clear();
    };
    const auto flush_run = [&] {
      flush_column();
      if (run.size() == 1) run.push_back(run.front() + Vec2(0.1 * em_, 0));  // a lone point still shows
      drawing_.line(std::exchange(run, {}), stroke_of(curve));
    };
    const std::size_t count = std::min(chart_.x.size(), curve.y.size());
    for (std::size_t i = 0; i < count; ++i) {
      const double y = curve.y[i];
      if (!std::isfinite(y) || (axis.logarithmic && !(y >= axis.min))) {
        if (!run.empty() || !column.empty()) flush_run();
        continue;
      }
      const Vec2 at(px(chart_.x[i]), box.bottom + box.height * std::clamp(axis.share(y), 0.0, 1.0));
      if (!column.empty() && std::floor(at.x()) != std::floor(column.front().x())) flush_column();
      column.push_back(at);
    }
    if (!run.empty() || !column.empty()) flush_run();
  }

  /// Spans of equal key, a column of the drawing at a time: [left, right), key. The key that holds a column's
  /// first value stands for it.
  struct Span {
    double left, right;
    std::size_t key;
  };
  const std::vector<Span>& spans() {
    if (!spans_.empty() || chart_.x.empty()) return spans_;
    double next = -inf;
    for (std::size_t i = 0; i < chart_.x.size() && i < chart_.band->key_at.size(); ++i) {
      const double x = px(chart_.x[i]);
      const std::size_t key = chart_.band->key_at[i];
      if (x < next || (!spans_.empty() && spans_.back().key == key)) continue;
      if (!spans_.empty()) spans_.back().right = x;
      spans_.push_back({x, inner_.right(), key});
      next = x + 1;
    }
    return spans_;
  }

  void paint_band_behind(const Box& box) {
    for (const Span& span : spans()) {
      drawing_.box({span.left, box.bottom, span.right - span.left, box.height},
                   chart_.band->keys[span.key].colour.with_opacity(0.13));
    }
  }

  /// @returns where the panels may begin
  double paint_band(double top) {
    const double size = 0.92 * em_;
    double x = inner_.left;
    const double middle = top - 0.75 * em_;
    for (const BandKey& key : chart_.band->keys) {
      drawing_.box({x, middle - 0.4 * em_, 0.8 * em_, 0.8 * em_}, key.colour);
      drawing_.text({x + 1.1 * em_, middle}, key.label, {.size = size, .upright = Upright::middle});
      x += 2.3 * em_ + text_width(key.label, size);
    }
    const Box strip{inner_.left, top - 2.3 * em_, inner_.width, 0.75 * em_};
    for (const Span& span : spans()) {
      drawing_.box({span.left, strip.bottom, span.right - span.left, strip.height},
                   chart_.band->keys[span.key].colour);
    }
    drawing_.frame(strip, {colours::grey, std::max(1.0, 0.08 * em_)});
    drawing_.text({strip.left - 0.35 * em_, strip.centre().y()}, "phase",
                  {.size = em_, .across = Across::right, .upright = Upright::middle});
    return strip.bottom - 0.3 * em_;
  }

  Drawing& drawing_;
  const Chart& chart_;
  Box box_, inner_;
  double em_;
  Axis x_axis_;
  std::vector<Span> spans_;
};

}  // namespace

double ChartPlace::x_at(double drawing_x) const {
  const double share = std::clamp((drawing_x - panels.front().left) / panels.front().width, 0.0, 1.0);
  return x_min + share * (x_max - x_min);
}

double ChartPlace::drawing_x_at(double x) const {
  return panels.front().left + panels.front().width * std::clamp((x - x_min) / (x_max - x_min), 0.0, 1.0);
}

ChartPlace draw_chart(Drawing& drawing, const Chart& chart, const Box& box, double text_size) {
  return ChartPainter(drawing, chart, box, text_size).paint();
}

}  // namespace fingerpad
