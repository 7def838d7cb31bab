#pragma once

#include "base/random_stream.hpp"

namespace fingerpad {

/// The pad's vibration in slip (paper, figs. 10-11; SCIENCE 1): a narrow-band random signal of mean 0 and
/// variance 1, a second-order autoregression driven by a seeded stream,
///   x_k = 2 r cos(theta) x_(k-1) - r^2 x_(k-2) + g w_k,  r = exp(-pi bandwidth T),
/// with g set so that the variance is 1 at any tick T. Starts in its stationary state at each slip.
///
/// Its spectrum peaks where cos(2 pi f T) = (1 + r^2)/(2 r) cos(theta) (Box & Jenkins, AR(2)). The paper's 89
/// Hz is a peak, so theta is set for the peak to be at the frequency asked for, f0:
///   cos(theta) = 2 r/(1 + r^2) cos(2 pi f0 T).
/// Deviation: with theta = 2 pi f0 T, as SCIENCE 1 writes it, the peak is at sqrt(f0^2 - (bandwidth/2)^2),
/// for 89 Hz at 88.4 Hz where it is 20 Hz broad and at 83.8 Hz where it is 60 Hz broad.
///
/// Use, once a tick of contact: in slip `next()`, times the amplitude; else `rest()`, which draws nothing.
class SlipVibration {
 public:
  /// @param frequency_hz  of the spectral peak, > 0 and below half the tick rate (above, it folds back)
  /// @param bandwidth_hz  width of the peak, > 0
  /// @param dt_s          tick, > 0
  SlipVibration(double frequency_hz, double bandwidth_hz, double dt_s, const RandomStream& stream) noexcept;

  /// The signal on a tick of slip. Finite; allocates nothing.
  double next() noexcept;
  /// A tick that is not slip: the signal is forgotten.
  void rest() noexcept { slipping_ = false; }

 private:
  RandomStream stream_;
  double feedback_1_ = 0, feedback_2_ = 0;  // of the last value and the one before
  double gain_ = 0;
  double correlation_ = 0;  // of neighbouring values, for the start
  double last_ = 0, before_ = 0;
  bool slipping_ = false;
};

/// What to multiply a tick's slip force by, for a vibration of `amplitude` (RMS as a fraction of that force).
/// Clipped at 0, so that friction never reverses. Hand it on in FrictionState::slip_force_scale, so that a
/// stick that follows starts at the force as written.
double vibration_force_scale(double amplitude, double signal) noexcept;

}  // namespace fingerpad
