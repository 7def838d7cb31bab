#pragma once

#include <string>

#include "motion/motion.hpp"

namespace fingerpad {

/// Reads a recording from an HDF5 file with a one-dimensional dataset a column at its root, called and
/// understood as the columns of a table (read_motion_csv); an attribute `unit` (or `units`) of a dataset is
/// read as a table's line of units. The file is read by a child process, as read_trace does it.
/// @param format  given the units that the file has
/// Throws Error (refused) as read_hdf5_columns and read_motion_csv; for a separator, a decimal mark, a
/// published layout's name and a second file of positions, which are of tables of text.
Motion read_motion_hdf5(const std::string& path, RecordingFormat& format);

/// Whether an HDF5 file is none of this program's traces, and so a table of somebody's own.
/// Throws Error (refused) where it cannot be read.
bool is_hdf5_table(const std::string& path);

}  // namespace fingerpad
