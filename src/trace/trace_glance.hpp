#pragma once

#include <string>

namespace fingerpad {

/// Whether a trace begins and ends as its writer leaves one, by a few of its bytes: the header of a CSV is a
/// trace's and its last row has its line end; the seal of an HDF5 file names its length. Damage in between is
/// not seen. Where this is false, only read_trace() can tell what is wrong: perhaps nothing, for other tools
/// leave no seal.
bool looks_whole(const std::string& path);

/// Whether an HDF5 file is another program's: it can be read, says of no scene, and lacks a column that every
/// trace has. A child process looks (read_trace). False for what is damaged, which may have been a trace.
bool is_foreign_hdf5(const std::string& path);

}  // namespace fingerpad
