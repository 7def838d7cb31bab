#pragma once

#include "study/stretch_run.hpp"

namespace fingerpad {

/// What a rate alone costs, whatever touches: between ticks a device holds the last force, while the model's
/// goes on. Root mean squares over the time in contact.
struct RateFigures {
  double rate_hz = 0;
  double held_mu_share = 0;       ///< the coefficient, of its mean
  double held_force_share = 0;    ///< the whole force, of its RMS
  double unseen_teeth_share = 0;  ///< of the sawtooth's teeth: those that last under two ticks
};

/// The model's forces held from tick to tick at this rate, against the model's own.
/// @pre its rate is a whole multiple of this one
RateFigures rate_figures(const std::vector<StretchRun>& model, double rate_hz);

}  // namespace fingerpad
