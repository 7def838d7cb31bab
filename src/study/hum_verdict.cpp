#include "study/hum_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/number_text.hpp"
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
enum class HumReason { open, hum, not_while_still, not_steady };

HumReason judged_while_still(const HumEvidence& evidence) {
  constexpr double least_share = 0.5;
  if (!evidence.still.is_told()) return HumReason::open;
  return evidence.still.share() < least_share ? HumReason::not_while_still : HumReason::hum;
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

HumReason judged(const TrialLine& found, const std::vector<TrialLine>& lines,
                 const std::vector<RecordedTrial>& trials, std::size_t showing) {
  std::vector<const TrialLine*> alike;
  HumEvidence all;
  for (const TrialLine& other : lines) {
    if (!are_alike(found, other, trials)) continue;
    alike.push_back(&other);
    all += other.evidence;
  }
  for (const auto judge : {judged_while_still, judged_by_windows}) {
    for (const HumEvidence* evidence : {&found.evidence, &std::as_const(all)})
      if (const HumReason reason = judge(*evidence); reason != HumReason::open) return reason;
  }
  return is_in_most(alike, showing) ? HumReason::hum : HumReason::open;
}

std::string reason_words(HumReason reason, double nominal_hz) {
  if (reason == HumReason::not_while_still)
    return "it is not there where nothing touches the sensor or the finger stands still, and so is teeth of "
           "stick and slip";
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
};

}  // namespace

HumVerdict judge_hum(const std::vector<RecordedTrial>& trials, Sensed sensed, Mains mains) {
  HumVerdict verdict;
  verdict.lines.resize(trials.size());
  const bool are_forces = sensed == &RecordedTrial::force_W;
  const auto sensing = std::count_if(trials.begin(), trials.end(),
                                     [&](const RecordedTrial& trial) { return (trial.*sensed).cols() > 0; });
  std::array<std::vector<TrialLine>, mains_hz.size()> found;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    for (HumLine& line : hum_lines(trials[i], sensed, mains)) {
      if (mains != Mains::any) {
        verdict.lines[i].push_back(line);
        continue;
      }
      HumEvidence evidence = hum_evidence(trials[i], sensed, line);
      found[line.nominal_hz == mains_hz[0] ? 0 : 1].push_back({i, line, evidence});
    }
  }
  for (std::size_t k = 0; k < mains_hz.size(); ++k) {
    const auto showing =
        static_cast<std::size_t>(std::count_if(trials.begin(), trials.end(), [&](const RecordedTrial& trial) {
          return can_show_line(trial, sensed, mains_hz[k]);
        }));
    std::map<HumReason, LeftIn> left;
    for (const TrialLine& one : found[k]) {
      const HumReason reason = judged(one, found[k], trials, showing);
      if (reason == HumReason::hum) {
        verdict.lines[one.trial].push_back(one.line);
        continue;
      }
      LeftIn& here = left[reason];
      ++here.trials;
      if (one.line.amplitude() > here.most) here.most = one.line.amplitude(), here.hz = one.line.hz;
    }
    for (const auto& [reason, here] : left)
      verdict.left_in.push_back(
          fmt::format("a line near {:.0f} Hz is left in {} of {} trials, of at most {} {} at {:.2f} Hz: {}",
                      mains_hz[k], here.trials, sensing, rounded_text((are_forces ? 1 : 1e3) * here.most, 2),
                      are_forces ? "N" : "N mm", here.hz, reason_words(reason, mains_hz[k])));
  }
  return verdict;
}

}  // namespace fingerpad
