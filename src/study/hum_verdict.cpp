#include "study/hum_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "base/number_text.hpp"
#include "study/air_hum.hpp"
#include "study/hum_evidence.hpp"
#include "study/hum_reason.hpp"
#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

/// Lines that are left in for one reason.
struct LeftIn {
  std::size_t trials = 0;
  double most = 0, hz = 0;  ///< amplitude, and its frequency

  void add(double amplitude, double line_hz) {
    ++trials;
    if (amplitude > most) most = amplitude, hz = line_hz;
  }
};

/// What is left of a line, at the trial's middle, where what is hum is taken off.
double left_of(const HumLine& line, const HumLine& hum, const RecordedTrial& trial) {
  const double middle = static_cast<double>(trial.samples()) / 2;
  double most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at_middle = [&](const HumLine& of) {
      return of.phasors[axis] * std::polar(1.0, 2 * std::numbers::pi * of.hz / trial.rate_hz * middle);
    };
    if (line.hums[axis]) most = std::max(most, std::abs(at_middle(line) - at_middle(hum)));
  }
  return most;
}

/// Whether an amplitude is more than what stands beside a line.
bool stands_out(const HumLine& line, double amplitude) {
  constexpr double deviations = 3.5;  // as a line's own: twelvefold in power
  return amplitude * amplitude >
         deviations * deviations * *std::max_element(line.around.begin(), line.around.end());
}

/// What of each line is hum, where the air tells that the whole of it is not: teeth may stand beside hum, or
/// hum beneath teeth. Between frequencies that moments in the air do not part, most of the trials decide.
std::vector<std::optional<HumLine>> bounded_by_air(const std::vector<TrialLine>& lines,
                                                   const std::vector<RecordedTrial>& trials, Sensed sensed) {
  constexpr std::size_t fewest = 3;
  std::vector<std::optional<HumLine>> found;
  std::vector<double> hums_hz;
  const auto air_of = [&](const TrialLine& one) {
    return AirHum(trials[one.trial], sensed, one.evidence.free, one.line.nominal_hz);
  };
  for (const TrialLine& one : lines) {
    const AirHum air = air_of(one);
    found.push_back(air.is_like(one.line) ? std::nullopt : air.bounded(one.line, one.line.hz));
    if (air.reach_hz() > 0) hums_hz.push_back(found.back() ? found.back()->hz : one.line.hz);
  }
  if (hums_hz.size() < fewest) return found;
  const double usual_hz = median_of(hums_hz);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (!found[k]) continue;
    const AirHum air = air_of(lines[k]);
    if (std::abs(found[k]->hz - usual_hz) > air.reach_hz()) found[k] = air.bounded(lines[k].line, usual_hz);
  }
  return found;
}

/// Judges the lines near one frequency of the mains: puts what is hum, and what is left in, into the trials'
/// own, and says what is left in.
std::map<HumReason, LeftIn> judge_lines(const std::vector<TrialLine>& lines,
                                        const std::vector<RecordedTrial>& trials, Sensed sensed,
                                        std::size_t showing, HumVerdict& verdict) {
  std::map<HumReason, LeftIn> left;
  const auto leave_in = [&](const TrialLine& one, HumReason reason, double amplitude) {
    left[reason].add(amplitude, one.line.hz);
    verdict.lines_left_in[one.trial].push_back({one.line.nominal_hz, amplitude});
  };
  const std::vector<std::optional<HumLine>> bounded = bounded_by_air(lines, trials, sensed);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const TrialLine& one = lines[k];
    if (bounded[k]) {
      verdict.lines[one.trial].push_back(*bounded[k]);
      const double rest = left_of(one.line, *bounded[k], trials[one.trial]);
      if (stands_out(one.line, rest)) leave_in(one, HumReason::beside_air, rest);
      continue;
    }
    const HumReason reason = reason_of(one, lines, trials, showing);
    if (reason == HumReason::hum) {
      verdict.lines[one.trial].push_back(one.line);
    } else {
      leave_in(one, reason, one.line.amplitude());
    }
  }
  return left;
}

}  // namespace

HumVerdict judge_hum(const std::vector<RecordedTrial>& trials, Sensed sensed, Mains mains) {
  const auto is_asked_for = [&](double nominal_hz) {
    return std::ranges::any_of(mains_frequencies, [&](const MainsFrequency& one) {
      return one.mains == mains && one.hz == nominal_hz;
    });
  };
  HumVerdict verdict;
  verdict.lines.resize(trials.size());
  verdict.lines_left_in.resize(trials.size());
  const bool are_forces = sensed == &RecordedTrial::force_W;
  const auto sensing = std::count_if(trials.begin(), trials.end(),
                                     [&](const RecordedTrial& trial) { return (trial.*sensed).cols() > 0; });
  std::map<double, std::vector<TrialLine>> found;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    for (HumLine& line : hum_lines(trials[i], sensed, Mains::any)) {
      if (mains != Mains::any) {
        if (is_asked_for(line.nominal_hz))
          verdict.lines[i].push_back(line);
        else
          verdict.lines_left_in[i].push_back({line.nominal_hz, line.amplitude()});
        continue;
      }
      HumEvidence evidence = hum_evidence(trials[i], sensed, line);
      found[line.nominal_hz].push_back({i, line, std::move(evidence)});
    }
  }
  for (const auto& [nominal, lines] : found) {
    const double nominal_hz = nominal;
    const auto showing =
        static_cast<std::size_t>(std::count_if(trials.begin(), trials.end(), [&](const RecordedTrial& trial) {
          return can_show_line(trial, sensed, nominal_hz);
        }));
    for (const auto& [reason, here] : judge_lines(lines, trials, sensed, showing, verdict))
      verdict.left_in.push_back(
          fmt::format("a line near {:.0f} Hz is left in {} of {} trials, of at most {} {} at {:.2f} Hz: {}",
                      nominal_hz, here.trials, sensing, rounded_text((are_forces ? 1 : 1e3) * here.most, 2),
                      are_forces ? "N" : "N mm", here.hz, reason_words(reason, nominal_hz)));
  }
  return verdict;
}

}  // namespace fingerpad
