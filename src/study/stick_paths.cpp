#include "study/stick_paths.hpp"

#include <cmath>
#include <limits>

#include "study/law_residual.hpp"
#include "study/phase_stretch.hpp"

namespace fingerpad {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_drawn = 8;  // of a stretch that is drawn

/// The stretches of stick that are long enough to be drawn.
std::vector<PhaseStretch> drawn_stretches(const StickSegments& segments) {
  std::vector<PhaseStretch> found = phase_stretches(segments, PadPhase::stick);
  std::erase_if(found, [](const PhaseStretch& s) { return s.to - s.from < fewest_drawn; });
  return found;
}

/// mu_s of the fit; where it is refused that at which a profile's axes hold then.
double mu_of_axes(const ProfileFit& fit) {
  const double fitted = fitted_number(fit, PadNumber::mu_static);
  return std::isfinite(fitted) ? fitted : 0.3;
}

/// Displacement for a unit of force ratio, lateral and longitudinal, each of its own axis where it is told.
Vec2 compliance_m(const ProfileFit& fit, const Vec2& own_axes_m, double inclination_deg) {
  const double mu_static = mu_of_axes(fit);
  const double stiffness = fitted_number(fit, PadNumber::stick_stiffness);
  const Vec2 axes_m = fitted_axes_m(fit, inclination_deg);
  Vec2 compliance = Vec2::Constant(std::isfinite(stiffness) ? 1 / stiffness : 0);
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double axis_m = std::isfinite(own_axes_m[axis]) ? own_axes_m[axis] : axes_m[axis];
    if (std::isfinite(axis_m)) compliance[axis] = axis_m / mu_static;
  }
  return compliance;
}

/// A trial's force ratios at the load at which the fit's numbers hold, as the fit takes them.
std::vector<Vec2> fitted_ratio(const MeasuredTrial& trial, const ProfileFit& fit) {
  const double exponent = fitted_number(fit, PadNumber::mu_load_exponent);
  std::vector<Vec2> ratio =
      ratio_at_load(trial, {.load_n = fit.mu_load_n, .exponent = std::isfinite(exponent) ? exponent : 0});
  EvidencePoint about;
  about.load.load_n = fit.mu_load_n;
  about.axes_exponent = fit.axes_exponent ? fit.axes_exponent->value : 0;
  for (std::size_t i = 0; i < ratio.size(); ++i) ratio[i] *= about.axes_at(trial.normal_force_n[i]);
  return ratio;
}

/// @param ratio  of the trial, as the fit takes it
StickPath path_of(const Measurement& measurement, std::size_t k, const PhaseStretch& stretch,
                  const std::vector<Vec2>& ratio, const Vec2& compliance) {
  const MeasuredTrial& trial = measurement.trials[k];
  StickPath path{k, {}, {}};
  Vec2 centre_m(0, 0);
  for (std::size_t i = stretch.from; i < stretch.to; ++i)
    centre_m += (trial.position_m[i] + compliance.cwiseProduct(ratio[i])) /
                static_cast<double>(stretch.to - stretch.from);
  for (std::size_t i = stretch.from; i < stretch.to; ++i) {
    path.displacement_m.emplace_back(trial.position_m[i] - centre_m);
    path.force_n.emplace_back(trial.normal_force_n[i] * trial.force_ratio[i]);
  }
  return path;
}

