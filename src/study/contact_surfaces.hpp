#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "part/part.hpp"

namespace fingerpad {

/// Where a point stands against a surface that is known exactly.
struct ExactFoot {
  double signed_distance_m = 0;  ///< < 0 inside
  Vec3 normal = Vec3::UnitZ();   ///< unit, outward, at the nearest point
};

/// A smooth surface known exactly, with its tessellations (every vertex on it) and a way over it.
struct ExactSurface {
  std::string name;
  std::string words;        ///< with its sizes, for a chart
  std::vector<int> levels;  ///< of tessellation, coarse to fine
  std::function<TriangleSoup(int level)> mesh;
  std::function<double(int level)> facet_m;  ///< size of a facet across the curve [m]
  std::function<ExactFoot(const Vec3& p)> foot;
  std::function<Vec3(double along)> way;  ///< a point of the surface for 0 .. 1, at a fairly even pace
  double deepest_m = 0;                   ///< so deep a finger's centre is nearest to where it came in
  double highest_m = std::numeric_limits<double>::infinity();  ///< over it, where nothing else is met
  bool is_whole = true;                                        ///< `foot` is right all over the mesh
};

inline constexpr int all_levels = std::numeric_limits<int>::max();

/// A sphere (patches superconverge there: no orders are told from it), a generic torus, and a cylinder whose
/// rims are rounded by quarter circles, as CAD fillets are.
/// @param most_levels  of tessellation, the coarsest: finer ones take longer
std::vector<ExactSurface> exact_surfaces(int most_levels = all_levels);

/// Where a part's places differ: a spherical hollow of 8.5 mm in a box, which a ball of 7 mm just fits; a
/// knob, a three-hundredth of the surface of a plate 0.3 m wide that is flat but for it; a block whose flat
/// sides are two triangles each, and its roundings many; a bar on which a hill and a hollow of 20 mm meet
/// with nothing flat between, where facets of one row tell the least of how the surface turns. Their ways
/// stay in the hollow, on the knob and about where the two meet.
std::vector<ExactSurface> small_exact_surfaces(int most_levels = all_levels);

}  // namespace fingerpad
