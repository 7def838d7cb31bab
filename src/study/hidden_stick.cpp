#include "study/hidden_stick.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

/// So many times as fast as slip is seen to end is surely faster: a step is known to a bin of speed, and lies
/// up to one too high where the finger's speed is noisy.
constexpr double faster = 1.03 + SlipBySpeed::bin_width;

/// Of all trials, how often stick gives way to slip, and slip is seen to end in it.
struct SeenEnds {
  long gives = 0, drops = 0, stops = 0;

  explicit SeenEnds(const std::vector<TrialEvidence>& trials) {
    for (const TrialEvidence& trial : trials) {
      gives += trial.gives;
      drops += trial.drops;
      stops += trial.stops;
    }
  }
  bool give_way_unseen() const noexcept { return gives_without_drops(gives, drops); }
};

bool has_short_teeth(const std::vector<TrialEvidence>& trials) {
  return std::any_of(trials.begin(), trials.end(), [](const TrialEvidence& t) { return t.short_teeth > 0; });
}

}  // namespace

std::string hidden_stick_words(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                               const std::optional<SpeedStep>& slow_slip, const PadValues& found) {
  constexpr double most_rise = 0.25;  // of what a rupture drops; of hidden teeth it is half of that
  const PadValue &mu_static = value_of(found, PadNumber::mu_static),
                 &mu_dynamic = value_of(found, PadNumber::mu_dynamic);
  const PadValue v_min = seen_v_min(trials, times);
  const bool is_seen = v_min.refusal.empty();
  const std::string seen = is_seen ? fmt::format("is seen to end at {} m/s", rounded_text(v_min.value, 3))
                                   : std::string("is not plainly seen to end in stick");
  if (mu_static.samples == 0 && has_short_teeth(trials))
    return fmt::format(
        "slip {}, where stick gives way again within a few samples, and passes for slip before: sample "
        "faster",
        seen);
  const SeenEnds ends(trials);
  if (ends.give_way_unseen() && hardly_ends_in_stick(ends.gives, ends.stops))
    return fmt::format(
        "stick gives way without a drop of the force at {} of its {} ends, and slip is seen to end in stick "
        "{} times only: where the finger sticks is not told, or it hardly does",
        ends.gives - ends.drops, ends.gives, ends.stops);
  if (slow_slip && (!is_seen || slow_slip->speed_m_per_s > faster * v_min.value))
    return fmt::format(
        "slip {}, but its friction is up by {} already below {} m/s: stick that gives way again "
        "within a few samples hides there (then sample faster), or friction rises as the finger slows",
        seen, rounded_text(slow_slip->rise, 3), rounded_text(slow_slip->speed_m_per_s, 3));
  if (!is_seen || !mu_static.refusal.empty() || !mu_dynamic.refusal.empty()) return {};
  double rise = 0, stops = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    rise += times[i] * trials[i].stop_rise;
    stops += static_cast<double>(times[i] * trials[i].stops);
  }
  rise /= stops;
  const double drop = mu_static.value - mu_dynamic.value;
  if (!(drop > 0) || !(rise > most_rise * drop)) return {};  // subjects that differ may have no drop
  return fmt::format(
      "friction is up by {:.0f} % of what a rupture drops just before slip is seen to end (at {} m/s): "
      "stick that gives way again within a few samples hides there (then sample faster), or friction rises "
      "as the finger slows",
      100 * rise / drop, rounded_text(v_min.value, 3));
}

bool is_hidden_stick(const PadValues& found, const SpeedStep& slow) {
  constexpr double least_of_drop = 0.25, least_of_friction = 0.04;
  const PadValue &mu_static = value_of(found, PadNumber::mu_static),
                 &mu_dynamic = value_of(found, PadNumber::mu_dynamic);
  if (!mu_dynamic.refusal.empty() || !(slow.rise > least_of_friction * mu_dynamic.value)) return false;
  return !mu_static.refusal.empty() || slow.rise > least_of_drop * (mu_static.value - mu_dynamic.value);
}

bool tells_v_min(const SpeedStep& slow, const PadValue& seen) {
  return slow.is_sharp && (!seen.refusal.empty() || slow.speed_m_per_s > faster * seen.value);
}

bool may_hide_stick(const std::vector<TrialEvidence>& trials, const std::optional<SpeedStep>& slow_slip,
                    const PadValues& found) {
  const std::vector<int> once(trials.size(), 1);
  const SeenEnds ends(trials);
  if (ends.give_way_unseen() || (ends.gives >= fewest_gives && ends.stops == 0)) return true;
  return !hidden_stick_words(trials, once, slow_slip, found).empty();
}

}  // namespace fingerpad
