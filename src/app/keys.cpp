#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/commands.hpp"
#include "app/standard_streams.hpp"
#include "base/error.hpp"
#include "base/nearest_word.hpp"
#include "scene/scene_key.hpp"

namespace fingerpad {
namespace {

struct TellableKey {
  std::string name;  ///< dotted, as a set names it
  const SceneKey* key;
};

std::vector<TellableKey> all_keys() {
  std::vector<TellableKey> keys;
  for (const SceneTable& table : scene_tables()) {
    for (const SceneKey& key : table.keys)
      keys.push_back(
          {table.name.empty() ? std::string(key.key) : fmt::format("{}.{}", table.name, key.key), &key});
  }
  return keys;
}

/// "friction.law = "finger-pad"    what it is; for these words".
std::string line_of(const TellableKey& key) {
  std::string line = key.name;
  if (!key.key->shown.empty()) line += " = " + key.key->shown;
  line = fmt::format("{:<46}", line);
  if (!key.key->doc.empty()) line += fmt::format("  {}", key.key->doc);
  if (!key.key->words.empty()) line += fmt::format("  ({})", fmt::join(key.key->words, ", "));
  while (line.ends_with(' ')) line.pop_back();
  return line;
}

int tell_keys(const std::vector<std::string>& asked) {
  const std::vector<TellableKey> keys = all_keys();
  const auto is_of = [](const std::string& name, const std::string& word) {
    return name == word || name.starts_with(word + ".") || (name.ends_with("." + word));
  };
  for (const std::string& word : asked) {
    if (std::any_of(keys.begin(), keys.end(), [&](const TellableKey& key) { return is_of(key.name, word); }))
      continue;
    std::vector<std::string> names;
    names.reserve(3 * keys.size());
    for (const TellableKey& key : keys) {
      names.push_back(key.name);
      names.emplace_back(key.key->key);
      names.push_back(key.name.substr(0, key.name.find('.')));  // its table
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    const std::string mend = word == "set" ? ": [[set]] takes any of the keys that `fingerpad keys` lists"
                                           : near_miss_hint(word, names);
    throw Error(ErrorKind::usage, "", fmt::format("a scene has no key '{}'{}", word, mend));
  }
  for (const TellableKey& key : keys) {
    const bool wanted = std::any_of(asked.begin(), asked.end(),
                                    [&](const std::string& word) { return is_of(key.name, word); });
    if (asked.empty() || wanted) print_out("{}\n", line_of(key));
  }
  return 0;
}

}  // namespace

void add_keys(CLI::App& program, Action& action) {
  auto asked = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      program.add_subcommand("keys", "Tell the keys of a scene file: default or example, meaning, choices");
  command->add_option("KEY", *asked, "Keys (part.mu_static, mu_static) or tables (friction); default: all");
  command->footer(
      "Names are those that a [[set]] gives its keys. `fingerpad replay --help` shows a whole scene.");
  command->callback([asked, &action] { action = [asked] { return tell_keys(*asked); }; });
}

}  // namespace fingerpad
