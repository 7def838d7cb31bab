#include "scene/scene_differences.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "scene/toml_tree.hpp"

namespace fingerpad {
namespace {

/// A key's value, which the same number is however it is written.
struct FlatValue {
  std::string shown;    ///< as written
  std::string meaning;  ///< equal where the values are

  bool operator==(const FlatValue& other) const { return meaning == other.meaning; }
};

/// A scene without its tables.
struct FlatScene {
  std::map<std::string, FlatValue> values;  ///< by dotted keys; the second of an array of tables is "part 2"
  std::set<std::string> listed;             ///< those tables of arrays: "part", "part 2"
};

bool holds_tables(const TomlNode& node) {
  return node.is(TomlNode::Type::array) && !node.items.empty() &&
         node.items.front().is(TomlNode::Type::table);
}

/// The value with 1000 and 1000.0 as one: whole numbers that a double holds, as such.
TomlNode with_doubles(TomlNode value) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  if (value.is(TomlNode::Type::integer) && value.integer <= most && value.integer >= -most)
    value.type = TomlNode::Type::number;
  for (TomlNode& item : value.items) item = with_doubles(std::move(item));
  for (TomlEntry& entry : value.entries) entry.value = with_doubles(std::move(entry.value));
  return value;
}

void flatten(const TomlNode& table, const std::string& prefix, FlatScene& flat) {
  for (const TomlEntry& entry : table.entries) {
    const std::string key = prefix + entry.key;
    if (key == "name" || key == "set") continue;
    if (entry.value.is(TomlNode::Type::table)) {
      flatten(entry.value, key + ".", flat);
    } else if (holds_tables(entry.value)) {
      for (std::size_t i = 0; i < entry.value.items.size(); ++i) {
        const std::string table = key + (i > 0 ? " " + std::to_string(i + 1) : "");
        flat.listed.insert(table);
        flatten(entry.value.items[i], table + ".", flat);
      }
    } else {
      const bool is_text = entry.value.is(TomlNode::Type::text);
      flat.values[key] = {is_text ? entry.value.text : write_toml_value(entry.value),
                          write_toml_value(with_doubles(entry.value))};
    }
  }
}

bool names_file(const std::string& key) {
  return key.ends_with(".mesh") || key == "motion.file" || key == "finger.profile";
}

/// "mu_static 0.3"; a file by its name alone.
std::string words_for(const std::string& key, const std::string& label,
                      const std::optional<FlatValue>& value) {
  if (!value) return label + " as by default";
  if (names_file(key)) return std::filesystem::path(value->shown).filename().string();
  return label + " " + value->shown;
}

/// The last part of each key, or the whole of it where two end alike.
std::map<std::string, std::string> labels_of(const std::vector<std::string>& keys) {
  std::map<std::string, int> ends;
  const auto end_of = [](const std::string& key) { return key.substr(key.rfind('.') + 1); };
  for (const std::string& key : keys) ++ends[end_of(key)];
  std::map<std::string, std::string> labels;
  for (const std::string& key : keys) labels[key] = ends[end_of(key)] > 1 ? key : end_of(key);
  return labels;
}

std::optional<FlatValue> value_of(const FlatScene& scene, const std::string& key) {
  const auto found = scene.values.find(key);
  return found != scene.values.end() ? std::optional(found->second) : std::nullopt;
}

/// The table of an array that a key is of, where this scene has none such though others do; else empty.
std::string table_left_out(const FlatScene& scene, const FlatScene& all, const std::string& key) {
  const std::string table = key.substr(0, key.find('.'));
  return all.listed.contains(table) && !scene.listed.contains(table) ? table : "";
}

}  // namespace

std::vector<std::string> scene_differences(const std::vector<std::string>& scene_texts) {
  std::vector<FlatScene> scenes;
  FlatScene all;
  for (const std::string& text : scene_texts) {
    scenes.emplace_back();
    flatten(parse_toml(text, "the scene"), "", scenes.back());
    all.values.insert(scenes.back().values.begin(), scenes.back().values.end());
    all.listed.insert(scenes.back().listed.begin(), scenes.back().listed.end());
  }
  std::vector<std::string> keys;
  for (const auto& entry : all.values) {
    const auto differs = [&](const FlatScene& scene) { return value_of(scene, entry.first) != entry.second; };
    if (std::any_of(scenes.begin(), scenes.end(), differs)) keys.push_back(entry.first);
  }
  const auto labels = labels_of(keys);
  std::vector<std::string> words;
  for (const FlatScene& scene : scenes) {
    words.emplace_back();
    std::string last_left_out;
    for (const std::string& key : keys) {
      const std::string left_out = table_left_out(scene, all, key);
      if (!left_out.empty() && std::exchange(last_left_out, left_out) == left_out) continue;
      if (!words.back().empty()) words.back() += ", ";
      words.back() +=
          left_out.empty() ? words_for(key, labels.at(key), value_of(scene, key)) : "no " + left_out;
    }
  }
  return words;
}

}  // namespace fingerpad
