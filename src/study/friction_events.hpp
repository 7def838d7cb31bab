#pragma once

#include "study/report.hpp"

namespace fingerpad {

/// What looking for rupture and restick between ticks is worth: both readings of `[friction] events` side by
/// side, on a slow drag, whose sawtooth is known exactly, and on a rub, against 128 kHz.
void study_events(StudyReport& report);

}  // namespace fingerpad
