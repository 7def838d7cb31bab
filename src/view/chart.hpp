#pragma once

#include <optional>
#include <string>
#include <vector>

#include "view/drawing.hpp"

namespace fingerpad {

enum class CurveStyle { solid, dotted, dashed, rings };  ///< rings: points alone

/// A curve over its chart's x; y values that are not finite leave gaps.
struct Curve {
  std::string label;  ///< in the legend; empty: none
  Colour colour;
  CurveStyle style = CurveStyle::solid;
  std::vector<double> y;  ///< one for each of the chart's x
};

/// A dashed level across a panel.
struct Level {
  std::string label;
  double y = 0;
  Colour colour;
};

/// One of the panels that a chart stacks over its x axis.
struct Panel {
  std::string y_label;        ///< with its unit
  std::string short_y_label;  ///< where the other does not fit; empty: none
  std::vector<Curve> curves;
  std::vector<Level> levels;
  bool logarithmic = false;
  bool from_zero = false;  ///< the y axis holds zero
};

/// Colours behind x, such as the phases of a touch.
struct BandKey {
  std::string label;
  Colour colour;
};
struct Band {
  std::vector<BandKey> keys;
  std::vector<std::uint8_t> key_at;  ///< one for each of the chart's x: index into keys
};

/// Panels stacked over one x axis.
struct Chart {
  std::string x_label;    ///< with its unit
  std::vector<double> x;  ///< increasing
  bool logarithmic_x = false;
  std::vector<Panel> panels;
  std::optional<Band> band;  ///< a coloured strip above the panels, with its legend
};

/// Where the panels of a drawn chart lie, to put a cursor in and to read the mouse.
struct ChartPlace {
  std::vector<Box> panels;  ///< from the top
  double x_min = 0, x_max = 1;
  double x_at(double drawing_x) const;
  double drawing_x_at(double x) const;
};

/// Draws a chart into a box. Curves with more points than the box has columns keep each column's least and
/// greatest value.
/// @param text_size  of labels [px]
ChartPlace draw_chart(Drawing& drawing, const Chart& chart, const Box& box, double text_size);

}  // namespace fingerpad
