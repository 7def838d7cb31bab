#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/error.hpp"
#include "scene/pad_profile_file.hpp"
#include "support/paths.hpp"

namespace fingerpad::pad_profile_file_test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string written(const std::string& text) {
  std::string path = (test::scratch_dir() / "pad.toml").string();
  std::ofstream(path) << text;
  return path;
}

/// The message of the Error that reading `text` throws, without the folder.
std::string refusal_of(const std::string& text) {
  try {
    read_profile(written(text));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    const std::string what = error.what();
    const auto name = what.find("pad.toml");
    return name == std::string::npos ? what : what.substr(name);
  }
  return "accepted";
}

const std::string axes = "lateral_axis_m = 0.002\nlongitudinal_axis_m = 0.0016\n";

TEST(PadProfile, ReadsEveryKey) {
  const PadProfile pad = read_profile(
      written(axes + "lateral_slope_per_deg = 0.005\nlongitudinal_slope_per_deg = -0.01\nmu_static = 1\n"
                     "v_min_m_per_s = 0.05\nvibration_hz = 120.5\nsource = 'measured'\n"));
  EXPECT_EQ(pad.lateral_axis_m, 0.002);
  EXPECT_EQ(pad.longitudinal_axis_m, 0.0016);
  EXPECT_EQ(pad.lateral_slope_per_deg, 0.005);
  EXPECT_EQ(pad.longitudinal_slope_per_deg, -0.01);
  EXPECT_EQ(pad.mu_static, 1);
  EXPECT_EQ(pad.v_min_m_per_s, 0.05);
  EXPECT_EQ(pad.vibration_hz, 120.5);
  EXPECT_EQ(pad.source, "measured");
}

TEST(PadProfile, WhatIsNotWrittenHasTheDocumentedDefault) {
  const PadProfile pad = read_profile(written(axes));
  EXPECT_EQ(pad.lateral_slope_per_deg, 0.01);
  EXPECT_EQ(pad.longitudinal_slope_per_deg, 0.01);
  EXPECT_EQ(pad.mu_static, 0.3);
  EXPECT_EQ(pad.v_min_m_per_s, 0.1);
  EXPECT_EQ(pad.vibration_hz, 89);
}

TEST(PadProfile, RefusesWithThePlaceOfTheFault) {
  EXPECT_THAT(refusal_of(axes + "colour = 3\n"), StartsWith("pad.toml:3:1: unknown key 'colour'"));
  EXPECT_THAT(refusal_of("lateral_axis_m = '2 mm'\n"),
              StartsWith("pad.toml:1:18: lateral_axis_m must be a number"));
  EXPECT_THAT(refusal_of(axes + "mu_static = inf\n"), StartsWith("pad.toml:3:13: mu_static must be finite"));
  EXPECT_THAT(refusal_of(axes + "mu_static = 0\n"), HasSubstr("must be larger than 0"));
  EXPECT_THAT(refusal_of(axes + "source = 1\n"), StartsWith("pad.toml:3:10: source must be a text"));
  EXPECT_THAT(refusal_of("lateral_axis_m = 0.002\n"), EndsWith("longitudinal_axis_m is missing"));
  EXPECT_THAT(refusal_of("lateral_axis_m = = 1\n"), StartsWith("pad.toml:1:1"));
  EXPECT_THAT(refusal_of("[[x]]\n"), HasSubstr("unknown key 'x'"));
}

TEST(PadProfile, TakesWhatAFitSaysBesides) {
  EXPECT_EQ(refusal_of(axes + "mu_dynamic = 0.2\nstick_stiffness_per_m = 150\n[interval]\nmu_static = [0.2, "
                              "0.4]\n[samples]\n[refused]\nvibration_hz = 'no slip'\n"),
            "accepted");
  EXPECT_THAT(refusal_of(axes + "interval = 1\n"), StartsWith("pad.toml:3:12: interval must be a table"));
  EXPECT_THAT(refusal_of(axes + "mu_dynamic = 0\n"), HasSubstr("must be larger than 0"));
  EXPECT_THAT(refusal_of("[refused]\nlateral_axis_m = 'no stick'\n"),
              EndsWith("lateral_axis_m is missing: its fit says 'no stick'"));
}

TEST(PadProfile, RefusesNumbersThatNoFingerHas) {
  EXPECT_THAT(
      refusal_of("lateral_axis_m = 1e-300\nlongitudinal_axis_m = 1\n"),
      StartsWith(
          "pad.toml:1:18: lateral_axis_m is 1e-300; it must be at least 1e-12 and at most 1000000000000"));
  EXPECT_THAT(refusal_of(axes + "mu_static = 1e300\n"), HasSubstr("mu_static is 1e+300; it must be"));
}

TEST(PadProfile, RefusesAxesThatVanishForSomeAngle) {
  EXPECT_THAT(refusal_of(axes + "lateral_slope_per_deg = 0.0223\n"), HasSubstr("vanish"));
  EXPECT_THAT(refusal_of(axes + "longitudinal_slope_per_deg = -0.0223\n"),
              StartsWith("pad.toml:3:30: longitudinal_slope_per_deg"));
  EXPECT_EQ(refusal_of(axes + "lateral_slope_per_deg = 0.0222\n"), "accepted");
}

TEST(PadProfile, RefusesWhatIsNoProfileAtAll) {
  EXPECT_THROW(read_profile((test::scratch_dir() / "absent.toml").string()), Error);
  EXPECT_THROW(read_profile(test::scratch_dir().string()), Error);
  EXPECT_THAT(refusal_of(std::string(2 << 20, ' ')), HasSubstr("1 MiB"));
  EXPECT_THAT(refusal_of(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)), StartsWith("pad.toml:1:1"));
  EXPECT_THAT(refusal_of(std::string(100000, '[')), StartsWith("pad.toml:1:"));
}

}  // namespace
}  // namespace fingerpad::pad_profile_file_test
