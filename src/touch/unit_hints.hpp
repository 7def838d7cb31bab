#pragma once

#include <string>
#include <vector>

namespace fingerpad {

struct Scene;
struct World;

/// A line for each part that was read in an unlikely unit: "FILE: is 0.1 mm long; ..." (unit_hint).
std::vector<std::string> unit_hints(const World& world, const Scene& scene);

}  // namespace fingerpad
