#include "touch/unit_hints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "part/unit_hint.hpp"
#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad {

void add_unit_hint(const Verdict& verdict, const PartEntry& part, std::vector<std::string>& lines) {
  const std::string hint = unit_hint(verdict, part.metres_per_unit);
  if (!hint.empty()) lines.push_back(fmt::format("{}: {}", verdict.file, hint));
}

std::vector<std::string> unit_hints(const World& world, const Scene& scene) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(world.verdicts.size(), scene.parts.size()); ++i)
    add_unit_hint(world.verdicts[i], scene.parts[i], lines);
  return lines;
}

}  // namespace fingerpad
