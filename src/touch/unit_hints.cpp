#include "touch/unit_hints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "part/unit_hint.hpp"
#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad {

std::vector<std::string> unit_hints(const World& world, const Scene& scene) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(world.verdicts.size(), scene.parts.size()); ++i) {
    const std::string hint = unit_hint(world.verdicts[i], scene.parts[i].metres_per_unit);
    if (!hint.empty()) lines.push_back(fmt::format("{}: {}", world.verdicts[i].file, hint));
  }
  return lines;
}

}  // namespace fingerpad
