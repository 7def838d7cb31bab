#include "study/hum_reason.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/sample_noise.hpp"

namespace fingerpad {
namespace {

/// Whether two lines may be one hum. A trial tells its frequency the better the longer it is.
bool are_alike(const TrialLine& one, const TrialLine& other, const std::vector<RecordedTrial>& trials) {
  constexpr double drift_hz = 0.1, of_resolution = 0.3;
  const auto resolution_hz = [&](const TrialLine& found) {
    return trials[found.trial].rate_hz / static_cast<double>(trials[found.trial].samples());
  };
  return std::abs(one.line.hz - other.line.hz) <
         drift_hz + of_resolution * std::max(resolution_hz(one), resolution_hz(other));
}

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

}  // namespace

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

}  // namespace fingerpad
