#pragma once

#include <cstddef>
#include <vector>

#include "study/stick_segments.hpp"

namespace fingerpad {

/// The window around a sample, [from, to), within its run.
struct SampleWindow {
  std::size_t from, to;
};

/// The windows around all samples, which end where their run does.
class SampleWindows {
 public:
  /// @param begins_run  of each sample
  explicit SampleWindows(const std::vector<bool>& begins_run);
  SampleWindow around(std::size_t i, int half_window) const;

 private:
  std::vector<SampleWindow> run_;  ///< that each sample is in
};

/// What a window says.
struct LocalStiffness {
  double per_m = 0;
  bool is_known = false;
};

/// Sums up to each sample, so that a window of any width is told by its two ends.
class WindowSums {
 public:
  /// @param found  what is told of the trial's noise and load, and its axes_exponent
  WindowSums(const MeasuredTrial& trial, const StickSegments& found);
  /// @param least_m2  spread below which the window tells nothing
  LocalStiffness stiffness(const SampleWindow& w, double noise_m, double least_m2) const;

 private:
  struct Sums {
    Vec2 x{0, 0}, q{0, 0};
    double xx = 0, xq = 0;
  };
  std::vector<Sums> sums_;
};

/// Half the mean of the stiffer of two groups; where there is no second group, what puts all on one side.
/// @param ratio_rms  of the force ratio
double border_per_m(const std::vector<LocalStiffness>& locals, double ratio_rms);

/// The local stiffness at each sample, over windows that are widened where the pad hardly moves, until they
/// tell it by four deviations of the noise from the border (`border_per_m`, where it is known).
std::vector<LocalStiffness> local_stiffnesses(const MeasuredTrial& trial, const StickSegments& found,
                                              const WindowSums& sums, const std::vector<bool>& is_light);

}  // namespace fingerpad
