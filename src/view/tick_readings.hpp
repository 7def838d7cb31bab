#pragma once

#include <vector>

#include "touch/time_histogram.hpp"
#include "view/overlay.hpp"

namespace fingerpad {

/// How the servo loop keeps its time, as lines of the head-up display.
std::vector<Reading> timing_readings(const ServoTiming& timing);

/// A bar for each length of tick between the shortest and the longest; a single one is still to be seen.
TickBars tick_bars(const TimeCounts& times);

}  // namespace fingerpad
