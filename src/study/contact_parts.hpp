#pragma once

#include "study/contact_exact_set.hpp"
#include "study/report.hpp"
#include "study/studies.hpp"

namespace fingerpad {

/// The parts of study_contact; each adds its tables and charts.
void study_contact_accuracy(StudyReport& report, int most_levels, const StudyProgress& progress);
void study_contact_exact(StudyReport& report, const ExactSet& set, const StudyProgress& progress);
void study_contact_strikes(StudyReport& report);
void study_contact_auto(StudyReport& report, const ContactExtent& extent, const StudyProgress& progress);

}  // namespace fingerpad
