#pragma once

#include <array>
#include <vector>

#include "study/profile_fit.hpp"

namespace fingerpad {

/// One stretch of stick of a trial, about its stick centre, in the pad's axes.
struct StickPath {
  std::size_t trial = 0;             ///< of Measurement::trials
  std::vector<Vec2> displacement_m;  ///< of the pad from the stick centre
  std::vector<Vec2> force_n;         ///< tangential, on the finger
};

/// What one trial says of the axes by itself: mu_s over the slope of its force ratio, taken to the load of
/// the fit, against displacement.
struct TrialAxes {
  std::size_t trial = 0;
  std::array<double, 2> axis_m{};  ///< lateral, longitudinal; nan where the trial was not pushed along it
};

/// The measurement's stick, for pictures.
struct StickPicture {
  std::vector<StickSegments> segments;  ///< per trial
  std::vector<StickPath> paths;
  std::vector<TrialAxes> axes;
};

/// Finds each stretch of stick and its centre: the place at which the subject's own spring would bear no
/// force, the mean of x + A q with A each of the subject's axes over mu_s (where it has none the fitted one,
/// and without that 1/k_f).
StickPicture stick_picture(const Measurement& measurement, const ProfileFit& fit);

/// The fitted axes at an inclination [m], lateral and longitudinal; nan where the fit gives none.
Vec2 fitted_axes_m(const ProfileFit& fit, double inclination_deg);

/// A subject's own axes at an inclination [m]: the mean of its trials' (TrialAxes), each taken to 45 degrees
/// and from there along the fitted lines; nan where no trial was pushed along one.
Vec2 subject_axes_m(const Measurement& measurement, const ProfileFit& fit, const std::vector<TrialAxes>& axes,
                    int subject, double inclination_deg);

/// A number of the fit; nan where it is refused.
double fitted_number(const ProfileFit& fit, PadNumber number) noexcept;

}  // namespace fingerpad
