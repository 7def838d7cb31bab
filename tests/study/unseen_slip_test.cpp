#include "study/unseen_slip.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "study/profile_text.hpp"
#include "support/effort.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::unseen_slip_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

ProfileFit fitted(const std::vector<test::KnownTrial>& trials, const test::KnownFinger& finger,
                  double rate_hz) {
  test::KnownSensors sensors;
  sensors.rate_hz = rate_hz;
  return fit_profile(clean(test::known_measurement(trials, finger, sensors, 3), {}), {});
}

const PadValue& of(const ProfileFit& fit, PadNumber number) {
  return fit.values[static_cast<std::size_t>(number)];
}

bool holds(const ProfileFit& fit, PadNumber number, double truth) {
  const auto& interval = fit.interval[static_cast<std::size_t>(number)];
  return interval && interval->first <= truth && truth <= interval->second;
}

test::KnownFinger finger_of(double mu_dynamic, double v_min_m_per_s) {
  test::KnownFinger finger;
  finger.mu_dynamic = mu_dynamic;
  finger.pad.v_min_m_per_s = v_min_m_per_s;
  return finger;
}

/// Twelve rubs of one subject, at three angles, along both axes.
std::vector<test::KnownTrial> rubs(double speed_m_per_s, bool are_even) {
  std::vector<test::KnownTrial> trials;
  constexpr double frequency_hz = 0.3;
  const double amplitude_m = speed_m_per_s / frequency_hz / (are_even ? 4 : 2 * 3.14159265);
  for (int k = 0; k < 12; ++k) {
    trials.push_back({2, 25.0 + 20 * (k % 3), k % 2 * 90.0, amplitude_m, frequency_hz, 4});
    trials.back().is_even = are_even;
  }
  return trials;
}

TEST(UnseenSlip, RubsThatAreAllBelowVMinAreNoOtherLaw) {
  // At most 0.06 m/s, where the finger slips from 0.1 on: teeth that are not seen, or seen here and there.
  for (const double mu_dynamic : test::cases({0.25, 0.27})) {
    for (const double rate_hz : test::cases({1000.0, 500.0})) {
      const ProfileFit fit = fitted(rubs(0.06, false), finger_of(mu_dynamic, 0.1), rate_hz);
      EXPECT_EQ(fit.residual.misfit, "") << mu_dynamic << " " << rate_hz;
      EXPECT_THAT(fit_notes(fit),
                  Contains(AllOf(HasSubstr("whether the pad's law fits cannot be told: no slip is "
                                           "surely seen"),
                                 HasSubstr("rub faster"))))
          << mu_dynamic << " " << rate_hz;
      EXPECT_THAT(fit_notes(fit), Not(Contains(HasSubstr("the pad's law fits: ")))) << mu_dynamic;
      EXPECT_TRUE(holds(fit, PadNumber::mu_dynamic, mu_dynamic)) << mu_dynamic << " " << rate_hz;
      EXPECT_THAT(fit_notes(fit), Contains(HasSubstr("mu_dynamic: what passes for slip may hold teeth")));
      const PadValue& mu_static = of(fit, PadNumber::mu_static);
      EXPECT_TRUE(!mu_static.refusal.empty() || std::abs(mu_static.value / 0.3 - 1) < 0.02)
          << mu_static.value;
    }
  }
}

/// Its load swings by a third, a little over once a second.
void swing_load(RecordedTrial& trial, double phase) {
  for (Eigen::Index i = 0; i < trial.samples(); ++i)
    trial.force_W.col(i) *= 1 + 0.35 * std::sin(7 * static_cast<double>(i) / trial.rate_hz + phase);
}

