#include "support/pad_measurement.hpp"

#include "support/effort.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random_stream.hpp"
#include "friction/law_table.hpp"
#include "friction/slip_vibration.hpp"
#include "study/trial_rows.hpp"

namespace fingerpad::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double knee_n = 100;  // of the load below which coefficients rise: above all loads here

double rounded(double value, double quantum) {
  return quantum * std::round(value / quantum);
}

/// The pad of one trial, made from its law; its coefficients hold at the knee where they rise.
struct TrialPad {
  std::unique_ptr<FrictionLaw> law;
  double mu_static, mu_dynamic;
};

TrialPad trial_pad(const KnownFinger& finger, double load_n, RandomStream& random) {
  const auto own = [&](double value) { return value * (1 + finger.scatter * random.normal()); };
  PadProfile pad = finger.pad;
  const double stiffer = std::pow(load_n, finger.stiffness_exponent);
  pad.lateral_axis_m = own(pad.lateral_axis_m) / stiffer;
  pad.longitudinal_axis_m = own(pad.longitudinal_axis_m) / stiffer;
  pad.v_min_m_per_s = own(pad.v_min_m_per_s);
  TrialPad made;
  made.mu_static = own(pad.mu_static);
  made.mu_dynamic = std::min(own(finger.mu_dynamic), made.mu_static);
  LawSettings settings;
  if (finger.law == "finger-pad") settings.numbers["cubic_share"] = finger.cubic_share;
  if (finger.rises_with_less_load) {
    const double at_knee = std::cbrt(1 / knee_n);
    settings.numbers["mu_rises_below_n"] = knee_n;
    pad.mu_static *= at_knee;
    made.mu_static *= at_knee;
    made.mu_dynamic *= at_knee;
  }
  if (finger.law == "lugre") settings.numbers["stiffness_n_per_m"] = pad.mu_static / pad.lateral_axis_m;
  settings.profile = pad;
  made.law = find_law(finger.law)->make(settings);
  return made;
}

/// The finger's true way and load: in the air, pressed within the ramp, lifted likewise.
struct TrueMotion {
  const KnownFinger& finger;
  const KnownTrial& trial;
  double air_s;

  double load_n(double t) const {
    const double from_end = air_s == 0 ? trial.ramp_s : std::min(t, trial.duration_s - t);
    const double s = std::clamp(from_end / trial.ramp_s, 0.0, 1.0);
    return trial.load_n * (1 + 0.2 * std::sin(2 * pi * 0.35 * t)) * s * s * (3 - 2 * s);
  }
  Vec2 place(double t) const {
    const double deg = pi / 180;
    return way_m(t) * Vec2(std::cos(trial.bearing_deg * deg), std::sin(trial.bearing_deg * deg));
  }
  double way_m(double t) const {
    if (trial.slowing_m_per_s2 > 0) return stroke_m(t);
    const double wave = std::sin(2 * pi * trial.frequency_hz * t);
    return trial.amplitude_m * (trial.is_even ? 2 / pi * std::asin(wave) : wave);
  }
  /// From -amplitude to amplitude and back: faster at an even rate, at one speed, slower at that rate.
  double stroke_m(double t) const {
    const double speed = trial.cruise_m_per_s, faster_s = speed / trial.slowing_m_per_s2,
                 whole_s = 2 * trial.amplitude_m / speed + faster_s, turns = std::floor(t / whole_s),
                 since_s = t - turns * whole_s, to_end_s = std::min(since_s, whole_s - since_s);
    const double from_end_m = to_end_s < faster_s ? trial.slowing_m_per_s2 * to_end_s * to_end_s / 2
                                                  : speed * (to_end_s - faster_s / 2);
    const double off_m =
        since_s < whole_s / 2 ? from_end_m - trial.amplitude_m : trial.amplitude_m - from_end_m;
    return std::fmod(turns, 2) == 0 ? off_m : -off_m;
  }
  double height_m(double t) const {
    if (air_s == 0) return 0;
    const double off = std::max(-t, t - trial.duration_s);  // while in the air
    if (off > 0) return 2e-3 * std::min(1.0, off / 0.1);
    return -finger.depth_at_1_n_m * std::pow(load_n(t), 1 / finger.press_exponent);
  }
};

