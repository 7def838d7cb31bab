#include "view/surface_words.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "part/part.hpp"
#include "touch/world.hpp"

namespace fingerpad {

std::string surface_name(const World& world, int index, std::size_t longest) {
  if (index < 0 || static_cast<std::size_t>(index) >= world.surfaces.size()) return "-";
  std::string name = shown_name(world.surfaces[static_cast<std::size_t>(index)]);
  if (name.size() > longest) name = name.substr(0, longest - 3) + "...";
  return name.empty() ? fmt::format("part {}", index) : name;
}

std::vector<std::string> about_lines(const ViewInput& input) {
  std::vector<std::string> lines;
  if (!input.world) return lines;
  for (std::size_t i = 0; i < input.world->surfaces.size() && i < 6; ++i) {
    const Surface& surface = input.world->surfaces[i];
    if (!surface.part) continue;
    const Vec3 size_mm = 2e3 * surface.part->half_extent;
    lines.push_back(fmt::format("{}: {} triangles", surface_name(*input.world, static_cast<int>(i), 40),
                                surface.part->triangle_count()));
    lines.push_back(fmt::format("{} x {} x {} mm", rounded_text(size_mm.x(), 4), rounded_text(size_mm.y(), 4),
                                rounded_text(size_mm.z(), 4)));
    if (i >= input.world->verdicts.size()) continue;
    const Verdict& verdict = input.world->verdicts[i];
    lines.emplace_back(verdict.closed ? "closed" : "open");
    const std::size_t warnings = verdict.warnings.size();
    if (warnings > 0)
      lines.push_back(fmt::format("{} warning{} (see check)", warnings, warnings > 1 ? "s" : ""));
  }
  return lines;
}

}  // namespace fingerpad
