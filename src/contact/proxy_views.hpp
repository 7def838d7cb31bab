#pragma once

#include <array>
#include <limits>

#include "contact/limited_sight.hpp"
#include "contact/near_triangles.hpp"
#include "contact/proxy_memory_limits.hpp"

namespace fingerpad {

/// A proxy's sight that keeps what its last search of the trees found. From a place nearby, these triangles
/// are all that can be within what is left of that search's reach; and what one look at a triangle showed
/// bounds its distance from everywhere, so that most are passed over. The way of a step is as free as with a
/// search made for it. Its walls are those that the search would find, but for three cases: a view may end a
/// step short of the finger, and the proxy then goes on from there; and a crowded view leaves out triangles
/// that a ball in front of its blocker cannot get at (BallShadow), which would only have led a step to its
/// end by other walls; and a step past all views begins with walls that it will likely end at.
/// ProxyMemory derives from it, and sees to the ways over edges.
class ProxyViews : public LimitedSight {
 public:
  ProxyStep step(const ProxyState& state, const StepTerms& terms) noexcept override;
  void let_go() noexcept override;
  void forget() noexcept override;

 protected:
  ProxyViews(ProxyWorld world, Looks looks);

  /// Looks around where a view that shows as far as `need_m` will do; a search is made from `ahead` of the
  /// place, which is nearer than the usual reach.
  void look_ahead(const Vec3& place_O, double need_m, const Vec3& ahead) noexcept;
  /// Sees to a view that shows the way to the edge and on to its far end, and some more in this direction.
  void look_over_edge(const WayOver& way) noexcept;
  /// Sees to a view about the edge, and makes the step from there.
  ProxyStep look_and_step_from_edge(const WayOver& way) noexcept;
  /// Whether steps from view to view over such a way would take more looks than are left, or no view about
  /// the place shows all that is near it.
  bool is_outrun(const Vec3& place_O, double way_m) const noexcept;
  /// The last step went past all views: what they show is not where the proxy is.
  bool is_past_views() const noexcept { return is_past_views_; }
  bool is_seen_free(const WayOver& way) noexcept;
  /// How far one can go from a centre in view and, in front of all these walls, meet no other [m].
  /// @param walls  seen from the place looked around from
  double room_in_front_of(std::span<const ProxyWall> walls, const Vec3& centre_O) noexcept;
  /// The room around a place: no surface comes nearer to any place within it than the clearance. Negative
  /// where the clearance is missed. Not looked for beyond `enough_m`; where the triangle that was closest
  /// last leaves less than `least_m`, what it leaves is the answer, though another may leave still less.
  double room_m(const Vec3& place_O, double least_m, double enough_m) noexcept;
  bool is_clear_of_planes(const Vec3& place_O, int but) const noexcept;

  /// Where the trees were searched from.
  const Vec3& search_place_O() const noexcept { return search_place_O_; }

  double finger_m_ = 0;              // how far the finger went in this tick
  double view_reach_m_ = 0;          // of the next search; grows and shrinks with what there is to see
  std::array<Blocker, 3> blockers_;  // what held the proxy last

 private:
  ProxyStep step_past_views(const Vec3& place_O, const Vec3& goal_O, const StepTerms& terms) noexcept;
  void note_short_step(const ProxyStep& step, long looks) noexcept;
  void note_blockers(const ProxyStep& step) noexcept;
  std::optional<ProxyWall> wall_touched(const Blocker& blocker, const Vec3& place_O) noexcept;
  std::optional<ProxyWall> wall_below(const Vec3& place_O, double way_m) noexcept;
  std::optional<ProxyWall> wall_ahead(const Vec3& place_O, const Vec3& goal_O, double way_m) noexcept;
  Blocker about_closest(const Vec3& place_O, double reach_m, const Blocker& near) noexcept;
  double look_around(const Vec3& place_O, double reach_m, bool anew) noexcept;
  bool see_from(const Vec3& place_O, double need_m, double reach_m, const Vec3& ahead) noexcept;
  bool look_again(const Vec3& place_O, double need_m) noexcept;
  void search_around(const Vec3& place_O, double reach_m) noexcept;
  bool search(const Vec3& place_O, double reach_m, int most) noexcept;
  /// No search showed anything before the looks were spent.
  bool is_blind() const noexcept { return reach_m_ < 0; }
  bool is_crowded_about(const Vec3& place_O) const noexcept;
  void suit_view() noexcept;
  double least_view_m() const noexcept;
  void see_nothing(double next_reach_m) noexcept;
  double widest_view_m() const noexcept;
  bool offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                  LookRound& round) noexcept override;

  Vec3 search_place_O_ = Vec3::Zero();
  double search_reach_m_ = -1;
  double asked_m_ = 0;            // how far the next step is to see ...
  bool falls_short_ = false;      // ... because the last one ended where its view did
  bool goes_past_views_ = false;  // the steps to this goal do
  bool is_past_views_ = false;    // the step asks the trees, however far it goes
  double short_step_m_ = 0;       // how far the last step came that ended where its rich view did ...
  long short_step_looks_ = 0;     // ... and what it cost
  Vec3 ahead_goal_O_ =
      Vec3::Constant(std::numeric_limits<double>::quiet_NaN());  // closest to this finger ...
  Blocker ahead_;                                                // ... is this triangle
  bool is_cut_ = false;    // the last search found too many and was made again, nearer
  bool is_rich_ = false;   // it found more than usual however near
  long rich_looks_ = 0;    // what the last search for the richest view cost
  bool overflow_ = false;  // there are more than can be listed: every pass asks the trees again
  Vec3 crowded_place_O_ = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());  // where there were, last
  int usual_view_ = ProxyMemoryLimits::usual_view;  // triangles; more with large fans
  NearTriangles near_;
  std::vector<int> seeds_;  // per surface: the triangle that was closest last
};

}  // namespace fingerpad
