#include "motion/recorded_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <optional>
#include <utility>

#include "base/printable_text.hpp"

namespace fingerpad {
namespace {

bool is_required(const RecordingFormat& format, std::size_t column) {
  if (!format.headers[column].empty() || column < place_of_dx) return true;
  if (column == place_of_fn) return format.reads_normal_force;
  if (column == place_of_subject) return format.subject.has_value();
  return column == place_of_trial && format.trial.has_value();
}

/// The rows of one subject and one trial, where those are asked for.
void keep_one_trial(const RecordingFormat& format, RecordedTable& table) {
  if (!format.subject && !format.trial) return;
  const auto is_of = [&table](std::size_t place, const std::optional<int>& wanted, std::size_t row) {
    return !wanted || table.columns[place][row] == *wanted;
  };
  std::size_t kept = 0;
  for (std::size_t row = 0; row < table.lines.size(); ++row) {
    if (!is_of(place_of_subject, format.subject, row) || !is_of(place_of_trial, format.trial, row)) continue;
    for (std::vector<double>& column : table.columns)
      if (!column.empty()) column[kept] = column[row];
    table.lines[kept++] = table.lines[row];
  }
  for (std::vector<double>& column : table.columns)
    if (!column.empty()) column.resize(kept);
  table.lines.resize(kept);
  if (kept > 0) return;
  throw refused(table.path, fmt::format("has no row of{}{}",
                                        format.subject ? fmt::format(" subject {}", *format.subject) : "",
                                        format.trial ? fmt::format(" trial {}", *format.trial) : ""));
}

void take_units(const std::string& path, const UnitRow& row, const AskedColumns& asked,
                RecordingFormat& format) {
  const auto unit = [&](Quantity quantity, std::initializer_list<std::size_t> columns, bool is_said,
                        double si_per_unit, const char* option) -> std::optional<double> {
    UnitGroup group{quantity, {}, is_said, si_per_unit, option};
    for (std::size_t k = 0; k < asked.places.size(); ++k)
      if (std::find(columns.begin(), columns.end(), asked.places[k]) != columns.end())
        group.columns.push_back(k);
    return told_unit_or_ask(path, row, asked.names, group);
  };
  format.seconds_per_unit =
      unit(Quantity::time, {0}, format.says_time_unit, format.seconds_per_unit, "time_unit in [motion]")
          .value_or(format.seconds_per_unit);
  format.says_time_unit = format.says_time_unit || (!row.words.empty() && !row.words[0].empty());
  format.metres_per_unit = unit(Quantity::length, {place_of_x, place_of_x + 1, place_of_x + 2},
                                format.says_unit, format.metres_per_unit, "unit in [motion]")
                               .value_or(format.metres_per_unit);
  const auto newtons = unit(Quantity::force, {place_of_fx, place_of_fx + 1, place_of_fx + 2, place_of_fn},
                            format.says_force_unit, format.newtons_per_unit, "force_unit in [motion]");
  format.newtons_per_unit = newtons.value_or(format.newtons_per_unit);
  format.says_force_unit = format.says_force_unit || newtons.has_value();
}

}  // namespace

std::string_view header_of(const RecordingFormat& format, std::size_t column) {
  const std::string& named = format.headers[column];
  return named.empty() ? recording_columns[column].header : std::string_view(named);
}

std::vector<std::string> trial_names(const std::vector<std::string>& header) {
  std::vector<std::string> found;
  for (const std::string& name : header) {
    std::string word(trimmed(name));
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (word.starts_with("trial") || word.starts_with("subject")) found.push_back(printable(name, 60));
  }
  return found;
}

AskedColumns asked_columns(const RecordingFormat& format) {
  AskedColumns asked;
  std::vector<std::size_t> optional;
  for (std::size_t k = 0; k < recording_columns.size(); ++k) {
    if (is_required(format, k))
      asked.places.push_back(k);
    else if (k < place_of_fx)
      optional.push_back(k);
  }
  asked.required = asked.places.size();
  asked.places.insert(asked.places.end(), optional.begin(), optional.end());
  for (const std::size_t k : asked.places) asked.names.push_back(header_of(format, k));
  return asked;
}

Error RecordedTable::fault(std::size_t row, const std::string& what) const {
  return refused(fmt::format("{}:{}", path, lines[row]), what);
}

int RecordedTable::count(std::size_t first, std::size_t last) const {
  int there = 0;
  for (std::size_t k = first; k <= last; ++k) there += columns[k].empty() ? 0 : 1;
  return there;
}

Points RecordedTable::points(std::size_t first) const {
  Points p(3, static_cast<Eigen::Index>(columns[first].size()));
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double>& row = columns[first + static_cast<std::size_t>(axis)];
    p.row(axis) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), static_cast<Eigen::Index>(row.size()));
  }
  return p;
}

RecordedTable recorded_table(const std::string& path, std::vector<std::vector<double>> columns,
                             std::vector<long> lines, const AskedColumns& asked, const UnitRow& units,
                             RecordingFormat& format) {
  take_units(path, units, asked, format);
  RecordedTable table{path, std::vector<std::vector<double>>(recording_columns.size()), std::move(lines)};
  if (table.lines.empty())
    throw refused(path,
                  units.source == UnitSource::line ? "has a header but no rows" : "has columns but no rows");
  for (std::size_t k = 0; k < asked.places.size(); ++k)
    table.columns[asked.places[k]] = std::move(columns[k]);
  keep_one_trial(format, table);
  return table;
}

}  // namespace fingerpad
