#include "app/quantity_option.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {

UnitFactor factors_of(Quantity quantity, double own_si) {
  return [quantity, own_si](std::string_view unit) -> std::optional<double> {
    const auto si = si_per_unit(quantity, unit);
    if (!si) return std::nullopt;
    return *si / own_si;
  };
}

UnitFactor factors_of_hertz() {
  return [](std::string_view unit) -> std::optional<double> {
    if (unit == "Hz") return 1;
    if (unit == "kHz") return 1e3;
    return std::nullopt;
  };
}

UnitFactor factors_of_percent() {
  return [](std::string_view unit) { return unit == "%" ? std::optional(1.0) : std::nullopt; };
}

std::optional<double> number_with_unit(std::string_view text, const UnitFactor& factor) {
  if (const auto plain = parse_number(text)) return plain;
  // The longest beginning that is a number: "1e-3s" is one of 1e-3.
  for (std::size_t length = text.size(); length-- > 1;) {
    const auto number = parse_number(text.substr(0, length));
    if (!number) continue;
    std::string_view unit = text.substr(length);
    while (unit.starts_with(' ')) unit.remove_prefix(1);
    const auto per_unit = factor(unit);
    return per_unit ? std::optional(*number * *per_unit) : std::nullopt;
  }
  return std::nullopt;
}

CLI::Option* take_units(CLI::Option* option, const UnitFactor& factor, const std::string& units) {
  const auto in_own_unit = [factor, units](std::string& text) -> std::string {
    const auto number = number_with_unit(text, factor);
    if (!number) return fmt::format("'{}' is no number, nor one of {}", printable(text, 40), units);
    text = number_text(*number);
    return {};
  };
  return option->transform(CLI::Validator(in_own_unit, ""));
}

CLI::Option* take_units_within(CLI::Option* option, const UnitFactor& factor, const std::string& units,
                               const NumberLimits& limits) {
  const auto refuse_beyond = [factor, limits](std::string& text) -> std::string {
    const auto number = number_with_unit(text, factor);  // what is none take_units() refuses
    if (!number || (*number >= limits.least && *number <= limits.most)) return {};
    return fmt::format("'{}' is out of range; {} to {} {} is asked for", printable(text, 40),
                       number_text(limits.least), number_text(limits.most), limits.unit);
  };
  take_units(option, factor, units);
  // Before it is turned into the option's own unit.
  return option->transform(
      CLI::Validator(refuse_beyond, fmt::format("FLOAT in [{:g} - {:g}]", limits.least, limits.most)));
}

}  // namespace fingerpad
