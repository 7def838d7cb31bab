#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fingerpad {

/// What differs between the results of two runs.
struct FolderComparison {
  std::vector<std::string> changes;  ///< a line each, by job and column
  std::size_t traces = 0;            ///< looked at, in either folder
  std::size_t jobs = 0;              ///< looked at in the summaries, where there is no trace
  std::size_t changed = 0;           ///< of those
};

/// Compares the traces of two folders by their names: those that only one has, the columns that differ and by
/// how much, and the jobs whose status in summary.csv differs. Files whose bytes are equal are not read
/// further.
/// @param tolerance  what a column may differ by, in its own unit; nan is equal to nan alone
/// Throws Error (refused) for a folder that cannot be read and as read_trace; and where neither has a trace
/// and one no summary.
FolderComparison compare_folders(const std::string& folder_a, const std::string& folder_b, double tolerance);

}  // namespace fingerpad
