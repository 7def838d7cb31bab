#include "study/mains_hum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

using Phasors = std::array<std::complex<double>, 3>;

/// The forces less their means over a period of the mains: what moves slowly is gone, the hum stays.
Points without_slow(const RecordedTrial& trial, double mains_hz) {
  const Eigen::Index n = trial.samples();
  const auto half = static_cast<Eigen::Index>(std::lround((trial.rate_hz / mains_hz - 1) / 2));
  Points rest = Points::Zero(3, n);
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < std::min(2 * half, n); ++i) sum += trial.force_W.col(i);
  for (Eigen::Index i = half; i + half < n; ++i) {
    sum += trial.force_W.col(i + half);
    rest.col(i) = trial.force_W.col(i) - sum / static_cast<double>(2 * half + 1);
    sum -= trial.force_W.col(i - half);
  }
  return rest;
}

/// Powers of all axes together, at first_hz, first_hz + step_hz, and so on.
struct HumScan {
  double first_hz = 0, step_hz = 0;
  std::vector<double> power;
};

/// The forces' windowed transform at one frequency, scaled so that a sine of amplitude 1 gives 1. Samples
/// that stand out, as those of ruptures, do not count.
class HannLine {
 public:
  HannLine(const RecordedTrial& trial, double mains_hz)
      : rate_hz_(trial.rate_hz), rest_(without_slow(trial, mains_hz)), weighted_(rest_) {
    constexpr double stands_out = 3;  // of what two thirds of the samples keep within
    const Eigen::Index n = trial.samples();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      std::vector<double> sizes;
      for (Eigen::Index i = 0; i < n; ++i) sizes.push_back(std::abs(rest_(axis, i)));
      const double most = stands_out * quantile(sizes, 0.667);
      for (Eigen::Index i = 0; i < n; ++i) {
        const double turn = 2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
        const bool counts = trial.origin[static_cast<std::size_t>(i)] == SampleOrigin::recorded &&
                            sizes[static_cast<std::size_t>(i)] <= most;
        const double weight = counts ? 0.5 - 0.5 * std::cos(turn) : 0;
        weighted_(axis, i) *= weight;
        sums_[axis] += weight;
      }
    }
  }

  bool is_empty() const noexcept { return !(sums_.minCoeff() > 0); }

  Phasors at(double frequency_hz) const {
    const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi * frequency_hz / rate_hz_);
    std::complex<double> phase = 1;
    Phasors sums{};
    for (Eigen::Index i = 0; i < weighted_.cols(); ++i) {
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        sums[static_cast<std::size_t>(axis)] += weighted_(axis, i) * phase;
      phase *= turn;
      if (i % 1024 == 0) phase /= std::abs(phase);
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) sums[static_cast<std::size_t>(axis)] *= 2 / sums_[axis];
    return sums;
  }

  HumScan scan(double first_hz, double width_hz) const;

 private:
  std::vector<std::complex<double>> block_sums(Eigen::Index axis, double at_hz, Eigen::Index block) const;

  double rate_hz_;
  Points rest_, weighted_;
  Vec3 sums_ = Vec3::Zero();
};

/// Sums over blocks of samples, turned back by a frequency: what is near it moves slowly in them.
std::vector<std::complex<double>> HannLine::block_sums(Eigen::Index axis, double at_hz,
                                                       Eigen::Index block) const {
  const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi * at_hz / rate_hz_);
  std::complex<double> phase = 1;
  std::vector<std::complex<double>> sums(static_cast<std::size_t>((weighted_.cols() - 1) / block + 1));
  for (Eigen::Index i = 0; i < weighted_.cols(); ++i) {
    sums[static_cast<std::size_t>(i / block)] += weighted_(axis, i) * phase;
    phase *= turn;
    if (i % 1024 == 0) phase /= std::abs(phase);
  }
  return sums;
}

