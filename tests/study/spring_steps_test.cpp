#include "study/spring_steps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fingerpad::spring_steps_test {
namespace {

std::string told_of(std::size_t light, std::size_t all) {
  Measurement measurement;
  measurement.trials.emplace_back();
  StickSegments segments;
  segments.light_samples = light;
  segments.phase.resize(all);
  ProfileFit fit;
  tell_light_samples(measurement, {segments}, fit);
  return fit.steps.empty() ? "" : fit.steps.front();
}

TEST(LightSamples, SayWhatTheyAreAndWhereNothingElseIsLeft) {
  using testing::HasSubstr;
  EXPECT_THAT(told_of(3, 10), HasSubstr("3 of 10 in touch are pressed with less than 25 %"));
  EXPECT_THAT(told_of(3, 10), testing::EndsWith("the normal law alone is told by them"));
  EXPECT_THAT(told_of(10, 10), testing::EndsWith("and nothing is left that tells friction"));
}

}  // namespace
}  // namespace fingerpad::spring_steps_test
