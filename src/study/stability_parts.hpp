#pragma once

#include "study/report.hpp"

namespace fingerpad {

/// The parts of study_stability; each adds its tables and charts.
void study_walls(StudyReport& report);
void study_buzz(StudyReport& report);
void study_remedies(StudyReport& report);
void study_energy(StudyReport& report);
void study_restick(StudyReport& report);
void study_velocity(StudyReport& report);
void study_undamped_block(StudyReport& report);

}  // namespace fingerpad
