#pragma once

#include <optional>

#include "touch/world.hpp"
#include "view/side_panels.hpp"
#include "view/world_props_vtk.hpp"

namespace fingerpad {

/// The list of parts beside the scene, in which a click hides or shows one.
class PartsPanel {
 public:
  /// All are kept by reference.
  PartsPanel(const decltype(ViewInput::world)& world, SidePanels& panels, WorldProps& props)
      : world_(world), panels_(panels), props_(props) {}

  /// Opens the list or closes it.
  void toggle();
  static bool owns(const PanelHit& hit);
  /// @pre owns(hit)
  void click(const PanelHit& hit);

 private:
  void show();

  const decltype(ViewInput::world)& world_;
  SidePanels& panels_;
  WorldProps& props_;
};

}  // namespace fingerpad
