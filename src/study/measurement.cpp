#include "study/measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/tangent_frame.hpp"
#include "touch/skin_motion.hpp"

namespace fingerpad {
namespace {

constexpr double least_normal_force_n = 0.05;  // below it a sensor's offset is most of the ratio

/// Columns of a measurement, in the order of measurement_request().
enum MeasuredColumn { time, x, fx = 4, nx = 7, dx = 10, subject = 13, trial = 14 };

CsvRequest measurement_request() {
  CsvRequest request;
  request.required = {"t_s", "x_m", "y_m", "z_m"};
  request.optional = {"fx_n", "fy_n", "fz_n", "nx", "ny", "nz", "dx", "dy", "dz", "subject", "trial"};
  request.mend = "a measurement has t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n";
  return request;
}

/// A table and how to ask it for vectors.
struct MeasuredTable {
  std::string path;
  CsvColumns csv;

  bool has(int first) const {
    return csv.present[static_cast<std::size_t>(first)] && csv.present[static_cast<std::size_t>(first) + 1] &&
           csv.present[static_cast<std::size_t>(first) + 2];
  }
  double number(int column, std::size_t row) const {
    return csv.columns[static_cast<std::size_t>(column)][row];
  }
  Vec3 vector(int first, std::size_t row) const {
    return {number(first, row), number(first + 1, row), number(first + 2, row)};
  }
  Vec3 unit(int first, std::size_t row, const char* what) const {
    const Vec3 v = vector(first, row);
    if (!(v.norm() > 1e-6))
      throw refused(fmt::format("{}:{}", path, csv.lines[row]), fmt::format("the {} has no length", what));
    return v.normalized();
  }
  int whole(int column, std::size_t row) const {
    if (!csv.present[static_cast<std::size_t>(column)]) return 0;
    const double value = number(column, row);
    if (value != std::floor(value) || std::abs(value) > 1e6)
      throw refused(fmt::format("{}:{}", path, csv.lines[row]), "subject and trial are whole numbers");
    return static_cast<int>(value);
  }
};

std::string missing_tangential_force(const CsvColumns& csv) {
  const char* names[] = {"fx_n", "fy_n", "fz_n"};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!csv.present[fx + k]) return fmt::format("column {} missing", names[k]);
  }
  return "";
}

double median_step_s(const MeasuredTable& table, std::size_t begin, std::size_t end) {
  std::vector<double> steps;
  for (std::size_t i = begin + 1; i < end; ++i) {
    const double step = table.number(time, i) - table.number(time, i - 1);
    if (!(step > 0))
      throw refused(fmt::format("{}:{}", table.path, table.csv.lines[i]),
                    "its time does not come after the row before it; a column 'trial' parts trials");
    steps.push_back(step);
  }
  std::nth_element(steps.begin(), steps.begin() + static_cast<long>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

/// The plate's normal and the finger's direction of a trial: their means. Both belong to a trial; a finger
/// that turns within one is measured at its mean angle.
struct TrialPose {
  Vec3 normal = Vec3::UnitZ(), direction = Vec3::Zero();
};

TrialPose pose_of(const MeasuredTable& table, std::size_t begin, std::size_t end) {
  TrialPose pose;
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = begin; i < end; ++i) {
    if (table.has(nx)) normal += table.unit(nx, i, "normal");
    if (table.has(dx)) pose.direction += table.unit(dx, i, "finger direction");
  }
  if (table.has(nx)) pose.normal = normal.normalized();
  if (table.has(dx)) pose.direction.normalize();
  return pose;
}

MeasuredTrial trial_of(const MeasuredTable& table, std::size_t begin, std::size_t end) {
  MeasuredTrial measured;
  measured.subject = table.whole(subject, begin);
  measured.name =
      fmt::format("{}, subject {}, trial {}", table.path, measured.subject, table.whole(trial, begin));
  const double step_s = median_step_s(table, begin, end);
  measured.rate_hz = 1 / step_s;
  const TrialPose pose = pose_of(table, begin, end);
  measured.has_direction = table.has(dx);
  if (measured.has_direction)
    measured.inclination_deg = inclination_rad(pose.direction, pose.normal) * 180 / std::numbers::pi;
  const Mat3 frame = tangent_frame(pose.normal, pose.direction);
  bool follows = false;
  for (std::size_t i = begin; i < end; ++i) {
    if (i > begin && table.number(time, i) - table.number(time, i - 1) > 1.5 * step_s) follows = false;
    const Vec3 force = table.vector(fx, i), place = table.vector(x, i);
    const double normal_n = frame.col(2).dot(force);
    if (!(normal_n > least_normal_force_n)) {
      follows = false;
      continue;
    }
    measured.position_m.emplace_back(frame.col(0).dot(place), frame.col(1).dot(place));
    measured.force_ratio.emplace_back(frame.col(0).dot(force) / normal_n, frame.col(1).dot(force) / normal_n);
    measured.starts_anew.push_back(!follows);
    follows = true;
  }
  return measured;
}

void read_measured_table(const std::string& path, Measurement& measurement) {
  constexpr std::size_t fewest = 16;
  const MeasuredTable table{path, read_csv_columns(path, measurement_request())};
  if (const std::string missing = missing_tangential_force(table.csv); !missing.empty()) {
    measurement.without_force.push_back(fmt::format("{}: {}", path, missing));
    return;
  }
  const std::size_t rows = table.csv.lines.size();
  for (std::size_t begin = 0, end = 0; begin < rows; begin = end) {
    const int of_subject = table.whole(subject, begin), of_trial = table.whole(trial, begin);
    end = begin + 1;
    while (end < rows && table.whole(subject, end) == of_subject && table.whole(trial, end) == of_trial)
      ++end;
    if (end - begin < fewest)
      throw refused(
          fmt::format("{}:{}", path, table.csv.lines[begin]),
          fmt::format("a trial of {} rows is too short to be measured; it takes {}", end - begin, fewest));
    MeasuredTrial measured = trial_of(table, begin, end);
    if (measured.position_m.size() < fewest) {
      measurement.untouched.push_back(measured.name);
    } else {
      measurement.trials.push_back(std::move(measured));
    }
  }
}

}  // namespace

Measurement read_measurements(const std::vector<std::string>& paths) {
  Measurement measurement;
  for (const std::string& path : paths) read_measured_table(path, measurement);
  return measurement;
}

}  // namespace fingerpad
