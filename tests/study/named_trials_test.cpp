#include "study/named_trials.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "study/odd_trials.hpp"
#include "support/pad_measurement.hpp"
#include "support/refusal.hpp"

namespace fingerpad::named_trials_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// Two subjects with trials 1 and 12 each, in a file whose name has a comma.
RecordedMeasurement recorded() {
  static const RecordedMeasurement made =
      test::known_measurement({{1}, {1}, {2}, {2}}, {}, test::bad_sensors(), 1);
  RecordedMeasurement four = made;
  for (std::size_t i = 0; i < 4; ++i) {
    four.trials[i].file = "a, b.csv";
    four.trials[i].number = i % 2 == 0 ? 1 : 12;
  }
  return four;
}

std::vector<std::string> left(const std::vector<std::string>& named) {
  RecordedMeasurement all = recorded();
  leave_out_trials(named, all);
  std::vector<std::string> names;
  for (const RecordedTrial& trial : all.trials) names.push_back(trial_name(trial).substr(10));
  return names;
}

std::string why_not(const std::function<void()>& make) {
  return test::why_not(make, ErrorKind::usage);
}

TEST(NamedTrials, AreLeftOutByAllOfTheirNameOrSome) {
  EXPECT_THAT(left({"trial 1"}), ElementsAre("subject 1, trial 12", "subject 2, trial 12"));
  EXPECT_THAT(left({"subject 2"}), ElementsAre("subject 1, trial 1", "subject 1, trial 12"));
  EXPECT_THAT(left({"subject 2, trial 12", "a, b.csv, subject 1, trial 1"}),
              ElementsAre("subject 1, trial 12", "subject 2, trial 1"));
  EXPECT_THAT(left({"a, b.csv, trial 12"}), ElementsAre("subject 1, trial 1", "subject 2, trial 1"));
  EXPECT_EQ(left({}).size(), 4U);
}

TEST(NamedTrials, WhatIsLeftOutIsTold) {
  RecordedMeasurement all = recorded();
  EXPECT_EQ(leave_out_trials({"trial 12"}, all),
            "left out (--leave-out): a, b.csv, subject 1, trial 12; a, b.csv, subject 2, trial 12");
}

TEST(NamedTrials, ANameOfNoneIsRefusedWithThoseThatThereAre) {
  for (const char* name : {"trial 7", "7", "subject 1, trial 2", "rial 1", ""})
    EXPECT_THAT(why_not([&] { left({name}); }),
                AllOf(HasSubstr("no trial is called"), HasSubstr("'subject 2, trial 12'")))
        << name;
  EXPECT_THAT(why_not([] { left({"subject 1", "subject 2"}); }), HasSubstr("leaves no trial"));
}

TEST(NamedTrials, OneInAnotherUnitIsTakenInItsOwn) {
  RecordedMeasurement all = recorded();
  const Points force_n = all.trials[3].force_W, places_m = all.trials[3].position_W;
  all.trials[3].force_W *= 1e3;
  all.trials[3].position_W *= 1e2;
  const std::vector<std::string> doubts = odd_trial_doubts(all.trials);
  EXPECT_THAT(doubts, Contains(AllOf(HasSubstr("--trial-unit 'subject 2, trial 12=UNIT'"),
                                     HasSubstr("--leave-out 'subject 2, trial 12'"))));
  const auto told = take_trial_units({"subject 2, trial 12=mN", "subject 2, trial 12=cm"}, {}, all);
  EXPECT_THAT(told, ElementsAre(HasSubstr("subject 2, trial 12: its forces are taken to be in mN"),
                                HasSubstr("its positions are taken to be in cm")));
  constexpr double rounding = 1e-12;
  EXPECT_TRUE(all.trials[3].force_W.isApprox(force_n, rounding));
  EXPECT_TRUE(all.trials[3].position_W.isApprox(places_m, rounding));
  EXPECT_TRUE(odd_trial_doubts(all.trials).empty());
}

TEST(NamedTrials, AUnitIsOfWhatTheFileWasTakenIn) {
  RecordedMeasurement all = recorded();
  all.told_units["a, b.csv"][static_cast<std::size_t>(Quantity::force)] = 1e-3;
  const Points force_n = all.trials[0].force_W;
  take_trial_units({"trial 1=N"}, {}, all);
  constexpr double rounding = 1e-12;
  EXPECT_TRUE(all.trials[0].force_W.isApprox(1e3 * force_n, rounding));
  for (const char* text : {"trial 1", "trial 1=furlong", "trial 1=", "=N"})
    EXPECT_NE(why_not([&] { take_trial_units({text}, {}, all); }), "taken") << text;
}

TEST(NamedTrials, HaveOneUnitEachAndNoneWhereASensorTellsContactPoints) {
  RecordedMeasurement all = recorded();
  EXPECT_THAT(why_not([&] {
                take_trial_units({"trial 1=mN", "subject 1, trial 1=N"}, {}, all);
              }),
              HasSubstr("a, b.csv, subject 1, trial 1: its forces are given two units"));
  EXPECT_EQ(why_not([&] { take_trial_units({"trial 12=mN", "trial 12=cm"}, {}, all); }), "taken");
  all.trials[2].sensor = ContactSensor{};
  for (const char* text : {"trial 1=mN", "subject 2=cm"})
    EXPECT_THAT(why_not([&] { take_trial_units({text}, {}, all); }), HasSubstr("told from torque over force"))
        << text;
  all.trials[2].force_W *= 1e3;
  EXPECT_THAT(odd_trial_doubts(all.trials), Contains(AllOf(HasSubstr("--leave-out 'subject 2, trial 1'"),
                                                           testing::Not(HasSubstr("--trial-unit")))));
}

TEST(NamedTrials, AreNamedWithTheirFileWhereAnotherHasThem) {
  RecordedMeasurement all = recorded();
  EXPECT_EQ(option_name(all.trials[1], all.trials), "subject 1, trial 12");
  all.trials[3] = all.trials[1];
  all.trials[3].file = "b.csv";
  EXPECT_EQ(option_name(all.trials[3], all.trials), "b.csv, subject 1, trial 12");
}

}  // namespace
}  // namespace fingerpad::named_trials_test
