#pragma once

#include <vector>

#include "base/random_stream.hpp"
#include "part/part.hpp"

namespace fingerpad {

/// Random places on a part's facets, each as likely as its area.
class RandomPlaces {
 public:
  /// @pre the part has triangles, and outlives this
  explicit RandomPlaces(const Part& part);

  int triangle(RandomStream& random) const;
  /// A point of that triangle.
  /// @param origin  added to what the part's arrays hold: centre_P for frame P, 0 for places about the centre
  Vec3 point(int triangle, const Vec3& origin, RandomStream& random) const;
  /// Draws what point() draws, for a point that nobody asks for.
  static void pass_point(RandomStream& random);

 private:
  Vec3 corner(int t, int k) const { return part_.vertices.col(part_.triangles(k, t)); }

  const Part& part_;
  std::vector<double> areas_;  // doubled, and summed
  // Where each of as many equal shares of their sum as there are triangles begins: in this one or a later.
  std::vector<int> first_;
};

}  // namespace fingerpad
