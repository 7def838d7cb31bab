#pragma once

#include <string>
#include <vector>

#include "touch/touch_swap.hpp"
#include "touch/world.hpp"
#include "view/side_panels.hpp"

namespace fingerpad {

/// What can be changed while it is touched, as the rows of a panel. Each step is a change of the scene
/// (SceneChange), which its recording keeps.
class MaterialPanel {
 public:
  /// The panel's rows, from the top.
  enum Row : int { part, mu_static, mu_dynamic, stiffness, damping, law, normals, method, row_count };

  /// @param swap, world  of the touch; outlive this
  /// @param has_motors   a device in a hand is sent the forces: where it would shake is told
  MaterialPanel(TouchSwap& swap, const World& world, bool has_motors);

  SidePanel panel() const;
  void select(int row) { selected_ = row; }
  int selected() const noexcept { return selected_; }
  /// A row so many steps less or more. @returns what to tell; empty: nothing has changed
  std::string step(int row, int steps);

 private:
  std::vector<std::string> values(const Scene& scene) const;
  std::string unstable_words(const Scene& scene) const;
  std::string soft_words(const Scene& scene) const;
  std::vector<std::string> doubts(const Scene& scene) const;
  std::string stepped(int row, int steps, const Scene& scene, std::string& key) const;

  TouchSwap& swap_;
  const World& world_;
  bool has_motors_;
  int surface_ = 0, selected_ = mu_static;
};

}  // namespace fingerpad
