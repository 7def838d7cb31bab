#pragma once

#include <cstddef>
#include <vector>

#include "study/stick_segments.hpp"

namespace fingerpad {

/// What the tangential forces of trials without a tare are off by: the mean of what a rub has one way and the
/// other. A force sensor that was not zeroed; or friction that is not alike both ways.
struct SensorOffset {
  std::size_t untared = 0;  ///< trials that no tare was taken off
  std::size_t told = 0;     ///< of these, that rub to and fro, so that it can be told
  std::size_t off = 0;      ///< of these, that are off by more than a twentieth of their friction
  double typical_n = 0;     ///< median over those that tell it, of its length along the plate
  double usual_n = 0;       ///< median over those that are off, of its length along the plate
  double most_n = 0;
};

/// Of a fast rub f = o - mu n v/|v| (f tangential, n normal force, v velocity), by least squares. What n is
/// off by is not told: it looks like friction that changes with the load.
SensorOffset sensor_offset(const Measurement& measurement, const std::vector<StickSegments>& segments);

}  // namespace fingerpad
