#pragma once

#include <limits>

#include "contact/near_triangles.hpp"
#include "contact/proxy_memory_limits.hpp"
#include "contact/proxy_sight.hpp"

namespace fingerpad {

/// What the last search of the trees found, and how far it shows all there is from places nearby: as far as
/// is left of the search's reach. A search reaches as far as is wanted, and finds no more than is kept at
/// hand; after what it found the next one reaches farther, or less far.
class ProxyView {
 public:
  /// @param at  where it is looked from, and how far all is in view; kept up to date. A negative reach: no
  /// search showed anything before the looks were spent
  ProxyView(const ProxyWorld& world, Looks& looks, Lookout& at);
  ProxyView(const ProxyView&) = delete;
  ProxyView& operator=(const ProxyView&) = delete;
  ~ProxyView() = default;

  void forget() noexcept;
  /// The finger's, in this tick: however rich, a view reaches as far as it goes in a few.
  void note_finger(double way_m) noexcept { finger_m_ = way_m; }

  /// Looks at everything within `reach_m`, or, where that is too much, within less; returns how far. What the
  /// last search found serves again as long as it shows half as far.
  /// @param anew  it does not
  double look_around(const Vec3& place_O, double reach_m, bool anew) noexcept;
  /// Sees to a view that shows as far as `need_m`; true where the trees were searched for it.
  /// @param ahead  a search is made from there, relative to the place: nearer than the reach
  bool see_from(const Vec3& place_O, double need_m, double reach_m, const Vec3& ahead) noexcept;
  /// The same with the usual reach.
  void look_ahead(const Vec3& place_O, double need_m, const Vec3& ahead) noexcept;
  /// Sees to a view that shows the way to the edge and on to its far end, and some more in this direction.
  void look_over_edge(const WayOver& way) noexcept;
  /// Makes the next views wider or narrower, after what a search has found. One that was broken off has seen
  /// to that itself.
  void suit() noexcept;
  /// What it shows is not where the proxy is: that has gone past it. Until it is looked at again.
  void leave() noexcept { is_left_ = true; }
  bool is_left() const noexcept { return is_left_; }

  bool is_blind() const noexcept { return at_.reach_m < 0; }
  /// There are more triangles than can be listed: every pass asks the trees again.
  bool overflows() const noexcept { return overflows_; }
  /// Whether the richest view found too many not far from there: it would again.
  bool is_crowded_about(const Vec3& place_O) const noexcept;
  bool is_rich() const noexcept { return near_.count() > ProxyMemoryLimits::rich_view; }
  /// The last search found too many and was made again, nearer.
  bool is_cut() const noexcept { return is_cut_; }
  /// The reach of the next search [m].
  double next_reach_m() const noexcept { return next_reach_m_; }
  /// Where the trees were searched from.
  const Vec3& search_place_O() const noexcept { return search_place_O_; }

  /// ProxySight::offer_part of what is listed.
  bool offer(int surface, const Vec3& z, std::span<const ProxyWall> walls, LookRound& round) noexcept {
    return near_.offer(world_, surface, z, walls, round.next, round.worst, looks_);
  }
  /// How far one can go from a centre in view and, in front of all these walls, meet no other [m].
  /// @param walls  seen from the place looked from
  double room_in_front_of(std::span<const ProxyWall> walls, const Vec3& centre_O) noexcept;

  /// What held the proxy last.
  const std::array<Blocker, 3>& blockers() const noexcept { return blockers_; }
  void note_blockers(std::span<const ProxyWall> walls) noexcept;

 private:
  bool look_again(const Vec3& place_O, double need_m) noexcept;
  void search_around(const Vec3& place_O, double reach_m) noexcept;
  bool search(const Vec3& place_O, double reach_m, int most) noexcept;
  void see_nothing(double next_reach_m) noexcept;
  double least_m() const noexcept;
  double widest_m() const noexcept;

  const ProxyWorld& world_;
  Looks& looks_;
  Lookout& at_;
  NearTriangles near_;
  std::array<Blocker, 3> blockers_;
  int usual_ = ProxyMemoryLimits::usual_view;  // triangles; more with large fans
  double finger_m_ = 0;
  Vec3 search_place_O_ = Vec3::Zero();
  double search_reach_m_ = -1, next_reach_m_ = 0;
  bool is_left_ = false, is_cut_ = false;
  bool is_crowded_ = false;  // the last search found more than usual however near
  bool overflows_ = false;
  long rich_looks_ = 0;  // what the last search for the richest view cost
  Vec3 crowded_place_O_ = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());  // where there were, last
};

}  // namespace fingerpad
