#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "part/part.hpp"

namespace fingerpad {

/// A corner of a triangle.
struct PartCorner {
  int triangle, corner;

  Eigen::Index column() const noexcept { return Eigen::Index{3} * triangle + corner; }
};

/// A facet at a vertex.
struct FanFacet {
  PartCorner at;
  Vec3 normal;         ///< unit; zero where it has no area
  Vec3 first, second;  ///< its edges from the vertex [m]
  double doubled_area_m2 = 0;
};

/// The facets around a vertex that are joined over smooth edges. Each is reached from each of the others;
/// what is made of them is made once, from the corner of the lowest number on.
class SmoothFan {
 public:
  static constexpr std::size_t most_facets = 64;

  /// The corner of the lowest number in the fan around `at`; none where the fan has too many facets.
  static std::optional<PartCorner> lowest(const Part& part, PartCorner at) noexcept;

  /// False where the fan has too many facets, or a corner of a lower number than `lowest`.
  bool gather(const Part& part, PartCorner lowest) noexcept;
  std::span<const FanFacet> facets() const noexcept { return std::span(facets_).first(count_); }
  /// Whether it goes all around the vertex; else it ends at a crease, or at the part's rim.
  bool is_closed() const noexcept { return is_closed_; }

 private:
  std::array<FanFacet, most_facets> facets_;
  std::size_t count_ = 0;
  bool is_closed_ = false;
};

}  // namespace fingerpad
