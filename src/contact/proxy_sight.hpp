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

/// A way of the proxy from one wall to another.
struct WayOver {
  Vec3 place_O, goal_O;  ///< of the proxy, and of the finger
  WallPair walls;
  // Seen from the place:
  Vec3 edge;           ///< where the ball lies on both walls
  Vec3 far;            ///< where the second wall alone would hold it
  double depth_m;      ///< how far the finger is behind that wall
  double must_beat_m;  ///< the way is worth going if it ends nearer to the finger than that
};

/// Where a sight looks around from, and how far beyond the ball [m].
struct Lookout {
  Vec3 place_O = Vec3::Zero();
  double reach_m = 0;
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

  /// The step from the proxy's place that brings it as close to its goal as it can get without crossing a
  /// surface. After a step that was broken off, from the same place, it is the same step gone on with,
  /// towards the goal that it was made for.
  virtual ProxyStep step(const ProxyState& state, const StepTerms& terms) noexcept;
  /// The step from the way's edge, where its second wall holds; nothing where the way to there is blocked.
  virtual std::optional<ProxyStep> step_over(const WayOver& way) noexcept;
  /// Where one facet holds the proxy from over its face: that facet and its smooth neighbour that is nearest
  /// to the finger, if one is nearer.
  virtual std::optional<WallPair> nearer_neighbour(const ProxyState& state) noexcept;

  /// A step that was broken off is not gone on with: the ball goes on from elsewhere.
  void drop_step() noexcept { making_.drop(); }

  /// Forgets everything, as before the first tick.
  virtual void forget() noexcept { drop_step(); }

  // For a step in the making:
  const Vec3& place_O() const noexcept { return at_.place_O; }
  /// Looks for the wall that the way by `z` from there breaches most; triangles behind the given walls
  /// cannot. False where the looks were spent before the end.
  bool offer_all(const Vec3& z, std::span<const ProxyWall> walls, LookRound& round) noexcept;

 protected:
  ProxyStep step_from_edge(const WayOver& way) noexcept;
  /// Of a way that was not seen to be free: nothing, or where that is for want of looks a step broken off.
  std::optional<ProxyStep> no_way() const noexcept;
  /// Looks around from there, for ways no longer than this.
  void look_from(const Vec3& place_O, double way_m) noexcept;
  /// Whether nothing blocks the way by `z` from the place looked around from; triangles behind the wall
  /// cannot.
  bool is_free(const Vec3& z, const ProxyWall& wall) noexcept;
  /// What offer_all asks of one part.
  virtual bool offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                          LookRound& round) noexcept;

  ProxyWorld world_;
  Lookout at_;
  Looks looks_{Looks::unlimited};
  StepMaking making_;
};

}  // namespace fingerpad
