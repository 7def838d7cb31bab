#include "scene/unread_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace fingerpad {
namespace {

/// What a choice says, given or by default; nothing where it says no word that is known.
std::optional<std::string> chosen_word(const SceneKey& deciding, const TomlNode& table) {
  const TomlEntry* entry = find_entry(table, deciding.key);
  if (entry == nullptr) return deciding.default_word;
  const auto& words = deciding.words;
  const bool known = entry->value.is(TomlNode::Type::text) &&
                     std::find(words.begin(), words.end(), entry->value.text) != words.end();
  return known ? std::optional(entry->value.text) : std::nullopt;
}

/// The words that stand in other tables of the scene and decide here too.
std::vector<std::string> words_elsewhere(const SceneTable& table, const TomlNode& scene) {
  std::vector<std::string> words;
  for (const std::string_view dotted : table.also_by) {
    const std::size_t dot = dotted.rfind('.');
    const TomlEntry* other = find_entry(scene, dotted.substr(0, dot));
    if (other == nullptr) continue;
    const TomlEntry* entry = find_entry(other->value, dotted.substr(dot + 1));
    if (entry != nullptr && entry->value.is(TomlNode::Type::text)) words.push_back(entry->value.text);
  }
  return words;
}

}  // namespace

void UnreadKeys::look_at(const SceneTable& table, const TomlNode& node, std::vector<std::string> words) {
  std::string chosen;
  for (const std::string_view name : table.decided_by) {
    const SceneKey& deciding = scene_key(table, name);
    const auto word = chosen_word(deciding, node);
    // Refused where it is read; and a choice without a default refuses there what does not go with it.
    if (!word || word->empty()) return;
    words.push_back(*word);
    chosen += fmt::format("{}{} \"{}\"", chosen.empty() ? "" : " with ", name, *word);
  }
  for (const TomlEntry& entry : node.entries) {
    const SceneKey* row = find_scene_key(table, entry.key);
    if (row == nullptr || row->only_with.empty()) continue;
    auto use = std::find_if(uses_.begin(), uses_.end(), [row](const Use& u) { return u.row == row; });
    if (use == uses_.end()) use = uses_.insert(use, {row, entry.place});
    const bool read =
        std::any_of(words.begin(), words.end(), [row](const auto& word) { return goes_with(*row, word); });
    use->read = use->read || read;
    if (std::find(use->chosen.begin(), use->chosen.end(), chosen) == use->chosen.end())
      use->chosen.push_back(chosen);
  }
}

void UnreadKeys::look(const TomlNode& scene) {
  for (const SceneTable& table : scene_tables()) {
    if (table.decided_by.empty()) continue;
    const TomlEntry* entry = find_entry(scene, table.name);
    if (entry != nullptr) look_at(table, entry->value, words_elsewhere(table, scene));
  }
}

void UnreadKeys::refuse(const std::string& path) const {
  for (const Use& use : uses_) {
    if (use.read) continue;
    throw refused(place_text(path, use.place),
                  fmt::format("'{}' is not read by {}; it is read by: {}", use.row->key,
                              fmt::join(use.chosen, " or "), fmt::join(use.row->only_with, ", ")));
  }
}

}  // namespace fingerpad
