#pragma once

#include <vector>

#include "study/stick_segments.hpp"

namespace fingerpad {

/// What one trial says about the pad, as sums: those of several trials add up, so that a bootstrap is quick.
struct TrialEvidence {
  int subject = 0;
  bool has_direction = false;
  double inclination_deg = 0;
  double rate_hz = 0;
  /// Sums over stick of dx^2 and of -dq dx, lateral and longitudinal: their quotient is the stiffness per
  /// newton mu_s/a, mu_s/b (the ellipse's closure parts the axes). dx^2 is without the noise of positions.
  Vec2 spread_m2{0, 0}, pull_m{0, 0};
  long stick_samples = 0;
  double rupture_ratio = 0;  ///< sum over ruptures of |q| just before it
  long ruptures = 0;
  double slip_ratio = 0;  ///< sum over slip of -q.v/|v|
  long slip_samples = 0;
  double stop_speed_m_per_s = 0;  ///< sum over ends of slip of the speed at which q begins to rise
  long stops = 0;
  std::vector<double> power;  ///< sum over pieces of slip of Welch's density of q along the motion
  long pieces = 0;
};

/// The samples of one of Welch's windows, a quarter of a second and a power of two.
std::size_t vibration_window(double rate_hz);

/// Gathers a trial's evidence.
///
/// mu_s: at a rupture, the line through the last six to eight samples, half a sample after the last of
/// them. mu_d: mean over slip. Stiffness: regression of q on x in each stretch of stick, without the half
/// window beside a border that is not a rupture.
/// v_min (paper, fig. 9): where slip ends, q rises from mu_d along the spring, q = mu_d + K (s - s*); s* is
/// where slip ended and the speed there is v_min. A stop counts where the rise is five times the noise.
TrialEvidence trial_evidence(const MeasuredTrial& trial, const StickSegments& segments);

}  // namespace fingerpad
