#pragma once

#include <limits>
#include <span>
#include <vector>

#include "contact/looks.hpp"
#include "contact/worst_wall.hpp"

namespace fingerpad {

/// A triangle in a proxy's view, and how it was last seen.
struct NearTriangle {
  int triangle;
  bool fetched = false;  ///< its corners, from the part; of one that is far or behind a wall seldom
  bool seen = false;     ///< looked at so far; most stand behind the wall that holds the proxy and never are
  TriangleCorners corners;  ///< where fetched
  FirstApproach first;      ///< where seen: of where it was looked at from ...
  Vec3 seen_from_P;         ///< ... and where that was
  double gap_m;             ///< distance from there less the clearance

  explicit NearTriangle(int t) noexcept : triangle(t) {}  // the rest is written before it is read
};

/// What is known of a triangle's distance. It is a convex function of the place that changes no faster than
/// the place does, so that one look bounds it everywhere. Kept apart from the triangle, since a pass over a
/// crowded view asks little else.
struct alignas(32) GapBound {
  Vec3 towards = Vec3::Zero();
  double level_m =
      -std::numeric_limits<double>::infinity();  ///< the gap that the tangent leaves at the
                                                 ///< part's centre; of one that nothing is known of, no bound

  GapBound() = default;
  /// @param approach  of the place that it was looked at from
  GapBound(const TriangleApproach& approach, const Vec3& place_P, double clearance_m) noexcept
      : towards(approach.towards), level_m(approach.distance_m - clearance_m - towards.dot(place_P)) {}

  /// The gap that the tangent leaves at a place; the true one is no smaller.
  double least_gap_m(const Vec3& place_P) const noexcept { return level_m + towards.dot(place_P); }
};

/// A triangle that holds the proxy, or held it not long ago: it may stand in others' way.
struct Blocker {
  int surface = -1, triangle = -1;
};

/// The triangles that the last search of the trees found within reach of a place, and what is known of each.
/// They are looked at from this place, or from another one near it. Allocates nothing once it is made.
class NearTriangles {
 public:
  explicit NearTriangles(const ProxyWorld& world);

  /// How many the last search found; where these were more than it should find, so many.
  int count() const noexcept { return count_; }
  void clear() noexcept {
    near_.clear();
    bounds_.clear();
    least_gaps_m_.clear();
    count_ = 0;
  }

  /// Lists all that a ball at the place, or within `reach_m` of it, may come upon. Where these are many,
  /// those that stand in the blocker's shadow (BallShadow) are left out. False where they are more than
  /// `most`.
  bool search(const ProxyWorld& world, const Vec3& place_O, double reach_m, int most, const Blocker& blocker,
              Looks& looks) noexcept;
  /// Looks at those that are listed from another place.
  void look_from(const ProxyWorld& world, const Vec3& place_O) noexcept;

  /// Offers a part's triangles, from `next` on, as walls to the way by `z` from the place looked from;
  /// triangles behind the given walls are passed over. False where the looks were spent before the last.
  bool offer(const ProxyWorld& world, int surface, const Vec3& z, std::span<const ProxyWall> walls,
             std::size_t& next, WorstWall& worst, Looks& looks) noexcept;
  /// How far the nearest of them is from a ball about `centre_O`, triangles behind the given walls aside, and
  /// at most `most_m` [m]. May be negative.
  /// @param walls  seen from the place looked from
  double room_m(const ProxyWorld& world, std::span<const ProxyWall> walls, const Vec3& centre_O,
                double most_m, Looks& looks) noexcept;

 private:
  struct PartView {
    Vec3 at_P = Vec3::Zero(), searched_P = Vec3::Zero();  ///< the places looked from and searched from
    bool within_reach = false;
    bool is_crowded = false;   ///< more is near than a small view holds: the next search begins with that
    bool is_in_order = false;  ///< its triangles stand as in the part, which decides what a pass costs
    std::size_t first = 0, end = 0;  ///< its triangles in near_; the one that blocked last comes first
  };

  bool search_part(const ProxyWorld& world, int surface, double distance_m, int most, const Blocker& blocker,
                   Looks& looks) noexcept;
  void list_found(const Part& part, int surface, const Blocker& blocker) noexcept;
  const NearTriangle& fetched(std::size_t k, const Part& part, const PartView& view, Looks& looks) noexcept;
  void swap(std::size_t a, std::size_t b) noexcept;
  bool is_cleared_by_plane(std::size_t k, const ProxyWorld& world, const PartWay& way,
                           const WorstWall& worst) noexcept;
  bool look_at(std::size_t k, const Vec3& place_P, double clearance_m) noexcept;

  int count_ = 0;
  std::vector<NearTriangle> near_;
  std::vector<GapBound> bounds_;      // of each in near_
  std::vector<double> least_gaps_m_;  // of each from where it was searched from, or less
  std::vector<int> found_;            // triangles, by the last search of a part
  std::vector<PartView> views_;
};

}  // namespace fingerpad
