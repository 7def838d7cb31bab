#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "contact/looks.hpp"
#include "contact/proxy_sweep.hpp"
#include "contact/proxy_world.hpp"

namespace fingerpad {

/// At most three walls that the proxy stays in front of anyway, in the frame of one part: triangles behind
/// one of them cannot stop it.
class PartWalls {
 public:
  static constexpr std::size_t most_walls = 3;

  struct Wall {
    Vec3 normal_P = Vec3::UnitZ();
    double offset_m = 0;  ///< what lies no farther along the normal stands behind it
  };

  /// @param walls  seen from the place whose point in the part's frame is `from_P`
  PartWalls(const ProxyWorld& world, int surface, std::span<const ProxyWall> walls,
            const Vec3& from_P) noexcept
      : count_(std::min(walls.size(), most_walls)) {
    for (std::size_t k = 0; k < count_; ++k) {
      walls_[k].normal_P = world.turned_into_part(surface, walls[k].normal);
      walls_[k].offset_m =
          walls_[k].normal_P.dot(from_P) + walls[k].least_m - world.clearance_m() + world.tolerance_m();
    }
  }

  /// Whether all of a triangle stands behind one of them.
  bool hide(const TriangleCorners& f) const noexcept {
    return std::any_of(walls().begin(), walls().end(), [&f](const Wall& wall) {
      return wall.normal_P.dot(f.a) <= wall.offset_m && wall.normal_P.dot(f.b) <= wall.offset_m &&
             wall.normal_P.dot(f.c) <= wall.offset_m;
    });
  }
  std::span<const Wall> walls() const noexcept { return {walls_.data(), count_}; }

 private:
  std::size_t count_;
  std::array<Wall, most_walls> walls_;
};

/// A way of the ball in the frame of a part.
struct PartWay {
  int surface;
  Vec3 from_P, way_P, to_P;

  /// @param start_P  where it begins; the way by `z` is the world's
  PartWay(const ProxyWorld& world, int part, const Vec3& start_P, const Vec3& z) noexcept
      : surface(part), from_P(start_P), way_P(world.turned_into_part(part, z)), to_P(start_P + way_P) {}
};

/// The wall that a way breaches most, of those offered so far; ties go to the lowest triangle.
struct WorstWall {
  std::optional<ProxyWall> wall;  ///< seen from where the way begins
  double slack_m;                 ///< how far in front of it the way ends; < 0
  long looks = 0;                 ///< that the sweeps past the triangles offered have cost (LookCosts)

  bool is_beaten_by(double other_slack_m, int surface, int triangle) const noexcept {
    if (!(other_slack_m == slack_m && wall)) return other_slack_m < slack_m;
    return surface == wall->surface && triangle < wall->triangle;
  }

  void offer_plane(const ProxyWall& plane, const Vec3& z) noexcept {
    const double end_slack_m = plane.normal.dot(z) - plane.least_m;
    if (!is_beaten_by(end_slack_m, plane.surface, -1)) return;
    wall = plane;
    slack_m = end_slack_m;
  }

  /// @param first  how the place where the way begins stands before the triangle
  /// @returns whether this triangle's is the worst now
  bool offer_triangle(const ProxyWorld& world, const PartWay& way, const TriangleCorners& corners,
                      int triangle, const FirstApproach& first) noexcept {
    // The breach only shrinks as the sweep goes on from its first tangent, which is this.
    const double end_slack_m = first.distance_m - world.clearance_m() + first.towards.dot(way.way_P);
    if (end_slack_m >= -world.tolerance_m() || end_slack_m > slack_m) return false;
    const TriangleSweep sweep = sweep_past_triangle(corners, way.from_P, way.to_P, world.clearance_m(),
                                                    world.tolerance_m(), first, slack_m);
    looks += LookCosts::sweep + LookCosts::sweep_step * sweep.steps;
    if (!sweep.blocked || !is_beaten_by(sweep.end_slack_m, way.surface, triangle)) return false;
    slack_m = sweep.end_slack_m;
    wall = ProxyWall{world.turned_from_part(way.surface, sweep.normal),
                     sweep.offset_m - sweep.normal.dot(way.from_P), way.surface, triangle};
    return true;
  }
};

}  // namespace fingerpad
