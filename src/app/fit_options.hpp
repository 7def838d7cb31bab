#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/block_draws.hpp"
#include "study/cleaning_settings.hpp"
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

/// How it is told to make them clean and to draw its intervals.
struct CleaningOptions {
  double fill_ms = 20, smoothing_hz = 0;
  std::string mains = "any", delay = "found", blocks = "trials", spring_load = "found";
  double light_percent = 25;
  bool no_tare = false;
};

void add_reading_options(CLI::App& command, ReadingOptions& options);
void add_cleaning_options(CLI::App& command, CleaningOptions& options);

/// Throw Error (usage) for what contradicts itself.
MeasurementFormat measurement_format(const ReadingOptions& options);
CleaningSettings cleaning_settings(const CleaningOptions& options);
Blocks blocks_of(const CleaningOptions& options);

}  // namespace fingerpad
