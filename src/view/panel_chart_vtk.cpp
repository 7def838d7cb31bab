#include "view/panel_chart_vtk.hpp"

#include <vtkContextMouseEvent.h>
#include <vtkContextScene.h>
#include <vtkObjectFactory.h>
#include <vtkTooltipItem.h>
#include <vtkVector.h>

#include <algorithm>
#include <cmath>

#include "view/panel_plots_vtk.hpp"
#include "view/theme_device_vtk.hpp"

namespace fingerpad {

vtkStandardNewMacro(PanelChart);

PanelChart::PanelChart() {
  this->SetAutoAxes(false);
  this->SetRenderEmpty(true);
  const std::pair<int, PanelAxis*> sides[] = {
      {vtkAxis::LEFT, left_}, {vtkAxis::BOTTOM, bottom_}, {vtkAxis::RIGHT, right_}, {vtkAxis::TOP, top_}};
  for (const auto& [position, axis] : sides) {
    axis->SetPosition(position);
    this->SetAxis(position, axis);
    axis->SetVisible(true);
    axis->SetGridVisible(position == vtkAxis::LEFT || position == vtkAxis::BOTTOM);
  }
  // Behind the axes that have just come in front of it.
  label_->SetVisible(false);
  this->SetTooltip(label_);
}

void PanelChart::add_backdrop(std::function<void(Drawing&, const PanelFrame&)> draw) {
  vtkNew<BackdropPlot> plot;
  plot->show(std::move(draw));
  this->AddPlot(plot);
}

void PanelChart::show(const ChartPanel& panel, const ChartLayout::Panel& placed, double em,
                      const ChartBand* band, const Box& strip) {
  if (this->GetNumberOfPlots() > 0) this->ClearPlots();
  label_->set_em(em);
  const std::string foot_label = placed.foot ? panel.x_label : "";
  left_->set_look({em, true, fitting_y_label(panel, placed.frame.height, em), placed.y_label_x});
  bottom_->set_look({em, placed.foot, foot_label, placed.frame.bottom - 2.25 * em});
  right_->set_look({em, false, "", 0});
  top_->set_look({em, false, "", 0});
  set_ranges(placed);
  if (band != nullptr) {
    add_backdrop([band = *band, strip](Drawing& drawing, const PanelFrame& frame) {
      draw_band(drawing, band, frame, strip);
      if (strip.height > 0) drawing.frame(strip, {colours::grey, 1});
    });
  }
  if (panel.pareto_front.size() > 1) {
    add_backdrop(
        [panel, em](Drawing& drawing, const PanelFrame& frame) { draw_front(drawing, panel, frame, em); });
  }
  for (const ChartLevel& level : panel.levels) {
    add_backdrop(
        [level, em](Drawing& drawing, const PanelFrame& frame) { draw_level(drawing, level, frame, em); });
  }
  for (const ChartCurve& curve : panel.curves) {
    vtkNew<CurvePlot> plot;
    plot->show(curve, panel, em);
    this->AddPlot(plot);
  }
  this->PlotTransformValid = false;  // until it is painted in its new place
}

void PanelChart::set_dark(bool dark) {
  const Colour grid = dark ? in_the_dark(colours::pale_grey) : colours::pale_grey;
  for (PanelAxis* axis : {left_, bottom_, right_, top_}) axis->set_grid(grid);
}

void PanelChart::set_ranges(const ChartLayout::Panel& placed) {
  const Axis before = bottom_->shown(), all_before = all_x_;
  const bool was_zoomed = zoomed();
  all_x_ = placed.x;
  bottom_->set_ends(placed.x);
  left_->set_ends(placed.y);
  if (!was_zoomed) return show_range(placed.x.min, placed.x.max);
  const bool at_end = before.max >= all_before.max;
  const double shift = at_end ? placed.x.max - before.max : 0;
  show_range(before.min + shift, before.max + shift);
}

void PanelChart::show_range(double min, double max) {
  bottom_->show_range(min, max);
  this->RecalculatePlotTransforms();  // by which VTK finds the point under the mouse
}

bool PanelChart::zoomed() const {
  const Axis now = bottom_->shown();
  return all_x_.max > all_x_.min && (now.max - now.min) < (all_x_.max - all_x_.min) * (1 - 1e-9);
}

void PanelChart::show_all() {
  if (all_x_.max > all_x_.min) show_range(all_x_.min, all_x_.max);
}

void PanelChart::follow(const PanelChart& other) {
  const Axis x = other.shown_x();
  if (&other != this) show_range(x.min, x.max);
}

bool PanelChart::MouseWheelEvent(const vtkContextMouseEvent& mouse, int steps) {
  this->GetTooltip()->SetVisible(false);
  Axis now = bottom_->shown();
  if (!(now.min < all_x_.max && now.max > all_x_.min)) now = all_x_;  // running charts have left it behind
  const double width = this->Point2[0] - this->Point1[0];
  const double at = std::clamp((mouse.GetScreenPos().GetX() - this->Point1[0]) / width, 0.0, 1.0);
  constexpr double step = 1.25, most = 1e5;
  const double factor = std::pow(step, -steps);
  const double least = (all_x_.max - all_x_.min) / most;
  if (steps > 0 && now.max - now.min < least) return true;
  // What is under the mouse stays there, as long as nothing beyond the ends comes into sight.
  Axis wide = now;
  const double from = wide.value_at(at - at * factor), to = wide.value_at(at + (1 - at) * factor);
  show_range(std::max(from, all_x_.min), std::min(to, all_x_.max));
  return true;
}

}  // namespace fingerpad
