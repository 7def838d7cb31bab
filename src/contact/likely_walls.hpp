#pragma once

#include <limits>

#include "contact/near_triangles.hpp"
#include "contact/proxy_sight.hpp"

namespace fingerpad {

/// Walls that likely hold a step which goes farther than views reach. Where facets are much smaller than a
/// tick's way a view shows a little of it, and steps from view to view would take more looks than a tick has;
/// but nearly all facets that the straight way to the finger meets stand behind these walls.
class LikelyWalls {
 public:
  LikelyWalls(const ProxyWorld& world, Looks& looks) noexcept : world_(world), looks_(looks) {}

  /// Looks for them. Where the looks run out, for fewer.
  /// @param way_m  how far the step may go
  /// @param blockers  what held the proxy last
  void find(const Vec3& place_O, const Vec3& goal_O, double way_m,
            const std::array<Blocker, 3>& blockers) noexcept;
  /// Those found, seen from the place: at most three.
  std::span<const ProxyWall> found() const noexcept { return {found_.data(), count_}; }
  /// One of them is ahead, and not where the step begins.
  bool has_one_ahead() const noexcept { return has_one_ahead_; }

  /// The next steps begin from elsewhere.
  void let_go() noexcept;
  void forget() noexcept;

 private:
  std::optional<ProxyWall> wall_touched(const Blocker& blocker, const Vec3& place_O) noexcept;
  std::optional<ProxyWall> wall_below(const Vec3& place_O, const Vec3& goal_O, double way_m,
                                      const Blocker& near) noexcept;
  std::optional<ProxyWall> wall_ahead(const Vec3& place_O, const Vec3& goal_O, double way_m,
                                      const Blocker& near) noexcept;
  struct Ahead {
    Blocker at;
    bool is_met = false;  ///< the finger's straight way meets a surface, and that leads there
  };
  std::optional<ProxyWall> wall_in_way(const Blocker& triangle, const Vec3& place_O,
                                       const Vec3& goal_O) noexcept;
  Ahead triangle_ahead(const Vec3& place_O, const Vec3& goal_O, double way_m, const Blocker& near) noexcept;
  struct Met;
  Met first_met(const Vec3& place_O, const Vec3& goal_O) noexcept;
  bool is_touched_first(const Met& met, const Vec3& place_P, const Vec3& goal_P) noexcept;
  Blocker about_closest(const Vec3& place_O, double reach_m, const Blocker& near) noexcept;
  void add(const ProxyWall& wall) noexcept { found_[count_++] = wall; }

  const ProxyWorld& world_;
  Looks& looks_;
  std::array<ProxyWall, 3> found_;
  std::size_t count_ = 0;
  bool has_one_ahead_ = false;
  Vec3 ahead_goal_O_ = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());  // a step to this finger ...
  Ahead ahead_;  // ... likely ends at this triangle
};

}  // namespace fingerpad
