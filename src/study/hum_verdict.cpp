#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/number_text.hpp"
#include "study/force_tare.hpp"
#include "study/mains_hum.hpp"
#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

/// How much of a line is there in some samples: 1 of what keeps its amplitude and phase, 0 of what is not
/// there; with the weight of what tells it.
struct HumShare {
  double sum = 0, weight = 0, variance = 0;
  HumShare& operator+=(const HumShare& other) {
    sum += other.sum;
    weight += other.weight;
    variance += other.variance;
    return *this;
  }
  double share() const noexcept { return sum / weight; }
  bool is_told() const noexcept {
    constexpr double sure = 0.15;
    return weight > 0 && std::sqrt(variance) < sure * weight;
  }
};

/// What of a line is in a run of samples, beside the straight line through them.
HumShare share_of(const RecordedTrial& trial, const HumLine& line, Eigen::Index from, Eigen::Index to) {
  HumShare found;
  const auto count = static_cast<double>(to - from);
  const double turn = 2 * std::numbers::pi * line.hz / trial.rate_hz;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!line.hums[axis]) continue;
    const auto row = trial.force_W.row(static_cast<Eigen::Index>(axis)).segment(from, to - from);
    const double middle = (count - 1) / 2, mean = row.mean();
    double drift = 0, squares = 0;
    for (Eigen::Index i = 0; i < row.size(); ++i) {
      drift += (static_cast<double>(i) - middle) * (row[i] - mean);
      squares += (static_cast<double>(i) - middle) * (static_cast<double>(i) - middle);
    }
    std::complex<double> sum = 0;
    double power = 0;
    for (Eigen::Index i = 0; i < row.size(); ++i) {
      const double off = row[i] - mean - drift / squares * (static_cast<double>(i) - middle);
      sum += off * std::polar(1.0, -turn * static_cast<double>(from + i));
      power += off * off / count;
    }
    const double line2 = std::norm(line.phasors[axis]);
    // Of a sine half of the power is its own.
    const double noise2 = std::max(0.0, power - 0.5 * std::norm(2.0 * sum / count));
    found.sum += 2 * (sum * std::conj(line.phasors[axis])).real();
    found.weight += count * line2;
    found.variance += 2 * count * line2 * noise2;
  }
  return found;
}

/// Of the moments without contact. With the line in them they may not be as still as such moments are.
HumShare share_in_air(const RecordedTrial& trial, const HumLine& line) {
  std::vector<Eigen::Index> free = samples_without_contact(trial);
  if (free.empty()) {
    RecordedTrial without = trial;
    take_off({line}, without);
    free = samples_without_contact(without);
  }
  HumShare found;
  const auto shortest = static_cast<Eigen::Index>(2 * trial.rate_hz / line.hz);
  for (std::size_t from = 0, to = 0; from < free.size(); from = to) {
    for (to = from + 1; to < free.size() && free[to] == free[to - 1] + 1;) ++to;
    if (free[to - 1] + 1 - free[from] >= shortest)
      found += share_of(trial, line, free[from], free[to - 1] + 1);
  }
  return found;
}

/// Of the slower and the faster half of a trial, and of its quarters one after another.
using PartShares = std::array<HumShare, 6>;

PartShares shares_of_parts(const RecordedTrial& trial, const HumLine& line) {
  constexpr double window_s = 0.2;
  const auto window = static_cast<Eigen::Index>(window_s * trial.rate_hz);
  std::vector<std::pair<double, Eigen::Index>> by_speed;
  for (Eigen::Index from = 0; from + window <= trial.samples(); from += window) {
    double way_m = 0;
    const Eigen::Index step = std::max<Eigen::Index>(1, window / 10);
    for (Eigen::Index i = from; i + step < from + window; i += step)
      way_m += (trial.position_W.col(i + step) - trial.position_W.col(i)).norm();
    by_speed.emplace_back(way_m, from);
  }
  std::sort(by_speed.begin(), by_speed.end());
  PartShares parts;
  for (std::size_t k = 0; k < by_speed.size(); ++k) {
    const Eigen::Index from = by_speed[k].second;
    const HumShare share = share_of(trial, line, from, from + window);
    parts[2 * k < by_speed.size() ? 0 : 1] += share;
    parts[2 + static_cast<std::size_t>(4 * from / trial.samples())] += share;
  }
  return parts;
}

/// A line of one of the trials.
struct TrialLine {
  std::size_t trial;
  HumLine line;
};

/// Those at one frequency. A trial tells it the better the longer it is.
std::vector<TrialLine> alike(const std::vector<TrialLine>& lines, const std::vector<RecordedTrial>& trials) {
  constexpr double drift_hz = 0.1, of_resolution = 0.3;
  std::vector<double> all_hz;
  for (const TrialLine& found : lines) all_hz.push_back(found.line.hz);
  const double middle_hz = median_of(all_hz);
  std::vector<TrialLine> kept;
  for (const TrialLine& found : lines) {
    const RecordedTrial& trial = trials[found.trial];
    const double resolution_hz = trial.rate_hz / static_cast<double>(trial.samples());
    if (std::abs(found.line.hz - middle_hz) < drift_hz + of_resolution * resolution_hz) kept.push_back(found);
  }
  return kept;
}

/// Why lines that stand in most trials are no hum; empty where they are.
std::string no_hum_words(const std::vector<TrialLine>& lines, const std::vector<RecordedTrial>& trials) {
  constexpr double least_share = 0.5;
  HumShare air;
  for (const TrialLine& found : lines) air += share_in_air(trials[found.trial], found.line);
  if (air.is_told()) return air.share() < least_share ? "is not there where nothing touches the sensor" : "";
  PartShares parts;
  for (const TrialLine& found : lines) {
    const PartShares own = shares_of_parts(trials[found.trial], found.line);
    for (std::size_t k = 0; k < parts.size(); ++k) parts[k] += own[k];
  }
  const bool keeps = std::all_of(parts.begin(), parts.end(), [](const HumShare& part) {
    return !(part.weight > 0) || part.share() > least_share;
  });
  return keeps ? "" : "does not keep its amplitude and phase while the finger sticks and slips";
}

}  // namespace

HumVerdict judge_hum(const std::vector<RecordedTrial>& trials, Mains mains) {
  HumVerdict verdict;
  verdict.lines.resize(trials.size());
  std::vector<std::vector<HumLine>> all;
  for (const RecordedTrial& trial : trials) all.push_back(hum_lines(trial, mains));
  for (const double nominal_hz : {50.0, 60.0}) {
    std::vector<TrialLine> lines;
    for (std::size_t i = 0; i < trials.size(); ++i)
      for (const HumLine& line : all[i])
        if (line.nominal_hz == nominal_hz) lines.push_back({i, line});
    if (lines.empty()) continue;
    const std::size_t found = lines.size();
    lines = alike(lines, trials);
    const std::string words =
        2 * lines.size() <= trials.size()
            ? fmt::format("stands at one frequency in {} of {} trials only", lines.size(), trials.size())
            : no_hum_words(lines, trials);
    if (words.empty()) {
      for (const TrialLine& hum : lines) verdict.lines[hum.trial].push_back(hum.line);
      continue;
    }
    verdict.left_in +=
        fmt::format("{}a line near {} Hz in {} trial{} is left in: it {}, as teeth of stick and slip do",
                    verdict.left_in.empty() ? "" : "; ", rounded_text(nominal_hz, 3), found,
                    found == 1 ? "" : "s", words);
  }
  return verdict;
}

}  // namespace fingerpad
