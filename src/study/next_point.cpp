#include "study/next_point.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/number_text.hpp"
#include "study/axes_exponent.hpp"
#include "study/axis_numbers.hpp"
#include "study/hidden_stick.hpp"
#include "study/mu_load_exponent.hpp"
#include "study/press_fit.hpp"
#include "study/rupture_sums.hpp"
#include "study/static_friction.hpp"
#include "study/subjects_mean.hpp"
#include "study/unseen_slip.hpp"

namespace fingerpad {

void doubt_slip(const std::vector<TrialEvidence>& trials, FitPoint& point) {
  point.has_unseen_slip = true;
  point.load_of_slip = point.evidence.load;
  point.evidence.load.exponent = 0;
  const PadValue log_load =
      subjects_mean(trials, std::vector<int>(trials.size(), 1), &TrialEvidence::rupture_log_load,
                    &TrialEvidence::ruptures, enough_ruptures, "no rupture");
  if (log_load.refusal.empty())
    point.evidence.load.load_n = std::stod(rounded_text(std::exp(log_load.value), 3));
}

void trust_slip(FitPoint& point) {
  point.has_unseen_slip = false;
  point.evidence.load = point.load_of_slip;
}

FitPoint next_point(const std::vector<TrialEvidence>& trials, const FitPoint& point) {
  const std::vector<int> once(trials.size(), 1);
  FitPoint next = point;
  if (const auto log_load = mean_log_load(trials))
    next.evidence.load.load_n = std::stod(rounded_text(std::exp(*log_load), 3));
  next.trial_scatter = trial_scatter(trials);
  const PadValue exponent = mu_load_exponent(trials, once, point.evidence.load.exponent, next.trial_scatter);
  if (exponent.refusal.empty()) next.evidence.load.exponent = exponent.value;
  const auto axes =
      point.takes_axes_exponent ? axes_exponent(trials, point.evidence.axes_exponent) : std::nullopt;
  next.evidence.axes_exponent = axes ? axes->value : 0;
  const PressFit press = fit_press(trials, once, point.evidence.press_exponent);
  if (press.exponent > 0) next.evidence.press_exponent = std::clamp(press.exponent, 0.1, 2.0);
  const VibrationPeak peak = vibration_peak(slip_density(trials, once));
  next.vibration = peak.refusal.empty() ? std::optional(peak) : std::nullopt;
  const PadValues found = pad_numbers(trials, once, point);
  take_bends(found, next.evidence);
  next.evidence.own = own_frictions(trials);
  const PadValue& v_min = value_of(found, PadNumber::v_min);
  next.evidence.v_min_m_per_s = v_min.refusal.empty() ? v_min.value : 0;
  next.slow_slip = speed_step(trials, once);
  const bool step_left_no_slip =
      point.v_min_by_step && !value_of(found, PadNumber::mu_dynamic).refusal.empty();
  next.distrusts_step = point.distrusts_step || step_left_no_slip;
  if (next.slow_slip && (next.distrusts_step || !is_hidden_stick(found, *next.slow_slip)))
    next.slow_slip.reset();
  next.v_min_by_step = next.slow_slip && tells_v_min(*next.slow_slip, seen_v_min(trials, once));
  const PadValue& mu_dynamic = value_of(found, PadNumber::mu_dynamic);
  const bool may_hide = may_hide_stick(trials, next.slow_slip, found);
  next.evidence.hidden_stick_ratio = may_hide && mu_dynamic.refusal.empty() ? mu_dynamic.value : 0;
  if (next.slow_slip)
    next.evidence.v_min_m_per_s = std::max(next.evidence.v_min_m_per_s, next.slow_slip->speed_m_per_s);
  next.evidence.rupture_lag = rupture_lag(trials);
  next.evidence.drop_tail = drop_tail_samples(trials);
  next.has_unseen_slip = false;
  if (!unseen_slip_words(trials, found, next).empty()) doubt_slip(trials, next);
  next.pairs_friction = is_friction_unlike(trials);
  return next;
}

}  // namespace fingerpad
