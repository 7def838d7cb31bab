#include "view/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/nearest_word.hpp"
#include "base/number_text.hpp"
#include "touch/tick_record.hpp"
#include "trace/trace_choice.hpp"
#include "view/several_walls.hpp"

namespace fingerpad {
namespace {

const ComparedColumn* column_of(const ComparedRun& run, const std::string& name) {
  const auto found = std::find_if(run.columns.begin(), run.columns.end(),
                                  [&](const ComparedColumn& column) { return column.name == name; });
  return found != run.columns.end() ? &*found : nullptr;
}

bool all_have(const std::vector<ComparedRun>& runs, const std::string& name) {
  return std::all_of(runs.begin(), runs.end(),
                     [&](const ComparedRun& run) { return column_of(run, name) != nullptr; });
}

std::string names_in(const ComparedRun& run) {
  std::string names;
  for (const ComparedColumn& column : run.columns) names += (names.empty() ? "" : ", ") + column.name;
  return names;
}

/// Of these names those that all runs have.
std::vector<std::string> had_by_all(const std::vector<ComparedRun>& runs, std::vector<std::string> names) {
  std::erase_if(names, [&](const std::string& name) { return !all_have(runs, name); });
  return names;
}

std::vector<std::string> usual_columns(const std::vector<ComparedRun>& runs) {
  constexpr std::size_t most = 6;
  std::vector<std::string> have = had_by_all(runs, {"fn_n", "friction", "mu"});
  if (have.size() == 3) return have;
  std::vector<std::string> all;
  for (const ComparedColumn& column : runs.front().columns) all.push_back(column.name);
  all = had_by_all(runs, all);
  // What was written with a few columns alone was meant for them.
  if (runs.size() == 1 && !all.empty() && all.size() <= most) return all;
  have = had_by_all(runs, {"fn_n", "fx_n", "fy_n", "fz_n", "mu"});
  if (have.empty())
    have.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(most, all.size())));
  if (!have.empty()) return have;
  throw refused(runs.back().path,
                fmt::format("has no column in common with {}: {} there, {} here", runs.front().path,
                            names_in(runs.front()), names_in(runs.back())));
}

/// "has no column 'fx'; did you mean 'fx_n'? It has t_s, fx_n".
std::string no_column_words(const ComparedRun& run, const std::string& name) {
  std::string hint = commas_hint(name);
  std::vector<std::string> known;
  for (const ComparedColumn& column : run.columns) known.push_back(column.name);
  if (hint.empty()) hint = near_miss_hint(name, known);
  return fmt::format("has no column '{}'{}{}it has {}", name, hint, hint.ends_with('?') ? " (" : "; ",
                     names_in(run)) +
         (hint.ends_with('?') ? ")" : "");
}

/// A quantity of a run at the ticks that tell it.
struct ComparedSeries {
  std::vector<double> x, t_s, values;  ///< t_s empty where the run has none
};

/// A column as it is laid over another run: of one that left out ticks, as such ticks tell it.
ComparedSeries compared_series(const ComparedRun& run, const std::string& name, const ComparedRun& other) {
  const ComparedColumn& column = *column_of(run, name);
  const auto thinned = std::ranges::find(column.thinned, other.t_s, &ThinnedColumn::by_t_s);
  if (thinned == column.thinned.end()) return {run.x, run.t_s, column.values};
  ComparedSeries series{{}, {}, thinned->values};
  for (const std::size_t tick : thinned->ticks) {
    series.x.push_back(run.x[tick]);
    series.t_s.push_back(run.t_s[tick]);
  }
  return series;
}

/// The value at x, linearly between the ticks beside it; of several ticks at x, as of a finger that rests,
/// that of the nearest time; nan before the first and after the last.
/// @param rounding  ticks that lie nearer are at x
double value_at(const ComparedSeries& series, double x, double t_s, double rounding) {
  const auto from = std::lower_bound(series.x.begin(), series.x.end(), x - rounding);
  const auto to = std::upper_bound(from, series.x.end(), x + rounding);
  const auto first = static_cast<std::size_t>(from - series.x.begin());
  const auto beyond = static_cast<std::size_t>(to - series.x.begin());
  if (beyond > first) {
    if (beyond == first + 1 || series.t_s.empty()) return series.values[first];
    const auto begin = series.t_s.begin();
    const auto after = std::lower_bound(begin + static_cast<std::ptrdiff_t>(first),
                                        begin + static_cast<std::ptrdiff_t>(beyond - 1), t_s);
    const auto i = static_cast<std::size_t>(after - begin);
    const bool before_is_nearer = i > first && t_s - series.t_s[i - 1] < series.t_s[i] - t_s;
    return series.values[before_is_nearer ? i - 1 : i];
  }
  if (first == 0 || first == series.x.size()) return TickRecord::nan;
  const double share = (x - series.x[first - 1]) / (series.x[first] - series.x[first - 1]);
  return series.values[first - 1] + share * (series.values[first] - series.values[first - 1]);
}

