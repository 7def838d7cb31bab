#pragma once

#include <vtkNew.h>

#include <memory>
#include <optional>

#include "view/chart.hpp"
#include "view/chart_board_vtk.hpp"
#include "view/kept_renderer_vtk.hpp"
#include "view/layout.hpp"
#include "view/theme_device_vtk.hpp"

class vtkRenderWindow;
class vtkRenderer;

namespace fingerpad {

/// The charts at the right of a stage, on their paper; kept from frame to frame while they are the same.
class ChartColumn {
 public:
  /// @param wanted  false: nothing is ever shown
  explicit ChartColumn(bool wanted) : wanted_(wanted) {}

  /// Behind all that is added later.
  void add_to(vtkRenderWindow* window);
  void show(Chart chart);
  /// In a layout from now on.
  void lay_out(const Layout& layout);
  void set_dark(bool dark);
  /// For what has changed by other means than show() and set_dark().
  void redraw() { ++changes_; }

  /// Before a frame.
  void prepare(bool keeping);
  bool shows() const { return wanted_ && chart_ && board_.visible(); }
  /// A line through the panels at a moment; none where they are zoomed to another time.
  std::shared_ptr<const Drawing> cursor(double t_s) const;
  ChartBoard& board() { return board_; }
  const ChartBoard& board() const { return board_; }
  bool wanted() const { return wanted_; }
  long drawn() const { return marks_->drawn(); }

 private:
  void place();

  bool wanted_;
  Layout layout_;
  std::optional<Chart> chart_;
  bool placed_ = false;  ///< in the present layout
  ChartBoard board_;
  std::uint64_t changes_ = 0;
  vtkNew<KeptRenderer> marks_;
  vtkNew<vtkRenderer> paper_;
  vtkNew<ThemeDevice> words_device_, device_;  ///< of what stands about the panels, and of the panels
};

}  // namespace fingerpad
