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
#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

/// A line of one of the trials.
struct TrialLine {
  std::size_t trial = 0;
  HumLine line;
  HumEvidence evidence;
};

/// Whether two lines may be one hum. A trial tells its frequency the better the longer it is.
bool are_alike(const TrialLine& one, const TrialLine& other, const std::vector<RecordedTrial>& trials) {
  constexpr double drift_hz = 0.1, of_resolution = 0.3;
  const auto resolution_hz = [&](const TrialLine& found) {
    return trials[found.trial].rate_hz / static_cast<double>(trials[found.trial].samples());
  };
  return std::abs(one.line.hz - other.line.hz) <
         drift_hz + of_resolution * std::max(resolution_hz(one), resolution_hz(other));
}

/// What a line is taken for, and why.
enum class HumReason { open, hum, not_while_still, not_steady, beside_air, in_position };

HumReason judged_by_share(const HumShare& here) {
  constexpr double least_share = 0.5;
  if (!here.is_told()) return HumReason::open;
  return here.share() < least_share ? HumReason::not_while_still : HumReason::hum;
}
HumReason judged_while_still(const HumEvidence& evidence) {
  return judged_by_share(evidence.still);
}
HumReason judged_in_air(const HumEvidence& evidence) {
  return judged_by_share(evidence.in_air);
}

/// Teeth follow the speed: a line that goes on at others is hum. One that is seen at one speed alone, or
/// beside it in turns, is left open.
HumReason judged_by_windows(const HumEvidence& evidence) {
  constexpr long fewest = 8, fewest_other = 4;
  constexpr double least_steady = 0.6, other_speed = 0.25;
  std::vector<double> steady_at;
  for (const HumWindow& window : evidence.windows)
    if (window.is_steady) steady_at.push_back(window.speed_m_per_s);
  const auto windows = static_cast<double>(evidence.windows.size());
  if (evidence.windows.size() < fewest) return HumReason::open;
  if (static_cast<double>(steady_at.size()) < least_steady * windows) return HumReason::not_steady;
  const double usual = median_of(steady_at);
  long others = 0, steady = 0;
  for (const HumWindow& window : evidence.windows) {
    if (window.turns || std::abs(window.speed_m_per_s - usual) < other_speed * usual) continue;
    ++others;
    steady += window.is_steady ? 1 : 0;
  }
  if (others < fewest_other) return HumReason::open;
  return static_cast<double>(steady) < least_steady * static_cast<double>(others) ? HumReason::not_steady
                                                                                  : HumReason::hum;
}

/// Most trials have the line, and teeth would have to be what they cannot: of one frequency at speeds that
/// differ, or in step through each turn of the finger. (From one way to the other they may be, by chance.)
bool is_in_most(const std::vector<const TrialLine*>& alike, std::size_t showing) {
  constexpr double least_spread = 0.1;  // of the speed, between the quartiles
  constexpr double least_steady = 0.8;
  constexpr long fewest_turns = 6;
  if (alike.size() < 3 || 2 * alike.size() <= showing) return false;
  std::vector<double> speeds;
  speeds.reserve(alike.size());
  for (const TrialLine* found : alike) speeds.push_back(found->evidence.speed_m_per_s);
  if (quantile(speeds, 0.75) - quantile(speeds, 0.25) > least_spread * quantile(speeds, 0.5)) return true;
  long windows = 0, steady = 0, turns = 0, steady_turns = 0;
  for (const TrialLine* line : alike) {
    for (const HumWindow& window : line->evidence.windows) {
      ++windows;
      steady += window.is_steady ? 1 : 0;
      turns += window.turns ? 1 : 0;
      steady_turns += window.turns && window.is_steady ? 1 : 0;
    }
  }
  return turns >= fewest_turns &&
         static_cast<double>(steady_turns) > least_steady * static_cast<double>(turns) &&
         static_cast<double>(steady) > least_steady * static_cast<double>(windows);
}

HumReason reason_of(const TrialLine& found, const std::vector<TrialLine>& lines,
                    const std::vector<RecordedTrial>& trials, std::size_t showing) {
  std::vector<const TrialLine*> alike;
  HumEvidence all;
  for (const TrialLine& other : lines) {
    if (!are_alike(found, other, trials)) continue;
    alike.push_back(&other);
    all += other.evidence;
  }
  const auto judged_by = [&](HumReason (*judge)(const HumEvidence&)) {
    const HumReason own = judge(found.evidence);
    return own == HumReason::open ? judge(all) : own;
  };
  HumReason reason = judged_by(judged_while_still);
  if (reason == HumReason::open) reason = judged_by(judged_by_windows);
  if (reason == HumReason::open && is_in_most(alike, showing)) reason = HumReason::hum;
  // A finger that vibrates does so at any speed, and where it rests: the air alone tells that from hum.
  const HumReason in_air = judged_by(judged_in_air);
  if (reason != HumReason::hum || in_air == HumReason::hum || !position_has(found.line, trials[found.trial]))
    return reason;
  return in_air == HumReason::open ? HumReason::in_position : in_air;
}

std::string reason_words(HumReason reason, double nominal_hz) {
  if (reason == HumReason::not_while_still)
    return "it is not there where nothing touches the sensor or the finger stands still, and so is of teeth "
           "of stick and slip, or of a finger that vibrates";
  if (reason == HumReason::beside_air)
    return "it is what stands there beyond the hum that is seen in the air, which is taken out, and so is "
           "of teeth of stick and slip, or of a finger that vibrates";
  if (reason == HumReason::in_position)
    return fmt::format(
        "the finger's position moves at that frequency too, so that the force may really be there, and no "
        "moment without contact tells: --mains {:.0f} takes it out, if it is hum",
        nominal_hz);
  if (reason == HumReason::not_steady)
    return "it does not keep its amplitude and phase as the finger moves on, as teeth of stick and slip do "
           "not";
  return fmt::format(
      "nothing tells it from teeth of stick and slip (no moment without contact, or of a finger at rest): "
      "--mains {:.0f} takes it out, if it is hum",
      nominal_hz);
}

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
