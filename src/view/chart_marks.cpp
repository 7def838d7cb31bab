#include "view/chart_marks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace fingerpad {
namespace {

Stroke stroke_of(const CurveStyle& style, double em) {
  const double width = 0.125 * em * style.weight;
  const Colour colour = palette::colour(style.colour);
  switch (style.dash) {
    case Dash::dashed:
      return {colour, width, 5 * width, 3 * width};
    case Dash::dotted:
      return {colour, 1.15 * width, 1.3 * width, 1.9 * width};
    case Dash::dash_dot:
      return {colour, width, 8 * width, 2 * width};
    case Dash::none:
    case Dash::solid:
      break;
  }
  return {colour, width};
}

Stroke stroke_of(const ChartLevel& level, double em) {
  return {palette::colour(level.colour), 0.09 * em, 0.5 * em, 0.35 * em};
}

Stroke front_stroke(double em) {
  return {colours::yellow.with_opacity(0.75), 0.75 * em};
}

void draw_ring(Drawing& drawing, const Vec2& at, double radius, const Stroke& stroke) {
  constexpr int sides = 24;
  std::vector<Vec2> points;
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * std::numbers::pi * (i % sides) / sides;
    points.emplace_back(at + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  drawing.line(std::move(points), stroke);
}

void draw_marker(Drawing& drawing, const Vec2& at, const CurveStyle& style, double em) {
  const double r = 0.3125 * em * style.weight;
  const Colour colour = palette::colour(style.colour);
  const Stroke stroke{colour, 0.13 * em};
  switch (style.marker) {
    case Marker::none:
      return;
    case Marker::disc:
      drawing.disc(at, r, colour);
      return;
    case Marker::square:
      drawing.box({at.x() - 0.85 * r, at.y() - 0.85 * r, 1.7 * r, 1.7 * r}, colour);
      return;
    case Marker::triangle:
      drawing.area({at + Vec2(0, 1.15 * r), at + Vec2(-r, -0.7 * r), at + Vec2(r, -0.7 * r)}, colour);
      return;
    case Marker::diamond:
      drawing.area(
          {at + Vec2(0, 1.2 * r), at + Vec2(-1.2 * r, 0), at - Vec2(0, 1.2 * r), at + Vec2(1.2 * r, 0)},
          colour);
      return;
    case Marker::ring:
      draw_ring(drawing, at, r, stroke);
      return;
    case Marker::cross:
      drawing.line(at + Vec2(-r, -r), at + Vec2(r, r), stroke);
      drawing.line(at + Vec2(-r, r), at + Vec2(r, -r), stroke);
  }
}

/// The part of a step that lies in a box (Liang & Barsky 1984); empty where none does.
std::optional<std::pair<Vec2, Vec2>> within(const Box& box, const Vec2& from, const Vec2& to) {
  const Vec2 step = to - from;
  double first = 0, last = 1;
  const double steps[] = {-step.x(), step.x(), -step.y(), step.y()};
  const double room[] = {from.x() - box.left, box.right() - from.x(), from.y() - box.bottom,
                         box.top() - from.y()};
  for (int side = 0; side < 4; ++side) {
    if (steps[side] == 0 && room[side] < 0) return std::nullopt;
    if (steps[side] < 0) first = std::max(first, room[side] / steps[side]);
    if (steps[side] > 0) last = std::min(last, room[side] / steps[side]);
  }
  if (first > last) return std::nullopt;
  return std::pair{Vec2(first > 0 ? from + first * step : from), Vec2(last < 1 ? from + last * step : to)};
}

/// Draws what lies in the box of a line.
void draw_within(Drawing& drawing, const Box& box, const std::vector<Vec2>& line, const Stroke& stroke) {
  std::vector<Vec2> piece;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto part = within(box, line[i - 1], line[i]);
    if (!part) continue;
    if (!piece.empty() && piece.back() != part->first) drawing.line(std::exchange(piece, {}), stroke);
    if (piece.empty()) piece.push_back(part->first);
    piece.push_back(part->second);
  }
  drawing.line(std::move(piece), stroke);
}

/// Takes a run's points in their order; adds the line and the markers to the drawing.
class RunPainter {
 public:
  RunPainter(Drawing& drawing, const CurveStyle& style, const PanelFrame& frame, double em)
      : drawing_(drawing), style_(style), frame_(frame), em_(em) {}

  void take(const Vec2& at) {
    if (!column_.empty() && std::floor(at.x()) != std::floor(column_.front().x())) end_column();
    column_.push_back(at);
    if (frame_.box.holds(at.x(), at.y())) marked_.push_back(at);
  }

