#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/csv_columns.hpp"
#include "base/unit.hpp"

namespace fingerpad {

/// Columns of a table that have one unit.
struct UnitGroup {
  Quantity quantity = Quantity::time;
  std::vector<std::size_t> columns;  ///< by their place in UnitRow::words
  bool is_said = false;              ///< the user has said the unit, which is `si_per_unit`
  double si_per_unit = 1;
  std::string option;  ///< how that is said, for people: "--unit"; empty: it cannot be said
};

/// The unit that a column's name ends in, in SI, as x_m and tx_n_m of the program's own tables, x_mm, f_mN,
/// X [mm], x/mm (ISO 80000) and "X, mm" of others.
std::optional<double> unit_in_name(Quantity quantity, std::string_view name);

/// What a row of units tells, in SI, by Quantity; nothing where it has no word for it.
using ToldUnits = std::array<std::optional<double>, quantities>;

/// The unit of a group by the row of units; nothing where the row has none for it.
/// Throws Error (refused, at the row) for a word that is no unit of that kind, for units that differ within
/// the group or from what was said, and for one that contradicts the column's own name (x_m below which mm
/// stands).
/// @param names  of the columns, as UnitRow::words has them
std::optional<double> told_unit(const UnitRow& row, const std::vector<std::string_view>& names,
                                const UnitGroup& group);

/// The same, where a column's own name may say its unit: one named x_mm is not to be taken for metres because
/// nobody said a unit. Throws Error also (refused, at `path`) where the row has none for the group, and none
/// is said, for a name that says another unit than the group's, and for a unit that is not known.
std::optional<double> told_unit_or_ask(const std::string& path, const UnitRow& row,
                                       const std::vector<std::string_view>& names, const UnitGroup& group);

/// "units as the line below its header has them: a time is 0.001 s, a force 9.80665 N", for people; empty
/// where the row tells none.
std::string told_units_words(const ToldUnits& told, UnitSource source = UnitSource::line);

}  // namespace fingerpad
