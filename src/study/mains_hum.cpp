#include "study/mains_hum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace fingerpad {
namespace {

double power(const Phasors& phasors) {
  double sum = 0;
  for (const auto& phasor : phasors) sum += std::norm(phasor);
  return sum;
}

/// The frequency near `nominal_hz` with most power.
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
std::array<double, 3> power_around(const HannLine& line, double hz, double bin_hz) {
  std::array<double, 3> mean{};
  for (const double bins : {-9.0, -7.0, -5.0, -3.0, 3.0, 5.0, 7.0, 9.0}) {
    const Phasors beside = line.at(hz + bins * bin_hz);
    for (std::size_t axis = 0; axis < 3; ++axis) mean[axis] += std::norm(beside[axis]) / 8;
  }
  return mean;
}

double resolution_hz(const RecordedTrial& trial) {
  return trial.rate_hz / static_cast<double>(trial.samples());
}

constexpr double surely_stands_out = 12;  // in power

/// Takes a sine off one of the axes.
/// @param turn  of its phase from sample to sample
void take_off_axis(std::complex<double> phasor, std::complex<double> turn, Eigen::Index axis,
                   Points& sensed) {
  for (Eigen::Index i = 0; i < sensed.cols(); ++i) {
    sensed(axis, i) -= phasor.real();
    phasor *= turn;
  }
}

/// The line near a frequency of the mains, if one stands out.
std::optional<HumLine> hum_line(const RecordedTrial& trial, Sensed sensed, double nominal_hz) {
  constexpr double stands_beside = 4;  // on other axes than the one for sure
  const HannLine line(trial, sensed, nominal_hz);
  if (line.is_empty()) return std::nullopt;
  HumLine found{nominal_hz, strongest_hz(line, nominal_hz)};
  found.phasors = line.at(found.hz);
  found.around = power_around(line, found.hz, resolution_hz(trial));
  bool is_sure = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    found.hums[axis] = std::norm(found.phasors[axis]) > stands_beside * found.around[axis];
    is_sure = is_sure || std::norm(found.phasors[axis]) > surely_stands_out * found.around[axis];
  }
  return is_sure ? std::optional(found) : std::nullopt;
}

}  // namespace

double HumLine::amplitude() const {
  double most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (hums[axis]) most = std::max(most, std::abs(phasors[axis]));
  return most;
}

bool can_show_line(const RecordedTrial& trial, Sensed sensed, double nominal_hz) {
  constexpr double shortest_s = 1, above_nyquist = 2.1;
  return (trial.*sensed).cols() > 0 && static_cast<double>(trial.samples()) >= shortest_s * trial.rate_hz &&
         trial.rate_hz > above_nyquist * nominal_hz;
}

std::vector<HumLine> hum_lines(const RecordedTrial& trial, Sensed sensed, Mains mains) {
  std::vector<HumLine> found;
  for (const MainsFrequency& of : mains_frequencies) {
    const bool is_asked = mains == Mains::any || mains == of.mains;
    if (!is_asked || !can_show_line(trial, sensed, of.hz)) continue;
    if (const auto line = hum_line(trial, sensed, of.hz)) found.push_back(*line);
  }
  return found;
}

bool position_has(const HumLine& line, const RecordedTrial& trial) {
  const HannLine of(trial, trial.seen(), line.nominal_hz);
  if (of.is_empty()) return false;
  const Phasors phasors = of.at(line.hz);
  const std::array<double, 3> around = power_around(of, line.hz, resolution_hz(trial));
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::norm(phasors[axis]) > surely_stands_out * around[axis]) return true;
  return false;
}

MainsHum take_off(const std::vector<HumLine>& lines, Sensed sensed, RecordedTrial& trial) {
  constexpr int passes = 3;  // with less hum left, fewer samples stand out because of it
  MainsHum found;
  for (const HumLine& line : lines) {
    const std::complex<double> turn = std::polar(1.0, 2 * std::numbers::pi * line.hz / trial.rate_hz);
    Phasors whole{};
    for (int pass = 0; pass < (line.is_of_air ? 1 : passes); ++pass) {
      const Phasors hum = pass == 0 ? line.phasors : HannLine(trial, sensed, line.nominal_hz).at(line.hz);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!line.hums[axis]) continue;
        take_off_axis(hum[axis], turn, static_cast<Eigen::Index>(axis), trial.*sensed);
        whole[axis] += hum[axis];
      }
    }
    for (const auto& phasor : whole)
      if (std::abs(phasor) > found.amplitude) found = {line.hz, std::abs(phasor)};
  }
  return found;
}

}  // namespace fingerpad
