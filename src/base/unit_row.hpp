#pragma once

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

/// The unit of a group by the row of units; that of the group where the row has none for it.
/// Throws Error (refused, at the row) for a word that is no unit of that kind, for units that differ within
/// the group or from what was said, and for one that contradicts the column's own name (x_m below which mm
/// stands).
/// @param names  of the columns, as UnitRow::words has them
double unit_of_group(const UnitRow& row, const std::vector<std::string_view>& names, const UnitGroup& group);

}  // namespace fingerpad
