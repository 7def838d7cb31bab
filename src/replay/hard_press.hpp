#pragma once

#include <optional>
#include <vector>

namespace fingerpad {

struct Scene;

/// A normal force that is far greater than a rub laid on a part asks for: in a corner the walls add up to two
/// or three times that, and more is another place.
struct HardPress {
  double felt_n = 0, asked_n = 0;
};

/// Nothing where a scene asks for no force, or felt it.
/// @param figures  Figures::values() of its run
std::optional<HardPress> hard_press(const Scene& scene, const std::vector<double>& figures);

}  // namespace fingerpad