  void end_run() {
    end_column();
    // A lone point of a line without markers still shows.
    if (run_.size() == 1 && style_.marker == Marker::none) run_.push_back(run_.front() + Vec2(0.1 * em_, 0));
    if (style_.dash != Dash::none) draw_within(drawing_, frame_.box, run_, stroke_of(style_, em_));
    for (const Vec2& at : marked_) draw_marker(drawing_, at, style_, em_);
    run_.clear();
    marked_.clear();
  }

 private:
  void end_column() {
    const auto by_y = [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); };
    if (column_.size() <= 4) {
      run_.insert(run_.end(), column_.begin(), column_.end());
    } else {
      auto [least, greatest] = std::minmax_element(column_.begin(), column_.end(), by_y);
      if (greatest < least) std::swap(least, greatest);
      run_.insert(run_.end(), {column_.front(), *least, *greatest, column_.back()});
    }
    column_.clear();
  }

  Drawing& drawing_;
  const CurveStyle& style_;
  const PanelFrame& frame_;
  double em_;
  std::vector<Vec2> run_, column_, marked_;
};

}  // namespace

Vec2 PanelFrame::at(double x_value, double y_value) const {
  // Far beyond a frame that is zoomed into, a screen's single precision must not overflow.
  const auto placed = [](double start, double length, double share) {
    return start + length * std::clamp(share, -1e4, 1e4);
  };
  return {placed(box.left, box.width, x.share(x_value)), placed(box.bottom, box.height, y.share(y_value))};
}

bool PanelFrame::shows(double x_value, double y_value) const {
  return std::isfinite(x_value) && std::isfinite(y_value) && (!x.logarithmic || x_value > 0) &&
         (!y.logarithmic || y_value > 0);
}

void draw_curve(Drawing& drawing, const ChartCurve& curve, const PanelFrame& frame, double em) {
  RunPainter painter(drawing, curve.style, frame, em);
  const std::size_t count = std::min(curve.x.size(), curve.y.size());
  bool open = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (frame.shows(curve.x[i], curve.y[i])) {
      painter.take(frame.at(curve.x[i], curve.y[i]));
      open = true;
    } else if (std::exchange(open, false)) {
      painter.end_run();
    }
  }
  if (open) painter.end_run();
}

void draw_front(Drawing& drawing, const ChartPanel& panel, const PanelFrame& frame, double em) {
  std::vector<Vec2> points;
  for (const auto& [x, y] : panel.pareto_front) {
    if (frame.shows(x, y)) points.push_back(frame.at(x, y));
  }
  draw_within(drawing, frame.box, points, front_stroke(em));
}

void draw_level(Drawing& drawing, const ChartLevel& level, const PanelFrame& frame, double em) {
  if (!frame.shows(frame.x.min, level.y)) return;
  const double y = frame.at(frame.x.min, level.y).y();
  if (y < frame.box.bottom || y > frame.box.top()) return;
  drawing.line({frame.box.left, y}, {frame.box.right(), y}, stroke_of(level, em));
}

void draw_band(Drawing& drawing, const ChartBand& band, const PanelFrame& frame, const Box& strip) {
  const Box& box = frame.box;
  const std::size_t count = std::min(band.x.size(), band.key_at.size());
  const auto span = [&](double left, double right, std::size_t key) {
    left = std::clamp(left, box.left, box.right());
    right = std::clamp(right, box.left, box.right());
    if (!(right > left)) return;
    const Colour& colour = band.keys[key].colour;
    drawing.box({left, box.bottom, right - left, box.height}, colour.with_opacity(0.13));
    if (strip.height > 0) drawing.box({left, strip.bottom, right - left, strip.height}, colour);
  };
  // A column of the drawing at a time: the key that holds its first value stands for it.
  double left = -HUGE_VAL;
  std::size_t key = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && band.key_at[i] == key) continue;
    const double x = frame.at(band.x[i], frame.y.min).x();
    if (i > 0 && x < left + 1) continue;
    if (i > 0) span(left, x, key);
    left = x;
    key = band.key_at[i];
  }
  if (count > 0) span(left, frame.at(band.x[count - 1], frame.y.min).x(), key);
}

void draw_key(Drawing& drawing, const CurveStyle& style, const Vec2& left, double width, double em) {
  if (style.dash != Dash::none) drawing.line(left, left + Vec2(width, 0), stroke_of(style, em));
  draw_marker(drawing, left + Vec2(width / 2, 0), style, em);
}

void draw_key(Drawing& drawing, const ChartLevel& level, const Vec2& left, double width, double em) {
  drawing.line(left, left + Vec2(width, 0), stroke_of(level, em));
}

void draw_front_key(Drawing& drawing, const Vec2& left, double width, double em) {
  drawing.line(left, left + Vec2(width, 0), front_stroke(em));
}

}  // namespace fingerpad
