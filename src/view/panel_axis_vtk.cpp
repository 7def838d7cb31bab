#include "view/panel_axis_vtk.hpp"

#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>

#include "view/chart_layout.hpp"
#include "view/drawing_item_vtk.hpp"

namespace fingerpad {

vtkStandardNewMacro(PanelAxis);

void PanelAxis::set_look(const Look& look) {
  look_ = look;
  this->SetBehavior(vtkAxis::CUSTOM);  // VTK chooses neither range nor marks
  this->SetLabelsVisible(false);
  this->SetTicksVisible(false);
  this->SetTitle("");
  this->GridPen->SetColor(colours::pale_grey.red, colours::pale_grey.green, colours::pale_grey.blue);
  this->GridPen->SetWidth(static_cast<float>(std::max(1.0, 0.06 * look.em)));
}

void PanelAxis::set_ends(const Axis& ends) {
  this->SetLogScale(ends.logarithmic);
  this->SetUnscaledMinimumLimit(ends.min);
  this->SetUnscaledMaximumLimit(ends.max);
  show_range(ends.min, ends.max);
}

void PanelAxis::show_range(double min, double max) {
  // What is held while running charts go on lies before their ends; VTK would cut it off at its limits.
  this->SetUnscaledMinimumLimit(std::min(this->UnscaledMinimumLimit, min));
  this->SetUnscaledMaximumLimit(std::max(this->UnscaledMaximumLimit, max));
  // One end may not pass the other on the way.
  if (min > this->UnscaledMaximum) {
    this->SetUnscaledMaximum(max);
    this->SetUnscaledMinimum(min);
  } else {
    this->SetUnscaledMinimum(min);
    this->SetUnscaledMaximum(max);
  }
}

Axis PanelAxis::shown() const {
  return {this->UnscaledMinimum, this->UnscaledMaximum, this->LogScaleActive, {}, {}, {}};
}

void PanelAxis::Update() {
  const Axis now = shown();
  const double length_px = std::hypot(this->Point2[0] - this->Point1[0], this->Point2[1] - this->Point1[1]);
  const bool same = now.min == marked_.min && now.max == marked_.max &&
                    now.logarithmic == marked_.logarithmic && length_px == marked_length_px_;
  if (!same && now.max > now.min) {
    marked_length_px_ = length_px;
    int most = upright() ? marks_along_y(length_px, look_.em) : marks_along_x(length_px, look_.em);
    do {
      marked_ = now.logarithmic ? log_axis(now.min, now.max, most) : linear_axis(now.min, now.max, most);
    } while (!upright() && numbers_meet(length_px) && --most > 0);
    vtkNew<vtkDoubleArray> at;
    vtkNew<vtkStringArray> labels;
    for (std::size_t i = 0; i < marked_.marks.size(); ++i) {
      at->InsertNextValue(now.logarithmic ? std::log10(marked_.marks[i]) : marked_.marks[i]);
      labels->InsertNextValue(marked_.labels[i]);
    }
    this->SetCustomTickPositions(at, labels);
  }
  Superclass::Update();
}

/// Whether two numbers that stand side by side along this length come nearer than half a letter's height.
bool PanelAxis::numbers_meet(double length_px) const {
  double end_px = -length_px;
  for (std::size_t i = 0; i < marked_.marks.size(); ++i) {
    const double middle_px = marked_.share(marked_.marks[i]) * length_px,
                 half_px = 0.5 * text_width(marked_.labels[i], look_.em);
    if (middle_px - half_px < end_px + 0.5 * look_.em) return true;
    end_px = middle_px + half_px;
  }
  return false;
}

Vec2 PanelAxis::place(double value) const {
  const Vec2 from(this->Point1[0], this->Point1[1]), to(this->Point2[0], this->Point2[1]);
  const Vec2 at = from + (to - from) * shown().share(value);
  return {std::round(at.x()), std::round(at.y())};
}

void PanelAxis::draw_mark(Drawing& drawing, double value, double length_px) const {
  const Vec2 at = place(value);
  const Vec2 inwards = upright() ? Vec2(length_px, 0) : Vec2(0, length_px);
  drawing.line(at, at + inwards, {colours::grey, std::max(1.0, 0.06 * look_.em)});
}

bool PanelAxis::Paint(vtkContext2D* painter) {
  if (!this->Visible) return false;
  const double em = look_.em;
  const Vec2 from(this->Point1[0], this->Point1[1]), to(this->Point2[0], this->Point2[1]);
  Drawing drawing;
  drawing.line(from, to, {colours::grey, std::max(1.0, 0.08 * em)});
  const bool marked = this->Position == LEFT || this->Position == BOTTOM;
  if (marked) {
    for (const double minor : marked_.minor_marks) draw_mark(drawing, minor, 0.25 * em);
  }
  const double gap = 0.45 * em;
  for (std::size_t i = 0; look_.numbers && i < marked_.marks.size(); ++i) {
    const Vec2 at = place(marked_.marks[i]);
    if (upright()) {
      drawing.text(at - Vec2(gap, 0), marked_.labels[i],
                   {.size = em, .across = Across::right, .upright = Upright::middle});
    } else {
      drawing.text(at - Vec2(0, gap), marked_.labels[i],
                   {.size = em, .across = Across::centre, .upright = Upright::top});
    }
  }
  const Vec2 middle = (from + to) / 2;
  const Vec2 label_at = upright() ? Vec2(look_.label_at, middle.y()) : Vec2(middle.x(), look_.label_at);
  drawing.text(label_at, look_.label,
               {.size = em, .across = Across::centre, .upright = Upright::middle, .turned = upright()});
  paint(drawing, painter, this->GetScene()->GetSceneWidth(), this->GetScene()->GetSceneHeight());
  return true;
}

}  // namespace fingerpad
