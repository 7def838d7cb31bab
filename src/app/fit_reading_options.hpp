#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/measurement_format.hpp"

namespace CLI {
class App;
}

namespace fingerpad {

/// How `fit` is told to read its files, as on the command line.
struct ReadingOptions {
  std::string positions;  ///< a table of positions with a clock of their own; empty: none
  std::string reader, unit, time_unit, force_unit, torque_unit, separator, decimal = ".", force_on = "finger";
  std::vector<std::string> columns;                       ///< KEY=NAME
  std::vector<double> markers, sensor_at, sensor_turned;  ///< none: not given
  std::optional<double> plate_height_m;
  std::vector<std::string> left_out, trial_units;  ///< names of trials; NAME=UNIT
};

void add_reading_options(CLI::App& command, ReadingOptions& options);

/// Throws Error (usage) for what contradicts itself.
MeasurementFormat measurement_format(const ReadingOptions& options);

}  // namespace fingerpad