/// What the force sensor adds to a trial.
struct SensorFault {
  Vec3 tare_n, drift_n_per_s, hum_n, hum_phase;
  double hum_hz;

  SensorFault(const KnownSensors& sensors, RandomStream& random) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      tare_n[axis] = sensors.tare_n * random.normal();
      drift_n_per_s[axis] = sensors.drift_n_per_s * random.normal();
      hum_n[axis] = sensors.hum_n * (0.5 + random.uniform());
      hum_phase[axis] = 2 * pi * random.uniform();
    }
    hum_hz = sensors.hum_hz * (1 + 5e-4 * random.normal());
  }
  Vec3 at(double t) const {
    Vec3 sum = tare_n + t * drift_n_per_s;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      sum[axis] += hum_n[axis] * std::sin(2 * pi * hum_hz * t + hum_phase[axis]);
    return sum;
  }
};

/// How many samples are lost from here on.
long lost_run(const KnownSensors& sensors, RandomStream& random) {
  if (!(sensors.lost_share > 0)) return 0;
  const double longest = 0.06 * sensors.rate_hz;
  if (random.uniform() < 0.5 * sensors.lost_share) return 1;
  if (random.uniform() < sensors.lost_share / longest) return 1 + std::lround(random.uniform() * longest);
  return 0;
}

/// The force on the finger at one moment, tick by tick.
class PadForce {
 public:
  PadForce(const KnownFinger& finger, const KnownTrial& trial, double dt_s, RandomStream& random)
      : finger_(finger),
        trial_(trial),
        pad_(trial_pad(finger, trial.load_n, random)),
        vibration_(finger.pad.vibration_hz, finger.bandwidth_hz, dt_s, RandomStream(random.bits())),
        dt_s_(dt_s) {}

  Vec2 next(const TrueMotion& motion, double t) {
    const double load_n = t < 0 || t > trial_.duration_s ? 0 : motion.load_n(t);
    Vec2 place = motion.place(t);
    const Vec2 way = place - motion.place(t - dt_s_);
    // A spring that yields late follows a place that stays behind, on the other side within some way of a
    // turn.
    constexpr double turn_m = 1e-4;
    if (way.norm() > 0)
      lag_ += (1 - std::exp(-way.norm() / turn_m)) * (finger_.hysteresis_m * way.normalized() - lag_);
    place -= lag_;
    const bool begins = !touches_;
    touches_ = load_n > 0;
    if (!touches_) {
      state_ = FrictionState();
      vibration_.rest();
      return {0, 0};
    }
    const double longer = axes_at(load_n);
    if (begins) longer_ = longer;
    // The skin stays where it is while the axes change, which the law's lengths are told by.
    state_.stretch_m *= longer_ / longer;
    state_.last_step_m *= longer_ / longer;
    longer_ = longer;
    TangentialMotion told;
    told.dt_s = dt_s_;
    told.normal_force_n = load_n;
    told.mu_static = pad_.mu_static;
    told.mu_dynamic = pad_.mu_dynamic;
    told.step_m = begins ? Vec2(0, 0) : Vec2((place - last_) / longer);
    told.velocity_m_per_s = begins ? Vec2(0, 0) : Vec2(way / dt_s_);
    told.inclination_rad = trial_.inclination_deg * pi / 180;
    last_ = place;
    Friction friction = pad_.law->tick(told, state_);
    if (friction.phase != Phase::slip || !(finger_.vibration > 0)) {
      vibration_.rest();
      return friction.force_n;
    }
    const double scale = vibration_force_scale(finger_.vibration, vibration_.next());
    state_.slip_force_scale = scale;
    return scale * friction.force_n;
  }

