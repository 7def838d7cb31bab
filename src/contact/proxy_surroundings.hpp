#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/placed_surface.hpp"
#include "contact/proxy_near.hpp"
#include "contact/proxy_wall.hpp"

namespace fingerpad {

/// What a proxy stays out of.
using ProxySurface = PlacedSurface;

/// A step of the proxy and the walls that hold it.
struct ProxyStep {
  Vec3 z = Vec3::Zero();  ///< where to, relative to where the proxy stood [m]
  int wall_count = 0;
  std::array<ProxyWall, 3> walls;
  std::array<double, 3> share_m{};  ///< multiplier of each
  bool truncated = false;           ///< the step ends where the view of the surroundings does
  bool stuck = false;               ///< rounding left no way: z is zero or ends at the first touch
};

/// What stands around a place in the world, and how far one can go from there.
///
/// Places are relative to a centre of the world's, so that far coordinates cost nothing. The ball that moves
/// keeps `clearance_m()` from every triangle, seen from either side, and from every plane's half space.
class ProxySurroundings {
 public:
  ProxySurroundings(std::vector<ProxySurface> surfaces, double radius_m);

  std::span<const ProxySurface> surfaces() const noexcept { return surfaces_; }
  const Vec3& centre_W() const noexcept { return centre_W_; }
  /// The largest distance from the centre to a part's far end [m]; 0 without parts.
  double extent_m() const noexcept { return extent_m_; }
  double radius_m() const noexcept { return radius_m_; }
  /// What the ball keeps beyond its radius, so that rounding never takes it to the other side: 2^-27 of the
  /// parts' extent [m]; none without parts.
  double skin_m() const noexcept { return skin_m_; }
  double clearance_m() const noexcept { return radius_m_ + skin_m_; }
  /// By how much the clearance may be missed [m]; 2^-6 of the skin.
  double tolerance_m() const noexcept { return tolerance_m_; }

  /// A place in the frame of a part's arrays, and back.
  Vec3 in_part(int surface, const Vec3& place) const noexcept;
  Vec3 from_part(int surface, const Vec3& q) const noexcept;

  /// The half space that a plane leaves free, seen from a place.
  ProxyWall plane_wall(int surface, const Vec3& place) const noexcept;
  /// The half space that a triangle leaves free of a ball at `from`: the way to there from its closest point
  /// is the wall's normal. Seen from a place.
  ProxyWall tangent_wall(int surface, int triangle, const Vec3& from, const Vec3& place) const noexcept;
  /// Whether a place keeps the clearance from every plane but one.
  bool is_clear_of_planes(const Vec3& place, int but) const noexcept;

  /// The room around a place: no surface comes nearer to any place within it than the clearance. Negative
  /// where the clearance is missed. Not looked for beyond `enough_m`.
  double room_m(const Vec3& place, double enough_m) noexcept;

  /// Looks at everything within `reach_m` beyond the ball around a place. A view too rich for the memory
  /// that was set aside is made smaller; returns how far it reaches. What the last search of the trees found
  /// serves again as long as it shows half as far, or more, from the new place.
  /// @param anew  search the trees whatever is at hand
  double look_around(const Vec3& place, double reach_m, bool anew) noexcept;
  /// As above, where a view that shows as far as `need_m` will do; a search is made from `ahead` of the
  /// place, which is nearer than the reach. True where the trees were searched.
  bool look_ahead(const Vec3& place, double need_m, double reach_m, const Vec3& ahead) noexcept;
  /// Whether the last look searched the trees, and whether it had to be cut short.
  bool is_fresh() const noexcept { return place_ == search_place_; }
  bool is_cut() const noexcept { return is_cut_; }

  /// Where was looked around from, how far, where the trees were searched from, how far, and how many
  /// triangles are in view.
  const Vec3& place() const noexcept { return place_; }
  double reach_m() const noexcept { return reach_m_; }
  const Vec3& search_place() const noexcept { return search_place_; }
  double search_reach_m() const noexcept { return search_reach_m_; }
  std::size_t view_count() const noexcept { return near_.size(); }

  /// The step that brings the ball as close to `goal` (relative to the place looked around from) as it can
  /// get without crossing a surface. Dual active-set method: the wall that blocks the way most is added until
  /// none blocks it; a step to the projection onto walls that all have the start in front of them crosses
  /// nothing, whenever it is stopped.
  /// @param first  a wall to begin with, or none
  ProxyStep step_towards(const Vec3& goal, const ProxyWall* first) noexcept;

  /// How far one can go from a centre in view and, in front of all these walls, meet no other [m].
  /// @param walls  seen from the place looked around from
  double room_in_front_of(std::span<const ProxyWall> walls, const Vec3& centre) noexcept;

  /// Whether the way by `z` is free, but for the triangles behind the given walls.
  bool is_free(const Vec3& z, std::span<const ProxyWall> walls) noexcept;

 private:
  struct View {
    Vec3 at = Vec3::Zero();          ///< the place in the part's frame
    std::size_t first = 0, end = 0;  ///< its triangles in near_; the one that blocked last comes first
    bool within_reach = false;
  };

  bool box_within(int surface, const Vec3& q, double distance_m) const noexcept;
  bool look_again(const Vec3& place, double need_m) noexcept;
  void search_around(const Vec3& place, double reach_m) noexcept;
  void search(const Vec3& place, double reach_m) noexcept;
  template <class Visit>
  void each_near(int surface, Visit visit) noexcept;
  std::size_t part_walls(int surface, std::span<const ProxyWall> walls,
                         std::array<PartWall, 3>& in_part) const noexcept;
  struct Worst;
  void offer_plane(int surface, const Vec3& z, Worst& worst) const noexcept;
  void offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls, Worst& worst) noexcept;
  std::optional<ProxyWall> worst_wall(const Vec3& z, std::span<const ProxyWall> walls,
                                      double breach_m) noexcept;
  double free_share(const Vec3& z) noexcept;

  std::vector<ProxySurface> surfaces_;
  double radius_m_;
  Vec3 centre_W_ = Vec3::Zero();
  double extent_m_ = 0, skin_m_ = 0, tolerance_m_ = 0;
  std::vector<Vec3> part_from_centre_;  // per surface: the part's centre, or the plane's point

  Vec3 place_ = Vec3::Zero();
  double reach_m_ = 0;
  Vec3 search_place_ = Vec3::Zero();  // where the trees were asked from, and how far
  double search_reach_m_ = -1;
  bool is_cut_ = false;
  std::vector<NearTriangle> near_;
  std::vector<View> views_;
  std::vector<int> seeds_;
  bool overflow_ = false;  // near_ could not hold the view: every pass asks the trees again
};

}  // namespace fingerpad