/// Where two runs are compared.
struct CommonTicks {
  double from = 0, to = 0;
  double rounding = 0;                   ///< places that lie nearer are one: two runs sum one way apart
  const ComparedRun* grid = nullptr;     ///< whose ticks serve
  const ComparedRun* between = nullptr;  ///< that is interpolated
};

bool are_at(const CommonTicks& ticks, double x) {
  return x >= ticks.from - ticks.rounding && x <= ticks.to + ticks.rounding;
}

long count_at(const CommonTicks& ticks, const ComparedRun& run) {
  return std::ranges::count_if(run.x, [&](double x) { return are_at(ticks, x); });
}

CommonTicks common_ticks(const ComparedRun& first, const ComparedRun& other, Over over) {
  if (first.x.empty() || other.x.empty())
    throw refused(first.x.empty() ? first.path : other.path, "holds no tick");
  CommonTicks ticks;
  ticks.from = std::max(first.x.front(), other.x.front());
  ticks.to = std::min(first.x.back(), other.x.back());
  if (over != Over::time) ticks.rounding = 1e-9 * (ticks.to - ticks.from);
  if (!(ticks.to >= ticks.from)) {
    throw refused(other.path, fmt::format("has no {} in common with {}: {} to {} here, {} to {} there",
                                          over == Over::time ? "time" : "way", first.path,
                                          rounded_text(other.x.front(), 6), rounded_text(other.x.back(), 6),
                                          rounded_text(first.x.front(), 6), rounded_text(first.x.back(), 6)));
  }
  const bool first_is_finer = count_at(ticks, first) > count_at(ticks, other);
  ticks.grid = first_is_finer ? &other : &first;
  ticks.between = first_is_finer ? &first : &other;
  return ticks;
}

Residual residual_of(const std::string& name, const ComparedRun& first, const ComparedRun& other,
                     std::size_t run, const CommonTicks& ticks) {
  const ComparedSeries a = compared_series(first, name, other), b = compared_series(other, name, first);
  Residual residual{run, name, column_of(first, name)->unit, {}, {}, 0, 0};
  double squares = 0;
  for (std::size_t i = 0; i < ticks.grid->x.size(); ++i) {
    const double x = ticks.grid->x[i];
    if (!are_at(ticks, x)) continue;
    const double t_s = ticks.grid->t_s.empty() ? x : ticks.grid->t_s[i];
    const double left = value_at(b, x, t_s, ticks.rounding) - value_at(a, x, t_s, ticks.rounding);
    residual.x.push_back(x);
    residual.values.push_back(left);
    if (!std::isfinite(left)) continue;
    squares += left * left;
    ++residual.ticks;
  }
  const auto count = static_cast<double>(residual.ticks);
  residual.rms = count > 1 ? std::sqrt(squares / count) : TickRecord::nan;
  return residual;
}

/// Whether both have all ticks at which they are compared, so that nothing is interpolated.
bool are_shared(const CommonTicks& ticks) {
  const std::vector<double>& other = ticks.between->x;
  return std::all_of(ticks.grid->x.begin(), ticks.grid->x.end(), [&](double x) {
    if (!are_at(ticks, x)) return true;
    const auto near = std::lower_bound(other.begin(), other.end(), x - ticks.rounding);
    return near != other.end() && *near <= x + ticks.rounding;
  });
}

/// "0.35 to 1 s": what two runs have in common.
std::string span_words(const CommonTicks& ticks, Over over) {
  const char* unit = over == Over::time ? "s" : over == Over::travel ? "mm" : "deg";
  return fmt::format("{} to {} {}", rounded_text(ticks.from, 4), rounded_text(ticks.to, 4), unit);
}

/// At which ticks a run is compared with the first; empty where both have the same.
std::string ticks_words(const ComparedRun& first, const ComparedRun& other, const CommonTicks& ticks) {
  const bool shared = are_shared(ticks);
  if (shared && count_at(ticks, first) == count_at(ticks, other)) return "";
  if (ticks.grid == &other)
    return std::string("at its own ticks") + (shared ? "" : ", the first interpolated linearly");
  return shared ? "at the ticks of the first" : "interpolated linearly at the ticks of the first";
}

/// Runs of which the same is told.
struct NotedRuns {
  std::vector<std::string> names;
  std::string span, at;
};

/// @param who  the runs by name, or that it is all
std::string note_on(const NotedRuns& runs, const std::string& who, bool tells_span) {
  std::string words = who + ": ";
  if (tells_span) words += runs.span + (runs.at.empty() ? "" : ", ");
  return words + (runs.names.size() > 1 && runs.at.starts_with("at its own") ? "each " : "") + runs.at;
}