TEST(UnseenSlip, TeethThatPassForSlipTellNoLoadExponent) {
  test::KnownSensors sensors;
  sensors.position_noise_m = 2e-6;
  sensors.position_quantum_m = sensors.force_quantum_n = 1e-7;
  for (const auto& [rate_hz, speed_m_per_s, noise_n] : test::cases<std::tuple<double, double, double>>(
           {{500, 0.015, 0.002}, {500, 0.02, 0.005}, {500, 0.018, 0.004}})) {
    sensors.rate_hz = rate_hz;
    sensors.force_noise_n = noise_n;
    RecordedMeasurement recorded =
        test::known_measurement(rubs(speed_m_per_s, false), finger_of(0.2, 0.1), sensors, 3);
    for (std::size_t k = 0; k < recorded.trials.size(); ++k)
      swing_load(recorded.trials[k], static_cast<double>(k));
    const ProfileFit fit = fit_profile(clean(recorded, {}), {});
    std::string about = fmt::format("{} Hz, {} m/s, {} N", rate_hz, speed_m_per_s, noise_n);
    for (const PadNumber number : {PadNumber::mu_static, PadNumber::mu_dynamic, PadNumber::mu_load_exponent})
      about += fmt::format("; {} of {} samples {}", of(fit, number).value, of(fit, number).samples,
                           of(fit, number).refusal);
    ASSERT_THAT(fit.residual.untold, HasSubstr("no slip is s")) << about;
    EXPECT_NE(of(fit, PadNumber::mu_load_exponent).refusal, "") << about;
    EXPECT_TRUE(holds(fit, PadNumber::mu_static, 0.3)) << about;
    EXPECT_TRUE(!of(fit, PadNumber::mu_dynamic).refusal.empty() || holds(fit, PadNumber::mu_dynamic, 0.2))
        << about;
  }
}

TEST(UnseenSlip, AdviceIsToRubFasterWhereThatIsWhy) {
  const ProfileFit slow = fitted(rubs(0.06, false), finger_of(0.27, 0.1), 1000);
  EXPECT_EQ(of(slow, PadNumber::lateral_axis).reason, RefusalReason::unseen_slip);
  EXPECT_THAT(missing_axes_words(slow),
              AllOf(HasSubstr("To have it, rub faster."), Not(HasSubstr("two angles"))));
  // The words are those of another refusal, whose reason is its own.
  ProfileFit other = slow;
  for (const PadNumber number : {PadNumber::lateral_axis, PadNumber::longitudinal_axis})
    other.values[static_cast<std::size_t>(number)].reason = RefusalReason::one_angle;
  EXPECT_THAT(missing_axes_words(other),
              AllOf(HasSubstr("two angles"), Not(HasSubstr("To have it, rub faster"))));
}

TEST(UnseenSlip, NoSlipAtAllIsNoVerdictEither) {
  const ProfileFit fit = fitted(rubs(0.06, false), finger_of(0.2, 0.1), 1000);
  EXPECT_EQ(of(fit, PadNumber::mu_dynamic).refusal, "no slip was found");
  EXPECT_THAT(fit_notes(fit), Contains(HasSubstr("cannot be told: no slip is seen: stick gives way")));
  // Teeth that are plainly seen tell spring and mu_static all the same.
  EXPECT_TRUE(holds(fit, PadNumber::mu_static, 0.3));
  EXPECT_TRUE(holds(fit, PadNumber::lateral_axis, 0.002));
}

TEST(UnseenSlip, SlowSlipThatCannotHoldTeethIsSlip) {
  // Forth and back at 0.06 m/s: the finger turns at once, so that slip is never seen to end in stick.
  for (const double vibration : test::cases({0.05, 0.0})) {
    test::KnownFinger finger = finger_of(0.25, 0.012);
    finger.vibration = vibration;
    for (const double mu_static : test::cases({0.3, 0.35})) {
      finger.pad = assumed_profile(mu_static, 150);
      finger.pad.v_min_m_per_s = 0.012;
      const ProfileFit fit = fitted(rubs(0.06, true), finger, 1000);
      EXPECT_NEAR(of(fit, PadNumber::mu_dynamic).value, 0.25, 0.001) << vibration << " " << mu_static;
      EXPECT_EQ(of(fit, PadNumber::mu_dynamic).refusal, "") << vibration << " " << mu_static;
      // No slip ends in stick here, and its teeth would be seen: they do not widen it to mu_static and as far
      // below.
      EXPECT_TRUE(holds(fit, PadNumber::mu_dynamic, 0.25)) << vibration << " " << mu_static;
      const auto& interval = fit.interval[static_cast<std::size_t>(PadNumber::mu_dynamic)];
      EXPECT_LT(interval->second - interval->first, 0.02) << vibration << " " << mu_static;
      EXPECT_EQ(fit.residual.misfit, "") << vibration << " " << mu_static;
      EXPECT_EQ(fit.residual.untold, "") << vibration << " " << mu_static;
      EXPECT_THAT(fit_notes(fit).back(), HasSubstr("the pad's law fits: ")) << vibration << " " << mu_static;
      EXPECT_NE(of(fit, PadNumber::v_min).refusal, "") << of(fit, PadNumber::v_min).value;
    }
  }
}

