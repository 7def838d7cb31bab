#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fingerpad {

/// Columns picked from an HDF5 file that need not be a trace.
struct Hdf5Columns {
  std::vector<bool> present;                 ///< per asked-for name
  std::vector<std::vector<double>> columns;  ///< per asked-for name; empty where absent
  std::vector<std::string> units;   ///< per asked-for name: its attribute unit, or units; empty: it has none
  bool is_trace = false;            ///< of this program: it keeps its scene
  std::string scene_text;           ///< the scene that a trace keeps; empty where there is none
  std::vector<std::string> chosen;  ///< of a trace: the columns alone that it was written with; else none
  std::uint64_t every = 1;          ///< of a trace: its rows are every so manieth tick
};

/// How many times its own size an HDF5 file may unfold to whose columns are all compressed: columns of zeros
/// and ones shrink to nothing, but of the 26 that a measurement may have three positions and three forces
/// are noisy, and a number of eight bytes keeps a good two of them.
inline constexpr std::uint64_t most_unfolded = 32;

/// Reads datasets of N numbers (or N x 1, 1 x N) at a file's root. The file is read by a child process, as
/// read_trace does it. Throws Error (refused) for one that keeps anything outside of itself, for columns that
/// differ in length, for a unit that is no text, and where columns that are all compressed unfold to more
/// than most_unfolded times the file. (Where the first is not, its bytes bound the rows of the others.)
Hdf5Columns read_hdf5_columns(const std::string& path, const std::vector<std::string>& names);

/// "it holds pos (500 x 3), the group run1 with t_s (500), and 40 more": the first things in an HDF5 file and
/// in its groups, for who looks for something else. Read by a child process too; nothing outside of the file
/// is opened. Throws Error (refused) where the file cannot be read.
std::string read_hdf5_contents(const std::string& path);

}  // namespace fingerpad
