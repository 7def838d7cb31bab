#pragma once

#include <string_view>
#include <vector>

#include "trace/trace.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {

/// Which of its columns and rows a trace is written with; all of them unless chosen.
struct TraceChoice {
  std::vector<std::string> columns;  ///< names, in file order, t_s among them; empty: all
  long every = 1;                    ///< rows of every so manieth tick, and of the last
  bool deflated = false;             ///< TraceInfo::deflated

  bool is_all() const noexcept { return columns.empty() && every == 1; }
};

/// The columns of a list such as "fn_n,mu" in file order, with t_s. Throws Error (usage, at `where`) for a
/// name that no trace has, with the nearest.
std::vector<std::string> chosen_columns(std::string_view list, const std::string& where);

/// "; commas part them: fn_n,mu", to stand behind what is said of an unknown column that is several, parted
/// by another mark ("fn_n;mu", "fn_n mu"); "" of any other.
std::string commas_hint(std::string_view name);

/// Tells the info of a trace what it is written with.
void choose(const TraceChoice& choice, TraceInfo& info);

/// Of these columns those that the info's trace is written with.
std::vector<TraceColumn> chosen(std::vector<TraceColumn> columns, const TraceInfo& info);

/// Whether the row of tick k, from 0, is written.
constexpr bool is_kept(long k, long last, std::uint64_t every) noexcept {
  return k == last || static_cast<std::uint64_t>(k) % every == 0;
}

/// How many rows a trace of so many ticks has.
constexpr std::uint64_t kept_rows(long ticks, std::uint64_t every) noexcept {
  const auto last = static_cast<std::uint64_t>(ticks - 1);
  return ticks < 1 ? 0 : last / every + 1 + (last % every != 0 ? 1 : 0);
}

/// What a trace that was written with some columns alone lacks, and the mend; `missing` is not empty.
std::string missing_columns_words(const std::vector<std::string>& missing,
                                  const std::vector<std::string>& chosen);

/// Throws Error (refused) where a trace lacks columns: which it has, which it would need, and the mend.
void refuse_missing_columns(const Trace& trace, const std::string& path);

}  // namespace fingerpad
