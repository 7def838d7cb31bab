#pragma once

#include <string>
#include <vector>

#include "study/measurement_format.hpp"

namespace CLI {
class App;
}

namespace fingerpad {

/// How a person says that measurements are to be read.
struct MeasurementOptions {
  std::string reader;                ///< a row of measurement_readers(); empty: as each file is recognised
  std::vector<std::string> columns;  ///< "t=time"
  std::string unit, time_unit, separator = "auto", decimal = ".", force_on = "finger";
  std::string positions;  ///< a table of positions with a clock of their own; empty: none
};

/// Adds the options to a command that reads measurements.
void add_measurement_options(CLI::App& command, MeasurementOptions& options);

/// What they say. Throws Error (usage) for a column that is not of the form KEY=NAME, or whose key is not
/// known.
MeasurementFormat measurement_format(const MeasurementOptions& options);

}  // namespace fingerpad
