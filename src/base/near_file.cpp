#include "base/near_file.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/nearest_word.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

enum class Entry { file, folder };

/// A name with its ending apart; a folder's has none.
struct Name {
  std::string stem, ending;
};

Name name_of(const fs::path& path, Entry kind) {
  const fs::path name = path.filename();
  if (kind == Entry::folder) return {name.string(), ""};
  return {name.stem().string(), name.extension().string()};
}

std::string digits_of(std::string word) {
  std::erase_if(word, [](char c) { return c < '0' || c > '9'; });
  return word;
}

std::string in_lower_case(std::string word) {
  for (char& c : word)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return word;
}

/// The one of some words that is the asked one, or is so but for its case, or else is near it; "" if none is.
std::string same_or_near(const std::string& asked, const std::vector<std::string>& words) {
  constexpr std::size_t fewest_letters = 3;  // of fewer one letter is half of the word
  if (std::ranges::find(words, asked) != words.end()) return asked;
  std::vector<std::string> lowered(words.size());
  std::ranges::transform(words, lowered.begin(), in_lower_case);
  auto found = std::ranges::find(lowered, in_lower_case(asked));
  if (found == lowered.end() && asked.size() >= fewest_letters)
    found = std::ranges::find(lowered, nearest_word(in_lower_case(asked), lowered));
  return found == lowered.end() ? "" : words[static_cast<std::size_t>(found - lowered.begin())];
}

/// Whether an ending that was asked for is there misspelled, rather than another one.
bool may_be_ending(const std::string& asked, const std::string& there) {
  return asked == there || (!asked.empty() && !there.empty() && !same_or_near(asked, {there}).empty());
}

/// The names of a folder's entries of that kind which may be meant by another; none of a folder that has too
/// many.
std::vector<Name> likely_names(const fs::path& folder, const Name& asked, Entry kind) {
  constexpr int most_entries = 1000;
  std::vector<Name> names;
  std::error_code ignored;
  fs::directory_iterator at(folder.empty() ? "." : folder, ignored);
  for (int count = 0; at != fs::directory_iterator(); at.increment(ignored)) {
    if (++count > most_entries) return {};
    const bool is_file = kind == Entry::file;
    if (!(is_file ? at->is_regular_file(ignored) : at->is_directory(ignored))) continue;
    Name name = name_of(at->path(), kind);
    if (digits_of(name.stem) == digits_of(asked.stem) && may_be_ending(asked.ending, name.ending))
      names.push_back(std::move(name));
  }
  // Of two that are equally near, the same one everywhere.
  std::ranges::sort(names, {}, [](const Name& name) { return std::pair(name.stem, name.ending); });
  return names;
}

/// The entry of a folder that is there which `path` may mean.
fs::path near_entry(const fs::path& path, Entry kind) {
  if (!path.has_filename()) return {};
  const Name asked = name_of(path, kind);
  const std::vector<Name> names = likely_names(path.parent_path(), asked, kind);
  std::vector<std::string> stems, endings;
  for (const Name& name : names) stems.push_back(name.stem);
  const std::string stem = same_or_near(asked.stem, stems);
  if (stem.empty()) return {};
  for (const Name& name : names)
    if (name.stem == stem) endings.push_back(name.ending);
  return path.parent_path() / (stem + same_or_near(asked.ending, endings));
}

}  // namespace

std::filesystem::path near_file(const std::filesystem::path& path) {
  return near_entry(path, Entry::file);
}

std::filesystem::path near_folder(const std::filesystem::path& path) {
  if (!path.has_filename()) return path.has_relative_path() ? near_folder(path.parent_path()) : fs::path();
  std::error_code ignored;
  fs::path above = path.parent_path();
  if (!above.empty() && !fs::is_directory(above, ignored)) {
    above = near_folder(above);
    if (above.empty()) return {};
  }
  const fs::path moved = above / path.filename();
  return fs::is_directory(moved, ignored) ? moved : near_entry(moved, Entry::folder);
}

}  // namespace fingerpad
