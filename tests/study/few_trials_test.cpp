#include "study/few_trials.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "study/cross_validation.hpp"
#include "study/profile_text.hpp"
#include "support/effort.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::few_trials_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Measurement measured(const std::vector<test::KnownTrial>& trials, const test::KnownFinger& finger = {},
                     std::uint64_t seed = 1) {
  return clean(test::known_measurement(trials, finger, {}, seed), {});
}

const PadValue& of(const ProfileFit& fit, PadNumber number) {
  return fit.values[static_cast<std::size_t>(number)];
}

TEST(FewTrials, VMinAndVibrationOfTwoAreRefused) {
  const ProfileFit two = fit_profile(measured({{1, 45, 0}, {1, 45, 90}}), {}),
                   three = fit_profile(measured({{1, 45, 0}, {1, 45, 90}, {1, 45, 45}}), {});
  EXPECT_THAT(
      of(two, PadNumber::v_min).refusal,
      HasSubstr("slip is seen to end in 2 trials only, too few to say how far it may be off: record until"));
  for (const PadNumber number : {PadNumber::vibration, PadNumber::vibration_bandwidth})
    EXPECT_THAT(of(two, number).refusal, HasSubstr("2 trials tell it, too few"));
  EXPECT_THAT(fit_notes(two),
              Contains(HasSubstr("too few trials for an interval, so that these may be off by any "
                                 "amount (record 3 or more): lateral_axis_m")));
  EXPECT_NE(profile_text(two, "x").find("# too few trials for an interval"), std::string::npos);
  for (const PadNumber number : {PadNumber::v_min, PadNumber::vibration, PadNumber::vibration_bandwidth})
    EXPECT_EQ(of(three, number).refusal, "");
}

/// One of four trials along the finger has a spring of four times the stiffness, which leaves the axis
/// untold: it is named where the axis is refused, and where it is said what to do.
TEST(FewTrials, ASpringThatIsUnlikeTheOthersIsNamedWhereTheAxisIsRefused) {
  const std::vector<test::KnownTrial> trials{{2, 45, 0},  {2, 45, 90}, {2, 45, 0},  {2, 45, 90},
                                             {2, 45, 90}, {2, 45, 0},  {2, 45, 90}, {2, 45, 0}};
  test::KnownFinger stiff;
  stiff.pad.longitudinal_axis_m /= 4;
  RecordedMeasurement recorded = test::known_measurement(trials, {}, {}, 1);
  recorded.trials[3] = test::known_measurement(trials, stiff, {}, 1).trials[3];
  const ProfileFit fit = fit_profile(clean(std::move(recorded), {}), {});
  EXPECT_THAT(
      of(fit, PadNumber::longitudinal_axis).refusal,
      testing::AllOf(HasSubstr("too few or too unlike"),
                     HasSubstr("trial 4 is unlike the others: its longitudinal_stiffness_per_m is 7")));
  EXPECT_THAT(missing_axes_words(fit), HasSubstr("leave the trial out that is unlike the others"));
  EXPECT_EQ(of(fit, PadNumber::lateral_axis).refusal, "");
}

/// Some ninety samples of stick an axis, of two trials.
TEST(FewTrials, SpringsThatTheirOwnStickDoesNotTellAreRefused) {
  test::KnownSensors slow;
  slow.rate_hz = 250;
  const auto truth = test::known_numbers({}, 1);
  const int sets = test::samples(20);
  int given = 0, far_off = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(sets); ++seed) {
    const ProfileFit fit = fit_profile(
        clean(test::known_measurement({{2, 25, 0}, {2, 25, 90}, {2, 65, 0}, {2, 65, 90}}, {}, slow, seed),
              {}),
        {});
    for (const PadNumber number : {PadNumber::lateral_axis, PadNumber::longitudinal_axis}) {
      const PadValue& axis = of(fit, number);
      if (!axis.refusal.empty()) {
        EXPECT_THAT(axis.refusal, HasSubstr("2 trials tell it, and by chance within them it may be off by"));
        EXPECT_FALSE(of(fit, number == PadNumber::lateral_axis ? PadNumber::stick_stiffness
                                                               : PadNumber::longitudinal_stiffness)
                         .refusal.empty());
        ++refused;
        continue;
      }
      const double size = truth[static_cast<std::size_t>(number)];
      far_off += std::abs(axis.value - size) > 0.2 * size ? 1 : 0;
      ++given;
    }
  }
  EXPECT_GT(refused, sets);
  EXPECT_LE(far_off, 2) << "of " << given;  // 95 % of 40 that may be off by a fifth; 12 of 40 else
  const ProfileFit fast = fit_profile(measured({{2, 25, 0}, {2, 25, 90}, {2, 65, 0}, {2, 65, 90}}), {});
  EXPECT_EQ(of(fast, PadNumber::longitudinal_axis).refusal, "");
}

