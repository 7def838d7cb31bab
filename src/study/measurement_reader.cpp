#include "study/measurement_reader.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "study/measurement_hdf5.hpp"
#include "study/measurement_table.hpp"

namespace fingerpad {
namespace {

constexpr MeasurementReader reader_rows[] = {
    {"hdf5", "HDF5 with a dataset a column, called as those of a table; traces too", is_measured_hdf5,
     read_measured_hdf5},
    {"table", "a CSV table", nullptr, read_measured_table},
};

const MeasurementReader& reader_of(const std::string& path) {
  for (const MeasurementReader& row : reader_rows)
    if (row.recognises != nullptr && row.recognises(path)) return row;
  return reader_rows[std::size(reader_rows) - 1];
}

}  // namespace

std::span<const MeasurementReader> measurement_readers() noexcept {
  return reader_rows;
}

const MeasurementReader* find_measurement_reader(std::string_view name) noexcept {
  for (const MeasurementReader& row : reader_rows)
    if (row.name == name) return &row;
  return nullptr;
}

RecordedMeasurement read_measurements(const std::vector<std::string>& paths, const MeasurementFormat& format,
                                      std::string_view reader) {
  RecordedMeasurement measurement;
  for (const std::string& path : paths) {
    const MeasurementReader* named = find_measurement_reader(reader);
    (named != nullptr ? *named : reader_of(path)).read(path, format, measurement);
  }
  return measurement;
}

}  // namespace fingerpad
