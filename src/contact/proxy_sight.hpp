#pragma once

#include <optional>

#include "contact/looks.hpp"
#include "contact/proxy_shortcuts.hpp"
#include "contact/proxy_state.hpp"
#include "contact/step_making.hpp"
#include "contact/worst_wall.hpp"

namespace fingerpad {

/// Two walls, seen from the proxy's place: the one that holds it and one that would hold it nearer to the
/// finger.
struct WallPair {
  ProxyWall here, there;
};

/// How far a step is to go.
struct StepTerms {
  double most_m;      ///< the proxy will go no farther: what stands beyond need not be seen
  double bent_m = 0;  ///< goes on along walls that bend away (way_along_bend) where the way is then no longer
                      ///< than this
};

/// What a proxy asks about its surroundings, answered by asking the trees for every triangle within reach,
/// each time anew: each answer depends on the question alone.
///
/// LimitedSight looks at no more than a tick may: where that is not enough, a step is broken off, and gone on
/// with in the next tick, and all else is declined. ProxyMemory, which derives from it, answers the same
/// questions faster, and takes shortcuts, of which there are none here.
class ProxySight : public ProxyShortcuts {
 public:
  explicit ProxySight(ProxyWorld world) : world_(std::move(world)) {}

  const ProxyWorld& world() const noexcept { return world_; }
  /// What this tick may still look at.
  Looks& looks() noexcept { return looks_; }
  const Looks& looks() const noexcept { return looks_; }

  /// The step from the proxy's place that brings it as close to its goal as it can get without crossing a
  /// surface. After a step that was broken off, from the same place, it is the same step gone on with,
  /// towards the goal that it was made for.
  virtual ProxyStep step(const ProxyState& state, const StepTerms& terms) noexcept;
  /// The same from a place above an edge, where `first` is known to hold (seen from there).
  /// @param rest_m  how far from there to the place that `first` alone would allow
  virtual ProxyStep step_over(const Vec3& edge_O, const Vec3& goal_O, const ProxyWall& first,
                              double rest_m) noexcept;
  /// Whether the ball may go by `over` from its place, in front of the wall `here`.
  /// @param far  where it will go on to from there, relative to its place
  virtual bool is_way_free(const Vec3& place_O, const Vec3& over, const Vec3& far,
                           const ProxyWall& here) noexcept;
  /// Where one facet holds the proxy from over its face: that facet and its smooth neighbour that is nearest
  /// to the finger, if one is nearer.
  virtual std::optional<WallPair> nearer_neighbour(const ProxyState& state) noexcept;

  /// A step that was broken off is not gone on with: the ball goes on from elsewhere.
  void drop_step() noexcept { making_.drop(); }

  /// Forgets everything, as before the first tick.
  virtual void forget() noexcept { drop_step(); }

  // For a step in the making:
  const Vec3& place_O() const noexcept { return place_O_; }
  /// Looks for the wall that the way by `z` from there breaches most; triangles behind the given walls
  /// cannot. False where the looks were spent before the end.
  bool offer_all(const Vec3& z, std::span<const ProxyWall> walls, LookRound& round) noexcept;

 protected:
  /// @param most_m  the step ends there at the latest; no farther than is looked around
  /// @param first  walls to begin with that likely hold, seen from the place looked around from
  ProxyStep step_towards(const Vec3& goal_O, double most_m, double bent_m,
                         std::span<const ProxyWall> first = {}) noexcept;
  ProxyStep step_beside(const ProxyWall& first, const Vec3& goal_O) noexcept;
  /// Whether the last step was broken off.
  bool is_amid_step() const noexcept { return making_.is_underway(); }
  ProxyStep go_on_with_step() noexcept { return making_.go_on(*this); }
  /// Looks around from there, for ways no longer than this.
  void look_from(const Vec3& place_O, double way_m) noexcept;
  /// Whether nothing blocks the way by `z` from the place looked around from; triangles behind the given
  /// walls cannot.
  bool is_free(const Vec3& z, std::span<const ProxyWall> walls) noexcept;
  /// What offer_all asks of one part.
  virtual bool offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                          LookRound& round) noexcept;

  ProxyWorld world_;
  Vec3 place_O_ = Vec3::Zero();  // looked around from ...
  double reach_m_ = 0;           // ... so far beyond the ball
  Looks looks_{Looks::unlimited};

 private:
  StepMaking making_;
};

}  // namespace fingerpad