TEST(UnseenSlip, TeethThatSlipWouldHoldAreSeenWhereTheyAreLongEnough) {
  // Of 0.05 either way of slip's friction and 150 1/m: 0.67 mm, at 1 kHz 11 samples at 0.06 m/s and 3 at 0.2.
  PadValues found;
  found[static_cast<std::size_t>(PadNumber::mu_static)] = {0.3, 20, 5, ""};
  found[static_cast<std::size_t>(PadNumber::mu_dynamic)] = {0.25, 1000, 5, ""};
  for (const double speed_m_per_s : {0.06, 0.2}) {
    TrialEvidence trial;
    trial.rate_hz = 1000;
    trial.gives = trial.drops = trial.strokes = trial.stroke_drops = 10;
    trial.slip_samples = 1000;
    trial.spring[0](spring_straight, spring_straight) = 150;
    trial.spring[0](spring_position, spring_straight) = 1;
    for (int k = 0; k < 1000; ++k) trial.slip_by_speed.add(speed_m_per_s, 0.25);
    const bool may_hold = speed_m_per_s > 0.1;
    EXPECT_EQ(slip_may_hold_teeth({trial}, found), may_hold) << speed_m_per_s;
    EXPECT_EQ(unseen_slip_words({trial}, found, {}).empty(), !may_hold) << speed_m_per_s;
  }
}

/// One rub forth and back gives way two or three times, and never is slip seen to end in stick.
TEST(UnseenSlip, OfOneRubSlipIsTakenForSlipWhereTeethWouldBeSeen) {
  std::vector<test::KnownTrial> one = rubs(0.06, true);
  one.resize(1);
  one[0].inclination_deg = 45;
  for (const double v_min_m_per_s : {0.012, 0.1}) {
    // Teeth of 0.4 mm, of which a sample at 250 Hz is more than half.
    const ProfileFit slow = fitted(one, finger_of(0.27, v_min_m_per_s), 250);
    EXPECT_THAT(of(slow, PadNumber::mu_dynamic).refusal, HasSubstr("no slip is surely seen"))
        << v_min_m_per_s;
  }
  const ProfileFit fast = fitted(one, finger_of(0.25, 0.012), 1000);
  EXPECT_EQ(of(fast, PadNumber::mu_dynamic).refusal, "");
  EXPECT_NEAR(of(fast, PadNumber::mu_dynamic).value, 0.25, 0.001);
}

TEST(UnseenSlip, EndsOfSlipThatAreSeenOnceInAWhileTellNoVMin) {
  TrialEvidence trial;
  trial.subject = 1;
  trial.stops = 1;
  trial.stop_speed_m_per_s = 0.06;
  trial.gives = 10;
  EXPECT_EQ(seen_v_min({trial}, {1}).refusal, "");
  trial.gives = 11;
  EXPECT_THAT(seen_v_min({trial}, {1}).refusal, HasSubstr("seen to end in stick 1 times only"));
}

TEST(UnseenSlip, AnotherLawIsToldAtAnySpeed) {
  for (const double speed_m_per_s : {0.06, 0.2}) {
    test::KnownFinger finger = finger_of(0.2, 0.1);
    finger.law = "lugre";
    EXPECT_NE(fitted(rubs(speed_m_per_s, false), finger, 1000).residual.misfit, "") << speed_m_per_s;
  }
}

}  // namespace
}  // namespace fingerpad::unseen_slip_test
