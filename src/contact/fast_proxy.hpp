#pragma once

#include <vector>

#include "contact/looks.hpp"
#include "contact/placed_surface.hpp"
#include "contact/proxy.hpp"

namespace fingerpad {

/// What the looks of a servo's tick may cost together, at the prices of LookCosts. The unit is a look at a
/// triangle that is at hand, some nine nanoseconds, twelve where many crowd: an eighth of a servo's
/// millisecond in all, a sixth there. A part that is touched here and there takes some hundreds; what is
/// broken off is gone on with in the next tick. With a tenth less a ball in a hollow that just fits it lags
/// so far that `auto` does not keep its word.
struct ServoLooks {
  static constexpr long most = 13500;
  /// What looks for the closest point may cost besides, as long as no start has found a place.
  static constexpr long most_unplaced = most / 4;
};

/// A proxy with a sight that remembers (ProxyMemory), which looks at no more in a tick than a servo has time
/// for: what callers use.
Proxy fast_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals);

/// The same with other looks a tick.
Proxy fast_proxy(std::vector<PlacedSurface> surfaces, double radius_m, Normals normals, Looks looks);

}  // namespace fingerpad
