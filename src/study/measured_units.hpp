#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "base/unit_row.hpp"
#include "study/measurement_format.hpp"

namespace fingerpad {

/// Takes the units that a table names into `format`, and tells them.
/// @param names   of the columns, as UnitRow::words has them
/// @param places  of the same columns, in measurement_columns
/// Throws Error (refused) as told_unit_or_ask.
ToldUnits take_measured_units(const std::string& path, const UnitRow& row,
                              const std::vector<std::string_view>& names,
                              const std::vector<std::size_t>& places, MeasurementFormat& format);

}  // namespace fingerpad
