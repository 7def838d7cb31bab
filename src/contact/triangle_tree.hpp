#pragma once

#include <memory>

#include "contact/closest_point.hpp"

namespace fingerpad {

/// The closest triangle of a part to a point.
struct ClosestTriangle {
  int triangle = -1;  ///< index into Part::triangles; -1 when nothing lies within the search radius
  TrianglePoint at;   ///< relative to the part's centre
};

/// A search tree over a part's triangles: Embree traverses padded float boxes, the callback decides in double.
/// Immutable after construction; queries from any number of threads.
class TriangleTree {
 public:
  explicit TriangleTree(std::shared_ptr<const Part> part);
  ~TriangleTree();
  TriangleTree(TriangleTree&&) noexcept;
  TriangleTree& operator=(TriangleTree&&) noexcept;

  /// The closest triangle to q (relative to the part's centre [m]). Exact: the same answer as looking at every
  /// triangle; ties go to the lowest triangle, so it depends on q alone.
  /// @param seed  a triangle that is likely close (the last answer), or -1; costs speed only, never changes the answer
  /// @param reach_m  look no farther than this; infinity for no bound
  /// @pre q finite. noexcept, allocates nothing.
  ClosestTriangle closest(const Vec3& q, int seed, double reach_m) const noexcept;

  const Part& part() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fingerpad
