#include "base/nearest_word.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace fingerpad {
namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Twice Levenshtein's distance, to which a letter of the other case counts half.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t k = 0; k < row.size(); ++k) row[k] = 2 * k;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], 2 * i);
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const char x = a[i - 1], y = b[k - 1];
      const std::size_t changed = diagonal + (x == y ? 0 : lower(x) == lower(y) ? 1 : 2);
      diagonal = std::exchange(row[k], std::min({row[k] + 2, row[k - 1] + 2, changed}));
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  if (word.size() > 100) return {};
  std::string nearest;
  std::size_t least = 2 * (std::max<std::size_t>(word.size() / 3, 1) + 1);
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string word_list(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace fingerpad
