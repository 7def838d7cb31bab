#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fingerpad/finger.hpp"

namespace fingerpad {

/// Writes the ticks of a finger to a trace, HDF5 or CSV, that can be viewed, plotted and replayed. It keeps
/// the parts of up to 100,000 triangles, so that the trace can be seen without their meshes. Not for a servo
/// thread: it waits for the disk.
class TraceRecorder {
 public:
  /// Starts a new file; an older one is replaced. Throws Error: usage for an ending other than .h5 and .csv,
  /// fault where the disk refuses.
  TraceRecorder(const std::string& path, const Finger& finger);
  /// Without finish() the trace stays behind as one that was cut short.
  ~TraceRecorder();
  TraceRecorder(const TraceRecorder&) = delete;
  TraceRecorder& operator=(const TraceRecorder&) = delete;

  /// Adds a tick. Throws Error (fault) where the disk refuses.
  void append(const TickRecord& record);
  /// What was added can be read back even if the program is killed now. Throws as `append`.
  void flush();
  /// Marks the trace complete and closes it. Throws as `append`.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A trace as it was read.
struct TraceFile {
  std::vector<TickRecord> rows;  ///< one a tick
  bool complete = true;          ///< false: the recording was cut short
  double rate_hz = 0;            ///< ticks a second; 0 where the file does not say (CSV)
  std::string scene_name;        ///< as in the scene; may be empty
  std::string scene_text;        ///< the scene as TOML; empty where there was none
};

/// Reads a trace, HDF5 or CSV, of this library or of the program. Throws Error (refused) for a file that is
/// neither or is damaged; it may come from anyone.
TraceFile read_trace_file(const std::string& path);

}  // namespace fingerpad
