#pragma once

#include <vtkChartMatrix.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <string>
#include <vector>

#include "view/chart.hpp"
#include "view/chart_layout.hpp"
#include "view/drawing_item_vtk.hpp"
#include "view/panel_chart_vtk.hpp"

namespace fingerpad {

/// A chart as a matrix of VTK's charts: for a window, in which it can be zoomed, panned and asked, or to be
/// recorded as a drawing.
class ChartBoard {
 public:
  /// Must come before show.
  void add_to(vtkContextScene* scene);

  /// Shows a chart, or what is new in it; zoomed panels stay zoomed.
  /// @param width, height  of the scene [px]
  void show(const Chart& chart, const ChartLayout& layout, int width, int height);

  /// Where there is no room for it nothing of it is seen, and the mouse means nothing to it.
  void set_visible(bool visible);
  bool visible() const { return visible_; }
  void set_dark(bool dark);

  /// Where its panels are and what they show now.
  ChartPlace place() const;

  bool zoomed() const;
  void show_all();

  // The mouse, at a place of the scene. False where it means nothing to the chart.
  bool wheel(int x, int y, int steps);
  bool press(int x, int y);
  bool move(int x, int y);
  bool release(int x, int y);

  /// Asks anew what the mouse is over, when the curves have gone on under it; after they were painted.
  void ask_again();
  /// The value that the mouse asks for; empty: none.
  std::string told() const;

  /// How often what it paints has changed, by show or by the mouse.
  std::uint64_t changes() const { return changes_; }

  std::vector<vtkAbstractContextItem*> items();

 private:
  PanelChart* panel_at(int x, int y);
  void build(const ChartLayout& layout);
  void follow(const PanelChart& leader);

  ChartLayout layout_;
  std::vector<vtkSmartPointer<PanelChart>> panels_;  ///< row by row from the top
  vtkNew<DrawingItem> words_;
  vtkNew<vtkChartMatrix> matrix_;
  PanelChart* held_ = nullptr;     ///< that is panned
  PanelChart* hovered_ = nullptr;  ///< that shows a value
  int last_x_ = 0, last_y_ = 0;
  bool visible_ = true, dark_ = false;
  std::uint64_t changes_ = 0;
};

}  // namespace fingerpad