/// Over what, and at which ticks, each run is compared with the first; what several have in common is told
/// once.
/// @param ticks  of each run but the first
std::vector<std::string> common_notes(const std::vector<ComparedRun>& runs,
                                      const std::vector<CommonTicks>& ticks, Over over) {
  std::vector<NotedRuns> noted;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    const std::string span = span_words(ticks[i - 1], over), at = ticks_words(runs[0], runs[i], ticks[i - 1]);
    const auto same =
        std::ranges::find_if(noted, [&](const NotedRuns& one) { return one.span == span && one.at == at; });
    NotedRuns& of_run = same == noted.end() ? noted.emplace_back(NotedRuns{{}, span, at}) : *same;
    of_run.names.push_back(runs[i].name);
  }
  const bool is_one_span = noted.size() > 1 && std::ranges::all_of(noted, [&](const NotedRuns& one) {
                             return one.span == noted[0].span;
                           });
  std::vector<std::string> notes;
  if (is_one_span) notes.push_back("all: " + noted[0].span);
  for (const NotedRuns& one : noted) {
    const bool are_all = noted.size() == 1 && one.names.size() > 1;
    const std::string who =
        are_all ? "all" : fmt::format("{}", fmt::join(one.names, "; "));  // names have commas
    if (!is_one_span || !one.at.empty()) notes.push_back(note_on(one, who, !is_one_span));
  }
  return notes;
}

/// How the ways are told of runs that left out ticks.
std::vector<std::string> way_notes(const std::vector<ComparedRun>& runs, Over over) {
  if (std::ranges::none_of(runs, &ComparedRun::x_by_fewer)) {
    if (std::ranges::none_of(runs, &ComparedRun::lacks_ticks)) return {};
    return {std::string(shortened_words(over))};
  }
  std::vector<std::string> notes{
      "way: from each tick to the next of the run that has fewest; what lies between is longer"};
  const auto ticks_of = [](const ComparedRun& run) { return run.t_s.size(); };
  const std::size_t fewest = ticks_of(*std::ranges::min_element(runs, {}, ticks_of));
  for (const ComparedRun& run : runs) {
    if (run.x_by_fewer || ticks_of(run) == fewest) continue;
    notes.push_back(run.name +
                    " has not all of its ticks: its way is its own, of another length; over t they compare");
  }
  return notes;
}

std::string left_out_words(const ComparedRun& run) {
  const std::string of = run.name.empty() ? "" : run.name + ": ";
  if (run.every > 1) return fmt::format("{}1 tick in {} is here", of, run.every);
  return of + "ticks were left out (the last row comes sooner than the others)";
}

}  // namespace

Comparison compare_runs(std::vector<ComparedRun> runs, const std::vector<std::string>& columns, Over over) {
  Comparison comparison;
  name_apart(runs);
  comparison.columns = columns.empty() ? usual_columns(runs) : columns;
  for (const std::string& name : comparison.columns) {
    for (const ComparedRun& run : runs) {
      if (column_of(run, name) == nullptr) throw refused(run.path, no_column_words(run, name));
    }
  }
  if (runs.size() > 1) comparison.notes.push_back("residuals: less the first, " + runs[0].name);
  if (std::ranges::find(comparison.columns, "friction") != comparison.columns.end()) {
    comparison.friction = share_friction_sense(runs);
    comparison.notes.push_back(comparison.friction.sentence);
  }
  const bool shows_normal_force = std::ranges::any_of(
      comparison.columns, [](const std::string& name) { return name == "fn_n" || name == "mu"; });
  if (shows_normal_force && std::ranges::any_of(runs, &ComparedRun::several_walls))
    comparison.notes.emplace_back(several_walls_words);
  for (const ComparedRun& run : runs) {
    if (run.lacks_ticks) comparison.notes.push_back(left_out_words(run));
  }
  if (over != Over::time) {
    for (std::string& note : way_notes(runs, over)) comparison.notes.push_back(std::move(note));
  }
  std::vector<CommonTicks> ticks;
  for (std::size_t i = 1; i < runs.size(); ++i) ticks.push_back(common_ticks(runs[0], runs[i], over));
  for (std::string& note : common_notes(runs, ticks, over)) comparison.notes.push_back(std::move(note));
  for (const std::string& name : comparison.columns) {
    for (std::size_t i = 1; i < runs.size(); ++i)
      comparison.residuals.push_back(residual_of(name, runs[0], runs[i], i, ticks[i - 1]));
  }
  comparison.runs = std::move(runs);
  return comparison;
}

}  // namespace fingerpad
