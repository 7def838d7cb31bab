#include "fuzz/dictionary_words.hpp"

#include <fmt/format.h>

#include <set>

#include "scene/scene_key.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad::test {

std::string scene_words() {
  std::set<std::string> words{R"("set")", R"("[[set]]\x0a")"};
  for (const SceneTable& table : scene_tables()) {
    if (table.heading.starts_with('[')) {
      words.insert(fmt::format("\"{}\"", table.name));
      words.insert(fmt::format("\"{}\\x0a\"", table.heading));
    }
    for (const SceneKey& row : table.keys) {
      words.insert(fmt::format("\"{}\"", row.key));
      for (const std::string& word : row.words) words.insert(fmt::format(R"("\"{}\"")", word));
    }
  }
  return fmt::format("{}\n", fmt::join(words, "\n"));
}

std::string trace_words() {
  std::string words;
  for (const TraceColumn& column : trace_columns()) words += fmt::format("\"{}\"\n", column.name);
  return words;
}

std::string dictionary_words(std::string_view target) {
  if (target == "scene") return scene_words();
  if (target == "trace_csv") return trace_words();
  return {};
}

}  // namespace fingerpad::test
