#pragma once

#include <set>
#include <string>
#include <vector>

namespace fingerpad {

/// What of a folder of traces is not compared: a line for the files that have a trace's ending and are none,
/// and one for what else is there: "DIR: 2 other files are passed over: notes.txt, p.png". What a replay and
/// a report leave beside the traces is not among them, nor what is hidden.
/// @param traces  names of those that are compared
std::vector<std::string> passed_over_words(const std::string& folder, const std::set<std::string>& traces);

}  // namespace fingerpad
