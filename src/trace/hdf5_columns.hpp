#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fingerpad {

/// Columns picked from an HDF5 file that need not be a trace.
struct Hdf5Columns {
  std::vector<bool> present;                 ///< per asked-for name
  std::vector<std::vector<double>> columns;  ///< per asked-for name; empty where absent
  std::string scene_text;                    ///< the scene that a trace keeps; empty where there is none
  std::vector<std::string> chosen;  ///< of a trace: the columns alone that it was written with; else none
  std::uint64_t every = 1;          ///< of a trace: its rows are every so manieth tick
};

/// Reads datasets of N numbers (or N x 1, 1 x N) at a file's root. The file is read by a child process, as
/// read_trace does it. Throws Error (refused) for one that keeps anything outside of itself, for columns that
/// differ in length, and where the first of `names` that is there is compressed: its bytes bound the rows
/// that the others, shuffled and deflated or not, unfold to.
Hdf5Columns read_hdf5_columns(const std::string& path, const std::vector<std::string>& names);

/// "it holds pos (500 x 3), the group run1 with t_s (500), and 40 more": the first things in an HDF5 file and
/// in its groups, for who looks for something else. Read by a child process too; nothing outside of the file
/// is opened. Throws Error (refused) where the file cannot be read.
std::string read_hdf5_contents(const std::string& path);

}  // namespace fingerpad
