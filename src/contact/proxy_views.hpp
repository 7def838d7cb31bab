#pragma once

#include "contact/likely_walls.hpp"
#include "contact/limited_sight.hpp"
#include "contact/proxy_view.hpp"

namespace fingerpad {

/// A proxy's sight that keeps what its last search of the trees found (ProxyView). From a place nearby, these
/// triangles are all that can be within what is left of that search's reach; and what one look at a triangle
/// showed bounds its distance from everywhere, so that most are passed over. The way of a step is as free as
/// with a search made for it. Its walls are those that the search would find, but for three cases: a view may
/// end a step short of the finger, and the proxy then goes on from there; and a crowded view leaves out
/// triangles that a ball in front of its blocker cannot get at (BallShadow), which would only have led a step
/// to its end by other walls; and a step past all views, for a way that they would take too long for or one
/// that a view has turned off in the air, begins with walls that it will likely end at (LikelyWalls).
/// ProxyMemory derives from it, and sees to the ways over edges.
class ProxyViews : public LimitedSight {
 public:
  ProxyStep step(const ProxyState& state, const StepTerms& terms) noexcept override;
  void let_go() noexcept override;
  void forget() noexcept override;

 protected:
  ProxyViews(ProxyWorld world, Looks looks);

  /// Sees to a view about the edge, and makes the step from there.
  ProxyStep look_and_step_from_edge(const WayOver& way) noexcept;
  /// Whether steps from view to view over such a way would take more looks than are left, or no view about
  /// the place shows all that is near it.
  bool is_outrun(const Vec3& place_O, double way_m) const noexcept;
  bool is_seen_free(const WayOver& way) noexcept;
  /// The room around a place: no surface comes nearer to any place within it than the clearance. Negative
  /// where the clearance is missed. Not looked for beyond `enough_m`; where the triangle that was closest
  /// last leaves less than `least_m`, what it leaves is the answer, though another may leave still less.
  double room_m(const Vec3& place_O, double least_m, double enough_m) noexcept;
  bool is_clear_of_planes(const Vec3& place_O, int but) const noexcept;

  ProxyView view_;

 private:
  ProxyStep step_past_views(const ProxyState& state, const StepTerms& terms) noexcept;
  bool bends_in_the_air(const ProxyStep& step) const noexcept;
  void note_blockers(const ProxyStep& step) noexcept;
  bool offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                  LookRound& round) noexcept override;

  LikelyWalls likely_;
  double asked_m_ = 0;            // how far the next step is to see ...
  bool falls_short_ = false;      // ... because the last one ended where its view did
  bool goes_past_views_ = false;  // the steps to this goal do
  double short_step_m_ = 0;       // how far the last step came that ended where its rich view did ...
  long short_step_looks_ = 0;     // ... and what it cost
  std::vector<int> seeds_;        // per surface: the triangle that was closest last
};

}  // namespace fingerpad
