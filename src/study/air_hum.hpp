#pragma once

#include <optional>
#include <vector>

#include "study/mains_hum.hpp"

namespace fingerpad {

/// Samples at which hardly anything presses, of means over a period of the mains: where hum is larger than
/// noise, what is still cannot be asked for before it is off.
std::vector<Eigen::Index> lightest_samples(const RecordedTrial& trial, double nominal_hz);

/// What hums of a trial while nothing touches its sensor.
class AirHum {
 public:
  /// @param free  samples at which nothing does, in order
  AirHum(const RecordedTrial& trial, Sensed sensed, const std::vector<Eigen::Index>& free, double nominal_hz);

  /// Whether a line has in the air the amplitude and the phase that it has in the whole trial, to a tenth or
  /// as far as the air tells it.
  bool is_like(const HumLine& line) const;

  /// What of a line is hum, by the air alone. Its frequency is looked for about `near_hz`, as near as moments
  /// at both ends of the trial tell one from the next; where they are at one end it is the line's. Nothing
  /// where no hum stands out.
  std::optional<HumLine> bounded(const HumLine& line, double near_hz) const;
  /// How far about a frequency it is looked for; 0: it is not.
  double reach_hz() const;

 private:
  /// Moments in the air, [from, to) of samples_.
  struct Moment {
    std::size_t from, to;
  };
  struct Told {
    Phasors phasors{};
    std::array<double, 3> variance{};  ///< of a phasor's real part
    double power = 0;
  };
  Told at(double hz, const Moment& moment) const;

  double rate_hz_;
  std::vector<Eigen::Index> samples_;
  std::vector<Moment> moments_;
  Points rest_;        ///< 3 x n, of these: less its line over each moment
  double span_s_ = 0;  ///< from the middle of the first moment to that of the last
};

}  // namespace fingerpad
