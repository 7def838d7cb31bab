#pragma once

#include <string>

#include "study/block_draws.hpp"
#include "study/cleaning_settings.hpp"

namespace CLI {
class App;
}

namespace fingerpad {

/// How `fit` is told to make measurements clean and to draw its intervals, as on the command line.
struct CleaningOptions {
  double fill_ms = 20, smoothing_hz = 0;
  std::string mains = "any", delay = "found", blocks = "trials", spring_load = "found";
  double light_percent = 25;
  bool no_tare = false;
};

void add_cleaning_options(CLI::App& command, CleaningOptions& options);

/// Throws Error (usage) for a delay that is none.
CleaningSettings cleaning_settings(const CleaningOptions& options);
Blocks blocks_of(const CleaningOptions& options);

}  // namespace fingerpad
