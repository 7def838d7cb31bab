#pragma once

#include <string>

#include "base/checksum.hpp"

namespace fingerpad {

/// What a file's seal says. A seal is 32 bytes behind the contents: a mark, their length and their checksum.
/// HDF5 does not look behind its own end, so that a sealed trace is an HDF5 file like any other; what changes
/// it drops the seal.
enum class Seal {
  none,    ///< not sealed: cut short, or changed by another tool
  whole,   ///< the contents are those that were sealed
  broken,  ///< they are not
};

/// Appends the seal to a finished file. Throws Error (fault).
/// @returns the sum of the file with its seal
FileSum seal_file(const std::string& path);

/// Reads the whole file. Throws Error (refused) if it cannot be read.
Seal check_seal(const std::string& path);

/// Whether a seal stands at the file's end, and names the length that the file has: by its last bytes alone.
bool ends_with_seal(const std::string& path);

}  // namespace fingerpad
