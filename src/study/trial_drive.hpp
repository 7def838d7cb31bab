#pragma once

#include "study/recorded_trial.hpp"

namespace fingerpad {

/// What a trial's forces do on its finger where it presses (driving_share.hpp).
struct Drive {
  Vec3 by_axis;  ///< not a number for an axis that does little of the work
  double share = 0;
};

/// @param delay_s  by which force lags position
Drive drive_of(const RecordedTrial& trial, double delay_s);

}  // namespace fingerpad
