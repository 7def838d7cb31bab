#include "app/number_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/number_text.hpp"
#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t longest_shown = 40;

std::string bound_text(long bound) {
  return fmt::format("{}", bound);
}
std::string bound_text(double bound) {
  return fmt::format("{:g}", bound);
}

/// Whether it is a number with a word behind it, "2 s".
bool has_unit(std::string_view text) {
  if (parse_number(text)) return false;
  for (std::size_t length = text.size(); length-- > 1;) {
    if (!parse_number(text.substr(0, length))) continue;
    return std::isalpha(static_cast<unsigned char>(text[length])) != 0;
  }
  return false;
}

constexpr const char* without_unit = ", without a unit";

/// @param unit  "seconds"; empty: of a pure number
template <typename Number>
CLI::Validator in_range(Number least, Number most, const std::string& what, const std::string& unit,
                        const char* type_name) {
  const std::string low = bound_text(least), high = bound_text(most),
                    asked = unit.empty() ? what : what + " of " + unit;
  const auto fault = [=](const std::string& text) {
    Number value{};
    const bool is_number = CLI::detail::lexical_cast(text, value) && !std::isnan(static_cast<double>(value));
    if (is_number && value >= least && value <= most) return std::string();
    return fmt::format("'{}' is {}; a {} from {} to {} is asked for{}", printable(text, longest_shown),
                       is_number ? "out of range" : fmt::format("no {}", what), asked, low, high,
                       !is_number && !unit.empty() && has_unit(text) ? without_unit : "");
  };
  return CLI::Validator(fault, fmt::format("{} in [{} - {}]", type_name, low, high));
}

/// What is asked for, by how CLI11 calls the option's type.
std::string_view number_words(std::string_view type_name) {
  if (type_name.starts_with("UINT")) return "whole number from 0";
  return type_name.starts_with("INT") ? "whole number" : "number";
}

/// "seconds" of an option that says "[s]"; empty where it says no unit that is known.
std::string_view unit_in(std::string_view description) {
  constexpr std::pair<std::string_view, std::string_view> units[] = {
      {"[s]", "seconds"}, {"[ms]", "milliseconds"}, {"[Hz]", "hertz"}, {"[m]", "metres"}, {"[N]", "newtons"}};
  for (const auto& [mark, words] : units) {
    if (description.find(mark) != std::string_view::npos) return words;
  }
  return "";
}

}  // namespace

CLI::Validator whole_number_in(long least, long most) {
  return in_range(least, most, "whole number", "", "INT");
}

CLI::Validator number_in(double least, double most, const std::string& unit) {
  return in_range(least, most, "number", unit, "FLOAT");
}

CLI::Validator memory_size() {
  const CLI::AsSizeValue size(false);
  const auto to_bytes = [size](std::string& text) -> std::string {
    const std::string given = text;
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    constexpr std::size_t most_digits = 9;  // of terabytes even these are a number
    const bool is_number = digits > 0 && text.find_first_not_of('0') < digits &&
                           (digits <= most_digits || (digits == text.size() && digits <= 2 * most_digits));
    try {
      if (is_number && size(text).empty()) return {};
    } catch (const CLI::ValidationError&) {  // told below, with what is allowed
    }
    return fmt::format(
        "'{}' is no size of memory; 500M or 4G is one: a whole number with K, M, G or T behind it",
        printable(given, longest_shown));
  };
  return CLI::Validator(to_bytes, size.get_description());
}

std::string no_number_words(const CLI::ConversionError& error, const CLI::App& command) {
  constexpr std::string_view begin = "Could not convert: ", between = " = ";
  const std::string told = error.what();
  const std::size_t at = told.find(between);
  if (!told.starts_with(begin) || at == std::string::npos) return told;
  const std::string name = told.substr(begin.size(), at - begin.size());
  const CLI::Option* const option = command.get_option_no_throw(name);
  const std::string given = told.substr(at + between.size());
  const std::string_view unit = unit_in(option != nullptr ? option->get_description() : "");
  const std::string mend = !has_unit(given) ? ""
                           : unit.empty()   ? "; it is written without a unit"
                                            : fmt::format("; it is in {}{}", unit, without_unit);
  return fmt::format("{}: '{}' is no {}{}", name, printable(given, longest_shown),
                     number_words(option != nullptr ? option->get_type_name() : ""), mend);
}

}  // namespace fingerpad
