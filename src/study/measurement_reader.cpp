#include "study/measurement_reader.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

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

/// Scenes and profiles, which one may well name by mistake, are no tables.
void refuse_toml(const std::string& path) {
  std::error_code none;
  if (!path.ends_with(".toml") || !std::filesystem::is_regular_file(path, none) || is_hdf5(path)) return;
  throw refused(path,
                "is TOML, as scenes and profiles are, and no measurement: name the table of where the finger "
                "was and what force acted on it (CSV or HDF5), as a scene's [motion] has it in `file`; a "
                "profile is what fit writes (--out)");
}

const MeasurementReader& reader_of(const std::string& path) {
  refuse_toml(path);
  refuse_false_hdf5(path);
  for (const MeasurementReader& row : measurement_readers())
    if (row.recognises != nullptr && row.recognises(path)) return row;
  return measurement_readers().back();
}

/// Reads a file. Of a recording that is not finished says so, whatever else is told of it.
void read_one(const MeasurementReader& reader, const std::string& path, const MeasurementFormat& format,
              RecordedMeasurement& into) {
  if (!path.ends_with(".part") || !std::filesystem::exists(path)) return reader.read(path, format, into);
  into.warnings.push_back(fmt::format("{}: {}", path, unfinished_words));
  try {
    reader.read(path, format, into);
  } catch (const Error& error) {
    throw Error(error.kind(), "", fmt::format("{}; the file {}", error.what(), unfinished_words));
  }
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
    read_one(named != nullptr ? *named : reader_of(path), path, format, measurement);
  }
  return measurement;
}

}  // namespace fingerpad
