#pragma once

#include "contact/proxy_sight.hpp"

namespace fingerpad {

/// A proxy's sight whose looks a tick limits: it asks the trees in pieces, in an order that is the part's
/// alone, so that it stops at the same triangle on every machine and goes on from there with the next tick.
/// For speed it looks along the step's way only, and leaves out what cannot be the worst wall (WaySieve);
/// what it finds is what the plain sight finds.
class LimitedSight : public ProxySight {
 public:
  LimitedSight(ProxyWorld world, Looks looks) : ProxySight(std::move(world)) { looks_ = looks; }

 protected:
  bool offer_part(int surface, const Vec3& z, std::span<const ProxyWall> walls,
                  LookRound& round) noexcept override;
};

}  // namespace fingerpad
