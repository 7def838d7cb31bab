#pragma once

#include <string>
#include <vector>

#include "view/compared_run.hpp"

namespace fingerpad {

/// What to warn of where a table's t_s is hardly in seconds, as it must be: of 21 rows or more, under 10 a
/// second, and many times as long as every trace beside it, while in ms, us or ns it would have a recorder's
/// rate and last as long as these. Nothing where no trace stands beside it.
std::vector<std::string> clock_doubts(const std::vector<ComparedRun>& runs);

}  // namespace fingerpad
