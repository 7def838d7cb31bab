#pragma once

#include <limits>
#include <span>
#include <string>

namespace fingerpad {

class TriangleTree;
struct ContactDemand;
struct SurfacePlace;

/// A hollow that a ball fits so well that it is near very many triangles at once.
struct CrowdedHollow {
  int facets =
      0;  ///< that the ball is near to as it rests there; no more are counted than a tick can do with
  double radius_m = std::numeric_limits<double>::infinity();  ///< of the hollow

  /// Whether a proxy cannot keep them at hand: its tick, which has a bound, then ends before the proxy is at
  /// rest, tick after tick, and it falls behind by as much as the whole force.
  bool is_too_much() const noexcept;
};

/// The hollow of a part in which a ball is near the most triangles, of some that are looked at: near is what
/// stands off by less than a sixty-fourth of the ball's radius. That is half of what a proxy looks around by;
/// with all of it, hollows would count in which it keeps up (a sphere of 8 mm in 32,768 facets round a ball
/// of 7 mm).
/// @param places  of the part that `tree` was built on
CrowdedHollow most_crowded_hollow(const TriangleTree& tree, std::span<const SurfacePlace> places,
                                  double radius_m);

/// Why a proxy cannot keep a scene's forces on a part; empty where it can.
std::string proxy_fails(const ContactDemand& demand);

}  // namespace fingerpad
