#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/file_delays.hpp"
#include "study/fit_told.hpp"
#include "study/profile_text.hpp"
#include "support/pad_measurement.hpp"

namespace fingerpad::fit_told_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST(FitTold, SpeaksOfWhatWasTakenOutWhereSomethingWas) {
  ProfileFit fit;
  fit.delay_left_s = 7e-3;
  EXPECT_THAT(fit_remarks(fit), Not(Contains(HasSubstr("the springs tell")))) << "no more than chance";
  fit.tells_delay_left = true;
  EXPECT_THAT(fit_remarks(fit),
              Contains(HasSubstr("delay: none was taken out, and the springs tell one of 7 ms, which bent")));
  fit.took_delay = true;
  EXPECT_THAT(fit_remarks(fit), Contains(HasSubstr("delay: the springs tell another 7 ms beside what was "
                                                   "taken out, which bent")));
}

TEST(FitTold, AdvisesWhereADelayIsNotTold) {
  FileDelay told{{"a.csv"}, {}}, untold{{"b.csv"}, {}};
  untold.estimate.refusal = "too little stick";
  EXPECT_THAT(delay_text({untold}, {}),
              HasSubstr("cannot be told: too little stick; none was taken out: where "
                        "it is known, give it (--delay 7ms)"));
  EXPECT_THAT(delay_text({told, untold}, {}),
              HasSubstr("; what is told was taken out: where it is known, give"));
  EXPECT_THAT(delay_text({told}, {}), AllOf(HasSubstr("; taken out"), Not(HasSubstr("--delay"))));
  CleaningSettings off;
  off.takes_delay = false;
  EXPECT_THAT(delay_text({untold}, off), Not(HasSubstr("--delay")));
}

TEST(FitTold, DoubtsAFrictionThatNoFingertipHas) {
  const auto told = [](double mu_dynamic, const char* refusal) {
    ProfileFit fit;
    value_of(fit.values, PadNumber::mu_dynamic).value = mu_dynamic;
    value_of(fit.values, PadNumber::mu_dynamic).refusal = refusal;
    return fit_warnings(fit);
  };
  EXPECT_THAT(told(0.024, ""), Contains(HasSubstr("mu_dynamic comes out as 0.024, less than a fingertip's")));
  EXPECT_THAT(told(5.8, ""), Contains(HasSubstr("mu_dynamic comes out as 5.8, more than a fingertip's")));
  for (const double usual : {0.06, 3.5})
    EXPECT_THAT(told(usual, ""), Not(Contains(HasSubstr("mu_dynamic comes"))));
  EXPECT_THAT(told(0.024, "not told"), Not(Contains(HasSubstr("mu_dynamic comes"))));
}

TEST(FitTold, AdvisesWhereNoTareIsTakenAndCallsASwingNotStill) {
  const Measurement pressed = clean(test::known_measurement({{1, 45, 0}, {1, 45, 90}}, {}, {}, 1), {});
  EXPECT_THAT(pressed.steps, Contains(AllOf(HasSubstr("tare: taken off 0 of 2 trials; none has a moment"),
                                            HasSubstr(": record a second in the air in each trial"),
                                            Not(HasSubstr("still")), Not(HasSubstr("at most")))));
  test::KnownSensors air;
  air.air_s = 0.3;
  const Measurement tared = clean(test::known_measurement({{1, 45, 0}, {1, 45, 90}}, {}, air, 1), {});
  EXPECT_THAT(tared.steps, Contains(AllOf(HasSubstr("tare: taken off 2 of 2 trials, at most"),
                                          Not(HasSubstr("in the air")))));
}

}  // namespace
}  // namespace fingerpad::fit_told_test
