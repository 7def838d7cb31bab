#include "study/measurement_table.hpp"

#include <fmt/format.h>

#include "base/csv_row_reader.hpp"
#include "base/error.hpp"
#include "study/measured_row.hpp"

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
  request.takes_gaps = true;
  request.mend =
      "a measurement has t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n; where yours is called otherwise, say "
      "--columns t=NAME,x=NAME";
  const std::vector<std::size_t> asked = asked_columns(format, request);
  CsvRowReader table(path, request);
  std::vector<bool> present(measurement_columns.size());
  for (std::size_t k = 0; k < asked.size(); ++k) present[asked[k]] = table.present()[k];
  const RowReader rows(path, format, present);
  if (const std::string missing = rows.missing_force(); !missing.empty()) {
    into.without_force.push_back(fmt::format("{}: {}", path, missing));
    return;
  }
  TrialCollector trials(path, rows, into);
  std::vector<double> numbers(measurement_columns.size());
  while (table.next()) {
    for (std::size_t k = 0; k < asked.size(); ++k) numbers[asked[k]] = table.number(k);
    trials.add(numbers, {path, table.line()});
  }
  trials.finish();
}

}  // namespace fingerpad
