#include "study/measurement_hdf5.hpp"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "scene/toml_tree.hpp"
#include "study/measured_row.hpp"
#include "study/measured_units.hpp"
#include "study/own_trace.hpp"
#include "trace/hdf5_columns.hpp"
#include "trace/trace.hpp"
#include "trace/trace_choice.hpp"

namespace fingerpad {
namespace {

/// The direction of a trace's finger, from its scene; zero where it says none.
Vec3 scene_direction(const std::string& scene_text, const std::string& path) {
  const TomlNode scene = parse_toml(scene_text, path);
  const TomlEntry* finger = find_entry(scene, "finger");
  const TomlEntry* direction = finger != nullptr ? find_entry(finger->value, "direction") : nullptr;
  Vec3 found = Scene{}.finger.direction;
  if (direction == nullptr || direction->value.items.size() != 3) return found;
  for (std::size_t k = 0; k < 3; ++k) found[static_cast<Eigen::Index>(k)] = direction->value.items[k].number;
  return found.normalized();
}

/// Takes the units that the datasets' attributes name.
ToldUnits told_units(const std::string& path, const std::vector<std::string>& names,
                     std::vector<std::string> units, MeasurementFormat& format) {
  std::vector<std::size_t> places(names.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  const UnitRow row{std::move(units), path, UnitSource::attributes};
  return take_measured_units(path, row, {names.begin(), names.end()}, places, format);
}

}  // namespace

bool is_measured_hdf5(const std::string& path) {
  return is_hdf5(path);
}

void read_measured_hdf5(const std::string& path, const MeasurementFormat& format, RecordedMeasurement& into) {
  const CsvDialect plain = MeasurementFormat{}.dialect;
  if (format.dialect.separator != plain.separator || format.dialect.decimal != plain.decimal)
    throw refused(
        path, "--separator and --decimal say how a table of text is read, and this is HDF5: leave them out");
  std::vector<std::string> names;
  for (std::size_t k = 0; k < measurement_columns.size(); ++k) names.emplace_back(header_of(format, k));
  Hdf5Columns file = read_hdf5_columns(path, names);
  std::vector<std::string> missing;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (!file.present[k] && is_required(format, k)) missing.push_back(names[k]);
  if (!missing.empty())
    throw refused(
        path,
        file.chosen.empty()
            ? fmt::format("has no dataset '{}'; a measurement has one a column at its root, as t_s, x_m, "
                          "fx_n, of N numbers each, and {}",
                          missing.front(), read_hdf5_contents(path))
            : missing_columns_words(missing, file.chosen));
  if (file.columns[0].empty()) throw refused(path, "has columns but no rows");
  const std::size_t count = file.columns[0].size(),
                    first_direction = static_cast<std::size_t>(MeasuredColumn::dx);
  if (!file.scene_text.empty() && !file.present[first_direction] && !format.markers) {
    const Vec3 direction = scene_direction(file.scene_text, path);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      file.present[first_direction + axis] = true;
      file.columns[first_direction + axis].assign(count, direction[static_cast<Eigen::Index>(axis)]);
    }
  }
  MeasurementFormat read_as = format;
  const ToldUnits told = told_units(path, names, std::move(file.units), read_as);
  into.told_units[path] = told;
  const std::string words = told_units_words(told, UnitSource::attributes);
  if (!words.empty() && !file.is_trace) into.notes.push_back(fmt::format("{}: {}", path, words));
  if (file.is_trace) into.notes.push_back(fmt::format("{}: {}", path, own_trace_words));
  const RowReader rows(path, read_as, file.present);
  const std::string lacks = rows.missing_force();
  if (!lacks.empty()) {
    into.force_mend = rows.missing_force_mend();
    if (!rows.has_normal_force_alone()) {
      into.without_force.push_back(fmt::format("{}: {}", path, lacks));
      return;
    }
  }
  warn_of_thinned(path, file.every, into);
  const std::size_t before = into.trials.size();
  TrialCollector trials(path, rows, lacks, into);
  std::vector<double> numbers(names.size());
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < names.size(); ++k)
      if (file.present[k]) numbers[k] = file.columns[k][i];
    trials.add(numbers, {path, static_cast<long>(i + 1)});
  }
  trials.finish();
  warn_of_normal_force_alone(path, rows, before, into);
}

}  // namespace fingerpad
