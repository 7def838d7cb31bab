#pragma once

#include <vector>

#include "study/mains_hum.hpp"

namespace fingerpad {

/// How much of a line is there in some samples: a share of 1 of what keeps its amplitude and phase, 0 where
/// it is not there.
struct HumShare {
  double sum = 0, weight = 0;  ///< each window by how well it tells it: weight is 1 over the share's variance
  HumShare& operator+=(const HumShare& other) noexcept {
    sum += other.sum;
    weight += other.weight;
    return *this;
  }
  double share() const noexcept { return sum / weight; }
  /// Whether its standard deviation is below 0.15.
  bool is_told() const noexcept { return weight * 0.15 * 0.15 > 1; }
};

/// A window of 0.2 s that tells a line well.
struct HumWindow {
  double speed_m_per_s = 0;  ///< of the finger
  bool is_steady = false;    ///< the line has its amplitude and phase there
  bool turns = false;        ///< the finger goes some of the way back
};

/// What a trial, or several, say of a line.
struct HumEvidence {
  HumShare still;   ///< while no teeth can be: nothing touches the sensor, or the finger stands still
  HumShare in_air;  ///< of that, while nothing touches the sensor
  std::vector<HumWindow> windows;  ///< of the rest
  double speed_m_per_s = 0;        ///< median of all of the trial's windows
  std::vector<Eigen::Index> free;  ///< samples of the one trial at which nothing touches the sensor

  HumEvidence& operator+=(const HumEvidence& other);
};

HumEvidence hum_evidence(const RecordedTrial& trial, Sensed sensed, const HumLine& line);

}  // namespace fingerpad
