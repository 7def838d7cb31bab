#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.hpp"

namespace fingerpad::key_ranges_test {
namespace {

using test::plane_scene;
using test::refusal;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string part = "[[part]]\nmesh = \"a\"\n";
const std::string sine =
    "[motion]\nkind = \"sine\"\ncentre_m = [0,0,0]\namplitude_m = 1\nfrequency_hz = 1\nduration_s = 1\n";

struct Case {
  std::string lines;  ///< up to the number
  std::string inside, outside;
  std::string message;
};

TEST(KeyRanges, NumbersThatNoFingerHasAreRefusedWithTheirRange) {
  const std::vector<Case> cases = {
      {"stiffness_n_per_m = ", "1e9", "1e300",
       "'stiffness_n_per_m' in [[plane]] is 1e+300; it must be at least 1e-06 and at most 1000000000"},
      {"stiffness_n_per_m = ", "1e-6", "1e-300", "is 1e-300; it must be at least 1e-06"},
      {part + "stiffness_n_per_m = ", "1e9", "1e10", "'stiffness_n_per_m' in [[part]] is 10000000000"},
      {"damping_n_s_per_m = ", "1e9", "1e10", "at most 1000000000"},
      {"mu_static = ", "1000", "1e6", "at least 0 and at most 1000"},
      {part + "crease_deg = ", "180", "181", "at most 180"},
      {"[contact]\nforce_tolerance = ", "1e-9", "1e-300", "at least 1e-09 and at most 1"},
      {"[contact]\nmu_tolerance = ", "1", "1e-300", "at least 1e-09"},
      {"[contact]\ngreatest_force_n = ", "1e-6", "1e-300", "at least 1e-06 and at most 1000000"},
      {"[finger]\nradius_m = ", "1000", "1e300", "at most 1000"},
      {"[friction]\nstick_stiffness_per_m = ", "1e-12", "1e-300", "at least 1e-12 and at most 1000000000000"},
      {"[friction]\nlaw = \"dahl\"\nstick_stiffness_n_per_m = ", "1e12", "1e13", "at most 1000000000000"},
      {"[hand]\nmass_kg = ", "1e3", "1e4",
       "'mass_kg' in [hand] is 10000; it must be at least 1e-06 and at most 1000"},
      {"[hand]\nmass_kg = ", "1e-6", "1e-300", "is 1e-300; it must be at least 1e-06 and at most 1000"},
      {"[hand]\nencoder_m = ", "1", "2", "at least 0 and at most 1"},
      {"[hand]\ncoulomb_n = ", "1e9", "1e300", "at most 1000000000"},
      {sine + "rate_hz = ", "1e6", "1e7", "at least 1 and at most 1000000"},
  };
  for (const Case& c : cases) {
    EXPECT_EQ(refusal(plane_scene + c.lines + c.inside + "\n"), "") << c.lines << c.inside;
    EXPECT_THAT(refusal(plane_scene + c.lines + c.outside + "\n"),
                AllOf(StartsWith("s.toml:"), HasSubstr(c.message)))
        << c.lines << c.outside;
  }
}

TEST(KeyRanges, AScenePastEveryRangeTellsEachOfThem) {
  const std::string circle = "[motion]\nkind = \"circle\"\ncentre_m = [0,0,0]\nradius_m = ";
  const struct {
    std::string lines, message;
  } cases[] = {
      {part + "rotation = { axis = [0,0,1], angle_deg = 1e9 }", "at least -3600 and at most 3600"},
      {"[friction]\nvibration = { frequency_hz = 1e9 }", "at least 0.001 and at most 1000000"},
      {"[friction]\nvibration = { amplitude = 2 }", "at least 0 and at most 1"},
      {"[friction]\nvibration = { normal_amplitude = 2 }", "at least 0 and at most 1"},
      {"[motion]\nkind = \"line\"\nfrom_m = [0,0,0]\nto_m = [1,0,0]\nspeed_m_per_s = 1e-300",
       "at least 1e-09"},
      {"[motion]\nkind = \"sine\"\ncentre_m = [0,0,0]\nfrequency_hz = 1\nduration_s = 1\namplitude_m = 1e300",
       "at least 0 and at most 1000000000"},
      {circle + "1e300\nfrequency_hz = 1\nduration_s = 1", "'radius_m' in [motion] is 1e+300"},
      {circle + "1\nfrequency_hz = 1e300\nduration_s = 1", "'frequency_hz' in [motion] is 1e+300"},
      {circle + "1\nfrequency_hz = 1\nduration_s = 1e300", "'duration_s' in [motion] is 1e+300"},
      {"[hand]\ndamping_n_s_per_m = 1e300", "at least 0 and at most 1000000000"},
      {"[hand]\nstiffness_n_per_m = 1e300", "at least 0 and at most 1000000000"},
      {"[[plane]]\npoint_m = [1e300, 0, 0]\nnormal = [0,0,1]", "it must lie between -1e+09 and 1e+09"},
      {part + "position_m = [1e300, 0, 0]", "it must lie between -1e+09 and 1e+09"},
  };
  for (const auto& c : cases)
    EXPECT_THAT(refusal(plane_scene + c.lines + "\n"), AllOf(StartsWith("s.toml:"), HasSubstr(c.message)))
        << c.lines;
}

TEST(KeyRanges, AVibrationIsSlowestAtAThousandthOfAHertz) {
  EXPECT_EQ(refusal(plane_scene + "[friction]\nvibration = { bandwidth_hz = 1e-3 }\n"), "");
  EXPECT_THAT(
      refusal(plane_scene + "[friction]\nvibration = { bandwidth_hz = 1e-300 }\n"),
      StartsWith(
          "s.toml:6:30: 'bandwidth_hz' in vibration of [friction] is 1e-300; it must be at least 0.001"));
}

TEST(KeyRanges, AMotionOfMoreTicksThanAnyDiskHoldsIsRefusedWithTheirNumber) {
  const std::string long_sine =
      "[motion]\nrate_hz = 1e6\nkind = \"sine\"\ncentre_m = [0,0,0]\namplitude_m = 1\nfrequency_hz = 1\n"
      "duration_s = ";
  EXPECT_EQ(refusal(plane_scene + long_sine + "2147\n"), "");
  EXPECT_THAT(refusal(plane_scene + long_sine + "1e9\n"),
              AllOf(StartsWith("s.toml:11:14: "), HasSubstr("1e+15 ticks"), HasSubstr("at most 2147483648")));
  const std::string line = "[motion]\nkind = \"line\"\nfrom_m = [0,0,0]\nto_m = [1,0,0]\nspeed_m_per_s = ";
  EXPECT_EQ(refusal(plane_scene + line + "1e-6\n"), "");
  EXPECT_THAT(refusal(plane_scene + line + "1e-9\n"),
              AllOf(StartsWith("s.toml:9:17: "), HasSubstr("1e+12 ticks at 1000 Hz")));
}

TEST(KeyRanges, AHandThatIsTooQuickForItsTicksIsRefused) {
  EXPECT_EQ(refusal(plane_scene + "[hand]\nmass_kg = 1e-3\nstiffness_n_per_m = 1e6\n"), "");
  EXPECT_THAT(refusal(plane_scene + "[hand]\nmass_kg = 1e-6\nstiffness_n_per_m = 1e9\n"),
              AllOf(StartsWith("s.toml:5:1: "), HasSubstr("moves too quickly for ticks at 1000 Hz")));
}

}  // namespace
}  // namespace fingerpad::key_ranges_test
