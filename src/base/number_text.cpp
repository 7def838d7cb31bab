#include "base/number_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

namespace fingerpad {

void append_number(std::string& out, double value) {
  if (std::isnan(value)) {
    out += "nan";
    return;
  }
  fmt::format_to(std::back_inserter(out), "{}", value);
}

std::string number_text(double value) {
  std::string out;
  append_number(out, value);
  return out;
}

std::string rounded_text(double value, int digits) {
  if (std::isnan(value)) return "nan";
  if (value == 0) return "0";
  std::string text = fmt::format("{:.{}g}", value, digits);
  constexpr double most = 1e9;
  if (text.find('e') == std::string::npos || std::abs(value) < 1 || !(std::abs(value) < most)) return text;
  return fmt::format("{:.0f}", parse_number(text).value_or(value));
}

std::string fixed_text(double value, int digits) {
  if (std::isnan(value)) return "nan";
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::optional<double> parse_number(std::string_view text) noexcept {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

}  // namespace fingerpad
