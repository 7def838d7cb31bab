#include "part/unit_hint.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "base/unit.hpp"

namespace fingerpad {
namespace {

constexpr double least_usual_m = 2e-3, greatest_usual_m = 20, least_likely_m = 1e-2, greatest_likely_m = 5;

/// "0.3 mm", "300 m".
std::string length_words(double length_m) {
  return length_m < 1 ? fmt::format("{} mm", rounded_text(1e3 * length_m, 3))
                      : fmt::format("{} m", rounded_text(length_m, 3));
}

}  // namespace

std::string unit_hint(const Verdict& verdict, double metres_per_unit) {
  const double length_m = (verdict.bounds_m.max - verdict.bounds_m.min).maxCoeff();
  if (!verdict.touchable || verdict.format.find("STEP") != std::string::npos) return {};
  if (!(length_m > 0) || (length_m >= least_usual_m && length_m <= greatest_usual_m)) return {};
  for (const std::string_view name : {"m", "mm", "in", "cm", "um"}) {
    const double likely_m = length_m / metres_per_unit * fingerpad::metres_per_unit(name).value();
    if (likely_m < least_likely_m || likely_m > greatest_likely_m) continue;
    return fmt::format("is {} long; --unit {} (in a scene: unit = \"{}\") reads it as {}",
                       length_words(length_m), name, name, length_words(likely_m));
  }
  return {};
}

}  // namespace fingerpad
