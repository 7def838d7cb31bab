#pragma once

#include <vtkChartXY.h>
#include <vtkNew.h>

#include <functional>

#include "base/chart.hpp"
#include "view/chart_layout.hpp"
#include "view/chart_marks.hpp"
#include "view/panel_axis_vtk.hpp"
#include "view/value_label_vtk.hpp"

namespace fingerpad {

/// One panel of a chart as a chart of VTK. The wheel zooms along x about the mouse, a drag pans, and the
/// mouse over a point tells its value.
class PanelChart : public vtkChartXY {
 public:
  static PanelChart* New();
  vtkTypeMacro(PanelChart, vtkChartXY);

  /// Shows another panel, or new values. A range that was zoomed to stays; where it reached the old end it
  /// goes on with the new one.
  /// @param band, strip  of the chart; null and empty without
  void show(const ChartPanel& panel, const ChartLayout::Panel& placed, double em, const ChartBand* band,
            const Box& strip);

  /// The range of x shown.
  Axis shown_x() const { return bottom_->shown(); }
  bool zoomed() const;
  void show_all();
  /// Shows the range of x that another panel shows.
  void follow(const PanelChart& other);

  /// Of the grid, which VTK paints itself.
  void set_dark(bool dark);

  bool MouseWheelEvent(const vtkContextMouseEvent& mouse, int steps) override;

 protected:
  PanelChart();

 private:
  void add_backdrop(std::function<void(Drawing&, const PanelFrame&)> draw);
  void show_range(double min, double max);
  void set_ranges(const ChartLayout::Panel& placed);

  // The chart frees the axes that SetAxis gives it.
  PanelAxis *left_ = PanelAxis::New(), *bottom_ = PanelAxis::New(), *right_ = PanelAxis::New(),
            *top_ = PanelAxis::New();
  vtkNew<ValueLabel> label_;
  Axis all_x_{0, 0, false, {}, {}, {}};
};

}  // namespace fingerpad
