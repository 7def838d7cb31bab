#include "base/nearest_word.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Twice the edit distance (Levenshtein's, with swapped neighbours as one edit), to which a letter of the
/// other case counts half.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t k = 0; k < row.size(); ++k) row[k] = 2 * k;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = std::exchange(last, row);
    row[0] = 2 * i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const char x = a[i - 1], y = b[k - 1];
      const std::size_t changed = last[k - 1] + (x == y ? 0 : lower(x) == lower(y) ? 1 : 2);
      row[k] = std::min({last[k] + 2, row[k - 1] + 2, changed});
      if (i > 1 && k > 1 && x == b[k - 2] && a[i - 2] == y) row[k] = std::min(row[k], before_last[k - 2] + 2);
    }
  }
  return row.back();
}

bool has_between_hyphens(std::string_view whole, std::string_view part) {
  return part.size() > 1 && fmt::format("-{}-", whole).find(fmt::format("-{}-", part)) != std::string::npos;
}

/// Whether a word goes on with an underscore, as a quantity's name does with its unit: "fx_n" of "fx".
bool is_with_unit(std::string_view whole, std::string_view word) {
  return !word.empty() && whole.size() > word.size() && whole.starts_with(word) && whole[word.size()] == '_';
}

/// All of the words that are it with a unit.
std::vector<std::string> with_unit(std::string_view word, const std::vector<std::string>& known) {
  std::vector<std::string> found;
  for (const std::string& whole : known)
    if (is_with_unit(whole, word)) found.push_back(whole);
  return found;
}

/// The only word that is it without its unit: "x" of "x_m".
std::string only_one_without_unit(std::string_view word, const std::vector<std::string>& known) {
  const auto begins_it = [&](const std::string& start) { return is_with_unit(word, start); };
  const auto found = std::ranges::find_if(known, begins_it);
  return std::ranges::count_if(known, begins_it) == 1 ? *found : "";
}

/// The only word that is near it up to its unit: "stiffness_n_per_m" of "stifness".
std::string only_one_near_without_unit(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t least_letters = 5;
  if (word.size() < least_letters) return {};
  std::vector<std::string> found;
  for (const std::string& whole : known) {
    for (std::size_t end = whole.find('_'); end != std::string::npos; end = whole.find('_', end + 1)) {
      if (edit_distance(word, std::string_view(whole).substr(0, end)) > 2 * (word.size() / 4)) continue;
      found.push_back(whole);
      break;
    }
  }
  return found.size() == 1 ? found.front() : "";
}

std::string only_one_with_part(std::string_view part, const std::vector<std::string>& known) {
  const auto has_part = [&](const std::string& whole) { return has_between_hyphens(whole, part); };
  const auto found = std::ranges::find_if(known, has_part);
  return std::ranges::count_if(known, has_part) == 1 ? *found : "";
}

/// The shortest that begins with `start`, where all that do begin with it: "friction" of "frict", beside
/// "friction.law".
std::string only_one_with_start(std::string_view start, const std::vector<std::string>& known) {
  constexpr std::size_t least_letters = 3;
  if (start.size() < least_letters) return {};
  std::string shortest;
  for (const std::string& word : known)
    if (word.starts_with(start) && (shortest.empty() || word.size() < shortest.size())) shortest = word;
  const bool is_only_one = std::ranges::all_of(
      known, [&](const std::string& word) { return !word.starts_with(start) || word.starts_with(shortest); });
  return is_only_one ? shortest : "";
}

}  // namespace

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  if (word.size() > 100) return {};
  if (const auto whole = with_unit(word, known); whole.size() == 1) return whole.front();
  std::string nearest;
  std::size_t least = 2 * (std::max<std::size_t>(word.size() / 3, 1) + 1);
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  if (nearest.empty()) nearest = only_one_with_part(word, known);
  if (nearest.empty()) nearest = only_one_with_start(word, known);
  if (nearest.empty()) nearest = only_one_near_without_unit(word, known);
  return nearest.empty() ? only_one_without_unit(word, known) : nearest;
}

std::string near_miss_hint(std::string_view word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_word(word, known);
  const std::vector<std::string> units = with_unit(word, known);
  if (nearest.empty() && units.size() == 2)
    return fmt::format("; did you mean '{}' or '{}'?", units[0], units[1]);
  return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

std::string unknown_word_text(std::string_view what, std::string_view word, std::string_view where,
                              const std::vector<std::string>& known) {
  constexpr std::size_t longest = 60;
  return fmt::format("unknown {} '{}'{}{}{} (known: {})", what, printable(word, longest),
                     where.empty() ? "" : " ", where, near_miss_hint(word, known), word_list(known));
}

std::string word_list(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace fingerpad
