#pragma once

#include <string_view>

#include "contact/normals.hpp"

namespace fingerpad {

struct BriefSearch;
class ClosestMemory;
struct PlacedSurface;
struct WorldBox;
struct WorldPoint;

/// What a part in its pose and a plane answer each in their own way, each in a file of its own
/// (placed_part.cpp, placed_plane.cpp). There are these two. The functions of placed_surface.hpp say what is
/// asked; whoever calls those need not tell the kinds apart.
struct SurfaceKind {
  template <class Hint>
  using Nearest = WorldPoint (*)(const PlacedSurface& surface, const Vec3& p_WQ, Normals normals, Hint hint,
                                 double reach_m) noexcept;

  std::string_view name;  ///< as users are told of one that has no name of its own
  Nearest<int> nearest_from_seed;
  Nearest<ClosestMemory&> nearest_on_path;
  Nearest<BriefSearch&> nearest_in_brief;
  bool (*comes_within)(const PlacedSurface& surface, const WorldBox& box, double width_m);
  /// A point of it, or in its middle, from which it is measured.
  Vec3 (*middle_W)(const PlacedSurface& surface);
};

extern const SurfaceKind part_kind, plane_kind;

}  // namespace fingerpad