 private:
  /// How long the axes are under a load, over those under 1 N.
  double axes_at(double load_n) const {
    constexpr double lightest_n = 1e-3;
    return std::pow(std::max(load_n, lightest_n), 1 - finger_.spring_load_exponent);
  }

  const KnownFinger& finger_;
  const KnownTrial& trial_;
  TrialPad pad_;
  SlipVibration vibration_;
  double dt_s_;
  FrictionState state_;
  Vec2 last_{0, 0}, lag_{0, 0};
  double longer_ = 1;  ///< axes_at the last tick
  bool touches_ = false;
};

}  // namespace

KnownSensors bad_sensors() {
  KnownSensors sensors;
  sensors.delay_s = 7.3e-3;
  sensors.tare_n = 0.1;
  sensors.drift_n_per_s = 0.01;
  sensors.hum_n = 0.01;
  sensors.lost_share = 0.005;
  sensors.air_s = 0.3;
  return sensors;
}

std::vector<KnownRow> measured_rows(const KnownFinger& finger, const KnownSensors& sensors,
                                    const KnownTrial& trial, RandomStream& random) {
  PadForce pad(finger, trial, 1 / sensors.rate_hz / sensors.ticks_a_sample, random);
  const TrueMotion motion{finger, trial, sensors.air_s};
  const SensorFault fault(sensors, random);
  const double deg = pi / 180;
  const Vec3 direction(0, std::cos(trial.inclination_deg * deg), -std::sin(trial.inclination_deg * deg));
  std::vector<KnownRow> rows;
  const long first = -std::lround(sensors.air_s * sensors.rate_hz);
  long lost = 0;
  Vec3 passed(0, 0, 0);  // of the force, by the sensor's low pass
  for (long k = first; k < std::lround(trial.duration_s * sensors.rate_hz) - first; ++k) {
    const double t = static_cast<double>(k) / sensors.rate_hz;
    for (int tick = sensors.ticks_a_sample; tick-- > 0;) {
      const double tick_s = 1 / sensors.rate_hz / sensors.ticks_a_sample, at_s = t - tick * tick_s;
      const Vec2 friction_n = pad.next(motion, at_s);
      const Vec3 sensed(friction_n.x(), friction_n.y(),
                        at_s < 0 || at_s > trial.duration_s ? 0 : motion.load_n(at_s));
      if (sensors.low_pass_hz > 0)
        passed += (1 - std::exp(-2 * pi * sensors.low_pass_hz * tick_s)) * (sensed - passed);
      else
        passed = sensed;
    }
    Vec3 force = passed + fault.at(t);
    const Vec2 place = motion.place(t + sensors.delay_s);
    Vec3 position(place.x(), place.y(), motion.height_m(t + sensors.delay_s));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      force[axis] = rounded(force[axis] + sensors.force_noise_n * random.normal(), sensors.force_quantum_n);
      position[axis] =
          rounded(position[axis] + sensors.position_noise_m * random.normal(), sensors.position_quantum_m);
    }
    if (lost == 0) lost = lost_run(sensors, random);
    if (lost > 0 && lost-- > 0) continue;
    rows.push_back({static_cast<double>(k - first) / sensors.rate_hz, position, force, direction});
  }
  return rows;
}

std::vector<KnownTrial> every(std::size_t step, const std::vector<KnownTrial>& trials) {
  std::vector<KnownTrial> some;
  for (std::size_t i = 0; i < trials.size(); i += step) some.push_back(trials[i]);
  return some;
}

