#include "study/measured_units.hpp"

#include <initializer_list>
#include <utility>

#include "study/measured_row.hpp"

namespace fingerpad {

ToldUnits take_measured_units(const std::string& path, const UnitRow& row,
                              const std::vector<std::string_view>& names,
                              const std::vector<std::size_t>& places, MeasurementFormat& format) {
  ToldUnits told;
  const auto take = [&](Quantity quantity, std::initializer_list<std::pair<MeasuredColumn, std::size_t>> runs,
                        bool is_said, double& si_per_unit, const char* option) {
    UnitGroup group{quantity, {}, is_said, si_per_unit, option};
    for (std::size_t k = 0; k < places.size(); ++k) {
      for (const auto& [first, count] : runs) {
        const auto place = static_cast<std::size_t>(first);
        if (places[k] >= place && places[k] < place + count) group.columns.push_back(k);
      }
    }
    told[static_cast<std::size_t>(quantity)] = told_unit_or_ask(path, row, names, group);
    si_per_unit = told[static_cast<std::size_t>(quantity)].value_or(si_per_unit);
  };
  using enum MeasuredColumn;
  take(Quantity::time, {{time, 1}}, format.says_time_unit, format.seconds_per_unit, "--time-unit");
  take(Quantity::length, {{x, 3}, {marker_1, 3}, {marker_2, 3}}, format.says_unit, format.metres_per_unit,
       "--unit");
  take(Quantity::force, {{fx, 3}, {fn, 1}}, format.says_force_unit, format.newtons_per_unit, "--force-unit");
  take(Quantity::torque, {{torque, 3}}, format.says_torque_unit, format.newton_metres_per_unit,
       "--torque-unit");
  return told;
}

}  // namespace fingerpad
