#include "study/measurement_reader.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "study/measurement_field.hpp"
#include "study/measurement_hdf5.hpp"
#include "study/measurement_table.hpp"
#include "trace/trace.hpp"

namespace fingerpad {
namespace {

/// Those of the program's own kinds, and between them the layouts that recordings of a motion have too.
std::vector<MeasurementReader> reader_rows() {
  std::vector<MeasurementReader> rows;
  rows.push_back({"hdf5", "HDF5 with a dataset a column, called as those of a table; traces too",
                  is_measured_hdf5, read_measured_hdf5});
  for (const FieldFormat& layout : field_formats()) {
    rows.push_back(
        {layout.name, layout.summary, nullptr,
         [&layout](const std::string& path, const MeasurementFormat& format, RecordedMeasurement& into) {
           read_measured_field(layout, path, format, into);
         }});
  }
  rows.push_back({"table", "a CSV table", nullptr, read_measured_table});
  return rows;
}

const MeasurementReader& reader_of(const std::string& path) {
  refuse_false_hdf5(path);
  for (const MeasurementReader& row : measurement_readers())
    if (row.recognises != nullptr && row.recognises(path)) return row;
  return measurement_readers().back();
}

}  // namespace

std::span<const MeasurementReader> measurement_readers() noexcept {
  static const std::vector<MeasurementReader> rows = reader_rows();
  return rows;
}

const MeasurementReader* find_measurement_reader(std::string_view name) noexcept {
  for (const MeasurementReader& row : measurement_readers())
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
