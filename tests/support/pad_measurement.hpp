#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "friction/pad_profile.hpp"
#include "study/profile_fit.hpp"

namespace fingerpad::test {

/// A finger whose pad is known. Its coefficients hold at a load of 1 N.
struct KnownFinger {
  std::string law = "finger-pad";              ///< that its forces come from
  PadProfile pad = assumed_profile(0.3, 150);  ///< axes of 2 and 1.6 mm at 45 deg
  double mu_dynamic = 0.2;
  bool rises_with_less_load = false;  ///< both coefficients and the spring as n^(-1/3)
  double stiffness_exponent = 0;      ///< of a trial's stiffness for each newton, over its load_n
  /// Of its stiffness in N/m over the load at each moment: 1 as the law has it, 0 alike under all loads.
  double spring_load_exponent = 1;
  double cubic_share = 0;
  double hysteresis_m = 0;                     ///< half the width of the spring's loop along the displacement
  double vibration = 0.05, bandwidth_hz = 20;  ///< RMS, share of the slip force
  double depth_at_1_n_m = 1.5e-3, press_exponent = 2;  ///< n = (depth/that)^exponent
  double scatter = 0;  ///< standard deviation of a trial's own pad about the finger's, as a share
};

/// The sensors that watch it, and what they do to it.
struct KnownSensors {
  double rate_hz = 1000;
  double position_noise_m = 2e-5, force_noise_n = 0.005;  ///< standard deviations
  double position_quantum_m = 1e-5, force_quantum_n = 1e-3;
  double delay_s = 0;        ///< of force behind position
  double tare_n = 0;         ///< standard deviation of a trial's offset, per axis
  double drift_n_per_s = 0;  ///< likewise of its drift
  double hum_n = 0, hum_hz = 60;
  double lost_share = 0;   ///< of samples, half of them in runs of up to 60 ms
  double air_s = 0;        ///< before and after each trial without contact
  double low_pass_hz = 0;  ///< of the force sensor, first order; 0: none
  int ticks_a_sample = 1;  ///< of the law
};
/// Sensors with all of the faults above.
KnownSensors bad_sensors();

/// What a finger does in a trial: x(t) = amplitude sin(2 pi f t) along a direction in the pad's axes.
struct KnownTrial {
  int subject = 1;
  double inclination_deg = 45;
  double bearing_deg = 0;  ///< 0 lateral, 90 longitudinal
  double amplitude_m = 0.06, frequency_hz = 0.6, duration_s = 4, load_n = 1;
  double ramp_s = 0.15;  ///< in which it is pressed and lifted, where the sensors watch it in the air
  bool is_even = false;  ///< forth and back at one speed, 4 f amplitude, in place of the sine
  /// Forth and back at one speed, in place of the sine, from and to rest at an even rate; 0: no such.
  double slowing_m_per_s2 = 0, cruise_m_per_s = 0;
};

/// A row of a measured table.
struct KnownRow {
  double t_s;
  Vec3 position_W, force_W, direction_W;
};

/// What is measured of a trial on the plane z = 0. The finger lies along y. Samples that are lost have no
/// row.
std::vector<KnownRow> measured_rows(const KnownFinger& finger, const KnownSensors& sensors,
                                    const KnownTrial& trial, RandomStream& random);

/// Three subjects of unequal length, whose axes differ but fall alike with the angle: rubs both ways, at
/// three angles, and pushes that stay in stick, with loads of 1 to 2 N.
std::vector<KnownTrial> known_trials();
/// Every so manieth of them: of odd steps as many rubs as pushes.
std::vector<KnownTrial> every(std::size_t step, const std::vector<KnownTrial>& trials);
/// All of known_trials, or every third under the sanitizers, where these tell the same.
std::vector<KnownTrial> fewer_trials();

/// The finger of one of the subjects of known_trials, whose pad is larger or smaller than `finger`'s.
KnownFinger of_subject(KnownFinger finger, int subject);

/// What a reader yields of a measurement in whose tables fx_n and fy_n are missing.
RecordedMeasurement of_normal_force_alone(RecordedMeasurement measurement);

/// A measurement as a reader yields it.
RecordedMeasurement known_measurement(const std::vector<KnownTrial>& trials, const KnownFinger& finger,
                                      const KnownSensors& sensors, std::uint64_t seed);

/// A measurement as a CSV table; numbers have the digits that sensors have.
std::string measured_table(const std::vector<KnownTrial>& trials, std::uint64_t seed,
                           const KnownFinger& finger = {}, const KnownSensors& sensors = {});

/// What a fit to known_trials of a finger is to find, where coefficients hold at `load_n`.
std::array<double, pad_number_keys.size()> known_numbers(const KnownFinger& finger, double load_n);

/// scenes/measurements/synthetic_finger.csv: two subjects rub across the corner of their pad's axes.
std::string shipped_table();

}  // namespace fingerpad::test
