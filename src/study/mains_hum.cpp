#include "study/mains_hum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace fingerpad {
namespace {

using Phasors = std::array<std::complex<double>, 3>;

/// The forces' windowed transform at one frequency, scaled so that a sine of amplitude 1 gives 1.
class HannLine {
 public:
  explicit HannLine(const RecordedTrial& trial) : trial_(trial), weight_(trial.samples()) {
    const Eigen::Index n = trial.samples();
    for (Eigen::Index i = 0; i < n; ++i) {
      const double turn = 2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
      const bool is_there = trial.origin[static_cast<std::size_t>(i)] == SampleOrigin::recorded;
      weight_[i] = is_there ? 0.5 - 0.5 * std::cos(turn) : 0;
    }
    sum_ = weight_.sum();
    mean_ = trial.force_W * weight_ / sum_;
  }

  bool is_empty() const noexcept { return !(sum_ > 0); }

  Phasors at(double frequency_hz) const {
    const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi * frequency_hz / trial_.rate_hz);
    std::complex<double> phase = 1;
    Phasors sums{};
    for (Eigen::Index i = 0; i < trial_.samples(); ++i) {
      const std::complex<double> weighted = weight_[i] * phase;
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        sums[static_cast<std::size_t>(axis)] += weighted * (trial_.force_W(axis, i) - mean_[axis]);
      phase *= turn;
      if (i % 1024 == 0) phase /= std::abs(phase);
    }
    for (auto& sum : sums) sum *= 2 / sum_;
    return sums;
  }

 private:
  const RecordedTrial& trial_;
  Eigen::VectorXd weight_;
  double sum_ = 0;
  Vec3 mean_;
};

double power(const Phasors& phasors) {
  double sum = 0;
  for (const auto& phasor : phasors) sum += std::norm(phasor);
  return sum;
}

/// The frequency near `nominal_hz` at which the forces have most power.
double strongest_hz(const HannLine& line, double nominal_hz, double resolution_hz) {
  constexpr double reach_hz = 0.4;  // grids keep closer
  const double step_hz = 0.5 * resolution_hz;
  double best_hz = nominal_hz, best = -1;
  for (double hz = nominal_hz - reach_hz; hz <= nominal_hz + reach_hz; hz += step_hz) {
    const double here = power(line.at(hz));
    if (here > best) best = here, best_hz = hz;
  }
  const double left = power(line.at(best_hz - step_hz)), right = power(line.at(best_hz + step_hz));
  const double bend = left - 2 * best + right;
  return bend < 0 ? best_hz + std::clamp(0.5 * (left - right) / bend, -1.0, 1.0) * step_hz : best_hz;
}

/// Mean power of the axes around a line, beyond what the window smears of it.
std::array<double, 3> power_around(const HannLine& line, double hz, double resolution_hz) {
  std::array<double, 3> mean{};
  for (const double bins : {-9.0, -7.0, -5.0, -3.0, 3.0, 5.0, 7.0, 9.0}) {
    const Phasors beside = line.at(hz + bins * resolution_hz);
    for (std::size_t axis = 0; axis < 3; ++axis) mean[axis] += std::norm(beside[axis]) / 8;
  }
  return mean;
}

}  // namespace

MainsHum remove_mains_hum(RecordedTrial& trial, Mains mains) {
  constexpr double stands_out = 12;
  MainsHum found;
  const double duration_s = static_cast<double>(trial.samples()) / trial.rate_hz,
               resolution_hz = 1 / duration_s;
  if (mains == Mains::off || duration_s < 1) return found;
  for (const double nominal_hz : {50.0, 60.0}) {
    const bool is_asked = mains == Mains::any || (mains == Mains::hz_50) == (nominal_hz == 50.0);
    if (!is_asked || !(trial.rate_hz > 2.5 * nominal_hz)) continue;
    const HannLine line(trial);
    if (line.is_empty()) return found;
    const double hz = strongest_hz(line, nominal_hz, resolution_hz);
    const Phasors hum = line.at(hz);
    const std::array<double, 3> around = power_around(line, hz, resolution_hz);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const std::complex<double> phasor = hum[static_cast<std::size_t>(axis)];
      if (!(std::norm(phasor) > stands_out * around[static_cast<std::size_t>(axis)])) continue;
      const double w = 2 * std::numbers::pi * hz / trial.rate_hz;
      for (Eigen::Index i = 0; i < trial.samples(); ++i)
        trial.force_W(axis, i) -= (phasor * std::polar(1.0, w * static_cast<double>(i))).real();
      if (std::abs(phasor) > found.amplitude_n) found = {hz, std::abs(phasor)};
    }
  }
  return found;
}

}  // namespace fingerpad
