#pragma once

#include <optional>
#include <string>
#include <vector>

#include "view/drawing.hpp"
#include "view/layout.hpp"

namespace fingerpad {

/// One line of a panel: something to switch on and off, or a value with less and more beside it.
struct PanelRow {
  enum class Kind { check, value, note };
  Kind kind = Kind::note;
  std::string label, value;
  bool on = false;        ///< of a check
  bool selected = false;  ///< the keys' row
};

/// A list drawn over the scene, to be clicked.
struct SidePanel {
  std::string name;  ///< by which whoever shows it knows it
  std::string title;
  std::vector<PanelRow> rows;
};

/// Where in a panel the mouse is.
struct PanelHit {
  std::string panel;
  int row = -1;   ///< -1: none
  int steps = 0;  ///< on less: -1, on more: 1
};

/// The panels of a window, one under the other at the upper right of the scene. They stay where they are,
/// whatever is touched: who clicks must not be fled from. One that does not fit into the scene has as many of
/// its rows as do, and says how many more there are; without room for one it is not there.
class SidePanels {
 public:
  /// Shows a panel, or what is new in it.
  void show(SidePanel panel);
  void hide(const std::string& name);
  bool shows(const std::string& name) const;

  std::vector<Box> boxes(const Layout& layout) const;
  void paint(Drawing& drawing, const Layout& layout) const;
  std::optional<PanelHit> hit(const Layout& layout, double x, double y) const;

 private:
  std::vector<SidePanel> panels_;
};

}  // namespace fingerpad
