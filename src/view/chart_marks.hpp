#pragma once

#include "base/chart.hpp"
#include "view/axis.hpp"
#include "view/drawing.hpp"

namespace fingerpad {

/// A panel's frame in a drawing, and the values at its edges.
struct PanelFrame {
  Box box;
  Axis x, y;

  /// Where a value lies. A logarithmic axis has no place for one that is not positive.
  Vec2 at(double x_value, double y_value) const;
  bool shows(double x_value, double y_value) const;  ///< has a place for it
};

/// A curve with its markers. Where several points fall on one column of the drawing only its ends, least and
/// greatest stay; what lies beyond the frame is left out.
/// @param em  size of the chart's texts [px]
void draw_curve(Drawing& drawing, const ChartCurve& curve, const PanelFrame& frame, double em);

/// The line of the points that no other beats.
void draw_front(Drawing& drawing, const ChartPanel& panel, const PanelFrame& frame, double em);

void draw_level(Drawing& drawing, const ChartLevel& level, const PanelFrame& frame, double em);

/// The band, pale, behind a panel; and in a strip of its own, which may be empty.
void draw_band(Drawing& drawing, const ChartBand& band, const PanelFrame& frame, const Box& strip);

/// What a legend shows of a curve, a level or the front: a piece of it, `width` long.
void draw_key(Drawing& drawing, const CurveStyle& style, const Vec2& left, double width, double em);
void draw_key(Drawing& drawing, const ChartLevel& level, const Vec2& left, double width, double em);
void draw_front_key(Drawing& drawing, const Vec2& left, double width, double em);

}  // namespace fingerpad
