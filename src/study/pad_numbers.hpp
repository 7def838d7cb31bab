#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/trial_evidence.hpp"
#include "study/vibration_peak.hpp"

namespace fingerpad {

/// What a fit gives, in the order of a profile file.
enum class PadNumber {
  lateral_axis,
  longitudinal_axis,
  lateral_slope,
  longitudinal_slope,
  mu_static,
  mu_dynamic,
  mu_load_exponent,
  stick_stiffness,
  longitudinal_stiffness,
  lateral_linearity,
  longitudinal_linearity,
  lateral_cubic_share,
  longitudinal_cubic_share,
  lateral_hysteresis_area,
  longitudinal_hysteresis_area,
  v_min,
  vibration,
  vibration_bandwidth,
  normal_stiffness,
  normal_exponent,
};
inline constexpr std::array<std::string_view, 20> pad_number_keys{"lateral_axis_m",
                                                                  "longitudinal_axis_m",
                                                                  "lateral_slope_per_deg",
                                                                  "longitudinal_slope_per_deg",
                                                                  "mu_static",
                                                                  "mu_dynamic",
                                                                  "mu_load_exponent",
                                                                  "stick_stiffness_per_m",
                                                                  "longitudinal_stiffness_per_m",
                                                                  "lateral_linearity",
                                                                  "longitudinal_linearity",
                                                                  "lateral_cubic_share",
                                                                  "longitudinal_cubic_share",
                                                                  "lateral_hysteresis_area_m",
                                                                  "longitudinal_hysteresis_area_m",
                                                                  "v_min_m_per_s",
                                                                  "vibration_hz",
                                                                  "vibration_bandwidth_hz",
                                                                  "normal_stiffness_n_per_m",
                                                                  "normal_exponent"};

/// "m", "1/deg"; "1" of a pure number. Every key ends in its unit.
std::string_view unit_of_key(std::string_view key) noexcept;

/// Why a number is refused, where advice depends on it.
enum class RefusalReason {
  other,
  not_pushed,     ///< no stick along this axis was seen
  one_angle,      ///< stick was, at one angle of the finger that is far from 45 degrees
  hidden_stick,   ///< stick that gives way unseen passes for slip
  unseen_slip,    ///< the same, and no slip is surely seen: unseen_slip_words
  vague,          ///< too few trials, or too unlike ones, tell it
  unknown_zero,   ///< the force sensor's zero is not known, and an offset may be there
  unknown_delay,  ///< the delay of force behind position is not known
  no_friction,    ///< the normal force alone was measured
  impossible,     ///< it came out as no number, or as a size that is none
  contradiction,  ///< with another number, by the pad's law
};

/// A number, how many samples it rests on, and why there is none.
struct PadValue {
  double value = 0;
  long samples = 0;  ///< of stick or slip; of mu_static ruptures, of v_min ends of slip, of vibration windows
  long trials = 0;   ///< that it rests on
  std::string refusal;  ///< empty: the value holds
  RefusalReason reason = RefusalReason::other;

  /// An earlier refusal stays.
  void refuse(RefusalReason why, const std::string& words) {
    if (!refusal.empty()) return;
    refusal = words;
    reason = why;
  }
};
using PadValues = std::array<PadValue, pad_number_keys.size()>;

inline PadValue& value_of(PadValues& values, PadNumber number) noexcept {
  return values[static_cast<std::size_t>(number)];
}
inline const PadValue& value_of(const PadValues& values, PadNumber number) noexcept {
  return values[static_cast<std::size_t>(number)];
}

/// What earlier passes over the trials have found, about which the evidence is taken.
struct FitPoint {
  EvidencePoint evidence;
  bool takes_axes_exponent = true;         ///< FitSettings'
  std::optional<VibrationPeak> vibration;  ///< where a draw's own peak is looked for
  double trial_scatter = 0;                ///< of the trials' friction; see mu_load_exponent
  std::optional<SpeedStep> slow_slip;      ///< where slip's friction rises as it slows
  bool has_unseen_slip = false;            ///< what passes for slip may be teeth (unseen_slip_words)
  bool pairs_friction = false;             ///< trials are unlike one another (static_friction)
  bool contradicts_law = false;            ///< mu_static comes out below mu_dynamic
  MuLoadLaw load_of_slip;                  ///< what evidence.load is where it is not
  /// A step of friction over the speed of slip once left no slip above it: it was none, such as one that a
  /// load which is not taken out yet makes.
  bool distrusts_step = false;
  bool v_min_by_step = false;  ///< v_min is the speed at which it does (tells_v_min)
};

/// The numbers of the trials' evidence, each counted `times` (a bootstrap's draw; once each for the
/// estimate).
///
/// Each subject weighs the same, whatever its samples (paper, "Stick Ellipse"): a number is the mean of the
/// subjects' own. mu_static is the mean of |q| at ruptures, mu_dynamic of q in slip, both at the load of
/// `point`; mu_load_exponent is that of mu(n) = mu (n/load)^exponent in slip (refused where that may be
/// teeth); v_min the mean of the speeds at ends of slip, or the one at which friction steps in slip
/// (speed_step). Axes: a trial at angle alpha gives A of x = A g(r) (SpringBend), and a = A mu_s, where the
/// spring ends. Each subject's line a(alpha) gives its own a45, by which its points are normalised (figs. 5,
/// 6); the slope s is that of the weighted least squares line a/a45 = 1 - s (alpha - 45) over all subjects,
/// the weights of a subject's trials (by what they moved) adding up to 1. Where there is one angle only,
/// slopes are refused and axes given if it is within 10 degrees of 45. Where mu_static is refused, the axes
/// hold at 0.3, a profile's default, and the spring is taken for straight: their quotient is what is
/// measured. stick_stiffness is mu_s/a45, k_f across the finger, longitudinal_stiffness along it; without
/// directions stick_stiffness is the mean over those that were pushed. cubic_share is c of the finger-pad
/// law's third-order spring; hysteresis_area that of the loop of force ratio over displacement, pushed to the
/// limit both ways, 4 h mu_s (too small where the loop turns slowly: of one that turns within a tenth of the
/// reach some 70 %); linearity the share of the displacement's variance that a straight line explains.
/// Vibration: see vibration_peak. normal_stiffness is dn/d(depth) at 1 N of n ~ depth^normal_exponent. What
/// is not finite, or not above 0 where it must be, is refused.
PadValues pad_numbers(const std::vector<TrialEvidence>& trials, const std::vector<int>& times,
                      const FitPoint& point);

/// The mean speed at which slip is seen to end.
PadValue seen_v_min(const std::vector<TrialEvidence>& trials, const std::vector<int>& times);

/// All that rests on the stick of one axis or of the other: lateral ones at even places, longitudinal ones at
/// odd.
inline constexpr std::array<PadNumber, 12> spring_numbers{PadNumber::lateral_axis,
                                                          PadNumber::longitudinal_axis,
                                                          PadNumber::lateral_slope,
                                                          PadNumber::longitudinal_slope,
                                                          PadNumber::stick_stiffness,
                                                          PadNumber::longitudinal_stiffness,
                                                          PadNumber::lateral_linearity,
                                                          PadNumber::longitudinal_linearity,
                                                          PadNumber::lateral_cubic_share,
                                                          PadNumber::longitudinal_cubic_share,
                                                          PadNumber::lateral_hysteresis_area,
                                                          PadNumber::longitudinal_hysteresis_area};

}  // namespace fingerpad
