#pragma once

#include <vtkAxis.h>
#include <vtkPen.h>

#include <string>

#include "view/axis.hpp"
#include "view/drawing.hpp"

namespace fingerpad {

/// An axis of VTK whose numbers are ours: marks at 1, 2 and 5 times powers of ten, as many as there is room
/// for by the width of their numbers, also while it is zoomed.
class PanelAxis : public vtkAxis {
 public:
  static PanelAxis* New();
  vtkTypeMacro(PanelAxis, vtkAxis);

  /// What stands along it. `label_at`: middle of the line that the label stands on, across the axis [px].
  struct Look {
    double em = 12;
    bool numbers = false;
    std::string label;
    double label_at = 0;
  };
  void set_look(const Look& look);
  void set_grid(const Colour& colour) { this->GridPen->SetColor(colour.red, colour.green, colour.blue); }

  /// Shows this range and lets nobody zoom or move out of it.
  void set_ends(const Axis& ends);
  void show_range(double min, double max);

  /// The range shown, without marks.
  Axis shown() const;

  void Update() override;
  bool Paint(vtkContext2D* painter) override;

 private:
  bool upright() const { return this->Position == LEFT || this->Position == RIGHT; }
  bool numbers_meet(double length_px) const;
  Vec2 place(double value) const;
  void draw_mark(Drawing& drawing, double value, double length_px) const;

  Look look_;
  Axis marked_{0, 0, false, {}, {}, {}};
  double marked_length_px_ = 0;
};

}  // namespace fingerpad
