#pragma once

#include "study/measurement_format.hpp"
#include "study/recorded_trial.hpp"

namespace fingerpad {

/// Reads a CSV table: a column a quantity as measurement_columns has them, a row a moment. Time, place and,
/// where known, force, the plate's normal (default 0,0,1), the finger's direction, `subject` and `trial`
/// (whole numbers). A trial is a run of rows of one subject and trial. Cells that are empty or nan are
/// missing samples. Throws Error (refused) as read_csv_columns, and where times do not increase within a
/// trial, or normals or directions have no length.
void read_measured_table(const std::string& path, const MeasurementFormat& format, RecordedMeasurement& into);

}  // namespace fingerpad
