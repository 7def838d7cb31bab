// The scene file that the README and `--help` show, from the rows of its keys.
#include <fmt/format.h>

#include <algorithm>

#include "scene/scene_key.hpp"

namespace fingerpad {
namespace {

/// A line with a remark behind it, remarks one below the other where the lines are short enough.
std::string line(const std::string& text, std::string_view remark) {
  if (remark.empty()) return text + '\n';
  return fmt::format("{:<30} # {}\n", text.size() > 30 ? text + "  " : text, remark);
}

/// What is said of a key: of a choice between a few words the other words first.
std::string remark_of(const SceneKey& row) {
  constexpr std::size_t most_words = 6;
  std::vector<std::string> others = row.words;
  std::erase(others, row.default_word);
  if (others.empty() || others.size() > most_words) return std::string(row.doc);
  return fmt::format("or {}{}{}", word_list(others), row.doc.empty() ? "" : "; ", row.doc);
}

/// "{ axis = [0, 0, 1], angle_deg = 0 }".
std::string inline_text(const SceneTable& table) {
  std::vector<std::string> values;
  for (const SceneKey& row : table.keys) values.push_back(fmt::format("{} = {}", row.key, row.shown));
  return "{ " + word_list(values) + " }";
}

/// The line of a key whose value is a table: its keys, or what stands for none of them.
std::string table_line(const SceneTable& table, const SceneKey& row) {
  const std::string values = inline_text(scene_table(fmt::format("{}.{}", table.name, row.key)));
  if (row.shown.empty()) return line(fmt::format("{} = {}", row.key, values), row.doc);
  return line(fmt::format("{} = {}", row.key, row.shown), "or " + values);
}

/// A line for each word of a deciding key without a default, with the keys that it brings.
std::string lines_of_words(const SceneTable& table, const SceneKey& deciding) {
  std::string text;
  for (const std::string& word : deciding.words) {
    std::vector<std::string> keys;
    for (const SceneKey& row : table.keys) {
      if (row.only_with.empty() || !goes_with(row, word)) continue;
      keys.push_back(fmt::format("{}{}", row.key, row.required ? "" : " (optional)"));
    }
    text += fmt::format("# or {} = \"{}\", with {}\n", deciding.key, word, word_list(keys));
  }
  return text;
}

bool is_without_default(const SceneKey& row) {
  return row.type == KeyType::choice && row.default_word.empty();
}

std::string table_text(const SceneTable& table) {
  std::string text;
  if (!table.name.empty()) text += '\n' + line(std::string(table.heading), table.doc);
  const auto deciding = std::find_if(table.keys.begin(), table.keys.end(), is_without_default);
  for (const SceneKey& row : table.keys) {
    if (row.type == KeyType::table) {
      text += table_line(table, row);
    } else if (is_without_default(row)) {
      text += lines_of_words(table, row);
    } else if (!row.shown.empty() && (deciding == table.keys.end() || row.only_with.empty())) {
      text += line(fmt::format("{} = {}", row.key, row.shown), remark_of(row));
    }
  }
  return text;
}

constexpr std::string_view set_text = R"(
[[set]]                        # optional, any number: the product of the lists is the jobs
mesh = "parts/*.stl"           # a glob; `mesh` is the first part's, `motion` the motion's file
friction.law = ["stick-slip", "finger-pad"]
part.mu_static = { from = 0.3, to = 0.5, steps = 3 }   # 0.3, 0.4, 0.5; any scene key has values, a list or a range
zip = false                    # true: the lists go side by side, not every value with every other
)";

}  // namespace

std::string scene_keys_text() {
  std::string text;
  for (const SceneTable& table : scene_tables()) {
    const bool is_inline = table.name.find('.') != std::string_view::npos;
    if (!is_inline) text += table_text(table);
  }
  return text.append(set_text);
}

}  // namespace fingerpad
