#include "study/measured_row.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "study/six_axis_sensor.hpp"

namespace fingerpad {
namespace {

std::size_t place_of(MeasuredColumn column) {
  return static_cast<std::size_t>(column);
}

constexpr bool reads_as(MeasuredColumn column, std::string_view key) {
  return measurement_columns[static_cast<std::size_t>(column)].key == key;
}
static_assert(reads_as(MeasuredColumn::x, "x") && reads_as(MeasuredColumn::fx, "fx") &&
              reads_as(MeasuredColumn::nx, "nx") && reads_as(MeasuredColumn::dx, "dx") &&
              reads_as(MeasuredColumn::marker_1, "m1x") && reads_as(MeasuredColumn::marker_2, "m2x") &&
              reads_as(MeasuredColumn::torque, "tx") && reads_as(MeasuredColumn::subject, "subject") &&
              reads_as(MeasuredColumn::trial, "trial") && reads_as(MeasuredColumn::fn, "fn") &&
              reads_as(MeasuredColumn::speed, "speed"));
// What a recorded motion has too is called alike.
static_assert(measurement_columns[0].header == recording_columns[0].header &&
              measurement_columns[1].header == recording_columns[1].header &&
              measurement_columns[10].header == recording_columns[4].header);

bool is_within(std::size_t column, MeasuredColumn first, std::size_t count) {
  return column >= place_of(first) && column < place_of(first) + count;
}

}  // namespace

std::string_view header_of(const MeasurementFormat& format, std::size_t column) {
  const std::string& named = format.headers[column];
  return named.empty() ? measurement_columns[column].header : std::string_view(named);
}

bool is_required(const MeasurementFormat& format, std::size_t column) {
  if (column == place_of(MeasuredColumn::time) || !format.headers[column].empty()) return true;
  if (is_within(column, MeasuredColumn::x, 3)) return !format.markers;
  return format.markers && is_within(column, MeasuredColumn::marker_1, 6);
}

RowReader::RowReader(const std::string& path, const MeasurementFormat& format, std::vector<bool> present)
    : format_(format), present_(std::move(present)) {
  if (!format.headers[place_of(MeasuredColumn::speed)].empty())
    throw refused(path,
                  "the column speed of --columns is read with --reader sens3 and its like alone: leave it "
                  "out; the positions give it");
  for (const MeasuredColumn first : {MeasuredColumn::nx, MeasuredColumn::dx, MeasuredColumn::torque}) {
    const auto begin = present_.begin() + static_cast<std::ptrdiff_t>(place_of(first));
    const auto there = std::count(begin, begin + 3, true);
    if (there == 0 || there == 3) continue;
    throw refused(path,
                  fmt::format("has {} of the columns {}, {}, {}: they belong together", there,
                              header_of(format, place_of(first)), header_of(format, place_of(first) + 1),
                              header_of(format, place_of(first) + 2)));
  }
  is_force_whole_ = missing_force().empty();
  refuse_unused_place(path);
}

void RowReader::refuse_unused_place(const std::string& path) const {
  if (!format_.sensor || !format_.sensor->says_place) return;
  if (format_.markers)
    throw refused(path,
                  "--sensor-at has no effect beside --markers, which tell the fingertip: leave one out");
  // A file without force is left out as a whole, which is told elsewhere.
  if (has(MeasuredColumn::torque) || !missing_force().empty()) return;
  const std::size_t first = place_of(MeasuredColumn::torque);
  throw refused(
      path,
      fmt::format("--sensor-at has no effect without torque, and the columns {}, {}, {} are missing: where "
                  "yours are called otherwise, say --columns tx=NAME,ty=NAME,tz=NAME (and --torque-unit); "
                  "else leave it out (--sensor-turned alone turns the forces)",
                  header_of(format_, first), header_of(format_, first + 1), header_of(format_, first + 2)));
}

std::string RowReader::missing_force() const {
  for (std::size_t k = place_of(MeasuredColumn::fx); k < place_of(MeasuredColumn::fx) + 3; ++k)
    if (!present_[k]) return fmt::format("column {} missing", header_of(format_, k));
  return {};
}

std::string RowReader::missing_force_mend() const {
  std::string names;
  long missing = 0;
  for (std::size_t k = place_of(MeasuredColumn::fx); k < place_of(MeasuredColumn::fx) + 3; ++k) {
    if (present_[k]) continue;
    names += fmt::format("{}{}=NAME", names.empty() ? "" : ",", measurement_columns[k].key);
    ++missing;
  }
  if (missing == 0) return {};
  return fmt::format("where {} called otherwise, say --columns {}", missing == 1 ? "it is" : "they are",
                     names);
}

bool RowReader::has_normal_force_alone() const {
  return !is_force_whole_ && present_[place_of(MeasuredColumn::fx) + 2] && !format_.sensor;
}

bool RowReader::has(MeasuredColumn first) const {
  return present_[place_of(first)];
}

double RowReader::time_s(std::span<const double> numbers) const {
  return format_.seconds_per_unit * numbers[0];
}

Vec3 RowReader::vector(std::span<const double> numbers, MeasuredColumn first) const {
  const std::size_t at = place_of(first);
  return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

Vec3 RowReader::unit(std::span<const double> numbers, MeasuredColumn first, const char* what,
                     const RowPlace& place) const {
  const Vec3 v = vector(numbers, first);
  if (!v.allFinite()) return v;
  const double length = v.stableNorm();
  if (!(length > 1e-6) || !std::isfinite(length))
    throw refused(place.text(), fmt::format("the {} has no length", what));
  return v / length;
}

int RowReader::whole(std::span<const double> numbers, MeasuredColumn column, const RowPlace& place) const {
  if (!has(column)) return 0;
  const double value = numbers[place_of(column)];
  if (value != std::floor(value) || std::abs(value) > 1e6)
    throw refused(place.text(), "subject and trial are whole numbers");
  return static_cast<int>(value);
}

/// The finger lies along the line from the proximal to the distal marker; its tip is beyond the distal one,
/// and below it towards the plate.
void RowReader::take_markers(std::span<const double> numbers, RecordedRow& row) const {
  const Vec3 proximal = format_.metres_per_unit * vector(numbers, MeasuredColumn::marker_1),
             distal = format_.metres_per_unit * vector(numbers, MeasuredColumn::marker_2);
  const Vec3 along = (distal - proximal).normalized();
  const Vec3 below = (-row.normal_W + row.normal_W.dot(along) * along).normalized();
  row.direction_W = along;
  row.position_W = distal + format_.markers->tip_beyond_m * along + format_.markers->tip_below_m * below;
}

RecordedRow RowReader::row(std::span<const double> numbers, const RowPlace& place) const {
  RecordedRow row;
  row.t_s = time_s(numbers);
  row.position_W = format_.metres_per_unit * vector(numbers, MeasuredColumn::x);
  Vec3 force = vector(numbers, MeasuredColumn::fx);
  if (!is_force_whole_) force.head<2>().setZero();  // one of the two alone tells no friction either
  row.force_W = (format_.force_on_plate ? -1 : 1) * format_.newtons_per_unit * force;
  if (has(MeasuredColumn::nx)) row.normal_W = unit(numbers, MeasuredColumn::nx, "normal", place);
  if (has(MeasuredColumn::dx)) row.direction_W = unit(numbers, MeasuredColumn::dx, "finger direction", place);
  if (format_.markers) take_markers(numbers, row);
  if (!format_.sensor) return row;
  const double torque_n_m = (format_.force_on_plate ? -1 : 1) * format_.newton_metres_per_unit;
  const Vec3 torque_S = torque_n_m * vector(numbers, MeasuredColumn::torque);
  const bool tells_contact = format_.sensor->says_place && has(MeasuredColumn::torque) && !format_.markers;
  take_wrench(*format_.sensor, tells_contact ? &torque_S : nullptr, row);
  return row;
}

namespace {

/// What is wrong with a time that does not come after the one before it, and what to do.
std::string time_fault(double t_s, double before_s, bool has_trials) {
  if (t_s == before_s)
    return fmt::format(
        "its time {:.15g} s is the time of the row before it too: leave out rows that are there twice, or "
        "write times with more digits",
        t_s);
  return fmt::format("its time {:.15g} s comes before {:.15g} s of the row before it{}", t_s, before_s,
                     has_trials
                         ? ", of the same trial: put the rows in order"
                         : ": put the rows in order, or, where a new trial begins, number the trials in "
                           "a column 'trial'");
}

}  // namespace

TrialCollector::TrialCollector(std::string path, const RowReader& rows, std::string lacks,
                               RecordedMeasurement& into)
    : path_(std::move(path)), rows_(rows), lacks_(std::move(lacks)), into_(into) {}

void TrialCollector::add(std::span<const double> numbers, const RowPlace& place) {
  const int subject = rows_.whole(numbers, MeasuredColumn::subject, place),
            number = rows_.whole(numbers, MeasuredColumn::trial, place);
  if (trial_ && (trial_->subject() != subject || trial_->number() != number)) finish();
  if (!trial_) trial_.emplace(path_, subject, number, rows_.has(MeasuredColumn::trial), lacks_);
  const RecordedRow row = rows_.row(numbers, place);
  if (!std::isfinite(row.t_s)) throw refused(place.text(), "has no time");
  if (trial_->size() > 0 && !(row.t_s > trial_->last_s()))
    throw refused(place.text(), time_fault(row.t_s, trial_->last_s(), rows_.has(MeasuredColumn::trial)));
  trial_->add(row);
}

void TrialCollector::finish() {
  if (trial_) trial_->finish(into_);
  trial_.reset();
}

void warn_of_normal_force_alone(const std::string& path, const RowReader& rows, std::size_t before,
                                RecordedMeasurement& into) {
  if (into.trials.size() == before || into.trials.back().lacks.empty()) return;
  into.warnings.push_back(
      fmt::format("{}: {}: its normal force tells the pad's normal law alone, and nothing of friction; {}",
                  path, into.trials.back().lacks, rows.missing_force_mend()));
}

void warn_of_thinned(const std::string& path, std::uint64_t every, RecordedMeasurement& into) {
  if (every <= 1) return;
  into.warnings.push_back(fmt::format(
      "{}: is a trace with 1 row in {} ticks (replay --every): where stick and slip begin is seen {} "
      "times as coarsely as its run had it; replay its scene without --every",
      path, every, every));
}

}  // namespace fingerpad
