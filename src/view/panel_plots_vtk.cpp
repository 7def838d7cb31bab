#include "view/panel_plots_vtk.hpp"

#include <fmt/format.h>
#include <vtkContext2D.h>
#include <vtkContextDevice2D.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkStdString.h>
#include <vtkTable.h>
#include <vtkTransform2D.h>
#include <vtkVector.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "view/drawing_item_vtk.hpp"
#include "view/panel_axis_vtk.hpp"

namespace fingerpad {
namespace {

/// The frame of a plot as it is now, zoomed or not.
PanelFrame frame_of(vtkPlot* plot) {
  auto* const x = static_cast<PanelAxis*>(plot->GetXAxis());
  auto* const y = static_cast<PanelAxis*>(plot->GetYAxis());
  const double left = x->GetPoint1()[0], bottom = y->GetPoint1()[1];
  return {{left, bottom, x->GetPoint2()[0] - left, y->GetPoint2()[1] - bottom}, x->shown(), y->shown()};
}

bool same_ends(const Axis& a, const Axis& b) {
  return a.min == b.min && a.max == b.max && a.logarithmic == b.logarithmic;
}

bool same_frame(const PanelFrame& a, const PanelFrame& b) {
  return a.box.left == b.box.left && a.box.bottom == b.box.bottom && a.box.width == b.box.width &&
         a.box.height == b.box.height && same_ends(a.x, b.x) && same_ends(a.y, b.y);
}

/// Paints in pixels, whatever the units of the plot. VTK's clipping would halve the strokes along the frame
/// and the markers on it; the drawing keeps to the frame by itself.
void paint_in_pixels(vtkPlot* plot, vtkContext2D* painter, const Drawing& drawing) {
  vtkNew<vtkTransform2D> pixels;
  painter->GetDevice()->EnableClipping(false);
  painter->PushMatrix();
  painter->SetTransform(pixels);
  paint(drawing, painter, plot->GetScene()->GetSceneWidth(), plot->GetScene()->GetSceneHeight());
  painter->PopMatrix();
}

/// What stands in the brackets of "force [N]", after a space.
std::string unit_of(const std::string& label) {
  const std::size_t open = label.rfind('['), close = label.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open + 2) return "";
  const std::string unit = label.substr(open + 1, close - open - 1);
  return unit == "1" ? "" : " " + unit;
}

}  // namespace

vtkStandardNewMacro(CurvePlot);
vtkStandardNewMacro(BackdropPlot);

void CurvePlot::show(const ChartCurve& curve, const ChartPanel& panel, double em) {
  curve_ = curve;
  em_ = em;
  x_unit_ = unit_of(panel.x_label);
  y_unit_ = unit_of(panel.y_label);
  drawn_for_ = {};
  this->SetLabel(curve.name);
  vtkNew<vtkTable> table;
  const std::size_t count = std::min(curve.x.size(), curve.y.size());
  for (const auto& [name, values] : {std::pair{"x", &curve.x}, {"y", &curve.y}}) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    column->SetNumberOfValues(static_cast<vtkIdType>(count));
    std::copy_n(values->begin(), count, column->GetPointer(0));
    table->AddColumn(column);
  }
  this->SetInputData(table, 0, 1);
}

bool CurvePlot::Paint(vtkContext2D* painter) {
  const PanelFrame frame = frame_of(this);
  if (!same_frame(frame, drawn_for_)) {
    drawn_ = {};
    draw_curve(drawn_, curve_, frame, em_);
    drawn_for_ = frame;
  }
  paint_in_pixels(this, painter, drawn_);
  return true;
}

vtkStdString CurvePlot::GetTooltipLabel(const vtkVector2d&, vtkIdType point, vtkIdType) {
  const auto i = static_cast<std::size_t>(point);
  if (i >= curve_.x.size() || i >= curve_.y.size()) return "";
  return fmt::format("{}{}{}{} at {}{}", curve_.name, curve_.name.empty() ? "" : ": ",
                     rounded_text(curve_.y[i], 4), y_unit_, rounded_text(curve_.x[i], 5), x_unit_);
}

bool BackdropPlot::Paint(vtkContext2D* painter) {
  const PanelFrame frame = frame_of(this);
  Drawing drawing;
  draw_(drawing, frame);
  paint_in_pixels(this, painter, drawing);
  return true;
}

}  // namespace fingerpad
