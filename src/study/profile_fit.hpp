#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/axes_exponent.hpp"
#include "study/block_draws.hpp"
#include "study/law_verdict.hpp"
#include "study/measurement.hpp"
#include "study/outlier_trials.hpp"
#include "study/pad_numbers.hpp"
#include "study/sensor_offset.hpp"

namespace fingerpad {

/// Why a number that is given has no interval.
enum class NoInterval {
  few_trials,     ///< fewer than three tell it
  few_a_subject,  ///< trials are drawn within each subject, of which most have one
  few_subjects,   ///< whole subjects are drawn, of which there are fewer than three
  draws_refused,  ///< too many draws of the trials do not give it
  no_spread,      ///< all draws give the same
};
inline constexpr long fewest_trials = 3;  ///< of which an interval is told

/// A profile from measurements.
struct ProfileFit {
  PadValues values;
  /// 95 %: low and high; nothing where the number is refused, or for the reason of no_interval.
  std::array<std::optional<std::pair<double, double>>, pad_number_keys.size()> interval;
  std::array<NoInterval, pad_number_keys.size()> no_interval{};
  double mu_load_n = 0;  ///< normal force at which mu_static and mu_dynamic hold: the geometric mean in slip,
                         ///< or at ruptures where no slip is surely seen
  std::size_t subjects = 0, trials = 0;
  /// By which springs were taken to mu_load_n; nothing where the pad's law may have it right, or where there
  /// is no spring.
  std::optional<AxesExponent> axes_exponent;
  std::vector<TrialEvidence> evidence;  ///< per trial of the measurement
  std::vector<OutlierTrial> outliers;
  LawResidual residual;
  SensorOffset offset;
  bool looks_for_tare = true;  ///< Measurement's
  bool knows_delay = false;    ///< likewise
  bool took_delay = false;     ///< a delay was found, of one file at least, and taken out
  double delay_left_s = 0;     ///< of force behind position, that the springs tell beside what was taken out;
                               ///< 0 where the delay is known
  bool tells_delay_left = false;    ///< that is over 0.5 ms, and beyond what trials differ by
  bool v_min_by_step = false;       ///< FitPoint's: v_min is a speed at which friction steps, no end of slip
  std::vector<std::string> doubts;  ///< why intervals of numbers are wider than their trials differ
  std::vector<std::string> steps;   ///< Measurement::steps
};

/// How intervals are made.
struct FitSettings {
  std::uint64_t seed = 1;
  Blocks blocks = Blocks::trials;
  /// Numbers that are refused as few trials tell them are given all the same: the best guess that they have
  /// of trials that are held out.
  bool keeps_told_by_few = false;
  /// Springs are taken to one load by how their trials go with the load (axes_exponent), if that is told.
  bool takes_axes_exponent = true;
};

/// Fits a pad's profile (pad_numbers). Trials of which the normal force alone was measured tell the normal
/// law beside the others (take_normal_law), and nothing else.
///
/// Interval: a block bootstrap, the trials of each subject drawn with replacement (so it holds for these
/// subjects, not for those who were not measured; with Blocks::subjects whole subjects are drawn); the
/// estimate -+ Student's t times the spread of the draws, or of the jackknife (interval_reach), and as far as
/// the number moves where what the sampling leaves unknown is a little otherwise: the sensors' noise a tenth
/// more than was taken off, the delay by half its interval more (and what the springs tell of its rest),
/// ruptures a twentieth of a sample later (of a bent spring by its cubic share more), ends of slip half a
/// sample earlier (and by as many more as teeth of stick and slip at v_min have less than six, or than 6 ms
/// hold), the peak of vibration a fortieth of the spectrum's step beside. The same seed gives the same
/// intervals.
ProfileFit fit_profile(const Measurement& measurement, const FitSettings& settings);

}  // namespace fingerpad
