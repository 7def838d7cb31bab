#pragma once

#include <vtkPlot.h>
#include <vtkPlotLine.h>

#include <functional>

#include "base/chart.hpp"
#include "view/chart_marks.hpp"

namespace fingerpad {

/// A curve of VTK's, drawn by us: lines with dashes of any length, all markers, many points in one column
/// reduced to what is seen. Its points are VTK's, which finds the one under the mouse.
class CurvePlot : public vtkPlotLine {
 public:
  static CurvePlot* New();
  vtkTypeMacro(CurvePlot, vtkPlotLine);

  /// @param panel  says the units
  void show(const ChartCurve& curve, const ChartPanel& panel, double em);

  bool Paint(vtkContext2D* painter) override;
  vtkStdString GetTooltipLabel(const vtkVector2d& at, vtkIdType point, vtkIdType segment) override;

 private:
  ChartCurve curve_;
  std::string x_unit_, y_unit_;
  double em_ = 12;
  PanelFrame drawn_for_;
  Drawing drawn_;  ///< for that frame
};

/// What VTK has no plot for, behind the curves: phase bands, the Pareto front, levels.
class BackdropPlot : public vtkPlot {
 public:
  using Draw = std::function<void(Drawing&, const PanelFrame&)>;
  static BackdropPlot* New();
  vtkTypeMacro(BackdropPlot, vtkPlot);

  void show(Draw draw) { draw_ = std::move(draw); }
  bool Paint(vtkContext2D* painter) override;

 private:
  Draw draw_;
};

}  // namespace fingerpad