std::vector<KnownTrial> known_trials() {
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

std::vector<KnownTrial> fewer_trials() {
  return sanitized() ? every(3, known_trials()) : known_trials();
}

KnownFinger of_subject(KnownFinger finger, int subject) {
  const double size = subject == 1 ? 0.8 : subject == 2 ? 1.0 : 1.2;
  finger.pad.lateral_axis_m *= size;
  finger.pad.longitudinal_axis_m *= size;
  return finger;
}

RecordedMeasurement known_measurement(const std::vector<KnownTrial>& trials, const KnownFinger& finger,
                                      const KnownSensors& sensors, std::uint64_t seed) {
  RecordedMeasurement measurement;
  RandomStream random(seed);
  int number = 0;
  for (const KnownTrial& trial : trials) {
    TrialRows rows("known", trial.subject, ++number, true);
    for (const KnownRow& row : measured_rows(of_subject(finger, trial.subject), sensors, trial, random))
      rows.add({row.t_s, row.position_W, row.force_W, Vec3::UnitZ(), row.direction_W});
    rows.finish(measurement);
  }
  return measurement;
}

RecordedMeasurement of_normal_force_alone(RecordedMeasurement measurement) {
  for (RecordedTrial& trial : measurement.trials) {
    trial.force_W.topRows(2).setZero();
    trial.lacks = "column fx_n missing";
  }
  return measurement;
}

std::string measured_table(const std::vector<KnownTrial>& trials, std::uint64_t seed,
                           const KnownFinger& finger, const KnownSensors& sensors) {
  std::string text = "t_s,x_m,y_m,z_m,fx_n,fy_n,fz_n,dx,dy,dz,subject,trial\n";
  RandomStream random(seed);
  int number = 0;
  for (const KnownTrial& trial : trials) {
    ++number;
    for (const KnownRow& row : measured_rows(of_subject(finger, trial.subject), sensors, trial, random)) {
      const Vec3 &p = row.position_W, &f = row.force_W, &d = row.direction_W;
      text += fmt::format("{:.3f},{:.5f},{:.5f},{:.5f},{:.3f},{:.3f},{:.3f},{:.4g},{:.4g},{:.4g},{},{}\n",
                          row.t_s, p.x(), p.y(), p.z(), f.x(), f.y(), f.z(), d.x(), d.y(), d.z(),
                          trial.subject, number);
    }
  }
  return text;
}

std::array<double, pad_number_keys.size()> known_numbers(const KnownFinger& finger, double load_n) {
  const double rise = finger.rises_with_less_load ? std::cbrt(1 / load_n) : 1;
  const double mu = finger.pad.mu_static * rise, a = finger.pad.lateral_axis_m,
               b = finger.pad.longitudinal_axis_m;
  // Sizes of the subjects: their stiffnesses have the mean of 1/size only as 1/axis of the mean axis.
  return {a,
          b,
          finger.pad.lateral_slope_per_deg,
          finger.pad.longitudinal_slope_per_deg,
          mu,
          finger.mu_dynamic * rise,
          finger.rises_with_less_load ? -1.0 / 3 : 0,
          mu / a,
          mu / b,
          1,
          1,
          finger.cubic_share,
          finger.cubic_share,
          4 * finger.hysteresis_m * mu,
          4 * finger.hysteresis_m * mu,
          finger.pad.v_min_m_per_s,
          finger.pad.vibration_hz,
          finger.bandwidth_hz,
          finger.press_exponent / finger.depth_at_1_n_m,
          finger.press_exponent};
}

std::string shipped_table() {
  std::vector<KnownTrial> trials;
  for (const int subject : {1, 3}) {
    for (const double angle : {25.0, 45.0, 65.0}) trials.push_back({subject, angle, 45, 0.04, 0.7, 1.5, 1});
  }
  return "# Synthetic: made by the program's own finger-pad law from a known pad, through sensors with "
         "noise, a "
         "drifting tare, 60 Hz hum, lost samples and 7.3 ms of delay; no finger was measured.\n"
         "# Axes 2 and 1.6 mm at 45 deg (mean of two subjects), slopes 0.01, mu 0.3 and 0.2, v_min 0.1 m/s, "
         "89 Hz 20 Hz wide, n = (depth/1.5 mm)^2 N. BSD-3-Clause.\n" +
         measured_table(trials, 1, {}, bad_sensors());
}

}  // namespace fingerpad::test
