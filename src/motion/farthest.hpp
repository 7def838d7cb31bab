#pragma once

namespace fingerpad {

/// No position of a motion or a scene, and no length, is beyond this [m]: a million kilometres, where a
/// double still tells a tenth of a micrometre.
inline constexpr double farthest_m = 1e9;

}  // namespace fingerpad
