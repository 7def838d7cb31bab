#include "scene/set_axis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "base/error.hpp"
#include "base/nearest_word.hpp"
#include "base/printable_text.hpp"
#include "scene/scene_key.hpp"
#include "scene/scene_values.hpp"
#include "scene/set_range.hpp"
#include "scene/toml_table.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// The paths that match a pattern, sorted by name; relative to the scene's folder unless the pattern is
/// absolute.
std::vector<std::string> matching_files(const std::string& pattern, const std::string& scene_path) {
  std::string folder;
  if (!fs::path(pattern).is_absolute()) folder = fs::path(scene_path).parent_path().string();
  if (!folder.empty() && folder.back() != '/') folder += '/';
  std::string escaped;
  for (const char c : folder) {
    if (c == '*' || c == '?' || c == '[' || c == ']' || c == '\\') escaped += '\\';
    escaped += c;
  }
  std::vector<std::string> files;
  glob_t found{};
  if (glob((escaped + pattern).c_str(), GLOB_NOSORT | GLOB_MARK, nullptr, &found) == 0) {
    for (std::size_t i = 0; i < found.gl_pathc; ++i) {
      const std::string file = found.gl_pathv[i];
      if (file.back() != '/' && file.starts_with(folder)) files.push_back(file.substr(folder.size()));
    }
  }
  globfree(&found);
  std::sort(files.begin(), files.end());
  return files;
}

std::string written_text(const TomlNode& value) {
  if (value.is(TomlNode::Type::text)) return value.text;
  return value.written.empty() ? write_toml_value(value) : value.written;
}

/// Adds one value of a key; a glob adds all its files, and is a list however many it finds.
void add_value(SetAxis& axis, const TomlNode& value, const std::string& path) {
  const bool names_file = axis.target == "part.mesh" || axis.target == "motion.file";
  const bool glob =
      names_file && value.is(TomlNode::Type::text) && value.text.find_first_of("*?[") != std::string::npos;
  std::error_code ignored;
  if (!glob || fs::exists(resolved_path(path, value.text), ignored)) {
    axis.values.push_back({value, written_text(value)});
    return;
  }
  axis.is_list = true;
  const std::vector<std::string> files = matching_files(value.text, path);
  if (files.empty()) {
    throw refused(place_text(path, value.place), fmt::format("no file matches '{}'", value.text));
  }
  for (const std::string& file : files) {
    if (!is_utf8(file)) {
      throw refused(place_text(path, value.place),
                    fmt::format("'{}' matches {}, whose name is not UTF-8, as a scene and its trace must be: "
                                "rename it",
                                value.text, printable(file)));
    }
    TomlNode name = toml_text(file);
    name.place = value.place;
    axis.values.push_back({std::move(name), file});
  }
}

/// Of a key that takes whole numbers alone: once, not job by job. What is no number is for the key itself to
/// refuse, and too many jobs are told of the set.
void refuse_fractions(const SetAxis& axis, const std::string& path) {
  const SceneKey* row = find_whole_key(axis.target);
  if (row == nullptr || axis.values.size() > max_jobs) return;
  const bool is_open = row->most_whole == std::numeric_limits<std::int64_t>::max();
  const std::string end = is_open ? "on" : fmt::format("to {}", row->most_whole);
  for (const SetValue& value : axis.values) {
    if (!value.value.is(TomlNode::Type::number)) continue;
    throw refused(
        place_text(path, value.value.place),
        fmt::format("'{}' in [[set]] takes whole numbers, and {} is none of them; give such from {} {}",
                    axis.key, value.written, row->least_whole, end));
  }
}

/// Of a key that takes one of a few words: a misspelt one once, not job by job. What is no text is for the
/// key itself to refuse, and too many jobs are told of the set.
void refuse_unknown_words(const SetAxis& axis, const std::string& path) {
  const SceneKey* row = find_choice_key(axis.target);
  if (row == nullptr || axis.values.size() > max_jobs) return;
  for (const SetValue& value : axis.values) {
    if (!value.value.is(TomlNode::Type::text) || std::ranges::count(row->words, value.value.text) > 0)
      continue;
    throw refused(place_text(path, value.value.place),
                  unknown_word_text(row->key, value.value.text, "in [[set]]", row->words));
  }
}

/// The key of a set that this one is most like; empty where none is. Within a table its name says nothing:
/// 'motion.bogus' is not like 'motion.columns'.
std::string nearest_set_key(const std::string& key) {
  const std::string table = key.substr(0, key.find('.') + 1);  // with its dot; empty where there is none
  std::vector<std::string> keys = set_keys();
  if (std::ranges::none_of(keys, [&](const std::string& other) { return other.starts_with(table); }))
    return nearest_word(key, keys);
  std::erase_if(keys, [&](const std::string& other) { return !other.starts_with(table); });
  for (std::string& other : keys) other.erase(0, table.size());
  const std::string nearest = nearest_word(std::string_view(key).substr(table.size()), keys);
  return nearest.empty() ? "" : table + nearest;
}

/// "; did you mean 'part.mu_dynamic' or 'plane.mu_dynamic'?" of a key that lacks its table, else with the
/// nearest; empty where none is like it.
std::string meant_keys(const std::string& key) {
  std::vector<std::string> meant;
  for (const std::string& known : set_keys()) {
    if (known.ends_with('.' + key)) meant.push_back(fmt::format("'{}'", known));
  }
  const std::string nearest = meant.empty() ? nearest_set_key(key) : "";
  if (!nearest.empty()) meant.push_back(fmt::format("'{}'", nearest));
  return meant.empty() ? "" : fmt::format("; did you mean {}?", fmt::join(meant, " or "));
}

}  // namespace

SetAxis read_axis(const SetLeaf& leaf, const std::string& path) {
  const auto target = set_key_target(leaf.key);
  if (!target) {
    throw refused(
        place_text(path, leaf.place),
        fmt::format("unknown key '{}' in [[set]]{}; a set has 'mesh', 'motion', 'seed' and the dotted keys "
                    "of a scene, such as 'friction.law'",
                    leaf.key, meant_keys(leaf.key)));
  }
  SetAxis axis{leaf.key, *target, leaf.place, {}, false};
  const bool is_range = is_set_range(*leaf.value);
  const TomlNode value =
      is_range ? range_values(*leaf.value, leaf.key, find_whole_key(*target) != nullptr, path) : *leaf.value;
  const auto is_list = [](const TomlNode& item) { return item.is(TomlNode::Type::array); };
  const bool list = is_list(value) && (is_range || !is_vector_key(*target) || value.items.empty() ||
                                       std::any_of(value.items.begin(), value.items.end(), is_list));
  axis.is_list = list;
  if (!list) add_value(axis, value, path);
  for (const TomlNode& item : list ? value.items : std::vector<TomlNode>{}) {
    if (axis.values.size() > max_jobs) break;
    add_value(axis, item, path);
  }
  if (axis.values.empty()) {
    throw refused(
        place_text(path, leaf.place),
        fmt::format("'{}' in [[set]] has an empty list, so that the set would have no jobs", leaf.key));
  }
  refuse_fractions(axis, path);
  refuse_unknown_words(axis, path);
  return axis;
}

}  // namespace fingerpad
