#pragma once

#include <string>

namespace fingerpad {

struct Scene;

/// Of two scenes with the same key load_motion() makes the same motion. Where the rate is chosen, or the
/// motion is laid on a part, it asks the scene for anything: then its whole text is in the key.
std::string motion_key(const Scene& scene);

}  // namespace fingerpad
