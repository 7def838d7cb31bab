#include "view/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "touch/tick_record.hpp"

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

std::vector<std::string> usual_columns(const std::vector<ComparedRun>& runs) {
  constexpr std::size_t most = 4;
  for (const std::vector<std::string>& wanted :
       {std::vector<std::string>{"fn_n", "friction", "mu"}, {"fn_n", "fx_n", "fy_n", "fz_n"}}) {
    std::vector<std::string> have;
    for (const std::string& name : wanted) {
      if (all_have(runs, name)) have.push_back(name);
    }
    if (have.size() == wanted.size() || (wanted.size() == most && !have.empty())) return have;
  }
  std::vector<std::string> have;
  for (const ComparedColumn& column : runs.front().columns) {
    if (have.size() < most && all_have(runs, column.name)) have.push_back(column.name);
  }
  if (!have.empty()) return have;
  throw refused(runs.back().path,
                fmt::format("has no column in common with {}: {} there, {} here", runs.front().path,
                            names_in(runs.front()), names_in(runs.back())));
}

/// The value at x, linearly between the ticks beside it. @pre x lies within the run
double value_at(const std::vector<double>& x_of, const std::vector<double>& values, double x) {
  const auto after = std::lower_bound(x_of.begin(), x_of.end(), x);
  const auto i = static_cast<std::size_t>(after - x_of.begin());
  if (i == x_of.size()) return values.back();
  if (x_of[i] == x || i == 0) return values[i];
  const double share = (x - x_of[i - 1]) / (x_of[i] - x_of[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

/// Where two runs are compared.
struct CommonTicks {
  double from = 0, to = 0;
  const ComparedRun* grid = nullptr;     ///< whose ticks serve
  const ComparedRun* between = nullptr;  ///< that is interpolated
};

long ticks_within(const ComparedRun& run, double from, double to) {
  return std::upper_bound(run.x.begin(), run.x.end(), to) -
         std::lower_bound(run.x.begin(), run.x.end(), from);
}

CommonTicks common_ticks(const ComparedRun& first, const ComparedRun& other, Over over) {
  const CommonTicks none;
  if (first.x.empty() || other.x.empty())
    throw refused(first.x.empty() ? first.path : other.path, "holds no tick");
  CommonTicks ticks{std::max(first.x.front(), other.x.front()), std::min(first.x.back(), other.x.back()),
                    nullptr, nullptr};
  if (!(ticks.to >= ticks.from)) {
    throw refused(other.path,
                  fmt::format("has no {} in common with {}: {:.6g} to {:.6g} here, {:.6g} to {:.6g} there",
                              over == Over::time ? "time" : "way", first.path, other.x.front(),
                              other.x.back(), first.x.front(), first.x.back()));
  }
  const bool first_is_finer =
      ticks_within(first, ticks.from, ticks.to) > ticks_within(other, ticks.from, ticks.to);
  ticks.grid = first_is_finer ? &other : &first;
  ticks.between = first_is_finer ? &first : &other;
  return ticks;
}

/// What of a column is laid over another run: of one that left out ticks, what such ticks tell.
const std::vector<double>& compared_values(const ComparedRun& run, const std::string& name,
                                           const ComparedRun& other) {
  const ComparedColumn& column = *column_of(run, name);
  return other.every > run.every && !column.thinned.empty() ? column.thinned : column.values;
}

Residual residual_of(const std::string& name, const ComparedRun& first, const ComparedRun& other,
                     std::size_t run, const CommonTicks& ticks) {
  const std::vector<double>&a = compared_values(first, name, other), &b = compared_values(other, name, first);
  Residual residual{run, name, column_of(first, name)->unit, {}, {}, 0};
  double squares = 0, count = 0;
  for (const double x : ticks.grid->x) {
    if (x < ticks.from || x > ticks.to) continue;
    const double left = value_at(other.x, b, x) - value_at(first.x, a, x);
    residual.x.push_back(x);
    residual.values.push_back(left);
    if (!std::isfinite(left)) continue;
    squares += left * left;
    ++count;
  }
  residual.rms = count > 0 ? std::sqrt(squares / count) : TickRecord::nan;
  return residual;
}

/// Whether both have all ticks at which they are compared, so that nothing is interpolated.
bool are_shared(const CommonTicks& ticks) {
  return std::all_of(ticks.grid->x.begin(), ticks.grid->x.end(), [&](double x) {
    return x < ticks.from || x > ticks.to ||
           std::binary_search(ticks.between->x.begin(), ticks.between->x.end(), x);
  });
}

std::string note_on(const ComparedRun& first, const ComparedRun& other, const CommonTicks& ticks, Over over) {
  const char* unit = over == Over::time ? "s" : over == Over::travel ? "mm" : "deg";
  const std::string span = fmt::format("{}: {:.4g} to {:.4g} {}", other.name, ticks.from, ticks.to, unit);
  if (first.x == other.x) return span;
  if (ticks.grid == &other)
    return span + ", at its own ticks" + (are_shared(ticks) ? "" : ", the first interpolated linearly");
  return span + (are_shared(ticks) ? ", at the ticks of the first"
                                   : ", interpolated linearly at the ticks of the first");
}

}  // namespace

Comparison compare_runs(std::vector<ComparedRun> runs, const std::vector<std::string>& columns, Over over) {
  Comparison comparison;
  name_apart(runs);
  comparison.columns = columns.empty() ? usual_columns(runs) : columns;
  for (const std::string& name : comparison.columns) {
    for (const ComparedRun& run : runs) {
      if (column_of(run, name) == nullptr)
        throw refused(run.path, fmt::format("has no column '{}'; it has {}", name, names_in(run)));
    }
  }
  if (runs.size() > 1) comparison.notes.push_back("residuals: less the first, " + runs[0].name);
  if (std::find(comparison.columns.begin(), comparison.columns.end(), "friction") != comparison.columns.end())
    comparison.notes.push_back(
        "friction: along the sliding direction, negative where it holds the finger back");
  std::vector<CommonTicks> ticks;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    ticks.push_back(common_ticks(runs[0], runs[i], over));
    comparison.notes.push_back(note_on(runs[0], runs[i], ticks.back(), over));
  }
  for (const std::string& name : comparison.columns) {
    for (std::size_t i = 1; i < runs.size(); ++i)
      comparison.residuals.push_back(residual_of(name, runs[0], runs[i], i, ticks[i - 1]));
  }
  comparison.runs = std::move(runs);
  return comparison;
}

}  // namespace fingerpad
