#include <cmath>

#include "motion/velocity_estimator.hpp"
#include "study/stability_parts.hpp"

namespace fingerpad {
namespace {

constexpr double quantum_m = 3e-5, v_min_m_per_s = 0.1;

struct VelocityError {
  double rms_m_per_s = 0;
  double wrong_side_share = 0;  ///< of ticks that an estimate stands on the wrong side of v_min
};

/// Error on a finger that moves at v (1 + 0.05 sin 20 t), seen through encoders.
VelocityError velocity_error(double speed_m_per_s, double rate_hz, bool adaptive) {
  VelocityEstimator estimator(adaptive ? quantum_m : 0, 1 / rate_hz);
  constexpr double seconds = 2, settled_s = 0.2, wobble = 0.05, turn_per_s = 20;
  const auto ticks = static_cast<long>(seconds * rate_hz);
  VelocityError error;
  long counted = 0;
  for (long k = 0; k < ticks; ++k) {
    const double t_s = static_cast<double>(k) / rate_hz;
    const double x_m = speed_m_per_s * (t_s + wobble / turn_per_s * (1 - std::cos(turn_per_s * t_s)));
    const double v = speed_m_per_s * (1 + wobble * std::sin(turn_per_s * t_s));
    const double estimate = estimator.next(Vec3(std::round(x_m / quantum_m) * quantum_m, 0, 0)).x();
    if (t_s < settled_s) continue;
    ++counted;
    error.rms_m_per_s += (estimate - v) * (estimate - v);
    error.wrong_side_share += (std::abs(estimate) > v_min_m_per_s) != (v > v_min_m_per_s) ? 1 : 0;
  }
  error.rms_m_per_s = std::sqrt(error.rms_m_per_s / static_cast<double>(counted));
  error.wrong_side_share /= static_cast<double>(counted);
  return error;
}

}  // namespace

void study_velocity(StudyReport& report) {
  const std::vector<double> rates_hz{250, 500, 1000, 2000, 4000, 10000, 20000};
  StudyTable table{
      "velocity",
      {"estimator", "speed_m_per_s", "rate_hz", "rms_error_m_per_s", "wrong_side_of_v_min_share"},
      {}};
  ChartPanel error{"error", "rate [Hz]", "RMS error of velocity [m/s]", true, true, {}, {}};
  ChartPanel wrong{"taken for the wrong side of v_min", "rate [Hz]", "share of ticks", true, false, {}, {}};
  ChartCurve limit{"v_min", {7, Dash::dotted, Marker::none}, rates_hz, {}};
  limit.y.assign(rates_hz.size(), v_min_m_per_s);
  error.curves.push_back(std::move(limit));
  int colour = 0;
  for (const double speed : {0.005, 0.05, 0.2}) {
    for (const bool adaptive : {false, true}) {
      const std::string name =
          std::string(adaptive ? "adaptive window" : "plain difference") + (speed < 0.01  ? " at 5 mm/s"
                                                                            : speed < 0.1 ? " at 50 mm/s"
                                                                                          : " at 200 mm/s");
      const CurveStyle style{colour, adaptive ? Dash::solid : Dash::dashed,
                             adaptive ? Marker::disc : Marker::ring};
      ChartCurve rms{name, style, rates_hz, {}}, share{name, style, rates_hz, {}};
      for (const double hz : rates_hz) {
        const VelocityError found = velocity_error(speed, hz, adaptive);
        rms.y.push_back(found.rms_m_per_s);
        share.y.push_back(found.wrong_side_share);
        table.rows.push_back({adaptive ? "adaptive-window" : "plain-difference", speed, hz, found.rms_m_per_s,
                              found.wrong_side_share});
      }
      error.curves.push_back(std::move(rms));
      wrong.curves.push_back(std::move(share));
    }
    colour += colour == 0 ? 4 : 1;
  }
  report.tables.push_back(std::move(table));
  report.charts.push_back(
      {"velocity",
       "Velocity from positions rounded to 0.03 mm",
       {"A finger whose speed wanders by 5 %. The plain difference jumps in steps of 0.03 mm a tick;",
        "the adaptive window (Janabi-Sharifi, Hayward & Chen 2000) looks back as far as one line explains."},
       1,
       {std::move(error), std::move(wrong)}});
}

}  // namespace fingerpad
