#pragma once

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>

#include <atomic>
#include <vector>

#include "touch/world.hpp"
#include "view/draw_space.hpp"
#include "view/surface_hit.hpp"

class vtkPolyData;
class vtkRenderer;

namespace fingerpad {

/// The parts and planes of a world as actors: the surface, its creases and its path.
class WorldProps {
 public:
  WorldProps(const ViewInput& input, const DrawSpace& space, const ViewExtent& extent);

  /// What is opaque and moves never: parts, creases, grids, path.
  void add_still_to(vtkRenderer* renderer);
  /// The squares of planes, through which one sees.
  void add_clear_to(vtkRenderer* renderer) const;
  /// All but the parts and their creases.
  void add_surroundings_to(vtkRenderer* renderer) const;

  /// A part or plane with all that belongs to it: hidden it is neither seen nor pointed at, and felt all the
  /// same.
  void show_surface(std::size_t index, bool shown);
  bool is_shown(std::size_t index) const { return shown_[index]; }
  /// Parts as the edges of their facets.
  void show_wireframe(bool wireframe);
  void show_creases(bool shown);
  bool creases_shown() const { return creases_shown_; }
  void show_path(bool shown, bool by_force);
  void set_line_width(double px);

  /// Meshes to be shown for parts while show_coarse(true), one a surface; one that is empty is shown whole.
  void set_coarse(const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);
  void show_coarse(bool coarse);
  /// How a part is painted, and its creases.
  vtkProperty* part_property() const { return part_property_; }
  vtkProperty* crease_property() const { return crease_property_; }

  /// The first surface on the way from a to b that is shown, draw space [mm]. Nothing is built for it and it
  /// waits for nobody. Any thread.
  std::optional<SurfaceHit> first_hit(const Vec3& a_mm, const Vec3& b_mm) const;
  /// The same of a finger: where one of this radius is too large for the hole that the line falls through, or
  /// for the slot that its spot is seen through, the rim, as a spot under the finger that rests there.
  std::optional<SurfaceHit> finger_hit(const Vec3& a_mm, const Vec3& b_mm, double radius_m) const;

  /// Distance between the lines of a plane's grid [m]; 0 without a plane.
  double grid_m() const noexcept { return grid_m_; }
  /// Around everything, shown or not, draw space.
  const vtkBoundingBox& bounds_mm() const { return bounds_mm_; }

 private:
  /// A part has a body and creases, a plane a square and a grid.
  struct SurfaceProps {
    vtkSmartPointer<vtkActor> body, creases, square, grid;
    vtkSmartPointer<vtkActor> coarse_body;  ///< in place of the body; may be none
  };
  void add_part(const Surface& surface);
  void add_plane(const Surface& surface, const ViewExtent& extent);
  void apply_visibility();

  std::shared_ptr<const World> world_;
  DrawSpace space_;
  std::vector<SurfaceProps> surfaces_;
  std::vector<std::atomic<bool>> shown_;  // a surface each; the window's thread sets them, any may ask
  vtkSmartPointer<vtkProperty> part_property_, crease_property_;
  vtkSmartPointer<vtkActor> path_;
  bool creases_shown_ = true, coarse_ = false;
  double grid_m_ = 0;
  vtkBoundingBox bounds_mm_;
  vtkRenderer* still_in_ = nullptr;  ///< that shows what is still
};

}  // namespace fingerpad
