#include "motion/open_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/csv_columns.hpp"
#include "base/error.hpp"

namespace fingerpad {
namespace {

/// What a unit of each quantity is in SI; 0: neither published nor said.
struct OpenUnits {
  std::array<double, quantities> si{1, 0, 1, 0, 0};  ///< by Quantity
  ToldUnits told;                                    ///< by the table itself
  double& of(Quantity quantity) { return si[static_cast<std::size_t>(quantity)]; }
};

OpenUnits known_units(const RecordingFormat& format, const OpenLayout& layout) {
  OpenUnits units;
  if (format.says_time_unit) units.of(Quantity::time) = format.seconds_per_unit;
  if (format.says_force_unit) units.of(Quantity::force) = format.newtons_per_unit;
  units.of(Quantity::length) = format.says_unit ? format.metres_per_unit : layout.metres_per_unit;
  units.of(Quantity::torque) =
      format.says_torque_unit ? format.newton_metres_per_unit : layout.newton_metres_per_unit;
  return units;
}

/// The units that stand in a line below the header, or are known else. Throws Error (refused) with the
/// question where neither is.
OpenUnits table_units(const std::string& path, const RecordingFormat& format, const OpenLayout& layout,
                      const std::vector<std::string_view>& keys, const CsvRequest& request,
                      const UnitRow& row) {
  constexpr std::string_view options[] = {"time_unit (--time-unit)", "unit (--unit)",
                                          "force_unit (--force-unit)", "--torque-unit", ""};
  constexpr std::string_view open[] = {
      "", "the unit of its positions: say unit = \"mm\" (or m, cm, in, um) in [motion], or --unit", "",
      "the unit of its torques: say --torque-unit", "the unit of its positions: say --unit"};
  const bool is_said[] = {format.says_time_unit, format.says_unit, format.says_force_unit,
                          format.says_torque_unit, false};
  OpenUnits units = known_units(format, layout);
  for (const Quantity quantity :
       {Quantity::time, Quantity::length, Quantity::force, Quantity::torque, Quantity::speed}) {
    const auto q = static_cast<std::size_t>(quantity);
    // A speed is in the unit of positions, a second, unless its own word says another.
    if (quantity == Quantity::speed) units.of(quantity) = units.of(Quantity::length);
    UnitGroup group{quantity, {}, is_said[q], units.of(quantity), std::string(options[q])};
    for (std::size_t k = 0; k < keys.size(); ++k)
      if (quantity_of(keys[k]) == quantity) group.columns.push_back(k);
    units.told[q] = told_unit(row, request.required, group);
    units.of(quantity) = units.told[q].value_or(group.si_per_unit);
    if (!group.columns.empty() && !(units.of(quantity) > 0))
      throw refused(path,
                    fmt::format("the published description of {} does not say {}", layout.format, open[q]));
  }
  return units;
}

}  // namespace

std::size_t recording_column_place(std::string_view key) noexcept {
  const auto found = std::find_if(recording_columns.begin(), recording_columns.end(),
                                  [key](const RecordingColumn& column) { return column.key == key; });
  return static_cast<std::size_t>(found - recording_columns.begin());
}

std::string_view named_column(const RecordingFormat& format, std::string_view key) {
  if (key == "speed") return format.speed_header;
  if (key.front() == 't' && key.size() == 2)
    return format.torque_headers[static_cast<std::size_t>(key[1] - 'x')];
  return format.headers[recording_column_place(key)];
}

Quantity quantity_of(std::string_view key) {
  if (key == "speed") return Quantity::speed;
  if (key == "t") return Quantity::time;
  if (key.front() == 'f') return Quantity::force;
  return key.front() == 't' ? Quantity::torque : Quantity::length;
}

ClockedValues clocked_columns(const std::string& path, const RecordingFormat& format,
                              const OpenLayout& layout, const std::vector<std::string_view>& wanted,
                              std::string what, FieldRecording& recording) {
  std::vector<std::string_view> keys{"t"};
  keys.insert(keys.end(), wanted.begin(), wanted.end());
  CsvRequest request;
  request.dialect = format.dialect;
  request.takes_units = request.takes_lines_above = true;
  request.mark_mend = separator_mend;
  request.decimal_key = "decimal = \"{0}\" in [motion] (fit: --decimal {0})";
  for (const std::string_view key : keys) request.required.push_back(named_column(format, key));
  const CsvColumns table = read_csv_columns(path, request);
  if (table.lines.empty()) throw refused(path, "has a header but no rows");
  OpenUnits units = table_units(path, format, layout, keys, request, table.units);
  for (std::size_t q = 0; q < quantities; ++q)
    if (units.told[q]) recording.told_units[q] = units.told[q];
  for (const std::string& words : {table.above, told_units_words(units.told)})
    if (!words.empty())
      recording.notes.push_back(format.positions_path.empty() ? words : fmt::format("{}: {}", what, words));
  ClockedValues read{std::move(what), table.columns.front(), {}};
  for (double& t_s : read.t_s) t_s *= units.of(Quantity::time);
  read.values.resize(static_cast<Eigen::Index>(wanted.size()), static_cast<Eigen::Index>(read.t_s.size()));
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    read.values.row(static_cast<Eigen::Index>(k)) =
        units.of(quantity_of(wanted[k])) *
        Eigen::Map<const Eigen::RowVectorXd>(table.columns[k + 1].data(),
                                             static_cast<Eigen::Index>(read.t_s.size()));
  }
  return read;
}

}  // namespace fingerpad
