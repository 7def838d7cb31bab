#include "study/trial_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "motion/recording_clock.hpp"
#include "study/recorders_rate.hpp"
#include "touch/skin_motion.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t fewest_rows = 16;
constexpr double longest_gap_s = 1;     // beyond it the recording was stopped
constexpr double longest_piece_s = 20;  // of a recording that names no trials

const Vec3& pose_at(const std::vector<Vec3>& values, std::size_t row) {
  return values.size() == 1 ? values.front() : values[row];
}

/// Keeps one value for as long as all rows have it.
void keep(std::vector<Vec3>& values, std::size_t rows, const Vec3& value) {
  if (rows == 0 || (values.size() == 1 && values.front() == value)) {
    if (rows == 0) values.push_back(value);
    return;
  }
  if (values.size() == 1 && rows > 1) values.resize(rows, Vec3(values.front()));
  values.push_back(value);
}

}  // namespace

TrialRows::TrialRows(std::string file, int subject, int number, bool is_numbered, std::string lacks)
    : file_(std::move(file)),
      subject_(subject),
      number_(number),
      is_numbered_(is_numbered),
      lacks_(std::move(lacks)) {}

void TrialRows::add(const RecordedRow& row) {
  keep(normal_, t_s_.size(), row.normal_W);
  keep(direction_, t_s_.size(), row.direction_W);
  t_s_.push_back(row.t_s);
  position_.push_back(row.position_W);
  force_.push_back(row.force_W);
  if (!row.wrench) return;
  sensor_ = row.wrench->sensor;
  torque_.push_back(row.wrench->torque_W_n_m);
  tracked_.push_back(row.wrench->tracked_W);
}

void TrialRows::leave_out(const std::string& words, RecordedMeasurement& into) const {
  std::string reason = fmt::format("{}: {}{}", file_, lacks_, words);
  if (into.without_force.empty() || into.without_force.back() != reason)
    into.without_force.push_back(std::move(reason));
}

void TrialRows::finish(RecordedMeasurement& into) const {
  if (t_s_.size() < fewest_rows && !lacks_.empty()) return leave_out("", into);
  if (t_s_.size() < fewest_rows)
    throw refused(
        file_, fmt::format("trial {} of subject {} has {} rows, too few to be measured; it takes {}", number_,
                           subject_, t_s_.size(), fewest_rows));
  std::size_t begin = 0;
  long lost = 0;
  const std::size_t first = into.trials.size();
  const auto end_piece = [&](std::size_t end) {
    if (end - begin >= fewest_rows) {
      finish_piece(begin, end, into);
    } else {
      lost += static_cast<long>(end - begin);
    }
    begin = end;
  };
  for (std::size_t i = 1; i < t_s_.size(); ++i) {
    const bool is_long = !is_numbered_ && t_s_[i] - t_s_[begin] >= longest_piece_s;
    if (is_long || t_s_[i] - t_s_[i - 1] > longest_gap_s) end_piece(i);
  }
  end_piece(t_s_.size());
  const double step_s =
      (t_s_.back() - t_s_.front()) / static_cast<double>(std::max<std::size_t>(t_s_.size(), 2) - 1);
  if (lost == static_cast<long>(t_s_.size()) && step_s > longest_gap_s)
    throw refused(file_,
                  fmt::format("trial {} of subject {}: its {} rows are {} s apart, longer than the second "
                              "that parts pieces: if its time is in another unit than seconds, say {}",
                              number_, subject_, t_s_.size(), rounded_text(step_s, 3),
                              unit_of_seconds_words(1 / step_s)));
  if (into.trials.size() > first + 1) {
    for (std::size_t k = first; k < into.trials.size(); ++k)
      into.trials[k].piece = static_cast<int>(k - first) + 1;
  }
  if (lost > 0)
    into.warnings.push_back(fmt::format("{}: trial {} of subject {}: {} rows between long gaps are left out",
                                        file_, number_, subject_, lost));
}

void TrialRows::add_pose(std::size_t row, RecordedTrial& trial, Vec3& normal, Vec3& direction) const {
  const Vec3 &n = pose_at(normal_, row), &d = pose_at(direction_, row);
  if (n.allFinite()) normal += n;
  if (!d.allFinite() || !(d.squaredNorm() > 0)) return;
  direction += d;
  if (!n.allFinite()) return;
  const double angle_deg = inclination_rad(d, n) * 180 / std::numbers::pi;
  trial.least_angle_deg = std::min(trial.least_angle_deg, angle_deg);
  trial.most_angle_deg = std::max(trial.most_angle_deg, angle_deg);
}

