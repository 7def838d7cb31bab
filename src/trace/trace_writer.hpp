#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "base/checksum.hpp"
#include "touch/time_histogram.hpp"
#include "trace/trace.hpp"

namespace fingerpad {

enum class TraceFormat { hdf5, csv };

/// Writes a trace row by row. Rows are gathered in blocks; a block is written and flushed when full and on
/// flush(). HDF5 writers of one process take turns (the library is not thread-safe), so any number may be
/// open.
class TraceWriter {
 public:
  /// Starts a new file (an older one is replaced). Throws Error, with the path, if it cannot be
  /// created: usage where the name leads to no place for it, fault where the disk refuses.
  /// @param world  parts of at most 100,000 triangles are embedded, so that the trace can be seen without its
  /// meshes
  /// @param rows_to_come  how many rows the trace will have, 0 where nobody knows: it is written in chunks
  /// that fit
  static std::unique_ptr<TraceWriter> create(const std::string& path, TraceFormat format,
                                             const TraceInfo& info, const World& world,
                                             std::uint64_t rows_to_come = 0);
  virtual ~TraceWriter() = default;
  /// Throws Error (fault) when the disk refuses.
  virtual void append(std::span<const TickRecord> rows) = 0;
  /// Everything appended so far can be read back even if the process is killed now.
  virtual void flush() = 0;
  /// Changes of the scene beyond those of the info, in order of time; flushed with the rows. Throws as
  /// append.
  virtual void note_changes(std::span<const SceneChange> /*changes*/) {}
  /// How the loop that made the rows kept its time, for the file's attributes; CSV has no place for it.
  virtual void note_timing(const ServoTiming& /*timing*/) {}
  /// Marks the trace complete and closes it. Without this it reads as cut short.
  /// @returns the sum of the whole file as it was written
  virtual FileSum finish() = 0;
};

}  // namespace fingerpad
