#include "replay/trace_comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/number_text.hpp"
#include "trace/trace_column.hpp"

namespace fingerpad {
namespace {

/// Rows of two traces at one time.
struct RowPair {
  std::size_t a = 0, b = 0;
};

/// The times that both have. Ticks of one rate have the same times to the bit, of others to rounding.
std::vector<RowPair> rows_at_common_times(const Trace& a, const Trace& b) {
  constexpr double least_s = 1e-9;
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();  // of clocks that count from 1970
  std::vector<RowPair> pairs;
  for (RowPair at; at.a < a.rows.size() && at.b < b.rows.size();) {
    const double a_s = a.rows[at.a].t_s, b_s = b.rows[at.b].t_s;
    if (std::abs(a_s - b_s) <= std::max(least_s, rounding * std::abs(a_s))) {
      pairs.push_back(at);
      ++at.a;
      ++at.b;
    } else {
      ++(a_s < b_s ? at.a : at.b);
    }
  }
  return pairs;
}

bool lacks(const Trace& trace, const TraceColumn& column) {
  return std::find(trace.absent.begin(), trace.absent.end(), column.name) != trace.absent.end();
}

/// Adds the column where it differs.
void compare_column(const TraceColumn& column, const Trace& a, const Trace& b,
                    const std::vector<RowPair>& pairs, double tolerance, std::vector<JobChange>& changes) {
  JobChange change{std::string(column.name), "", 0, column.unit, 0};
  std::size_t rows = 0;
  for (const RowPair& at : pairs) {
    const double apart = distance_between(column.get(a.rows[at.a]), column.get(b.rows[at.b]));
    if (!(apart > tolerance)) continue;
    ++rows;
    if (apart <= change.most) continue;
    change.most = apart;
    change.at_s = a.rows[at.a].t_s;
  }
  if (rows == 0) return;
  const std::string unit = column.unit == "1" ? "" : " " + std::string(column.unit);
  const std::string most = std::isinf(change.most)
                               ? "from a number to none"
                               : fmt::format("by up to {}{}", rounded_text(change.most, 6), unit);
  change.words = fmt::format("{} differs {} at t = {} s, in {} of {} ticks", column.name, most,
                             rounded_text(change.at_s, 6), rows, pairs.size());
  changes.push_back(std::move(change));
}

/// That the finger went another way, by the column that is the farthest apart, a place's before a turn's;
/// nothing where it did not.
void tell_the_way(const Trace& a, const Trace& b, std::vector<JobChange>& changes) {
  const auto is_place = [](const JobChange& change) { return change.column.ends_with("_m"); };
  const JobChange* farthest = nullptr;
  for (const JobChange& change : changes) {
    if (!is_of_the_way(change.column)) continue;
    if (farthest == nullptr ||
        std::pair(is_place(change), change.most) > std::pair(is_place(*farthest), farthest->most))
      farthest = &change;
  }
  if (farthest == nullptr) return;
  const auto has_hand = [](const Trace& trace) {
    return std::find(trace.absent.begin(), trace.absent.end(), "hx_n") == trace.absent.end();
  };
  const char* const what =
      has_hand(a) && has_hand(b) ? "the hand took the finger another way" : "the motions are not the same";
  JobChange told = whole_change(fmt::format("{}: {}", what, farthest->words));
  changes.insert(changes.begin(), std::move(told));
}

}  // namespace

bool is_of_the_way(std::string_view column) noexcept {
  const auto columns = trace_columns();
  return std::any_of(columns.begin(), columns.end(),
                     [column](const TraceColumn& row) { return row.of_the_way && row.name == column; });
}

double distance_between(double a, double b) noexcept {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double apart = std::abs(a - b);
  return std::isnan(apart) ? HUGE_VAL : apart;
}

JobChange whole_change(std::string words) {
  return {"", std::move(words), TickRecord::nan, "", TickRecord::nan};
}

/// Of the columns that one of two traces lacks: nothing, or a line.
void tell_columns_of_one(const std::vector<std::string>& names, std::string_view which,
                         std::vector<JobChange>& changes) {
  if (names.empty()) return;
  if (names.size() == 1)
    return changes.push_back(
        whole_change(fmt::format("{} is in the {} trace alone, and not compared", names[0], which)));
  changes.push_back(whole_change(fmt::format("{} columns are in the {} trace alone, and not compared: {}",
                                             names.size(), which, fmt::join(names, " "))));
}

std::vector<JobChange> trace_changes(const Trace& a, const Trace& b, double tolerance,
                                     bool are_of_two_formats) {
  std::vector<JobChange> changes;
  const std::vector<RowPair> pairs = rows_at_common_times(a, b);
  const std::size_t most_rows = std::max(a.rows.size(), b.rows.size());
  if (pairs.size() < most_rows)
    changes.push_back(whole_change(fmt::format("{} ticks, then {}; {} times are in both, and compared",
                                               a.rows.size(), b.rows.size(), pairs.size())));
  std::vector<std::string> of_a, of_b;
  std::vector<JobChange> of_columns;
  for (const TraceColumn& column : trace_columns()) {
    if (are_of_two_formats && column.of == ColumnOf::hdf5) continue;
    const bool lacks_a = lacks(a, column), lacks_b = lacks(b, column);
    if (lacks_a != lacks_b) (lacks_a ? of_b : of_a).emplace_back(column.name);
    if (lacks_a || lacks_b || column.name == "t_s") continue;  // by which they were set side by side
    compare_column(column, a, b, pairs, tolerance, of_columns);
  }
  tell_columns_of_one(of_a, "first", changes);
  tell_columns_of_one(of_b, "second", changes);
  changes.insert(changes.end(), of_columns.begin(), of_columns.end());
  tell_the_way(a, b, changes);
  return changes;
}

}  // namespace fingerpad
