#include "app/number_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

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

template <typename Number>
CLI::Validator in_range(Number least, Number most, const char* what, const char* type_name) {
  const std::string low = bound_text(least), high = bound_text(most);
  const auto fault = [=](const std::string& text) {
    Number value{};
    const bool is_number = CLI::detail::lexical_cast(text, value) && !std::isnan(static_cast<double>(value));
    if (is_number && value >= least && value <= most) return std::string();
    return fmt::format("'{}' is {}; a {} from {} to {} is asked for", printable(text, longest_shown),
                       is_number ? "out of range" : fmt::format("no {}", what), what, low, high);
  };
  return CLI::Validator(fault, fmt::format("{} in [{} - {}]", type_name, low, high));
}

/// What is asked for, by how CLI11 calls the option's type.
std::string_view number_words(std::string_view type_name) {
  if (type_name.starts_with("UINT")) return "whole number from 0";
  return type_name.starts_with("INT") ? "whole number" : "number";
}

}  // namespace

CLI::Validator whole_number_in(long least, long most) {
  return in_range(least, most, "whole number", "INT");
}

CLI::Validator number_in(double least, double most) {
  return in_range(least, most, "number", "FLOAT");
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
  return fmt::format("{}: '{}' is no {}", name, printable(told.substr(at + between.size()), longest_shown),
                     number_words(option != nullptr ? option->get_type_name() : ""));
}

}  // namespace fingerpad
