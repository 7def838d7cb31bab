#include "replay/passed_over.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/count_words.hpp"
#include "replay/batch_files.hpp"
#include "trace/change_log.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

/// Whether a replay calls a table so, its own or a shard's, or one that it keeps of an earlier run:
/// "summary.csv", "timing-2of8.csv", "jobs.kept-1.csv", "summary-2of8.schema.json"; or a report its page.
bool is_of_the_batch(const std::string& name) {
  if (name == "report.html") return true;
  const TableNames tables = table_names(1, 1);
  const bool is_schema = name.ends_with(".schema.json");
  const std::string table = is_schema ? name.substr(0, name.size() - 12) + ".csv" : name;
  if (!table.ends_with(".csv")) return false;
  return std::ranges::any_of(
      std::vector<std::string>{tables.summary, tables.timing, tables.jobs}, [&](const std::string& own) {
        const std::string stem = fs::path(own).stem().string();
        return table == own || table.starts_with(stem + ".kept-") || shard_of_table(table, stem).has_value();
      });
}

/// "DIR: 5 other files are passed over: a, b, c and 2 more"; nothing of none.
void add_words(const std::string& folder, std::vector<std::string> names, const char* one, const char* what,
               std::vector<std::string>& words) {
  constexpr std::size_t most_named = 3;
  if (names.empty()) return;
  std::sort(names.begin(), names.end());
  const std::size_t more = names.size() - std::min(names.size(), most_named);
  const std::string counted = count_words(names.size(), one);
  const bool is_one = names.size() == 1;
  names.resize(names.size() - more);
  words.push_back(fmt::format("{}: {}{} {} passed over: {}{}", folder, counted, what, is_one ? "is" : "are",
                              fmt::join(names, ", "), more == 0 ? "" : fmt::format(" and {} more", more)));
}

/// Whether it holds the changes of a scene while a trace was recorded, which a CSV trace has beside it.
bool is_change_file(const std::string& name, const std::set<std::string>& traces) {
  return std::ranges::any_of(traces, [&](const std::string& trace) {
    return trace.ends_with(".csv") && change_file_name(trace) == name;
  });
}

}  // namespace

std::vector<std::string> passed_over_words(const std::string& folder, const std::set<std::string>& traces) {
  std::vector<std::string> no_traces, others;
  std::error_code failure, none;
  for (fs::directory_iterator at(folder, failure); !failure && at != fs::directory_iterator();
       at.increment(failure)) {
    const std::string name = at->path().filename().string();
    if (traces.contains(name) || name.starts_with('.') || is_of_the_batch(name) ||
        is_change_file(name, traces))
      continue;
    if (at->is_directory(none)) {
      others.push_back(name + "/");
    } else {
      const bool is_named_so = name.ends_with(".h5") || name.ends_with(".csv");
      (is_named_so ? no_traces : others).push_back(name);
    }
  }
  std::vector<std::string> words;
  add_words(folder, std::move(no_traces), "file", " with a trace's ending but no trace in it", words);
  add_words(folder, std::move(others), "other file", "", words);
  return words;
}

}  // namespace fingerpad
