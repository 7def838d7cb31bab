#include "scene/scene_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>

#include "base/count_words.hpp"
#include "base/error.hpp"
#include "scene/scene_key.hpp"
#include "scene/set_range.hpp"
#include "scene/toml_table.hpp"

namespace fingerpad {
namespace {

void collect_leaves(const TomlNode& table, const std::string& prefix, std::vector<SetLeaf>& leaves) {
  for (const TomlEntry& entry : table.entries) {
    const std::string key = prefix + entry.key;
    if (entry.value.is(TomlNode::Type::table) && !is_set_range(entry.value)) {
      collect_leaves(entry.value, key + ".", leaves);
    } else {
      leaves.push_back({key, entry.place, &entry.value});
    }
  }
}

/// Lists that go side by side are equally long; a list of one among them may be meant for all, and is not.
void refuse_other_lengths(const std::vector<SetAxis>& axes, const std::string& place) {
  const SetAxis* first = nullptr;
  for (const SetAxis& axis : axes) {
    if (!axis.is_list) continue;
    if (first == nullptr) first = &axis;
    const std::size_t count = axis.values.size(), first_count = first->values.size();
    if (count == first_count) continue;
    const std::string mend = count == 1 || first_count == 1
                                 ? "; a value that is to go with all of them is written without a list"
                                 : "";
    throw refused(place, fmt::format("with zip the lists go side by side, but '{}' has {} and '{}' {}{}",
                                     first->key, count_words(first_count, "value"), axis.key, count, mend));
  }
}

SetEntry read_entry(const TomlNode& table, const std::string& path) {
  std::vector<SetLeaf> leaves;
  collect_leaves(table, "", leaves);
  std::stable_sort(leaves.begin(), leaves.end(), [](const SetLeaf& a, const SetLeaf& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  SetEntry entry;
  std::vector<SetAxis>& axes = entry.axes;
  for (const SetLeaf& leaf : leaves) {
    if (leaf.key == "zip") {
      if (!leaf.value->is(TomlNode::Type::boolean))
        throw refused(place_text(path, leaf.place), "'zip' in [[set]] is true or false");
      entry.zip = leaf.value->boolean;
      continue;
    }
    axes.push_back(read_axis(leaf, path));
    for (std::size_t i = 0; i + 1 < axes.size(); ++i) {
      if (axes[i].target != axes.back().target) continue;
      throw refused(place_text(path, leaf.place),
                    fmt::format("'{}' and '{}' in [[set]] are the same key", axes[i].key, leaf.key));
    }
  }
  if (entry.zip) refuse_other_lengths(axes, place_text(path, table.place));
  return entry;
}

TomlNode& put_entry(TomlNode& table, const std::string& key, const TomlNode& value) {
  if (TomlEntry* entry = find_entry(table, key)) {
    entry->value = value;
    return entry->value;
  }
  table.entries.push_back({key, value.place, value});
  return table.entries.back().value;
}

/// The table of that name, or the first of an array of tables; made where it is missing.
TomlNode& table_at(TomlNode& parent, const std::string& key, bool array) {
  TomlEntry* entry = find_entry(parent, key);
  TomlNode* node = entry != nullptr ? &entry->value : nullptr;
  if (array) {
    TomlNode list;
    list.type = TomlNode::Type::array;
    if (node == nullptr || !node->is(TomlNode::Type::array)) node = &put_entry(parent, key, list);
    if (node->items.empty()) node->items.emplace_back();
    return node->items.front();
  }
  if (node == nullptr || !node->is(TomlNode::Type::table)) node = &put_entry(parent, key, TomlNode{});
  return *node;
}

/// Whether a key of [motion] is of one made from a formula, which a file takes the place of.
bool is_of_a_kind(const TomlEntry& entry) {
  const SceneKey* row = find_scene_key(scene_table("motion"), entry.key);
  return entry.key == "kind" || (row != nullptr && !row->only_with.empty());
}

/// Whether a key of [motion] is of a file, which a formula takes the place of.
bool is_of_a_file(const TomlEntry& entry) {
  const SceneKey* row = find_scene_key(scene_table("motion"), entry.key);
  return entry.key == "file" || (row != nullptr && row->beside == "file");
}

/// The tables that there may be several of: a set's keys are of the first.
constexpr std::string_view tables_of_several[] = {"part", "plane"};

std::string_view table_of(const SetAxis& axis) {
  return std::string_view(axis.target).substr(0, axis.target.find('.'));
}

/// Whether the entry gives all that a new table of this name needs.
bool makes_table(const SetEntry& entry, std::string_view table) {
  const auto gives = [&](const SceneKey& key) {
    return std::any_of(entry.axes.begin(), entry.axes.end(), [&](const SetAxis& axis) {
      return axis.target == fmt::format("{}.{}", table, key.key);
    });
  };
  const std::vector<SceneKey>& keys = scene_table(table).keys;
  return std::all_of(keys.begin(), keys.end(), [&](const SceneKey& key) {
    const bool is_mesh = table == "part" && key.key == "mesh";  // which a set may give in its place
    return !(key.required || is_mesh) || gives(key);
  });
}

}  // namespace

void refuse_keys_without_table(const TomlNode& root, const std::vector<SetEntry>& entries,
                               const std::string& path) {
  for (const std::string_view table : tables_of_several) {
    if (find_entry(root, table) != nullptr) continue;
    for (const SetEntry& entry : entries) {
      const auto key = std::find_if(entry.axes.begin(), entry.axes.end(),
                                    [&](const SetAxis& axis) { return table_of(axis) == table; });
      if (key == entry.axes.end() || makes_table(entry, table)) continue;
      throw refused(
          place_text(path, key->place),
          fmt::format("'{}' in [[set]] is of the first [[{}]], and the scene has none", key->key, table));
    }
  }
}

std::vector<SetEntry> read_set(const TomlEntry& set, const std::string& path) {
  const auto refuse = [&](const TomlNode& value) {
    return refused(place_text(path, set.place),
                   fmt::format("'set' is {}; write it as [[set]]", type_text(value.type)));
  };
  if (!set.value.is(TomlNode::Type::array)) throw refuse(set.value);
  std::vector<SetEntry> entries;
  for (const TomlNode& item : set.value.items) {
    if (!item.is(TomlNode::Type::table)) throw refuse(item);
    entries.push_back(read_entry(item, path));
  }
  return entries;
}

void put_value(TomlNode& root, const std::string& target, const TomlNode& value) {
  TomlNode* table = &root;
  std::string rest = target;
  for (std::size_t dot = rest.find('.'); dot != std::string::npos; dot = rest.find('.')) {
    const std::string key = rest.substr(0, dot);
    const bool array = table == &root && std::find(std::begin(tables_of_several), std::end(tables_of_several),
                                                   key) != std::end(tables_of_several);
    table = &table_at(*table, key, array);
    rest.erase(0, dot + 1);
  }
  if (target == "motion.file") {
    std::erase_if(table->entries, is_of_a_kind);
  } else if (target == "motion.kind") {
    std::erase_if(table->entries, is_of_a_file);
  }
  put_entry(*table, rest, value);
}

}  // namespace fingerpad
