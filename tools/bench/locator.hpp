#pragma once

#include <memory>

#include "part/part.hpp"

namespace fingerpad::bench {

/// One way to find the closest point of a part, behind a call that costs the same for all.
class Locator {
 public:
  Locator() = default;
  Locator(const Locator&) = delete;
  Locator& operator=(const Locator&) = delete;
  virtual ~Locator() = default;

  /// The squared distance from q (relative to the part's centre) to the part [m^2]. Remembers the last answer
  /// where the method can use it.
  virtual double distance2_m2(const Vec3& q) = 0;
};

std::unique_ptr<Locator> make_tree_locator(
    std::shared_ptr<const Part> part);  ///< fingerpad's own TriangleTree
/// One Embree user primitive a triangle, frames in double
std::unique_ptr<Locator> make_one_by_one_locator(std::shared_ptr<const Part> part);
/// A hand-written tree of eight boxes a node over fingerpad's packets
std::unique_ptr<Locator> make_wide_tree_locator(std::shared_ptr<const Part> part);
std::unique_ptr<Locator> make_cgal_locator(
    const Part& part);  ///< CGAL's AABB tree in double, with the last answer as hint
std::unique_ptr<Locator> make_vtk_locator(const Part& part);  ///< vtkStaticCellLocator

}  // namespace fingerpad::bench
