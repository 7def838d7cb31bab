#pragma once

#include <cstddef>
#include <vector>

#include "study/measurement.hpp"

namespace fingerpad {

/// What the pad was doing at a sample; unknown where it moved too little to tell.
enum class PadPhase : unsigned char { unknown, stick, slip };

/// A window tells a local stiffness where the spread of its positions is beyond so many times their noise.
inline constexpr double least_window_spread = 4;

/// A trial told apart into stick and slip.
struct StickSegments {
  std::vector<PadPhase> phase;         ///< per sample
  std::vector<bool> is_rupture;        ///< per sample: the first after the force ratio has dropped
  std::vector<bool> begins_run;        ///< rupture or starts_anew: no window goes across
  std::vector<Vec2> velocity_m_per_s;  ///< slope of the window's positions
  double position_noise_m = 0;         ///< standard deviation of one component
  double ratio_noise = 0;              ///< likewise, of q
  double joined_noise = 1;             ///< of q: more than 1 where a low pass has joined it (sample_noise)
  double usual_normal_n = 0;           ///< median of the normal force, at which q has that noise
  double border_per_m = 0;             ///< local stiffness that parts slip (below) from stick
  /// Samples behind a rupture in which the force sensor still shows its drop (and one before it); 0: it shows
  /// it at once.
  std::size_t drop_tail = 0;
  int half_window = 0;            ///< samples
  double axes_exponent = 0;       ///< that it was told apart by
  std::size_t light_samples = 0;  ///< that tell nothing, as they are pressed too lightly
  bool is_too_noisy = false;      ///< noise of q may hide ruptures wherever it is pressed: all is unknown
};

/// Tells stick from slip by the local stiffness k = -sum dq.dx / sum |dx|^2: in stick the force ratio q
/// follows the finger, in slip it stays. Windows are 13 ms long, up to 100 ms where the pad moves slowly, and
/// end at ruptures. One whose positions spread over less than four times their noise tells nothing. The
/// border between the two is half the mean stiffness of the stiffer windows (two means).
///
/// Slip must also be against the motion, q.v < 0, with half of the friction of the trial's slip or more. What
/// shows less friction is stick if it follows the finger somewhat: a spring that is soft about its middle.
///
/// A rupture is a step in which |q| falls out of stick, from where the tooth was pulled most
/// (drops_below_its_tooth). It falls by more than the steps around it do (median): by their size (median),
/// and by a twelfth of |q| or by four and a half standard deviations of a step's noise, whichever is more. So
/// a sensor must show most of the drop within one sample. Where noise hides such steps, those between means
/// of three samples are taken; where it hides these too, nothing is told. Noise is told by second differences
/// (sample_noise), in which ruptures do not count.
StickSegments stick_segments(const MeasuredTrial& trial);

/// The same where the axes of stick go with the load, so that a spring is stiffer, for each newton, in a
/// light ramp than under the trial's usual load: stiffnesses are taken to that.
/// @param axes_exponent  EvidencePoint's
StickSegments stick_segments(const MeasuredTrial& trial, double axes_exponent);

/// The local stiffness that told the phase of each sample; not a number where none is told.
/// @param segments  the trial's
std::vector<double> local_stiffness_per_m(const MeasuredTrial& trial, const StickSegments& segments);

}  // namespace fingerpad
