#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "replay/trace_comparison.hpp"

namespace fingerpad {

/// A job whose results differ.
struct ChangedJob {
  /// "s-0003.h5 (plate.stl, law dahl)"; with "; now plate.stl, law lugre" where the folders' jobs are others.
  std::string job;
  std::vector<JobChange> changes;
  /// The greatest difference of a column in newtons; infinite where one folder alone has the job, or it ended
  /// otherwise: what is looked at first.
  double force_n = 0;
  /// "is in OUT_A alone" of a job of one folder alone; empty where both have it.
  std::string alone;
};

/// How much differs between the results of two runs.
struct FolderComparison {
  std::size_t traces = 0;   ///< looked at, in either folder
  std::size_t jobs = 0;     ///< looked at in the summaries, where there is no trace
  std::size_t changed = 0;  ///< of those
  /// Jobs that were told: those, and where there are traces those of another status.
  std::size_t differing = 0;
  std::size_t notes = 0;  ///< told of what is no change
  /// Traces that were read and end early: "DIR/s-0003.csv: ends within a row (line 12); ...".
  std::vector<std::string> early_ends = {};
  std::vector<std::string> damaged = {};      ///< those that could not be read: which and why
  std::vector<std::string> passed_over = {};  ///< passed_over_words() of both folders
};

/// Compares the traces of two folders by their names: those that only one has, the columns that differ and by
/// how much, and the jobs whose status in summary.csv differs. A job is told once: one that failed in one
/// folder by its status, not by the trace that it lacks. Rows are set against each other by their time,
/// so that a trace of every tenth tick goes with a whole one, and an HDF5 trace with one as CSV, where the
/// folders are of these. Whole files whose bytes are equal are not read further; a trace that cannot be read
/// is a change of its job, alike on both sides too.
/// @param tolerance   what a column may differ by, in its own unit; nan is equal to nan alone
/// @param on_changed  told each job that differs, as it is found: they may be many
/// Throws Error (refused) for a folder that cannot be read; and where one has no trace and
/// they have not both a summary.
FolderComparison compare_folders(const std::string& folder_a, const std::string& folder_b, double tolerance,
                                 const std::function<void(ChangedJob&&)>& on_changed);

}  // namespace fingerpad
