#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "view/camera_look.hpp"
#include "view/camera_vtk.hpp"
#include "view/draw_space.hpp"
#include "view/layout.hpp"
#include "view/pointed_scene.hpp"
#include "view/view_input.hpp"

class vtkCamera;
class vtkRenderer;

namespace fingerpad {

/// From where a scene is looked at: its renderer's camera, how that was set, and what stands where on the
/// screen.
class SceneView {
 public:
  /// @param renderer, input, extent, space  kept by reference
  SceneView(vtkRenderer* renderer, const ViewInput& input, const ViewExtent& extent, const DrawSpace& space);

  /// For a scene of this size. A view that was fitted and not changed since is fitted again.
  void lay_out(const Layout& layout);
  /// The view at first: from there, or the usual one (set_scene_camera) of the moment shown.
  void reset(const std::optional<LookFrom>& look, const TickRecord* shown);
  /// All in sight from a direction, the finger too where there is one.
  void look(const LookFrom& from, const std::optional<FingerInSight>& finger);
  void look_at_all(const std::optional<FingerInSight>& finger);  ///< from where it is looked now
  /// Nearer (> 1) or farther.
  void zoom(double factor);
  /// From now on what is looked at stands beside the readings, where the window has room for both.
  void keep_clear_of_readings();

  double px_per_mm() const;
  Vec2 on_screen(const Vec3& p_mm) const;
  /// The line of sight through a pixel of the scene, near to far, draw space [mm].
  std::pair<Vec3, Vec3> line_of_sight(double x_px, double y_px) const;
  /// For one who points at it; without panels.
  PointedScene pointed() const;

 private:
  vtkCamera* camera() const;
  void fit();
  double readings_strip_px() const;
  double width_to_height() const;
  void make_way_for_readings();

  vtkRenderer* renderer_;
  const ViewInput& input_;
  const ViewExtent& extent_;
  const DrawSpace& space_;
  Layout layout_;
  bool clear_of_readings_ = false;
  std::optional<LookFrom> look_;         ///< that the camera was set to last; none: the usual view
  std::optional<FingerInSight> finger_;  ///< that was in sight then
  std::optional<TickRecord> looked_at_;  ///< the moment for which the usual view was chosen, if for one
  std::vector<double> fitted_;           ///< view_of the camera then
};

}  // namespace fingerpad
