#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/random_stream.hpp"
#include "friction/law_table.hpp"

namespace fingerpad::test {

/// One trial of a finger that goes round: within its stick region all round (paper, fig. 4), or in cycloids
/// over the plate. The pad is the finger-pad law's: axes of 2 and 1.6 mm at 45 degrees times the subject's
/// size, 0.3 and 0.2.
struct RoundTrial {
  int subject = 1, number = 1;
  double size = 1;  ///< of the subject's axes
  double inclination_deg = 45;
  bool is_cycloid = false;
  double duration_s = 0.4;
};

inline Vec2 round_place_m(const RoundTrial& trial, const PadProfile& pad, double t_s) {
  const double deg = std::numbers::pi / 180, turn = 2 * std::numbers::pi * t_s;
  if (trial.is_cycloid)
    return {0.06 * t_s + 0.010 * std::sin(1.5 * turn), 0.010 * (std::cos(1.5 * turn) - 1)};
  const double share = 0.93 * std::min(1.0, t_s / 0.08);
  return share * Vec2(pad.lateral_axis_at(trial.inclination_deg * deg) * std::cos(3.2 * turn),
                      pad.longitudinal_axis_at(trial.inclination_deg * deg) * std::sin(3.2 * turn));
}

/// Its rows at 1 kHz: t, x, y, z, forces, direction, subject, trial; sensors as noisy as those of
/// pad_measurement.
inline std::string round_rows(const RoundTrial& trial, RandomStream& random) {
  PadProfile pad = assumed_profile(0.3, 150 / trial.size);
  LawSettings settings;
  settings.profile = pad;
  const auto law = find_law("finger-pad")->make(settings);
  const double deg = std::numbers::pi / 180;
  const auto noisy = [&random](double value, double noise, double quantum) {
    return quantum * std::round((value + noise * random.normal()) / quantum);
  };
  FrictionState state;
  std::string text;
  Vec2 last = round_place_m(trial, pad, 0);
  for (int k = 0; k < std::lround(1000 * trial.duration_s); ++k) {
    const double t_s = k / 1000.0;
    const Vec2 place = round_place_m(trial, pad, t_s);
    TangentialMotion motion;
    motion.dt_s = 1e-3;
    motion.normal_force_n = 1 + 0.1 * std::sin(2 * std::numbers::pi * 0.7 * t_s);
    motion.mu_static = 0.3;
    motion.mu_dynamic = 0.2;
    motion.step_m = place - last;
    motion.velocity_m_per_s = motion.step_m * 1e3;
    motion.inclination_rad = trial.inclination_deg * deg;
    last = place;
    const Vec2 force = law->tick(motion, state).force_n;
    text += fmt::format("{:.3f},{:.5f},{:.5f},{:.5f},{:.3f},{:.3f},{:.3f},0,{:.4g},{:.4g},{},{}\n", t_s,
                        noisy(place.x(), 2e-5, 1e-5), noisy(place.y(), 2e-5, 1e-5), noisy(0, 2e-5, 1e-5),
                        noisy(force.x(), 0.005, 1e-3), noisy(force.y(), 0.005, 1e-3),
                        noisy(motion.normal_force_n, 0.005, 1e-3), std::cos(trial.inclination_deg * deg),
                        -std::sin(trial.inclination_deg * deg), trial.subject, trial.number);
  }
  return text;
}

/// scenes/measurements/synthetic_rounds.csv: the two subjects of synthetic_finger.csv go round within stick
/// at three angles, and draw cycloids.
inline std::string shipped_rounds() {
  std::string text =
      "# Synthetic: made by the program's own finger-pad law from a known pad, with noise; no finger was "
      "measured.\n"
      "# The subjects of synthetic_finger.csv go round within their stick region, and in cycloids. "
      "BSD-3-Clause.\n"
      "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n,dx,dy,dz,subject,trial\n";
  RandomStream random(7);
  int number = 100;
  for (const auto& [subject, size] : {std::pair(1, 0.8), std::pair(3, 1.2)}) {
    for (const double angle : {25.0, 45.0, 65.0})
      text += round_rows({subject, ++number, size, angle}, random);
    text += round_rows({subject, ++number, size, 45, true, 0.7}, random);
  }
  return text;
}

}  // namespace fingerpad::test
