#include "part/text_cursor.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

namespace fingerpad {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::string_view TextCursor::word() {
  for (;;) {
    const std::string_view found = word_in_line();
    if (!found.empty() || at_end()) return found;
    ++at_;  // the line's end
    ++line_;
  }
}

std::string_view TextCursor::word_in_line() {
  while (!at_end() && is_blank(text_[at_])) ++at_;
  const std::size_t from = at_;
  while (!at_end() && !is_blank(text_[at_]) && text_[at_] != '\n') ++at_;
  return text_.substr(from, at_ - from);
}

std::string_view TextCursor::rest_of_line() {
  const std::size_t from = at_;
  at_ = std::min(text_.find('\n', at_), text_.size());
  const std::string_view rest = text_.substr(from, at_ - from);
  if (!at_end()) {
    ++at_;
    ++line_;
  }
  return rest;
}

std::optional<double> coordinate_of(std::string_view word) {
  if (word.find(".#") != std::string_view::npos) return std::numeric_limits<double>::quiet_NaN();
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size()) return std::nullopt;
  if (problem == std::errc()) return value;
  if (problem != std::errc::result_out_of_range) return std::nullopt;
  const auto exponent = word.find_first_of("eE");
  const bool tiny = exponent != std::string_view::npos && word.substr(exponent + 1, 1) == "-";
  return tiny ? 0 : std::numeric_limits<double>::infinity();
}

std::optional<long long> integer_of(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  long long value = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || problem != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::string shown(std::string_view word) {
  constexpr std::size_t enough = 40;
  std::string text(word.substr(0, enough));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return word.size() > enough ? text + "..." : text;
}

std::string not_a_number(std::string_view word) {
  if (word.empty()) return "a number is missing";
  std::string pointed(word);
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  const bool comma = pointed != word && coordinate_of(pointed).has_value();
  return "'" + shown(word) + "' is not a number" +
         (comma ? " (a decimal comma: export again with decimal points)" : "");
}

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace fingerpad
