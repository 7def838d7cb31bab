#pragma once

#include <memory>

#include "contact/proxy_leash.hpp"
#include "contact/proxy_limits.hpp"
#include "contact/proxy_sight.hpp"
#include "contact/proxy_start.hpp"

namespace fingerpad {

/// A god-object (Zilles & Salisbury 1995; for a ball Ruspini, Kolarov & Khatib 1997): a ball of the finger's
/// radius that goes where the finger goes but never crosses a surface, and holds out on the side where it
/// came from. What pushes the finger is the way from it to the proxy.
///
/// Sound: a step is the projection of the finger onto half spaces that each triangle in reach leaves free,
/// with the start in all of them, so it crosses nothing however often it is repeated and wherever it ends;
/// triangles block from both sides, whatever their winding. Steps repeat until the projection stays, which
/// is a place from where every short way nearer to the finger is blocked. Lengths compare with the parts'
/// size only.
///
/// Shaded normals: each wall that holds the proxy shades its own normal, which turns it by an angle that the
/// facets meeting there span. The normal shown for all of them together is the way from the finger to the
/// proxy turned by the mean of these turns, each weighted with its wall's share. So it stays within the
/// greatest of the walls' own angles of the way, however sharp the corner (a sum of shaded normals, in which
/// large shares nearly cancel, does not), and a wall whose share vanishes has no say any more.
///
/// Bounded steps: with `facet` the push (depth_m along normal_W) changes in a tick by at most the finger's
/// motion and twice that, or a share of the depth where this is more: see move(). With shaded normals it
/// changes by no more: a turn that jumps, as walls come and go, follows as fast as this leaves room for, and
/// until then is at most as wide as it was. A hop over a smooth edge adds 7 % of the depth, which nobody
/// feels; one that would add more is shown over as many ticks as that takes, and the next hop waits for it.
///
/// Bounded work: what a tick looks at can be limited (Looks), in triangles, so that it ends at the same place
/// on every machine. A step that is broken off is gone on with in the next tick, towards the finger's place
/// for which it was made; until then the proxy stays where it is, and pushes where a wall is known to hold
/// the finger back. A start that is broken off is gone on with alike: until then there is no proxy.
///
/// This class is the meaning: what it answers follows from its state, the finger's place and the surfaces
/// alone, and from what was broken off. It can be given a sight that remembers (fast_proxy), which answers
/// the same, faster.
class Proxy {
 public:
  /// @param normals  those that shade say that facets stand for a smooth surface, and what they hold back is
  /// not its shape: over edges that are no creases the proxy goes on to the neighbour that is nearer to the
  /// finger, as the closest point does
  Proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals);
  /// @param sight  what answers the proxy's questions about its surroundings
  explicit Proxy(std::unique_ptr<ProxySight> sight);

  /// Forgets where the proxy is: the next move starts anew.
  void reset() noexcept;

  /// Takes the proxy after the finger.
  ///
  /// The first move after a reset puts it there, or, where the ball would not fit, at the nearest place that
  /// is outside of all surfaces. In contact the steps of a tick change the way from the finger to the proxy
  /// by at most three times as much as the finger went (or, where that is more, by as much as it went and the
  /// share dt/0.5 s of the depth), so that a finger pressed in deep that slips off an edge is let go within a
  /// motion and not within a tick. Round a rounding the proxy keeps up while it has at most four times as far
  /// to go as the finger, which is as deep as three quarters of the rounding's radius and the ball's
  /// together. A hop over a smooth edge does not count towards this, since there the facets give way and not
  /// the shape; the steps after it do.
  /// @param p_WQ  finite
  /// noexcept, allocates nothing.
  const ProxyContact& move(const Vec3& p_WQ, double dt_s) noexcept;

  /// Where the ball's centre stands, its skin included [m]; the finger's place where nothing holds it.
  Vec3 ball_W() const noexcept { return state_.place_O + world().p_WO(); }
  /// What the ball keeps from every surface: radius and skin [m].
  double clearance_m() const noexcept { return world().clearance_m(); }

  /// What the last move looked at.
  const Looks& looks() const noexcept { return sight_->looks(); }

  /// All that the next move depends on besides the finger, the surfaces, and what was broken off.
  const ProxyState& state() const noexcept { return state_; }
  /// Goes on from the state of another proxy among the same surfaces.
  void resume(const ProxyState& state) noexcept;

 private:
  /// How a way over an edge ended: not gone; gone, perhaps not to the end; gone to where the proxy rests.
  enum class Way { blocked, gone, rests };

  const ProxyWorld& world() const noexcept { return sight_->world(); }
  void begin_tick(double dt_s) noexcept;
  bool start(const Vec3& goal_O) noexcept;
  void follow(ProxyLeash leash, bool goes_on) noexcept;
  void settle(const ProxyLeash& leash) noexcept;
  void break_off(const ProxyStep& step) noexcept;
  bool advance(const ProxyStep& step, const ProxyLeash& leash) noexcept;
  bool is_at_rest(const ProxyStep& step) const noexcept;
  bool has_come_to_rest(Way way) const noexcept;
  Way hop() noexcept;
  Way roll(const ProxyLeash& leash) noexcept;
  Way go_over(const ProxyWall& here, const ProxyWall& there, const ProxyLeash& leash) noexcept;

  std::unique_ptr<ProxySight> sight_;
  ProxyStart start_;
  ProxyState state_;
};

/// A proxy with a sight that remembers (ProxyMemory): what callers use.
/// @param looks  what a tick may look at
Proxy fast_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals,
                 Looks looks = Looks(ProxyLimits::most_looks));

}  // namespace fingerpad
