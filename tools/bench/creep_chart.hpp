#pragma once

#include "creep_runs.hpp"

namespace fingerpad::bench {

/// How the block moves under a held push, and how fast it still does at the end.
Chart creep_chart(const std::vector<CreepFindings>& findings);

/// All figures, a row a program, as CSV.
std::string creep_csv(const std::vector<CreepFindings>& findings);

/// The README's table.
std::string creep_table(const std::vector<CreepFindings>& findings);

}  // namespace fingerpad::bench
