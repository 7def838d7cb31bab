#include "study/slow_sensor.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "study/sample_noise.hpp"

namespace fingerpad {

void tell_slow_sensor(const std::vector<StickSegments>& segments, const FitPoint& point, ProfileFit& fit) {
  if (const double lag = point.evidence.rupture_lag; lag > 0)
    fit.steps.push_back(fmt::format(
        "ruptures: the force sensor shows their drops over some samples, as a low pass does; they are taken "
        "to lie in the middle of the drops, {} samples later than where these begin, and {} samples behind "
        "them tell no stick",
        rounded_text(lag, 2), point.evidence.drop_tail));
  // Over more samples the end of a drop is not seen, and how late its middle is told too small.
  constexpr double surely_seen_lag = 0.42;
  if (point.evidence.rupture_lag > surely_seen_lag)
    fit.doubts.emplace_back(
        "the force sensor's low pass takes so many samples for a drop that its middle cannot be told well: "
        "mu_static may be too low by some tenths of a percent, axes and stiffnesses off by some percent, and "
        "what follows from them; turn the sensor's filter off, or set it higher");
  constexpr double surely_joined = 1.25;  // of white noise it strays from 1 by some hundredths
  std::vector<double> joined;
  joined.reserve(segments.size());
  for (const StickSegments& trial : segments) joined.push_back(trial.joined_noise);
  if (point.evidence.rupture_lag == 0 && median_of(joined) > surely_joined &&
      value_of(fit.values, PadNumber::mu_static).refusal.empty())
    fit.doubts.emplace_back(
        "a low pass has joined the force's noise from sample to sample, and in that noise it is not seen how "
        "late drops are: mu_static may be too low by some percent, with axes too short, springs bent, and "
        "what follows from them; turn the sensor's filter off, or measure with less noise");
}

}  // namespace fingerpad
