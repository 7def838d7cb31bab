#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "study/speed_step.hpp"
#include "study/stick_segments.hpp"

namespace fingerpad {

/// How friction changes with the load: mu(n) = mu (n/load_n)^exponent. Force ratios are taken to what they
/// would be at load_n.
struct MuLoadLaw {
  double load_n = 1, exponent = 0;
};

/// What stick says of one axis' spring, as sums over products about each stretch's means; see SpringTerm.
using SpringSums = Eigen::Matrix<double, 6, 6>;
/// Rows and columns of SpringSums, for the displacement along one axis
///   x = A s (g(r) + e dg/dc(r)) + h v/|v| + d v,   r = -q:
/// the position, s g of SpringBend, what it changes with the cubic share, v/|v|, v and s r along the axis; s
/// is EvidencePoint::axes_at the load, 1 in the pad's law.
enum SpringTerm : Eigen::Index {
  spring_position,
  spring_ratio,
  spring_cubic,
  spring_direction,
  spring_speed,
  spring_straight
};

/// How the finger-pad law's third-order spring gives way to a force ratio r, mu_s being its end:
///   |r| = mu_s rho (1 - c + c rho^2),   g = mu_s rho r/|r|,   so that x = A g and the axis is A mu_s.
struct SpringBend {
  double mu_static = 0.3;  ///< > 0
  double cubic_share = 0;  ///< c, 0 to 0.9
  /// g, and its derivative by c, per unit of r.
  Vec2 at(double ratio) const noexcept;
};

/// So many ends of stick are needed before they tell anything.
inline constexpr long fewest_gives = 5;

/// Whether stick gives way mostly without a drop of the force, where it ends often enough to tell.
inline bool gives_without_drops(long gives, long drops) noexcept {
  return gives >= fewest_gives && 2 * drops < gives;
}

/// Whether slip is seen to end in stick in less than a quarter of the times that stick ends in slip.
inline bool hardly_ends_in_stick(long gives, long stops) noexcept {
  return 4 * stops < gives;
}

/// What one trial says about the pad, as sums: those of several trials add up, so that a bootstrap is quick.
struct TrialEvidence {
  int subject = 0;
  bool has_direction = false;
  double inclination_deg = 0;
  double rate_hz = 0;
  double position_noise_m = 0;  ///< StickSegments::position_noise_m
  std::array<SpringSums, 2> spring{SpringSums::Zero(), SpringSums::Zero()};  ///< lateral, longitudinal
  /// What was taken off `spring` for the sensors' noise, which is itself an estimate.
  std::array<SpringSums, 2> spring_noise{SpringSums::Zero(), SpringSums::Zero()};
  long stick_samples = 0;
  double stick_log_load = 0;    ///< sum over them of ln(n/1 N)
  double rupture_ratio = 0;     ///< sum over ruptures of |q| just before it
  double rupture_rise = 0;      ///< sum of what |q| rises from sample to sample before them
  double rupture_log_load = 0;  ///< sum of ln(n/1 N) just before them
  long ruptures = 0;
  double drop_lag = 0;  ///< sum over drop_lags of the samples by which a drop's middle is late (rupture_lag)
  long drop_lags = 0;   ///< ruptures after which stick surely goes on, which tell it
  double short_drop = 0;  ///< sum of what |q| falls at short_teeth
  long short_teeth = 0;   ///< ruptures of teeth with too few samples to tell where they gave way
  double slip_ratio = 0;  ///< sum over slip of r = -q.v/|v|, which and n are means over 20 ms here
  double slip_load = 0, slip_load_2 = 0, slip_load_ratio = 0;  ///< sums of L, L^2 and L r, L = ln(n/load_n)
  double slip_log_load = 0;                                    ///< sum of ln(n/1 N)
  long slip_samples = 0;
  SlipBySpeed slip_by_speed;        ///< with its slow ends
  double stop_speed_m_per_s = 0;    ///< sum over ends of slip of the speed at which q begins to rise
  double stop_slowing_m_per_s = 0;  ///< sum of how much the finger slows there from sample to sample
  double stop_rise = 0;  ///< sum of what friction is above the trial's in slip just before them (30 ms; no
                         ///< less than 15 samples)
  long stops = 0;
  /// Ends of stick in slip; of these, with a drop of the force (ruptures). Without one they count where the
  /// finger was pulled by less than three quarters of slip's friction before.
  long gives = 0, drops = 0;
  /// Of the gives, those before which it was pulled so little: stick that began anew; and of these the drops.
  long strokes = 0, stroke_drops = 0;
  double unseen_drop = 0;  ///< of friction, that noise would hide
  /// Whether teeth of stick and slip at v_min may pass for slip in this trial, as its noise hides their drops
  /// or they have too few samples: slower than v_min its slip is none then. Loads differ in this.
  bool hides_teeth = false;
  std::vector<std::size_t> stop_samples;  ///< where the spring says that slip ended, of each
  std::vector<double> power;              ///< sum over pieces of slip of Welch's density of r
  long pieces = 0;
  std::vector<LineLeftIn> lines_left_in;  ///< that may stand in `power` too
  /// Sums of products, about the trial's means, of -height, n^w and n^w ln n over means of some samples of
  /// contact (n in N).
  Mat3 press = Mat3::Zero();
  double press_load_2 = 0;    ///< likewise of ln n with itself
  double press_log_load = 0;  ///< sum over groups of ln n
  long press_samples = 0, press_groups = 0;

