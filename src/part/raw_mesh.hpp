#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/types.hpp"

namespace fingerpad {

/// What a mesh file says, as far as its numbers go: the measure for what OpenMesh makes of it.
///
/// Every format's scan reads a whole file with bounds on everything (counts against the bytes that are there,
/// every index against the vertices) and throws Error (refused) at a place in the file, without the file's
/// name, for a file that is no mesh of its format or ends too early. The bytes are what OpenMesh will be
/// given next: what would mislead it is taken out (material libraries that it would open, names that it would
/// take for keywords, headers that it would never leave).
struct RawMesh {
  std::string format;          ///< "text STL", "binary PLY", ...
  bool binary = false;         ///< OpenMesh is to read it as binary
  bool float32 = false;        ///< the file's own coordinates are float32
  std::vector<Vec3> vertices;  ///< in file units; of an STL three a triangle
  std::vector<int> corners;    ///< of all polygons, one after the other; -1: names a vertex that is not there
  std::vector<int>
      ends;  ///< polygon i has corners ends[i - 1] (0 for the first) up to, not including, ends[i]
  std::vector<std::string> warnings;
  /// Vertices with a coordinate that is not finite, ascending, with their line or byte.
  std::vector<std::pair<int, std::size_t>> nonfinite;
  std::string place_unit = "line";

  int polygon_count() const { return static_cast<int>(ends.size()); }
  int first_corner(int i) const { return i == 0 ? 0 : ends[static_cast<std::size_t>(i) - 1]; }
  int corner_count(int i) const { return ends[static_cast<std::size_t>(i)] - first_corner(i); }

  /// Adds a vertex that was read at this line or byte.
  void add_vertex(const Vec3& vertex, std::size_t place);
  /// Ends a polygon whose corners were appended; one with fewer than three is taken back and counted.
  void end_polygon();
  long short_polygons = 0;
};

/// A coordinate rounded to float32 and back.
double float32_of(double coordinate) noexcept;

/// The count as it may be announced by a file that goes on for `bytes_left` bytes of which each item needs at
/// least `least_bytes`; else throws Error (refused).
/// @param what  "vertices"
long long plausible_count(long long count, std::size_t least_bytes, std::size_t bytes_left,
                          const std::string& place, std::string_view what);

}  // namespace fingerpad
