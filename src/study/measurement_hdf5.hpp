#pragma once

#include "study/measurement_format.hpp"
#include "study/recorded_trial.hpp"

namespace fingerpad {

/// Reads an HDF5 file with a one-dimensional dataset a column at its root, called and understood as the
/// columns of a table (measurement_columns). A trace of the program is one: where the finger does not turn,
/// its direction is that of the scene which the trace keeps. Throws Error (refused) as read_hdf5_columns and
/// read_measured_table.
void read_measured_hdf5(const std::string& path, const MeasurementFormat& format, RecordedMeasurement& into);

/// Whether it is an HDF5 file.
bool is_measured_hdf5(const std::string& path);

}  // namespace fingerpad
