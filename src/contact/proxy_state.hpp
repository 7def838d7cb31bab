#pragma once

#include "contact/contact_method.hpp"
#include "contact/proxy_wall.hpp"

namespace fingerpad {

/// How a step of the proxy ends.
enum class StepEnd {
  whole,       ///< as close to its goal as its walls let it
  bent,        ///< likewise, having gone on along walls that bend away
  truncated,   ///< where no more is seen, or where it may go no farther
  at_rest,     ///< where it is known that no other step leads anywhere
  stuck,       ///< nowhere: rounding left no way
  broken_off,  ///< nowhere, for want of looks: more walls may come
};

/// A step of the proxy, and the walls that hold it where it ends, seen from where it began.
struct ProxyStep : HoldingWalls {
  Vec3 from_O = Vec3::Zero();  ///< where the proxy stood ...
  Vec3 z = Vec3::Zero();       ///< ... and where to, relative to there [m]
  Vec3 goal_O = Vec3::Zero();  ///< towards which it was made
  StepEnd end = StepEnd::whole;
};

inline ProxyStep broken_off_step() noexcept {
  ProxyStep step;
  step.end = StepEnd::broken_off;
  return step;
}

/// Where the proxy stands against the finger. Of the Contact:
/// - depth_m is from the finger to the ball without its skin, normal_W the direction of that way, shaded
///   (proxy_report);
/// - point_W is the one hold's; where there are several, or on the way, the ball's point farthest along the
/// push;
/// - a hold has the surface's point under the ball, and the normal as Normals says; on the way, as before;
/// - placed is false where a start found no place for the ball, or is broken off, started is true where it
/// put it down anew.
struct ProxyContact : Contact {
  bool settled = true;  ///< false: the proxy is still on its way to where it is closest to the finger
  Vec3 direction_W = Vec3::UnitZ();  ///< unit, from the finger to the ball

  bool touching() const noexcept { return hold_count > 0; }
};

/// All that a proxy takes from one tick to the next: where it is, what holds it there, and what it shows.
/// Frame O: see ProxyWorld.
struct ProxyState {
  bool placed = false;
  Vec3 place_O = Vec3::Zero();  ///< of the ball's centre, its skin included
  Vec3 goal_O = Vec3::Zero();   ///< where the finger is

  ProxyStep hold;  ///< the last step, with the walls that stopped it

  ProxyContact contact;
  bool lags = false;     ///< a hop is still on its way to be shown
  double arrives_s = 0;  ///< how long what is left of a first touch, which has not settled, may still take

  // Of one tick:
  double finger_m = 0;                    ///< how far the finger went
  double rest_share = 0;                  ///< of the depth, by which a resting finger's proxy goes on
  bool hopped = false;                    ///< over a smooth edge
  Vec3 last_push_W = Vec3::Zero();        ///< what the tick before it showed: depth times normal [m] ...
  Vec3 last_direction_W = Vec3::UnitZ();  ///< ... and the direction

  /// The wall of the one triangle that holds the proxy, where it rests on one alone, seen from hold.from_O;
  /// else null.
  const ProxyWall* one_triangles_wall() const noexcept {
    if (!contact.settled || hold.wall_count != 1 || hold.end == StepEnd::stuck) return nullptr;
    return hold.walls[0].triangle >= 0 ? &hold.walls[0] : nullptr;
  }
};

}  // namespace fingerpad
