#pragma once

#include <span>

namespace fingerpad {

struct Part;
struct Press;
struct SurfacePlace;

/// What a proxy's tick looks at (LookCosts) where a finger, pressed as deep as it will be, goes so far round
/// the part: on 99 % of the region where that is the most. 0 where it goes round nothing.
///
/// With the way W that the proxy has to go (W = step (1 + radius c) / (1 + h c), see reckoned_error.hpp), the
/// reach s of its views and the triangles n in one of these, 164 (W/s)^0.7 n^0.6. Fitted to 197 rubs round
/// cylinders and spheres of 5 mm in 500 to 256,000 facets, with a point and balls of 3 and 7 mm, 0.25 to
/// 2 mm a tick, without a bound: right to a third (one standard deviation), at the worst to a factor of 2.5.
/// @param places  of the part, region by region
/// @param finer   the facets are taken to be so many times smaller
double proxy_looks(const Part& part, std::span<const SurfacePlace> places, const Press& press, double step_m,
                   int finer = 1);

/// Whether that may be more than a tick is given: then the proxy goes on in the next tick, and falls behind
/// farther and farther.
bool outruns_proxy(double looks) noexcept;

/// The share of its step that a finger may make so as not to outrun it; above 1 where it does not.
double step_share_for(double looks) noexcept;

}  // namespace fingerpad
