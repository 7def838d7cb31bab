#include "app/pace_words.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"

namespace fingerpad {

std::string pace_words(double done, double total, double seconds, std::string_view many) {
  constexpr double least_s = 0.5, minute_s = 60;
  if (seconds < least_s || !(done > 0)) return "";
  const double left_s = (total - done) * seconds / done;
  const std::string left =
      left_s < 2 * minute_s ? fmt::format("{:.0f} s", left_s) : fmt::format("{:.0f} min", left_s / minute_s);
  return fmt::format(", {} {}/s, {} left", rounded_text(done / seconds, 3), many, left);
}

}  // namespace fingerpad