  /// Whether it slips for long enough to tell its friction alone, and that.
  bool tells_slip() const noexcept { return slip_samples >= 100 && slip_ratio > 0; }
  double mean_slip() const noexcept { return slip_ratio / static_cast<double>(slip_samples); }
};

/// The samples of one of Welch's windows, a quarter of a second and a power of two.
std::size_t vibration_window(double rate_hz);

/// A subject's friction at ruptures, and in the slip of the same trials; 0: not known.
struct OwnFriction {
  double mu_static = 0, mu_dynamic = 0;
};

/// What the last pass over the trials has told, that sums are taken about.
struct EvidencePoint {
  MuLoadLaw load;
  double axes_exponent = 0;      ///< of the stick axes over the load, which springs are taken to load_n by
  double press_exponent = 0.5;   ///< w of depth ~ n^w
  std::vector<OwnFriction> own;  ///< each subject's; of others it is not known yet
  double v_min_m_per_s = 0;      ///< below which what seems to slip is stick whose ruptures are not seen
  std::array<SpringBend, 2>
      bend;  ///< lateral, longitudinal: what is left of a share to find is small about it
  /// The force ratio of slip, where stick may give way unseen within what is taken for stick or slip: then
  /// the springs are told from where it surely does not (surest_pull). 0: where all of it is seen.
  double hidden_stick_ratio = 0;
  double rupture_lag = 0;     ///< samples by which the sensor's drop at a rupture is later than at once
  std::size_t drop_tail = 0;  ///< StickSegments', as drop_tail_samples tells it
  bool knows_delay = false;   ///< then no rest of it is looked for: it would take part of a loop

  /// Its subject's; of a trial that slips with a fifth more friction, or less, so many times as much.
  /// 0: not known yet.
  double mu_static_of(const TrialEvidence& trial) const {
    constexpr double unlike = 0.2;
    const auto i = static_cast<std::size_t>(trial.subject);
    if (i >= own.size()) return 0;
    if (!trial.tells_slip() || !(own[i].mu_dynamic > 0)) return own[i].mu_static;
    const double times = trial.mean_slip() / own[i].mu_dynamic;
    return std::abs(times - 1) > unlike ? times * own[i].mu_static : own[i].mu_static;
  }
  /// How long the stick axes are under a load, over those at load.load_n.
  double axes_at(double load_n) const {
    return axes_exponent == 0 ? 1 : std::pow(load_n / load.load_n, axes_exponent);
  }
};

/// Gathers a trial's evidence.
///
/// mu_s: at a rupture, the line through the last six to eight samples, half a sample after the last of
/// them. mu_d: mean over slip. Stiffness: regression of x on q in each stretch of stick, without the half
/// window beside a border that is not a rupture, over means of some samples, and without the sensors' noise.
/// v_min (paper, fig. 9): where slip ends, q rises from mu_d along the spring, q = mu_d + K (s - s*); s* is
/// where slip ended and the speed there is v_min. A stop counts where the finger slows, and the rise is
/// five times the noise and four times what friction varies by in the slip before it and in all of the trial.
/// Friction that rises before it says that slip ended sooner: stick that gives way within some samples passes
/// for slip.
TrialEvidence trial_evidence(const MeasuredTrial& trial, const StickSegments& segments,
                             const EvidencePoint& about);

/// What its presses alone say, of a trial that may tell no friction.
/// @param exponent  EvidencePoint::press_exponent
TrialEvidence press_evidence(const MeasuredTrial& trial, double exponent);

}  // namespace fingerpad
