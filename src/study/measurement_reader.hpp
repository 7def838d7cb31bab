#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/measurement_format.hpp"
#include "study/recorded_trial.hpp"

namespace fingerpad {

/// One row of the table of readers: a layout in which measurements come.
struct MeasurementReader {
  std::string_view name;     ///< as --reader names it
  std::string_view summary;  ///< what it reads, in a line
  /// Whether a path is surely in this layout, so that it needs no name; nullptr: never unnamed.
  bool (*recognises)(const std::string& path);
  /// Adds the path's trials, notes and warnings. Throws Error (refused, `file:line`).
  std::function<void(const std::string& path, const MeasurementFormat& format, RecordedMeasurement& into)>
      read;
};

/// All readers; the last takes what no other recognises.
std::span<const MeasurementReader> measurement_readers() noexcept;
/// The row of a name; nullptr if there is none.
const MeasurementReader* find_measurement_reader(std::string_view name) noexcept;

/// Reads measurements.
/// @param reader  a row's name; empty: each path's own, as it is recognised
RecordedMeasurement read_measurements(const std::vector<std::string>& paths, const MeasurementFormat& format,
                                      std::string_view reader = {});

}  // namespace fingerpad
