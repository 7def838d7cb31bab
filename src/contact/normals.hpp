#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/types.hpp"

namespace fingerpad {

class TriangleTree;
struct ClosestTriangle;
struct SurfacePlace;
struct SurfacePoint;
struct TrianglePoint;

/// One row of the table of normals: how the contact normal is made from facets. Creases and sharp vertices
/// keep the facet rule with all of them.
struct NormalsEntry {
  std::string_view name;     ///< as scenes write it
  std::string_view summary;  ///< in a line
  /// How far they are off the smooth surface that the facets stand for, at one of a part's places [rad].
  /// Null: `auto` never takes them.
  double (*off_rad)(const SurfacePlace& place) noexcept = nullptr;
  /// The normal at a smooth place of triangle t; null: what the facet rule gives there.
  /// @param facet_normal_P  that, on the facets' outer side, unit
  Vec3 (*shade)(const TriangleTree& tree, int t, const TrianglePoint& at,
                const Vec3& facet_normal_P) noexcept = nullptr;
  /// The answer on a surface that stands for the facets; null: the facets are the surface.
  /// @param facets             the tree's answer for q, found
  /// @param q                  relative to the part's centre [m]
  /// @param signed_distance_m  to the facets
  SurfacePoint (*own_surface)(const TriangleTree& tree, const ClosestTriangle& facets, const Vec3& q,
                              double signed_distance_m) noexcept = nullptr;
  /// Whether the facets' own are shown.
  bool shows_facets() const noexcept { return shade == nullptr; }
  double strays = 0;                               ///< of that surface off the facets, in sizes of the part
  void (*prepare)(const TriangleTree&) = nullptr;  ///< makes later answers faster; null: nothing to make
};

extern const NormalsEntry normals_facet, normals_smooth, normals_curved;

/// A row of the table of normals.
class Normals {
 public:
  static const Normals facet, smooth, curved;

  constexpr explicit Normals(const NormalsEntry& row) noexcept : row_(&row) {}
  constexpr const NormalsEntry* operator->() const noexcept { return row_; }
  friend constexpr bool operator==(Normals, Normals) noexcept = default;

 private:
  const NormalsEntry* row_;
};
inline constexpr Normals Normals::facet{normals_facet};
inline constexpr Normals Normals::smooth{normals_smooth};
inline constexpr Normals Normals::curved{normals_curved};

/// All kinds of normals, the plainest first.
std::span<const Normals> normals_table() noexcept;
/// The kind of a name; nullptr if there is none.
const Normals* find_normals(std::string_view name) noexcept;

}  // namespace fingerpad
