#pragma once

#include "motion/motion.hpp"
#include "motion/recording_clock.hpp"

namespace fingerpad {

/// A recording at even steps of its clock's rate, taken linearly between its samples; itself where its clock
/// is even. Throws Error (refused) where so many samples are missing that it would be made up.
Motion evenly_sampled(const Motion& motion, const RecordingClock& clock);

/// Moves the last sample to the tick of the clock that the rounding of times has put just behind it, so that
/// the tick is not lost.
void keep_last_sample(Motion& motion, const RecordingClock& clock);

/// Gives a motion the velocity that its positions have if an encoder has rounded them to a quantum
/// (VelocityEstimator).
/// @pre evenly sampled
void estimate_velocity(Motion& motion, double quantum_m, double rate_hz);

/// How far a low pass has moved a finger [m].
struct Smoothing {
  double rms_m = 0, most_m = 0;
};

/// Passes what moves the model (positions, orientation, normal force, velocity) through ZeroPhaseLowPass; the
/// measured force, which the model is compared with, stays as it is.
/// @pre evenly sampled
Smoothing smooth(Motion& motion, double cutoff_hz, double rate_hz);

}  // namespace fingerpad
