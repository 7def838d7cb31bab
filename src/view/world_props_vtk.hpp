#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "touch/world.hpp"
#include "view/draw_space.hpp"

class vtkPolyData;
class vtkRenderer;
class vtkStaticCellLocator;

namespace fingerpad {

/// Where a line of sight meets a surface of the world.
struct SurfaceHit {
  Vec3 point_W = Vec3::Zero();
  Vec3 normal_W = Vec3::UnitZ();  ///< unit, outward
  int surface = -1;
  double along = 0;  ///< 0 at the line's start, 1 at its end
};

/// The parts and planes of a world as actors: the surface, its creases and its path.
class WorldProps {
 public:
  WorldProps(const ViewInput& input, const DrawSpace& space, const ViewExtent& extent);

  void add_to(vtkRenderer* renderer) const;
  void show_creases(bool shown);
  void show_path(bool shown, bool by_force);
  void set_line_width(double px);
  /// A hidden surface is neither seen nor pointed at; it is felt all the same.
  void show_surface(std::size_t index, bool shown);
  bool shows_surface(std::size_t index) const { return shown_[index]; }
  /// Parts as the edges of their facets.
  void show_as_wires(bool wires);

  /// The first surface on the way from a to b, draw space [mm]. Locators are built on the first call.
  std::optional<SurfaceHit> first_hit(const Vec3& a_mm, const Vec3& b_mm);

  /// Distance between the lines of a plane's grid [m]; 0 without a plane.
  double grid_m() const noexcept { return grid_m_; }

 private:
  void add_part(const Surface& surface);
  void add_plane(const Surface& surface, const ViewExtent& extent);
  void build_locators();

  std::shared_ptr<const World> world_;
  DrawSpace space_;
  std::vector<vtkSmartPointer<vtkPolyData>> meshes_;  ///< one a surface, empty for a plane
  std::vector<vtkSmartPointer<vtkStaticCellLocator>> locators_;
  std::vector<vtkSmartPointer<vtkActor>> surfaces_, creases_, grids_;
  std::vector<bool> shown_;  ///< one a surface
  bool creases_shown_ = true;
  vtkSmartPointer<vtkActor> path_;
  double grid_m_ = 0;
};

}  // namespace fingerpad
