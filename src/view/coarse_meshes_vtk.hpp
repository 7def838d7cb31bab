#pragma once

#include <vtkSmartPointer.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "touch/world.hpp"
#include "view/draw_space.hpp"

class vtkPolyData;

namespace fingerpad {

/// A part's triangles, some hundred times fewer, near enough to be looked at while a view turns: vertices
/// that share a cell of a grid become one (quadric clustering, Lindstrom 2000). The same for the same part.
vtkSmartPointer<vtkPolyData> coarse_mesh(const Surface& surface, const DrawSpace& space);

/// Coarse meshes of a world's large parts, made by a thread of its own.
class CoarseMeshes {
 public:
  CoarseMeshes(std::shared_ptr<const World> world, const DrawSpace& space);
  /// Waits for the part that is under way.
  ~CoarseMeshes();
  CoarseMeshes(const CoarseMeshes&) = delete;
  CoarseMeshes& operator=(const CoarseMeshes&) = delete;

  bool are_ready() const { return ready_; }
  /// One a surface, empty for one that is not large. @pre are_ready()
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes() const { return meshes_; }

 private:
  std::vector<vtkSmartPointer<vtkPolyData>> meshes_;
  std::atomic<bool> ready_ = false, unwanted_ = false;
  std::thread maker_;
};

}  // namespace fingerpad
