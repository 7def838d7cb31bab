#include "touch/unit_hints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "part/unit_hint.hpp"
#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad {

void add_unit_hint(const Verdict& verdict, const PartEntry& part, std::vector<std::string>& lines) {
  const std::string hint = unit_hint(verdict, part.metres_per_unit);
  if (!hint.empty()) lines.push_back(fmt::format("{}: {}", verdict.file, hint));
}

namespace {

double longest_part_m(const World& world) {
  double longest_m = 0;
  for (const Verdict& verdict : world.verdicts) {
    if (verdict.touchable)
      longest_m = std::max(longest_m, (verdict.bounds_m.max - verdict.bounds_m.min).maxCoeff());
  }
  return longest_m;
}

std::string radius_place(const Scene& scene) {
  return scene.finger.radius_place.empty() ? "finger.radius_m" : scene.finger.radius_place;
}

/// @param longest_m  0 where no part is touched
std::string radius_words(double radius_m, double longest_m) {
  constexpr double metres_per_mm = 1e-3;
  const std::string beside =
      longest_m > 0 ? fmt::format(", where the longest part is {} m long", rounded_text(longest_m, 3)) : "";
  return fmt::format("a finger of radius_m = {}{}; it is in metres: if millimetres are meant, radius_m = {}",
                     rounded_text(radius_m, 3), beside, rounded_text(metres_per_mm * radius_m, 3));
}

}  // namespace

/// Rule: no fingertip is as large as a decimetre and larger than all that it touches.
std::string finger_hint(const World& world, const Scene& scene) {
  constexpr double too_large_m = 0.1;
  const double radius_m = scene.finger.radius_m, longest_m = longest_part_m(world);
  if (!(radius_m > too_large_m && radius_m > longest_m)) return {};
  return fmt::format("{}: {}", radius_place(scene), radius_words(radius_m, longest_m));
}

void refuse_huge_finger(const World& world, const Scene& scene) {
  constexpr double huge_m = 0.5;
  const double radius_m = scene.finger.radius_m, longest_m = longest_part_m(world);
  if (!(longest_m > 0) || !(radius_m > std::max(huge_m, longest_m)) || !scene.planes.empty()) return;
  throw refused(radius_place(scene), radius_words(radius_m, longest_m));
}

std::vector<std::string> unit_hints(const World& world, const Scene& scene) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(world.verdicts.size(), scene.parts.size()); ++i)
    add_unit_hint(world.verdicts[i], scene.parts[i], lines);
  std::string finger = finger_hint(world, scene);
  if (!finger.empty()) lines.push_back(std::move(finger));
  return lines;
}

}  // namespace fingerpad