bool TrialRows::is_recorded(std::size_t row) const {
  return position_[row].allFinite() && force_[row].allFinite() &&
         (!sensor_ || (torque_[row].allFinite() && tracked_[row].allFinite()));
}

void TrialRows::finish_piece(std::size_t begin, std::size_t end, RecordedMeasurement& into) const {
  const RecordingClock clock = recording_clock(std::span(t_s_).subspan(begin, end - begin));
  RecordedTrial trial;
  trial.file = file_;
  trial.subject = subject_;
  trial.number = number_;
  trial.start_s = t_s_[begin];
  trial.rate_hz = clock.rate_hz;
  trial.least_angle_deg = 90;
  const double last_step = (t_s_[end - 1] - t_s_[begin]) * clock.rate_hz;
  if (!(last_step <= 4 * static_cast<double>(end - begin) + 1000))
    throw refused(file_,
                  fmt::format("trial {} of subject {}: its clock is too uneven: {} rows, but {} steps "
                              "at {}",
                              number_, subject_, end - begin, rounded_text(last_step, 4), clock_text(clock)));
  const Eigen::Index steps = std::lround(last_step) + 1;
  std::vector<std::pair<const std::vector<Vec3>*, Points*>> columns{{&position_, &trial.position_W},
                                                                    {&force_, &trial.force_W}};
  if (sensor_) {
    trial.sensor = sensor_;
    columns.insert(columns.end(), {{&torque_, &trial.torque_W_n_m}, {&tracked_, &trial.tracked_W}});
  }
  for (const auto& [rows, points] : columns) points->resize(3, steps);
  trial.origin.assign(static_cast<std::size_t>(steps), SampleOrigin::missing);
  Vec3 normal = Vec3::Zero(), direction = Vec3::Zero();
  std::size_t before = end;  // the last recorded row
  for (std::size_t i = begin; i < end; ++i) {
    add_pose(i, trial, normal, direction);
    if (!is_recorded(i)) continue;
    const double at = (t_s_[i] - trial.start_s) * clock.rate_hz;
    const double from = before == end ? at : (t_s_[before] - trial.start_s) * clock.rate_hz;
    constexpr double slack = 0.05;  // of a step: times are rounded
    for (Eigen::Index k = before == end ? std::lround(at) : std::lround(std::floor(from + slack)) + 1;
         static_cast<double>(k) <= at + slack && k < steps; ++k) {
      const double step = static_cast<double>(k);
      // A row within half a step is taken as it is: between two, a straight line would cut across a rupture.
      const bool is_near = std::abs(step - at) <= 0.5;
      const double share = before == end || (is_near && at - step <= step - from) ? 1
                           : step - from <= 0.5                                   ? 0
                                                : (step - from) / (at - from);
      const std::size_t other = before == end ? i : before;
      for (const auto& [rows, points] : columns)
        points->col(k) = (*rows)[other] + share * ((*rows)[i] - (*rows)[other]);
      trial.origin[static_cast<std::size_t>(k)] =
          is_near || step - from <= 0.5 ? SampleOrigin::recorded : SampleOrigin::filled;
    }
    before = i;
  }
  if (before == end) {
    into.warnings.push_back(
        fmt::format("{}: trial {} of subject {} has no row that holds both position and force", file_,
                    number_, subject_));
    return;
  }
  for (Eigen::Index k = 0; k < steps; ++k) {  // before the first recorded row and after the last
    if (trial.origin[static_cast<std::size_t>(k)] != SampleOrigin::missing) continue;
    for (const auto& [rows, points] : columns) points->col(k) = (*rows)[before];
  }
  if (normal.norm() > 0) trial.normal_W = normal.normalized();
  if (direction.norm() > 0) trial.direction_W = direction.normalized();
  constexpr double along_z = 0.99995;  // within a hundredth, which is what friction would be of the force
  if (!lacks_.empty() && !(std::abs(trial.normal_W.z()) > along_z))
    return leave_out(", and the plate's normal is not along fz, so that its force is not known", into);
  trial.lacks = lacks_;
  into.trials.push_back(std::move(trial));
}

std::string trial_name(const RecordedTrial& trial) {
  return fmt::format("{}, subject {}, trial {}{}", trial.file, trial.subject, trial.number,
                     trial.piece > 0 ? fmt::format(", piece {}", trial.piece) : "");
}

}  // namespace fingerpad
