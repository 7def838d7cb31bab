#include "scene/scene_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

namespace fingerpad {
namespace {

/// The key of the file itself that a set may vary; `name` is left out, since it names their files.
constexpr std::string_view plain_set_key = "seed";

const SceneTable* find_table(std::string_view name) noexcept {
  const auto& tables = scene_tables();
  const auto found =
      std::find_if(tables.begin(), tables.end(), [name](const SceneTable& t) { return t.name == name; });
  return found == tables.end() ? nullptr : &*found;
}

/// The key of a full dotted name; null if there is none.
const SceneKey* find_dotted_key(std::string_view name) noexcept {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return nullptr;
  const SceneTable* table = find_table(name.substr(0, dot));
  return table != nullptr ? find_scene_key(*table, name.substr(dot + 1)) : nullptr;
}

/// Whether a key is this word, or a quantity of that name with its unit.
bool is_named(const SceneKey& row, std::string_view word) noexcept {
  if (row.key == word) return true;
  const bool has_unit = row.type == KeyType::number || row.type == KeyType::vector;
  return has_unit && row.key.size() > word.size() && row.key.starts_with(word) && row.key[word.size()] == '_';
}

/// "; did you mean 'mu_static' in [[part]] or 'mu_static' in [[plane]]?" of a key that stands in the wrong
/// table; empty where none has it.
std::string hint_elsewhere(std::string_view word) {
  std::vector<std::string> places;
  for (const SceneTable& table : scene_tables()) {
    for (const SceneKey& row : table.keys)
      if (is_named(row, word)) places.push_back(fmt::format("'{}' in {}", row.key, table.heading));
  }
  constexpr std::size_t most = 3;  // a word that many tables have says nothing
  if (places.empty() || places.size() > most) return {};
  return fmt::format("; did you mean {}?", fmt::join(places, " or "));
}

}  // namespace

const SceneTable& scene_table(std::string_view name) noexcept {
  const SceneTable* table = find_table(name);
  if (table == nullptr) std::abort();  // a table that the reader asks for and that has no rows
  return *table;
}

const SceneKey* find_scene_key(const SceneTable& table, std::string_view key) noexcept {
  const auto found = std::find_if(table.keys.begin(), table.keys.end(),
                                  [key](const SceneKey& row) { return row.key == key; });
  return found == table.keys.end() ? nullptr : &*found;
}

const SceneKey& scene_key(const SceneTable& table, std::string_view key) noexcept {
  const SceneKey* row = find_scene_key(table, key);
  if (row == nullptr) std::abort();  // a key that the reader asks for and that has no row
  return *row;
}

std::vector<std::string> known_keys(const SceneTable& table) {
  std::vector<std::string> keys;
  for (const SceneKey& row : table.keys) keys.emplace_back(row.key);
  if (!table.name.empty()) return keys;
  for (const SceneTable& other : scene_tables()) {
    const bool at_the_top = other.name.find('.') == std::string_view::npos;
    if (at_the_top && !other.name.empty()) keys.emplace_back(other.name);
  }
  keys.emplace_back("set");
  return keys;
}

bool goes_with(const SceneKey& row, std::string_view word) noexcept {
  return row.only_with.empty() ||
         std::find(row.only_with.begin(), row.only_with.end(), word) != row.only_with.end();
}

TomlTable open_table(const TomlNode& node, const std::string& file, const SceneTable& table) {
  const std::vector<std::string> known = known_keys(table);
  for (const TomlEntry& entry : node.entries) {
    if (std::ranges::find(known, entry.key) != known.end()) continue;
    const std::string hint = near_miss_hint(entry.key, known).empty() ? hint_elsewhere(entry.key) : "";
    if (hint.empty()) break;
    throw refused(place_text(file, entry.place),
                  fmt::format("unknown key '{}' in {}{} (known: {})", entry.key, table.heading, hint,
                              word_list(known)));
  }
  return TomlTable(node, file, std::string(table.heading), known);
}

void read_keys(const SceneTable& table, const TomlTable& from, Scene& scene, std::string_view word) {
  for (const SceneKey& row : table.keys) {
    if (row.required && goes_with(row, word)) from.require(row.key);
  }
  for (const SceneKey& row : table.keys) {
    if (row.read != nullptr && from.has(row.key)) row.read(row, from, scene);
  }
}

std::optional<std::string> set_key_target(std::string_view key) {
  if (key == plain_set_key) return std::string(key);
  if (key == "mesh") return "part.mesh";
  if (key == "motion") return "motion.file";
  if (find_dotted_key(key) == nullptr) return std::nullopt;
  return std::string(key);
}

std::vector<std::string> set_keys() {
  std::vector<std::string> keys = {"mesh", "motion", std::string(plain_set_key)};
  for (const SceneTable& table : scene_tables()) {
    if (table.name.empty()) continue;
    for (const SceneKey& row : table.keys)
      keys.push_back(std::string(table.name).append(".").append(row.key));
  }
  return keys;
}

bool is_vector_key(std::string_view dotted_key) {
  const SceneKey* row = find_dotted_key(dotted_key);
  return row != nullptr && row->type == KeyType::vector;
}

const SceneKey* find_whole_key(std::string_view dotted_key) {
  const SceneKey* row =
      dotted_key == plain_set_key ? find_scene_key(scene_table(""), dotted_key) : find_dotted_key(dotted_key);
  return row != nullptr && row->type == KeyType::whole ? row : nullptr;
}

const SceneKey* find_choice_key(std::string_view dotted_key) {
  const SceneKey* row = find_dotted_key(dotted_key);
  return row != nullptr && row->type == KeyType::choice && !row->words.empty() ? row : nullptr;
}

}  // namespace fingerpad
