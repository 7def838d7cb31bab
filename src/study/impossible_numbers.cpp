#include "study/impossible_numbers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

/// Lengths, stiffnesses, speeds and the like, that cannot be 0 or less.
constexpr PadNumber sizes[] = {PadNumber::lateral_axis,
                               PadNumber::longitudinal_axis,
                               PadNumber::stick_stiffness,
                               PadNumber::longitudinal_stiffness,
                               PadNumber::mu_static,
                               PadNumber::mu_dynamic,
                               PadNumber::v_min,
                               PadNumber::vibration,
                               PadNumber::vibration_bandwidth,
                               PadNumber::normal_stiffness,
                               PadNumber::normal_exponent};

}  // namespace

void refuse_impossible_numbers(PadValues& found) {
  for (PadValue& value : found)
    if (!std::isfinite(value.value)) value.refuse(RefusalReason::impossible, "it is no finite number");
  for (const PadNumber number : sizes) {
    PadValue& value = value_of(found, number);
    if (!(value.value > 0)) value.refuse(RefusalReason::impossible, "it must be above 0");
  }
}

void tell_impossible_numbers(PadValues& found) {
  for (std::size_t k = 0; k < found.size(); ++k) {
    PadValue& value = found[k];
    if (value.reason != RefusalReason::impossible) continue;
    value.refusal = std::isfinite(value.value)
                        ? fmt::format("the measurement gives a {} of {}; it must be above 0",
                                      pad_number_keys[k], rounded_text(value.value, 4))
                        : fmt::format("the measurement gives no finite {}", pad_number_keys[k]);
  }
}

}  // namespace fingerpad
