#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/scene_change.hpp"
#include "trace/hdf5_file.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {

// Where a trace keeps the changes that were made while it was touched (scene_changes_text). A trace without
// any has neither of these.

/// In HDF5: the bytes of that text, in a column `changes` that grows.
class Hdf5ChangeLog {
 public:
  void add(const hdf5::Handle& file, std::span<const SceneChange> changes);
  void close() { column_.reset(); }

 private:
  std::optional<hdf5::Handle> column_;
  std::size_t bytes_ = 0;
};

/// The text in an HDF5 trace; empty where it has none.
std::string read_change_log(const hdf5::Handle& file);

/// Beside a CSV: "run.csv" -> "run.changes.csv".
std::string change_file_name(const std::string& csv_path);

/// The text beside a CSV trace; empty where there is none.
std::string read_change_file(const std::string& csv_path);

/// Writes that file. An older one goes when the trace is begun: it tells of another touch.
class ChangeFile {
 public:
  explicit ChangeFile(std::string csv_path);
  void add(std::span<const SceneChange> changes);
  void flush();
  void commit();

 private:
  std::string csv_path_;
  std::unique_ptr<OutputFile> file_;
};

}  // namespace fingerpad
