#pragma once

#include <string>

#include "study/report.hpp"
#include "study/study.hpp"

namespace fingerpad {

/// The parts of study_contact; each adds its tables and charts.
void study_contact_accuracy(StudyReport& report, const StudyProgress& progress);
/// @param folder  see load_exact_set, whose Error it throws
void study_contact_exact(StudyReport& report, const std::string& folder, const StudyProgress& progress);
void study_contact_strikes(StudyReport& report);

}  // namespace fingerpad
