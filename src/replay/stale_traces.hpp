#pragma once

#include <string>
#include <vector>

#include "replay/batch.hpp"

namespace fingerpad {

/// Traces in the output folder that replays of the batch's sets have left, and that none of its jobs writes:
/// the set had more jobs then, or traces of another format. They stay, and whoever takes the folder for what
/// the summary tells is to know. One line; empty where there are none.
std::string words_of_stale_traces(const std::vector<BatchJob>& jobs, const BatchOptions& options);

}  // namespace fingerpad
