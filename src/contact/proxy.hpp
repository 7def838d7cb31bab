#pragma once

#include <memory>

#include "contact/proxy_leash.hpp"
#include "contact/proxy_limits.hpp"
#include "contact/proxy_sight.hpp"
#include "contact/proxy_start.hpp"

namespace fingerpad {

/// A god-object (Zilles & Salisbury 1995; for a ball Ruspini, Kolarov & Khatib 1997): a ball of the finger's
/// radius that goes where the finger goes but never crosses a surface, and holds out on the side where it
/// came from. What pushes the finger is the way from it to the ball.
///
/// A tick takes the ball from its place (ProxyState) to where it is as close to the finger as it gets:
/// - Gather: a triangle in reach that blocks the straight way to the finger is a wall, a half space that it
///   leaves free and that the ball's place is in (ProxySight; one triangle: sweep_past_triangle).
/// - Step: the finger is projected onto the walls found, and the wall that this breaches most is added, until
///   it breaches none (StepMaking). The step begins in front of all walls, and so crosses nothing, wherever
///   it ends. Steps repeat until one leads nowhere: every short way nearer to the finger is blocked.
/// - Hop: where normals are shaded, facets stand for a smooth surface. Over an edge that is no crease it goes
///   on to the neighbour nearer to the finger, as the closest point does (FacetFan).
/// - Report: how deep the finger is, and what holds it (proxy_report).
///
/// Triangles block from both sides, whatever their winding. Lengths compare with the parts' size only. By how
/// much the push may change in a tick is bounded (ProxyLeash).
///
/// What a tick looks at can be limited (Looks), in triangles, so that it ends at the same place on every
/// machine. A step that is broken off is gone on with in the next tick, towards the finger's place for which
/// it was made; until then the ball stays where it is, and pushes where a wall is known to hold the finger
/// back. A start that is broken off is gone on with alike: until then there is no proxy.
///
/// This class is the meaning: what it answers follows from its state and from what was broken off, from the
/// finger's place, the tick's length and the surfaces alone. It can be given a sight that remembers
/// (fast_proxy), which answers the same, faster.
class Proxy {
 public:
  Proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals);
  /// @param sight  what answers the proxy's questions about its surroundings
  explicit Proxy(std::unique_ptr<ProxySight> sight);

  /// Forgets where the proxy is: the next move starts anew.
  void reset() noexcept;

  /// Takes the proxy after the finger. The first move after a reset puts it there, or, where the ball would
  /// not fit, at the nearest place that is outside of all surfaces (ProxyStart).
  /// @param p_WQ  finite
  /// noexcept, allocates nothing.
  const ProxyContact& move(const Vec3& p_WQ, double dt_s) noexcept;

  /// Where the centre of the ball with its skin stands [m]; the finger's place where nothing holds it.
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
  /// How a way over an edge ended: not gone; gone, perhaps not to its end; gone to where the proxy rests.
  enum class Way { blocked, gone, rests };

  const ProxyWorld& world() const noexcept { return sight_->world(); }
  void begin_tick(double dt_s) noexcept;
  bool start(const Vec3& goal_O) noexcept;
  void follow(ProxyLeash leash, bool goes_on) noexcept;
  void settle(const ProxyLeash& leash) noexcept;
  void break_off(const ProxyStep& step) noexcept;
  bool advance(const ProxyStep& step, const ProxyLeash& leash) noexcept;
  bool is_at_rest(const ProxyStep& step) const noexcept;
  Way hop(ProxyLeash& leash) noexcept;
  Way roll(const ProxyLeash& leash) noexcept;
  Way go_over(const WallPair& walls, const ProxyLeash& leash) noexcept;

  std::unique_ptr<ProxySight> sight_;
  ProxyStart start_;
  ProxyState state_;
};

}  // namespace fingerpad
