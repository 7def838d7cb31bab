#pragma once

#include <optional>

#include "contact/proxy_state.hpp"
#include "contact/worst_wall.hpp"

namespace fingerpad {

/// Two walls, seen from the proxy's place: the one that holds it and one that would hold it nearer to the
/// finger.
struct WallPair {
  ProxyWall here, there;
};

/// What a proxy asks about its surroundings, answered by asking the trees for every triangle within reach,
/// each time anew. Each answer depends on the question alone.
///
/// ProxyMemory answers the same questions faster. The second half of this list are offers to it, to go on for
/// the proxy from a state where it knows what the proxy would do; here each of them declines.
class ProxySight {
 public:
  explicit ProxySight(ProxyWorld world) : world_(std::move(world)) {}
  virtual ~ProxySight() = default;

  const ProxyWorld& world() const noexcept { return world_; }

  /// The step from a place that brings the ball as close to `goal` as it can get without crossing a surface.
  /// @param most_m  the proxy will go no farther: what stands beyond need not be seen
  virtual ProxyStep step(const Vec3& place_O, const Vec3& goal_O, double most_m) noexcept;
  /// The same from a place above an edge, where `first` is known to hold (seen from there).
  /// @param rest_m  how far from there to the place that `first` alone would allow
  virtual ProxyStep step_over(const Vec3& edge_O, const Vec3& goal_O, const ProxyWall& first,
                              double rest_m) noexcept;
  /// Whether the ball may go by `over` from its place, in front of the wall `here`.
  /// @param far  where it goes on to from there, relative to its place
  virtual bool is_way_free(const Vec3& place_O, const Vec3& over, const Vec3& far,
                           const ProxyWall& here) noexcept;
  /// Where one facet holds the proxy from over its face: that facet and its smooth neighbour that is nearest
  /// to the finger, if one is nearer.
  virtual std::optional<WallPair> nearer_neighbour(const ProxyState& state) noexcept;

  /// At the tick's start: takes the proxy to where it comes to rest, and reports. False where that is not
  /// known; the proxy may then be on its way there.
  virtual bool carry(ProxyState&) noexcept { return false; }
  /// The proxy has come to rest.
  virtual void note_rest(const ProxyState&) noexcept {}
  /// At the tick's end: takes the proxy to the same place in closed form, and reports. False if not known.
  virtual bool slide(ProxyState&) noexcept { return false; }
  /// Takes the proxy to `to`, where `there` (seen from its place) alone holds it. False where that is not
  /// known.
  virtual bool land(ProxyState&, const ProxyWall& /*there*/, const Vec3& /*edge_O*/,
                    const Vec3& /*to_O*/) noexcept {
    return false;
  }
  /// The proxy leaves what it rested on; steps may follow.
  virtual void let_go() noexcept {}
  /// Forgets everything, as before the first tick.
  virtual void forget() noexcept {}

 protected:
  ProxyStep step_towards(const Vec3& goal, const ProxyWall* first) noexcept;
  /// The wall that the way by `z` from the place looked around from breaches most, and by more than
  /// `breach_m`; triangles behind the given walls cannot.
  std::optional<ProxyWall> worst_wall(const Vec3& z, std::span<const ProxyWall> walls,
                                      double breach_m) noexcept;
  /// Offers each triangle of a part that is within reach.
  virtual void offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                          WorstWall& worst) noexcept;

  ProxyWorld world_;
  Vec3 place_O_ = Vec3::Zero();  // looked around from ...
  double reach_m_ = 0;           // ... so far beyond the ball

 private:
  double free_share(const Vec3& z) noexcept;
};

/// Calls `visit(corners, triangle)` for each triangle of a part within a distance of a point.
template <class Visit>
void each_triangle_within(const TriangleTree& tree, const Vec3& at_P, double distance_m, Visit visit) {
  struct Passing {
    const Part* part;
    Visit* visit;
  } passing{&tree.part(), &visit};
  tree.each_within(
      at_P, distance_m,
      [](void* context, int triangle) {
        const Passing& p = *static_cast<Passing*>(context);
        (*p.visit)(corners_of(*p.part, triangle), triangle);
      },
      &passing);
}

}  // namespace fingerpad
