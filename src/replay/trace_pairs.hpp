#pragma once

#include <set>
#include <string>
#include <vector>

namespace fingerpad {

/// The traces of one job in two folders, by their file names; one is empty where its folder has none.
struct TracePair {
  std::string a, b;

  const std::string& name() const noexcept { return a.empty() ? b : a; }
  bool are_of_two_formats() const noexcept { return !a.empty() && !b.empty() && a != b; }
};

/// The names of the traces in a folder; not those of other programs' files. Throws Error (refused) where it
/// cannot be read.
std::set<std::string> traces_in(const std::string& folder);

/// Adds the files of a folder that have the name of a trace in the other one and are none themselves: empty,
/// or cut within the header.
void add_damaged(const std::string& folder, const std::set<std::string>& of_other,
                 std::set<std::string>& own);

/// The traces of two folders set side by side by their names, in that order: those of one name; and where
/// each folder has a job in one format alone, and these are not the same, those.
std::vector<TracePair> trace_pairs(const std::set<std::string>& in_a, const std::set<std::string>& in_b);

}  // namespace fingerpad
