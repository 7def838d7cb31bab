#include "study/measurement_table.hpp"

#include <fmt/format.h>

#include "base/csv_row_reader.hpp"
#include "base/error.hpp"
#include "base/nearest_word.hpp"
#include "base/printable_text.hpp"
#include "motion/recorded_table.hpp"
#include "study/measured_row.hpp"
#include "study/measured_units.hpp"
#include "study/own_trace.hpp"
#include "trace/trace.hpp"

namespace fingerpad {
namespace {

/// The columns that are asked for, in the order of the request, by their place in measurement_columns.
std::vector<std::size_t> asked_columns(const MeasurementFormat& format, CsvRequest& request) {
  std::vector<std::size_t> required, optional;
  for (std::size_t k = 0; k < measurement_columns.size(); ++k) {
    const bool is_needed = is_required(format, k);
    (is_needed ? required : optional).push_back(k);
    (is_needed ? request.required : request.optional).push_back(header_of(format, k));
  }
  required.insert(required.end(), optional.begin(), optional.end());
  return required;
}

}  // namespace

void read_measured_table(const std::string& path, const MeasurementFormat& format,
                         RecordedMeasurement& into) {
  CsvRequest request;
  request.dialect = format.dialect;
  request.takes_gaps = request.takes_units = request.takes_lines_above = true;
  request.mark_mend = separator_mend;
  request.decimal_key = "--decimal {}";
  request.leaves_out_cut_row = true;
  request.mend =
      "a measurement has t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n; where yours is called otherwise, say "
      "--columns t=NAME,x=NAME";
  request.xml_mend = "the Penn Haptic Texture Toolkit's is read with --reader hatt";
  const std::vector<std::size_t> asked = asked_columns(format, request);
  CsvRowReader table(path, request);
  if (!table.above().empty()) refuse_trace_below(path, table.names());
  std::vector<bool> present(measurement_columns.size());
  for (std::size_t k = 0; k < asked.size(); ++k) present[asked[k]] = table.present()[k];
  MeasurementFormat read_as = format;
  std::vector<std::string_view> names = request.required;
  names.insert(names.end(), request.optional.begin(), request.optional.end());
  const ToldUnits told = take_measured_units(path, table.units(), names, asked, read_as);
  into.told_units[path] = told;
  if (const std::string words = told_units_words(told); !words.empty())
    into.notes.push_back(fmt::format("{}: {}", path, words));
  if (!table.above().empty()) into.notes.push_back(fmt::format("{}: {}", path, table.above()));
  for (const std::string& name : trial_names(table.unread()))
    into.notes.push_back(
        fmt::format("{}: the column '{}' is not read: where it numbers trials, say --columns \"trial={}\"",
                    path, name, name));
  if (is_own_csv_trace(path)) into.notes.push_back(fmt::format("{}: {}", path, own_trace_words));
  const RowReader rows(path, read_as, present);
  std::string missing = rows.missing_force();
  if (!missing.empty()) {
    if (const std::string unread = printable(word_list(table.unread()), 200); !unread.empty())
      missing += fmt::format(" (it has, and nothing reads: {})", unread);
    into.force_mend = rows.missing_force_mend();
    if (!rows.has_normal_force_alone()) {
      into.without_force.push_back(fmt::format("{}: {}", path, missing));
      return;
    }
  }
  warn_of_thinned(path, every_of_csv(path), into);
  const std::size_t before = into.trials.size();
  TrialCollector trials(path, rows, missing, into);
  std::vector<double> numbers(measurement_columns.size());
  bool has_rows = false;
  while (table.next()) {
    has_rows = true;
    for (std::size_t k = 0; k < asked.size(); ++k) numbers[asked[k]] = table.number(k);
    trials.add(numbers, {path, table.line()});
  }
  if (!has_rows) throw refused(path, "has a header but no rows");
  if (!table.cut().empty()) into.warnings.push_back(fmt::format("{}: {}", path, table.cut()));
  trials.finish();
  warn_of_normal_force_alone(path, rows, before, into);
}

}  // namespace fingerpad
