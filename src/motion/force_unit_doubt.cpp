#include "motion/force_unit_doubt.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/number_text.hpp"

namespace fingerpad {

std::string ForceUnitDoubt::words(std::string_view force,
                                  const std::function<std::string(std::string_view)>& said) const {
  const std::string what = fmt::format("its {} is {} N where it presses, {} than a finger rubs", force,
                                       rounded_text(press_n, 3), is_hard ? "harder" : "lighter");
  if (!asks_for_unit) return what + ": is its unit the right one?";
  return fmt::format("taken as newtons, {}: say {}, or {} if it is newtons", what,
                     is_hard ? said("mN") + " (or gf)" : said("kN"), said("N"));
}

std::optional<ForceUnitDoubt> force_unit_doubt(double press_n, bool says_unit) {
  constexpr double hardest_n = 40, lightest_n = 0.01;
  const double size_n = std::abs(press_n);
  if (!(size_n > hardest_n) && !(size_n > 0 && size_n < lightest_n)) return std::nullopt;
  return ForceUnitDoubt{size_n, size_n > hardest_n, !says_unit};
}

}  // namespace fingerpad