TEST(FewTrials, ALoopIsNotToldWhereStickIsNotPushedToAndFro) {
  test::KnownSensors slow;
  slow.rate_hz = 250;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ProfileFit fit = fit_profile(
        clean(test::known_measurement({{2, 45, 0}, {2, 45, 0}, {2, 45, 0}, {2, 45, 0}}, {}, slow, seed), {}),
        {});
    const PadValue& loop = of(fit, PadNumber::lateral_hysteresis_area);
    if (loop.refusal.empty()) {
      EXPECT_NEAR(loop.value, 0, 3e-4) << seed;  // a tenth of the reach; 0.3 m else
    } else {
      EXPECT_THAT(loop.refusal, HasSubstr("not pushed to and fro")) << seed;
    }
  }
}

TEST(FewTrials, AVMinThatAStepOfOneTrialTellsIsRefused) {
  ProfileFit fit;
  for (PadValue& value : fit.values) value.refusal = "not here";
  fit.v_min_by_step = true;
  PadValue& v_min = fit.values[static_cast<std::size_t>(PadNumber::v_min)];
  v_min = {0.1, 200, 1, ""};
  refuse_told_by_few(fit);
  EXPECT_THAT(v_min.refusal,
              HasSubstr("friction is seen to step as the finger slows in 1 trial only, too few"));
  // One rub at 250 Hz, whose teeth are too short: its step alone says no more of how far it may be off.
  test::KnownFinger finger;
  finger.mu_dynamic = 0.25;
  finger.pad.v_min_m_per_s = 0.05;
  test::KnownSensors slow;
  slow.rate_hz = 250;
  CleaningSettings given;
  given.delay_s = 0;
  int steps = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const ProfileFit one = fit_profile(
        clean(test::known_measurement({{2, 45, 0, 0.06, 0.5, 4}}, finger, slow, seed), given), {});
    steps += one.v_min_by_step ? 1 : 0;
    EXPECT_NE(of(one, PadNumber::v_min).refusal, "") << seed << " " << of(one, PadNumber::v_min).value;
  }
  EXPECT_GT(steps, 2);
}

TEST(FewTrials, AVibrationWhoseWidthMayBeNoneIsRefused) {
  test::KnownFinger hardly;
  hardly.vibration = 0.01;  // beneath the noise
  std::vector<test::KnownTrial> trials;
  for (int k = 0; k < 6; ++k) trials.push_back({2, 45, 45.0 * k, 0.06, 0.6, 4});
  const ProfileFit fit = fit_profile(measured(trials, hardly, 3), {});
  for (const PadNumber number : {PadNumber::vibration, PadNumber::vibration_bandwidth}) {
    EXPECT_THAT(of(fit, number).refusal, HasSubstr("nothing is seen to vibrate for sure"));
    EXPECT_FALSE(fit.interval[static_cast<std::size_t>(number)]);
  }
  EXPECT_EQ(of(fit_profile(measured(trials), {}), PadNumber::vibration).refusal, "");
}

TEST(FewTrials, AnAxisWithoutAnIntervalThatIsNoFingersIsRefused) {
  ProfileFit fit;
  for (PadValue& value : fit.values) value.refusal = "not here";
  PadValue &axis = fit.values[0], &slope = fit.values[2];
  axis = {0.024, 100, 1, ""};
  slope.refusal = "one angle";
  refuse_told_by_few(fit);
  EXPECT_THAT(axis.refusal, HasSubstr("it would be 24 mm, which is no finger's, and 1 trial tells it"));
  EXPECT_EQ(slope.refusal, "one angle") << "an earlier refusal stays";
  axis = {0.024, 100, 3, ""};
  fit.interval[0] = {0.02, 0.028};
  refuse_told_by_few(fit);
  EXPECT_EQ(axis.refusal, "");
  axis = {0.004, 100, 1, ""};
  fit.interval[0].reset();
  refuse_told_by_few(fit);
  EXPECT_EQ(axis.refusal, "");
}

