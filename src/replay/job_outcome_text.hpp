#pragma once

#include <string>
#include <vector>

#include "replay/batch.hpp"

namespace fingerpad {

/// How a job ended, as one line that take_outcome() takes: how ranks tell one another.
std::string outcome_text(const BatchJob& job, std::size_t index);

/// Takes an outcome into the job that it is of. What is no outcome of one of these jobs is left out.
void take_outcome(std::vector<BatchJob>& jobs, const std::string& text);

}  // namespace fingerpad