/// Regression of displacement on force ratio over all stretches of a trial, along each axis.
/// @param ratio  of the trial, as the fit takes it
TrialAxes axes_of(const Measurement& measurement, std::size_t k, const StickSegments& segments,
                  const std::vector<PhaseStretch>& stretches, const std::vector<Vec2>& ratio,
                  double mu_static) {
  const MeasuredTrial& trial = measurement.trials[k];
  Vec2 spread(0, 0), pull(0, 0);
  for (const PhaseStretch& s : stretches) {
    Vec2 mean_x(0, 0), mean_q(0, 0);
    const auto count = static_cast<double>(s.to - s.from);
    for (std::size_t i = s.from; i < s.to; ++i) {
      mean_x += trial.position_m[i] / count;
      mean_q += ratio[i] / count;
    }
    for (std::size_t i = s.from; i < s.to; ++i) {
      const Vec2 dx = trial.position_m[i] - mean_x, dq = ratio[i] - mean_q;
      spread += dx.cwiseProduct(dx) - Vec2::Constant(segments.position_noise_m * segments.position_noise_m);
      pull -= dx.cwiseProduct(dq);
    }
  }
  TrialAxes axes{k, {no_number, no_number}};
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    if (!trial.has_direction || !(spread[axis] > 0.05 * spread.sum()) || !(pull[axis] > 0)) continue;
    axes.axis_m[static_cast<std::size_t>(axis)] = mu_static * spread[axis] / pull[axis];
  }
  return axes;
}

}  // namespace

double fitted_number(const ProfileFit& fit, PadNumber number) noexcept {
  const PadValue& value = value_of(fit.values, number);
  return value.refusal.empty() ? value.value : no_number;
}

Vec2 fitted_axes_m(const ProfileFit& fit, double inclination_deg) {
  const auto axis_m = [&](PadNumber axis, PadNumber slope) {
    const double per_deg = fitted_number(fit, slope);
    return fitted_number(fit, axis) * (1 - (std::isfinite(per_deg) ? per_deg : 0) * (inclination_deg - 45));
  };
  return {axis_m(PadNumber::lateral_axis, PadNumber::lateral_slope),
          axis_m(PadNumber::longitudinal_axis, PadNumber::longitudinal_slope)};
}

Vec2 subject_axes_m(const Measurement& measurement, const ProfileFit& fit, const std::vector<TrialAxes>& axes,
                    int subject, double inclination_deg) {
  Vec2 sum(0, 0), count(0, 0);
  const Vec2 at45_m = fitted_axes_m(fit, 45);
  for (const TrialAxes& of : axes) {
    const MeasuredTrial& trial = measurement.trials[of.trial];
    if (trial.subject != subject) continue;
    const Vec2 falls = fitted_axes_m(fit, trial.inclination_deg).cwiseQuotient(at45_m);
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const double at45 = of.axis_m[static_cast<std::size_t>(axis)] / falls[axis];
      if (!std::isfinite(at45)) continue;
      sum[axis] += at45;
      ++count[axis];
    }
  }
  const Vec2 own_m = sum.cwiseQuotient(count);  // 0/0 where there is none
  return own_m.cwiseProduct(fitted_axes_m(fit, inclination_deg).cwiseQuotient(at45_m));
}

StickPicture stick_picture(const Measurement& measurement, const ProfileFit& fit) {
  StickPicture picture;
  std::vector<std::vector<PhaseStretch>> stretches;
  for (std::size_t k = 0; k < measurement.trials.size(); ++k) {
    picture.segments.push_back(
        stick_segments(measurement.trials[k], fit.axes_exponent ? fit.axes_exponent->value : 0));
    stretches.push_back(drawn_stretches(picture.segments.back()));
    picture.axes.push_back(axes_of(measurement, k, picture.segments.back(), stretches.back(),
                                   fitted_ratio(measurement.trials[k], fit), mu_of_axes(fit)));
  }
  for (std::size_t k = 0; k < measurement.trials.size(); ++k) {
    const MeasuredTrial& trial = measurement.trials[k];
    const Vec2 compliance =
        compliance_m(fit, subject_axes_m(measurement, fit, picture.axes, trial.subject, angle_deg(trial)),
                     angle_deg(trial));
    const std::vector<Vec2> ratio = fitted_ratio(trial, fit);
    for (const PhaseStretch& stretch : stretches[k])
      picture.paths.push_back(path_of(measurement, k, stretch, ratio, compliance));
  }
  return picture;
}

}  // namespace fingerpad
