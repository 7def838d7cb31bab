#include "motion/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "motion/finger_path.hpp"
#include "motion/low_pass.hpp"
#include "motion/velocity_estimator.hpp"

namespace fingerpad {
namespace {

void smooth_rows(const ZeroPhaseLowPass& low_pass, Points& points) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd row = points.row(axis);
    points.row(axis) = low_pass.filtered(row);
  }
}

/// Directions that the low pass leaves without a length stay as they were.
void smooth_directions(const ZeroPhaseLowPass& low_pass, Points& directions) {
  Points passed = directions;
  smooth_rows(low_pass, passed);
  for (Eigen::Index i = 0; i < passed.cols(); ++i) {
    const double length = passed.col(i).norm();
    if (length > 1e-6) directions.col(i) = passed.col(i) / length;
  }
}

/// As four numbers, with the signs that make them run on.
void smooth_attitudes(const ZeroPhaseLowPass& low_pass, std::vector<Attitude>& attitudes) {
  Eigen::Matrix4Xd q(4, static_cast<Eigen::Index>(attitudes.size()));
  for (Eigen::Index i = 0; i < q.cols(); ++i) {
    q.col(i) = attitudes[static_cast<std::size_t>(i)].coeffs();
    if (i > 0 && q.col(i).dot(q.col(i - 1)) < 0) q.col(i) = -q.col(i);
  }
  for (Eigen::Index k = 0; k < 4; ++k) {
    const Eigen::VectorXd row = q.row(k);
    q.row(k) = low_pass.filtered(row);
  }
  for (Eigen::Index i = 0; i < q.cols(); ++i) {
    const double length = q.col(i).norm();
    if (length > 1e-6) attitudes[static_cast<std::size_t>(i)].coeffs() = q.col(i) / length;
  }
}

}  // namespace

Motion evenly_sampled(const Motion& motion, const RecordingClock& clock) {
  if (clock.is_even || motion.t_s.size() < 2) return motion;
  const double steps = (motion.t_s.back() - motion.t_s.front()) * clock.rate_hz;
  if (!(steps <= 4 * static_cast<double>(motion.t_s.size()) + 1000)) {
    throw refused("", fmt::format("its clock is too uneven to be resampled: {} samples, but {} steps at "
                                  "{}",
                                  motion.t_s.size(), rounded_text(steps, 4), clock_text(clock)));
  }
  const FingerPath path(motion, clock.rate_hz, Vec3::UnitX());
  Motion even;
  even.p_WQ.resize(3, path.tick_count());
  even.direction_W.resize(3, motion.direction_W.cols() > 0 ? path.tick_count() : 0);
  even.force_W_n.resize(3, motion.force_W_n.cols() > 0 ? path.tick_count() : 0);
  for (long k = 0; k < path.tick_count(); ++k) {
    const FingerSample sample = path.at(k);
    even.t_s.push_back(sample.t_s);
    even.p_WQ.col(k) = sample.p_WQ;
    if (even.direction_W.cols() > 0) even.direction_W.col(k) = sample.direction_W;
    if (even.force_W_n.cols() > 0) even.force_W_n.col(k) = path.measured_force_W_n(k);
    if (sample.attitude) even.attitude.push_back(*sample.attitude);
    if (sample.normal_force_n) even.normal_force_n.push_back(*sample.normal_force_n);
  }
  return even;
}

void keep_last_sample(Motion& motion, const RecordingClock& clock) {
  constexpr double most_of_a_step = 0.05;
  const double steps = (motion.t_s.back() - motion.t_s.front()) * clock.rate_hz;
  const double whole = std::round(steps);
  if (!(whole > steps) || whole - steps > most_of_a_step) return;
  motion.t_s.back() = motion.t_s.front() + whole / clock.rate_hz;
}

void estimate_velocity(Motion& motion, double quantum_m, double rate_hz) {
  VelocityEstimator estimator(quantum_m, 1 / rate_hz);
  motion.velocity_W.resize(3, motion.p_WQ.cols());
  for (Eigen::Index i = 0; i < motion.p_WQ.cols(); ++i)
    motion.velocity_W.col(i) = estimator.next(motion.p_WQ.col(i));
}

Smoothing smooth(Motion& motion, double cutoff_hz, double rate_hz) {
  const ZeroPhaseLowPass low_pass(cutoff_hz, rate_hz);
  const Points before = motion.p_WQ;
  smooth_rows(low_pass, motion.p_WQ);
  if (motion.velocity_W.cols() > 0) smooth_rows(low_pass, motion.velocity_W);
  if (motion.direction_W.cols() > 0) smooth_directions(low_pass, motion.direction_W);
  if (!motion.attitude.empty()) smooth_attitudes(low_pass, motion.attitude);
  if (!motion.normal_force_n.empty()) {
    Eigen::Map<Eigen::VectorXd> force(motion.normal_force_n.data(),
                                      static_cast<Eigen::Index>(motion.normal_force_n.size()));
    const Eigen::VectorXd measured = force;
    force = low_pass.filtered(measured);
  }
  const Eigen::RowVectorXd moved_m = (motion.p_WQ - before).colwise().norm();
  return {std::sqrt(moved_m.squaredNorm() / static_cast<double>(moved_m.size())), moved_m.maxCoeff()};
}

}  // namespace fingerpad
