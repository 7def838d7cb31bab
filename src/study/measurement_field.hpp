#pragma once

#include "motion/field_format.hpp"
#include "study/measurement_format.hpp"
#include "study/recorded_trial.hpp"

namespace fingerpad {

/// Reads a recording in a published layout as one trial of subject 0, numbered as it comes. What `format`
/// says of columns and units answers what the layout leaves open. One without a force in three directions is
/// told in `without_force`; one that no bare finger made has a warning. Throws Error (refused) as the
/// layout's row.
void read_measured_field(const FieldFormat& layout, const std::string& path, const MeasurementFormat& format,
                         RecordedMeasurement& into);

}  // namespace fingerpad
