#include "part/raw_mesh.hpp"

#include <fmt/format.h>

#include <limits>

#include "base/error.hpp"

namespace fingerpad {

void RawMesh::add_vertex(const Vec3& vertex, std::size_t place) {
  if (vertices.size() >= std::numeric_limits<int>::max() / 4) {
    throw refused(place_unit + " " + std::to_string(place), "more vertices than can be numbered");
  }
  // Coordinates beyond float32 become infinite on their way through OpenMesh.
  if (!vertex.cast<float>().allFinite()) nonfinite.emplace_back(static_cast<int>(vertices.size()), place);
  vertices.push_back(vertex);
}

void RawMesh::end_polygon() {
  const std::size_t first = ends.empty() ? 0 : static_cast<std::size_t>(ends.back());
  if (corners.size() - first < 3) {
    corners.resize(first);
    ++short_polygons;
    return;
  }
  if (corners.size() >= std::numeric_limits<int>::max() / 4) {
    throw refused(fmt::format("face {}", ends.size()), "more corners than can be numbered");
  }
  ends.push_back(static_cast<int>(corners.size()));
}

double float32_of(double coordinate) noexcept {
  // GCC 12 folds double -> float -> double into nothing where it handles two numbers at a time; volatile
  // keeps it from that.
  const volatile float rounded = static_cast<float>(coordinate);
  return rounded;
}

long long plausible_count(long long count, std::size_t least_bytes, std::size_t bytes_left,
                          const std::string& place, std::string_view what) {
  if (count < 0) throw refused(place, fmt::format("announces {} {}: a count below zero", count, what));
  const std::size_t most = bytes_left / least_bytes;
  if (static_cast<unsigned long long>(count) > most) {
    throw refused(
        place,
        fmt::format("announces {} {}, but the {} bytes that follow hold {} at most: the count is wrong "
                    "or the file is truncated",
                    count, what, bytes_left, most));
  }
  return count;
}

}  // namespace fingerpad