/// The powers of at() over a band, by one transform of block sums: n log n, where asking for each frequency
/// grows with the square of the duration. Blocks of 20 ms take 0.1 % off a line at 0.8 Hz from the first. At
/// least two frequencies for each that the window parts.
HumScan HannLine::scan(double first_hz, double width_hz) const {
  constexpr double block_s = 0.02;
  const Eigen::Index block = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(block_s * rate_hz_));
  std::size_t length = 2;
  while (static_cast<Eigen::Index>(length) * block < 2 * weighted_.cols()) length *= 2;
  HumScan found{first_hz, rate_hz_ / static_cast<double>(static_cast<Eigen::Index>(length) * block), {}};
  found.power.assign(std::min(length, static_cast<std::size_t>(width_hz / found.step_hz) + 1), 0.0);
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> transform;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<std::complex<double>> sums = block_sums(axis, first_hz, block);
    sums.resize(length);
    fft.fwd(transform, sums);
    for (std::size_t k = 0; k < found.power.size(); ++k)
      found.power[k] += std::norm(transform[k] * 2.0 / sums_[axis]);
  }
  return found;
}

double power(const Phasors& phasors) {
  double sum = 0;
  for (const auto& phasor : phasors) sum += std::norm(phasor);
  return sum;
}

/// The frequency near `nominal_hz` at which the forces have most power.
double strongest_hz(const HannLine& line, double nominal_hz) {
  constexpr double reach_hz = 0.4;  // grids keep closer
  const HumScan scan = line.scan(nominal_hz - reach_hz, 2 * reach_hz);
  const auto k = std::max_element(scan.power.begin(), scan.power.end()) - scan.power.begin();
  const double hz = scan.first_hz + static_cast<double>(k) * scan.step_hz;
  const double best = power(line.at(hz)), left = power(line.at(hz - scan.step_hz)),
               right = power(line.at(hz + scan.step_hz));
  const double bend = left - 2 * best + right;
  return bend < 0 ? hz + std::clamp(0.5 * (left - right) / bend, -1.0, 1.0) * scan.step_hz : hz;
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

/// Takes a sine off an axis.
void take_off(std::complex<double> phasor, double hz, Eigen::Index axis, RecordedTrial& trial) {
  const std::complex<double> turn = std::polar(1.0, 2 * std::numbers::pi * hz / trial.rate_hz);
  for (Eigen::Index i = 0; i < trial.samples(); ++i) {
    trial.force_W(axis, i) -= phasor.real();
    phasor *= turn;
  }
}

}  // namespace

MainsHum remove_mains_hum(RecordedTrial& trial, Mains mains) {
  constexpr double stands_out = 12, stands_beside = 4;  // once for sure, on other axes for likely
  constexpr int passes = 3;  // with less hum left, fewer samples stand out because of it
  MainsHum found;
  const double duration_s = static_cast<double>(trial.samples()) / trial.rate_hz,
               resolution_hz = 1 / duration_s;
  if (mains == Mains::off || duration_s < 1) return found;
  for (const double nominal_hz : {50.0, 60.0}) {
    const bool is_asked = mains == Mains::any || (mains == Mains::hz_50) == (nominal_hz == 50.0);
    if (!is_asked || !(trial.rate_hz > 2.5 * nominal_hz)) continue;
    std::array<bool, 3> hums{};
    std::array<std::complex<double>, 3> whole{};
    double hz = nominal_hz;
    for (int pass = 0; pass < passes; ++pass) {
      const HannLine line(trial, nominal_hz);
      if (line.is_empty()) return found;
      if (pass == 0) hz = strongest_hz(line, nominal_hz);
      const Phasors hum = line.at(hz);
      const std::array<double, 3> around =
          pass == 0 ? power_around(line, hz, resolution_hz) : std::array<double, 3>{};
      bool is_sure = false;
      for (std::size_t axis = 0; axis < 3; ++axis)
        is_sure = is_sure || std::norm(hum[axis]) > stands_out * around[axis];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (pass == 0) hums[axis] = is_sure && std::norm(hum[axis]) > stands_beside * around[axis];
        if (!hums[axis]) continue;
        take_off(hum[axis], hz, static_cast<Eigen::Index>(axis), trial);
        whole[axis] += hum[axis];
      }
      if (std::none_of(hums.begin(), hums.end(), [](bool is) { return is; })) break;
    }
    for (const auto& phasor : whole)
      if (std::abs(phasor) > found.amplitude_n) found = {hz, std::abs(phasor)};
  }
  return found;
}

}  // namespace fingerpad