TEST(FewTrials, OneTrialOfEachSubjectIsNotTooFewTrials) {
  std::vector<test::KnownTrial> trials;
  for (int k = 0; k < 12; ++k) trials.push_back({k + 1, 45, 45.0 * (k % 3), 0.06, 0.6, 4});
  const Measurement twelve = measured(trials, {}, 3);
  const ProfileFit fit = fit_profile(twelve, {});
  for (const PadNumber number : {PadNumber::vibration, PadNumber::vibration_bandwidth}) {
    EXPECT_EQ(of(fit, number).refusal, "");
    EXPECT_FALSE(fit.interval[static_cast<std::size_t>(number)]);
    EXPECT_EQ(fit.no_interval[static_cast<std::size_t>(number)], NoInterval::few_a_subject);
  }
  EXPECT_EQ(of(fit, PadNumber::v_min).refusal, "");
  EXPECT_THAT(fit_notes(fit),
              Contains(HasSubstr("too few trials of each subject for an interval, so that these may be off "
                                 "by any amount (record several trials of each, or draw whole subjects with "
                                 "--blocks subjects): lateral_axis_m")));
  EXPECT_THAT(fit_notes(fit), Not(Contains(HasSubstr("too few trials for an interval"))));
  FitSettings of_subjects;
  of_subjects.blocks = Blocks::subjects;
  const ProfileFit drawn = fit_profile(twelve, of_subjects);
  EXPECT_TRUE(drawn.interval[static_cast<std::size_t>(PadNumber::vibration)]);
  Measurement two = twelve;
  for (std::size_t i = 0; i < two.trials.size(); ++i) two.trials[i].subject = i % 2 == 0 ? 1 : 2;
  EXPECT_THAT(fit_notes(fit_profile(two, of_subjects)),
              Contains(HasSubstr("too few subjects for an interval")));
}

TEST(FewTrials, OddAxesOfManyTrialsAreGiven) {
  ProfileFit fit;
  for (PadValue& value : fit.values) value.refusal = "not here";
  fit.values[0] = {0.024, 100, 12, ""};
  fit.no_interval[0] = NoInterval::few_a_subject;
  refuse_told_by_few(fit);
  EXPECT_EQ(fit.values[0].refusal, "");
  EXPECT_THAT(fit_notes(fit), Contains(HasSubstr("is the positions' unit right?")));
}

TEST(FewTrials, AVibrationThatManyDrawsDoNotShowIsRefused) {
  ProfileFit fit;
  for (const PadNumber number : {PadNumber::vibration, PadNumber::vibration_bandwidth}) {
    fit.values[static_cast<std::size_t>(number)] = {90, 100, 12, ""};
    fit.no_interval[static_cast<std::size_t>(number)] = NoInterval::draws_refused;
  }
  refuse_told_by_few(fit);
  EXPECT_THAT(of(fit, PadNumber::vibration).refusal, HasSubstr("no frequency stands out"));
}

TEST(FewTrials, FoldsKeepWhatFewTell) {
  FitSettings of_fold;
  of_fold.keeps_told_by_few = true;
  const ProfileFit fold = fit_profile(measured({{1, 45, 0}, {1, 45, 90}}), of_fold);
  for (const PadNumber number : {PadNumber::v_min, PadNumber::vibration})
    EXPECT_EQ(of(fold, number).refusal, "");
  // Without their v_min each fold would have the built-in one.
  test::KnownFinger slow;
  slow.pad.v_min_m_per_s = 0.04;
  slow.vibration = 0;
  const CrossValidation checked = cross_validate(measured({{2, 45, 45}, {2, 45, 45}, {2, 45, 45}}, slow), {});
  EXPECT_LT(checked.fitted_rms_n, 0.02);  // 0.09 with the built-in v_min
}

}  // namespace
}  // namespace fingerpad::few_trials_test
