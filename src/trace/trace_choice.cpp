#include "trace/trace_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/csv_cells.hpp"
#include "base/error.hpp"
#include "base/nearest_word.hpp"

namespace fingerpad {
namespace {

bool names(const std::vector<std::string>& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

std::vector<std::string> chosen_columns(std::string_view list, const std::string& where) {
  std::vector<std::string> known, asked{"t_s"};
  for (const TraceColumn& column : trace_columns()) known.emplace_back(column.name);
  for (const std::string_view name : csv_cells(list, ',')) {
    asked.emplace_back(name);
    if (names(known, name)) continue;
    if (const std::string commas = commas_hint(name); !commas.empty())
      throw Error(ErrorKind::usage, where, fmt::format("'{}' is no column of a trace{}", name, commas));
    const std::string nearest = nearest_word(name, known);
    throw Error(
        ErrorKind::usage, where,
        fmt::format("'{}' is no column of a trace{}; they are {}", name,
                    nearest.empty() ? "" : fmt::format(" (did you mean '{}'?)", nearest), word_list(known)));
  }
  std::erase_if(known, [&asked](const std::string& name) { return !names(asked, name); });
  return known;
}

std::string commas_hint(std::string_view name) {
  constexpr std::string_view other_marks = "; \t|:/+";
  std::string parted;
  for (std::size_t at = 0; (at = name.find_first_not_of(other_marks, at)) != std::string_view::npos;) {
    const std::size_t end = std::min(name.find_first_of(other_marks, at), name.size());
    parted += (parted.empty() ? "" : ",") + std::string(name.substr(at, end - at));
    at = end;
  }
  return parted.find(',') == std::string::npos ? "" : "; commas part them: " + parted;
}

void choose(const TraceChoice& choice, TraceInfo& info) {
  info.columns = choice.columns;
  info.every = static_cast<std::uint64_t>(choice.every);
  info.deflated = choice.deflated;
}

std::vector<TraceColumn> chosen(std::vector<TraceColumn> columns, const TraceInfo& info) {
  if (info.columns.empty()) return columns;
  std::erase_if(columns, [&info](const TraceColumn& column) { return !names(info.columns, column.name); });
  return columns;
}

std::string missing_columns_words(const std::vector<std::string>& missing,
                                  const std::vector<std::string>& chosen) {
  constexpr std::size_t most_named = 3;
  const std::vector<std::string> named(
      missing.begin(), missing.begin() + static_cast<std::ptrdiff_t>(std::min(most_named, missing.size())));
  const std::size_t more = missing.size() - named.size();
  return fmt::format(
      "has no column {}{}: it was written with {} alone (replay --columns), and a whole trace is "
      "needed here; replay its scene without --columns",
      word_list(named), more > 0 ? fmt::format(" and {} more", more) : "", word_list(chosen));
}

void refuse_missing_columns(const Trace& trace, const std::string& path) {
  if (trace.missing.empty()) return;
  // A table of text does not say what wrote it, and its header is all that it has.
  if (trace.info.scene_text.empty())
    throw refused(path + ":1",
                  fmt::format("is no trace: it has no column '{}' (a trace that was written with "
                              "some columns alone, by replay --columns, cannot be taken here)",
                              trace.missing.front()));
  throw refused(path, missing_columns_words(trace.missing, trace.info.columns));
}

}  // namespace fingerpad
