#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "base/random_stream.hpp"
#include "friction/law_table.hpp"
#include "friction/slip_vibration.hpp"

namespace fingerpad::test {

/// A finger whose pad is known, and the sensors that watch it.
struct KnownFinger {
  PadProfile pad = assumed_profile(0.3, 150);  // axes of 2 and 1.6 mm at 45 deg
  double mu_dynamic = 0.2;
  double vibration = 0.05;                                ///< RMS, share of the slip force; 20 Hz wide
  double position_noise_m = 2e-5, force_noise_n = 0.005;  ///< standard deviations
  double position_quantum_m = 1e-5, force_quantum_n = 1e-3;
  double rate_hz = 1000;
  double scatter = 0;  ///< standard deviation of a trial's own pad about the finger's, as a share
};

/// What a finger does in a trial: x(t) = amplitude sin(2 pi f t) along a direction in the pad's axes.
struct KnownTrial {
  int subject = 1;
  double inclination_deg = 45;
  double bearing_deg = 0;  ///< 0 lateral, 90 longitudinal
  double amplitude_m = 0.06, frequency_hz = 0.6, duration_s = 4, load_n = 1;
};

/// The measured table of a trial, rows of t x y z fx fy fz dx dy dz, from the program's own finger-pad law on
/// the plane z = 0. The finger lies along y.
inline std::vector<std::array<double, 10>> measured_rows(const KnownFinger& finger, const KnownTrial& trial,
                                                         RandomStream& random) {
  LawSettings settings;
  const auto own = [&](double value) { return value * (1 + finger.scatter * random.normal()); };
  PadProfile pad = finger.pad;
  pad.lateral_axis_m = own(pad.lateral_axis_m);
  pad.longitudinal_axis_m = own(pad.longitudinal_axis_m);
  pad.v_min_m_per_s = own(pad.v_min_m_per_s);
  const double mu_static = own(pad.mu_static), mu_dynamic = std::min(own(finger.mu_dynamic), mu_static);
  settings.profile = pad;
  const auto law = find_law("finger-pad")->make(settings);
  SlipVibration vibration(finger.pad.vibration_hz, 20, 1 / finger.rate_hz, RandomStream(random.bits()));
  const double deg = std::numbers::pi / 180, w = 2 * std::numbers::pi * trial.frequency_hz;
  const Vec2 along(std::cos(trial.bearing_deg * deg), std::sin(trial.bearing_deg * deg));
  const auto rounded = [](double value, double quantum) { return quantum * std::round(value / quantum); };
  FrictionState state;
  Vec2 last(0, 0);
  std::vector<std::array<double, 10>> rows;
  for (long k = 0; k < std::lround(trial.duration_s * finger.rate_hz); ++k) {
    const double t = static_cast<double>(k) / finger.rate_hz;
    const Vec2 place = trial.amplitude_m * std::sin(w * t) * along;
    TangentialMotion motion;
    motion.dt_s = 1 / finger.rate_hz;
    motion.normal_force_n = trial.load_n * (1 + 0.2 * std::sin(2 * std::numbers::pi * 0.35 * t));
    motion.mu_static = mu_static;
    motion.mu_dynamic = mu_dynamic;
    motion.step_m = k > 0 ? Vec2(place - last) : Vec2(0, 0);
    motion.velocity_m_per_s = motion.step_m * finger.rate_hz;
    motion.inclination_rad = trial.inclination_deg * deg;
    last = place;
    Friction friction = law->tick(motion, state);
    if (friction.phase == Phase::slip && finger.vibration > 0) {
      const double scale = vibration_force_scale(finger.vibration, vibration.next());
      friction.force_n *= scale;
      state.slip_force_scale = scale;
    } else {
      vibration.rest();
    }
    const auto place_cell = [&](double value) {
      return rounded(value + finger.position_noise_m * random.normal(), finger.position_quantum_m);
    };
    const auto force_cell = [&](double value) {
      return rounded(value + finger.force_noise_n * random.normal(), finger.force_quantum_n);
    };
    rows.push_back({t, place_cell(place.x()), place_cell(place.y()), place_cell(0),
                    force_cell(friction.force_n.x()), force_cell(friction.force_n.y()),
                    force_cell(motion.normal_force_n), 0, std::cos(trial.inclination_deg * deg),
                    -std::sin(trial.inclination_deg * deg)});
  }
  return rows;
}

/// Three subjects of unequal length, whose axes differ but fall alike with the angle: rubs both ways, at
/// three angles, and pushes that stay in stick.
inline std::vector<KnownTrial> known_trials() {
  std::vector<KnownTrial> trials;
  const int rounds[] = {3, 2, 2};
  for (int subject = 1; subject <= 3; ++subject) {
    for (int round = 0; round < rounds[subject - 1]; ++round) {
      for (const double angle : {25.0, 45.0, 65.0}) {
        for (const double bearing : {0.0, 90.0}) {
          const double load_n = 1 + 0.5 * round;
          trials.push_back({subject, angle, bearing, 0.06, 0.6 + 0.05 * round, 4, load_n});
          trials.push_back({subject, angle, bearing + 45, 0.003, 1.0, 2.0 + subject, load_n});
        }
      }
    }
  }
  return trials;
}

/// The pad of one of the subjects of known_trials.
inline KnownFinger known_finger(int subject) {
  KnownFinger finger;
  const double size = subject == 1 ? 0.8 : subject == 2 ? 1.0 : 1.2;
  finger.pad.lateral_axis_m *= size;
  finger.pad.longitudinal_axis_m *= size;
  return finger;
}

/// A measurement as a CSV table; numbers have the digits that sensors have.
inline std::string measured_table(const std::vector<KnownTrial>& trials, std::uint64_t seed,
                                  double scatter = 0) {
  std::string text = "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n,dx,dy,dz,subject,trial\n";
  RandomStream random(seed);
  int number = 0;
  for (const KnownTrial& trial : trials) {
    ++number;
    KnownFinger finger = known_finger(trial.subject);
    finger.scatter = scatter;
    for (const auto& row : measured_rows(finger, trial, random)) {
      text += fmt::format("{:.3f},{:.5f},{:.5f},{:.5f},{:.3f},{:.3f},{:.3f},{:.4g},{:.4g},{:.4g},{},{}\n",
                          row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8], row[9],
                          trial.subject, number);
    }
  }
  return text;
}

/// scenes/measurements/synthetic_finger.csv: two subjects rub across the corner of their pad's axes.
inline std::string shipped_table() {
  std::vector<KnownTrial> trials;
  for (const int subject : {1, 3}) {
    for (const double angle : {25.0, 45.0, 65.0}) trials.push_back({subject, angle, 45, 0.04, 0.7, 1.5, 1});
  }
  return "# Synthetic: made by the program's own finger-pad law from a known pad, with noise; no finger was "
         "measured.\n"
         "# Axes 2 and 1.6 mm at 45 deg (mean of two subjects), slopes 0.01, mu 0.3 and 0.2, v_min 0.1 m/s, "
         "89 Hz. BSD-3-Clause.\n" +
         measured_table(trials, 1);
}

}  // namespace fingerpad::test
