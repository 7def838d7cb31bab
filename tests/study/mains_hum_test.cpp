#include "study/mains_hum.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "study/measurement.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::mains_hum_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Rubs at one speed, both ways: a pad of 2 mm and coefficients of 0.3 and 0.2 gives way every 0.67 mm, which
/// is 50 times a second here.
std::vector<test::KnownTrial> even_rubs(double frequency_step_hz) {
  constexpr double speed_m_per_s = 0.033;
  std::vector<test::KnownTrial> trials;
  for (int k = 0; k < 6; ++k) {
    const double frequency_hz = 0.3 + frequency_step_hz * k;
    test::KnownTrial trial{2, 45, 0, speed_m_per_s / 4 / frequency_hz, frequency_hz, 4};
    trial.is_even = true;
    trials.push_back(trial);
  }
  return trials;
}

test::KnownSensors sensors_with(double air_s, double hum_n) {
  test::KnownSensors sensors;
  sensors.force_noise_n = 0.003;
  sensors.air_s = air_s;
  sensors.hum_n = hum_n;
  return sensors;
}

long lines_near(const std::vector<HumLine>& lines, double nominal_hz) {
  return std::count_if(lines.begin(), lines.end(),
                       [&](const HumLine& line) { return line.nominal_hz == nominal_hz; });
}

TEST(MainsHum, TeethOfStickAndSlipAreNone) {
  // Without a moment in the air, teeth that are the same in each trial cannot be told from hum.
  for (const auto& [air_s, frequency_step_hz] :
       {std::pair(0.0, 0.02), std::pair(0.3, 0.02), std::pair(0.3, 0.0)}) {
    const RecordedMeasurement recorded =
        test::known_measurement(even_rubs(frequency_step_hz), {}, sensors_with(air_s, 0), 3);
    long standing = 0;
    for (const RecordedTrial& trial : recorded.trials)
      standing += lines_near(hum_lines(trial, Mains::any), 50);
    EXPECT_GT(standing, 0) << "nothing to be taken for hum " << air_s << " " << frequency_step_hz;
    const HumVerdict verdict = judge_hum(recorded.trials, Mains::any);
    for (const auto& lines : verdict.lines) EXPECT_TRUE(lines.empty()) << air_s << " " << frequency_step_hz;
    EXPECT_THAT(verdict.left_in, HasSubstr("as teeth of stick and slip do"));
    EXPECT_THAT(clean(recorded, {}).steps, Contains(HasSubstr("mains hum: none; a line near 50 Hz in")));
  }
}

TEST(MainsHum, IsTakenOutBesideTeeth) {
  for (const double air_s : {0.0, 0.3}) {
    const RecordedMeasurement recorded =
        test::known_measurement(even_rubs(0.02), {}, sensors_with(air_s, 0.02), 3);
    const HumVerdict verdict = judge_hum(recorded.trials, Mains::any);
    for (const auto& lines : verdict.lines) {
      EXPECT_EQ(lines_near(lines, 60), 1) << air_s;
      EXPECT_EQ(lines_near(lines, 50), 0) << air_s;
    }
  }
}

TEST(MainsHum, ALineThatIsNotThereInTheAirIsNone) {
  // Of one frequency, amplitude and phase in every trial, but in contact alone.
  RecordedMeasurement recorded = test::known_measurement({{2, 45, 0}, {2, 45, 90}, {2, 45, 45}}, {},
                                                         sensors_with(0.3, 0), 3),
                      in_air_too = recorded;
  for (std::size_t k = 0; k < recorded.trials.size(); ++k) {
    RecordedTrial &trial = recorded.trials[k], &other = in_air_too.trials[k];
    const auto air = static_cast<Eigen::Index>(0.3 * trial.rate_hz);
    for (Eigen::Index i = 0; i < trial.samples(); ++i) {
      const double hum_n =
          0.02 * std::sin(2 * std::numbers::pi * 50 * static_cast<double>(i) / trial.rate_hz);
      if (i >= air && i < trial.samples() - air) trial.force_W(0, i) += hum_n;
      other.force_W(0, i) += hum_n;
    }
  }
  EXPECT_THAT(judge_hum(recorded.trials, Mains::any).left_in,
              HasSubstr("is not there where nothing touches the sensor"));
  EXPECT_EQ(judge_hum(in_air_too.trials, Mains::any).left_in, "");
}

TEST(MainsHum, ALineThatDoesNotLastIsNone) {
  RecordedMeasurement recorded =
      test::known_measurement({{2, 45, 0}, {2, 45, 90}, {2, 45, 45}}, {}, sensors_with(0, 0), 3);
  for (RecordedTrial& trial : recorded.trials) {
    for (Eigen::Index i = 0; i < trial.samples() / 2; ++i)
      trial.force_W(0, i) +=
          0.02 * std::sin(2 * std::numbers::pi * 50 * static_cast<double>(i) / trial.rate_hz);
    ASSERT_EQ(lines_near(hum_lines(trial, Mains::any), 50), 1);
  }
  EXPECT_THAT(judge_hum(recorded.trials, Mains::any).left_in, HasSubstr("does not keep its amplitude"));
}

TEST(MainsHum, IsTakenOutOfTorquesToo) {
  RecordedMeasurement recorded =
      test::known_measurement({{2, 45, 0}, {2, 45, 90}, {2, 45, 45}}, {}, sensors_with(0.3, 0.02), 3);
  RecordedMeasurement still =
      test::known_measurement({{2, 45, 0}, {2, 45, 90}, {2, 45, 45}}, {}, sensors_with(0.3, 0), 3);
  // Contact points are torque over force: what hums in one alone moves them.
  for (RecordedMeasurement* measurement : {&recorded, &still}) {
    const bool hums = measurement == &recorded;
    for (RecordedTrial& trial : measurement->trials) {
      trial.sensor = ContactSensor{Vec3(0, 0, -0.02), 0};
      trial.tracked_W = trial.position_W;
      trial.torque_W_n_m = Points::Zero(3, trial.samples());
      for (Eigen::Index i = 0; i < trial.samples(); ++i) {
        const Vec3 arm = trial.position_W.col(i) + Vec3(0, 0, 0.02);
        trial.torque_W_n_m.col(i) = arm.cross(Vec3(trial.force_W.col(i)));
        if (hums)
          trial.torque_W_n_m(0, i) +=
              2e-3 * std::sin(2 * std::numbers::pi * 60 * static_cast<double>(i) / trial.rate_hz);
      }
    }
  }
  const auto roughness = [](const Measurement& measurement) {
    const std::vector<Vec2>& p = measurement.trials.front().position_m;
    double sum = 0;
    for (std::size_t i = 900; i < 2900; ++i) sum += (p[i] - 2 * p[i - 1] + p[i - 2]).squaredNorm();
    return sum;
  };
  CleaningSettings settings;
  settings.takes_delay = false;
  CleaningSettings left = settings;
  left.mains = Mains::off;
  const double without = roughness(clean(still, settings));
  const double hummed = roughness(clean(recorded, left)) - without;
  EXPECT_GT(hummed, 2 * without) << "the hum is too small to be seen";
  // What is left are samples of light loads, where the rest of the forces' hum is a large part.
  EXPECT_LT(roughness(clean(recorded, settings)) - without, 0.2 * hummed);
}

}  // namespace
}  // namespace fingerpad::mains_hum_test
