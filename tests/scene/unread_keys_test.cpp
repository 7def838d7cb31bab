#include "scene/unread_keys.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "friction/law_table.hpp"
#include "scene_text.hpp"

namespace fingerpad::unread_keys_test {
namespace {

using test::plane_scene;
using test::refusal;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string friction(const std::string& lines) {
  return plane_scene + "[friction]\n" + lines + "\n";
}

TEST(UnreadKeys, ANumberOfAnotherLawIsRefusedWithTheLawsThatReadIt) {
  EXPECT_EQ(refusal(friction("law = \"coulomb\"\nstick_stiffness_per_m = 1000")),
            "s.toml:7:1: 'stick_stiffness_per_m' is not read by law \"coulomb\"; it is read by: stick-slip, "
            "finger-pad, contact-area");
  EXPECT_THAT(refusal(friction("zero_band_m_per_s = 1e-3")),
              EndsWith("is not read by law \"finger-pad\"; it is read by: karnopp"));
}

TEST(UnreadKeys, NoLawsNumberPassesUnderALawThatDoesNotReadIt) {
  int refused_numbers = 0;
  for (const LawEntry& owner : law_table()) {
    for (const LawParameter& number : owner.parameters) {
      for (const LawEntry& law : law_table()) {
        const bool reads = std::any_of(law.parameters.begin(), law.parameters.end(),
                                       [&](const LawParameter& own) { return own.key == number.key; });
        const std::string said = refusal(
            friction("law = \"" + std::string(law.name) + "\"\n" + std::string(number.key) + " = 0.5"));
        EXPECT_EQ(said.empty(), reads) << law.name << " " << number.key << ": " << said;
        refused_numbers += reads ? 0 : 1;
      }
    }
  }
  EXPECT_GT(refused_numbers, 100);
}

TEST(UnreadKeys, ADefaultThatIsStatedCountsToo) {
  EXPECT_THAT(refusal(friction("law = \"dahl\"\nv_min_m_per_s = 0.1")),
              HasSubstr("'v_min_m_per_s' is not read by law \"dahl\""));
  EXPECT_THAT(refusal(friction("law = \"none\"\nrestick = \"level\"")),
              EndsWith("'restick' is not read by law \"none\"; it is read by: stick-slip, finger-pad, "
                       "contact-area"));
  EXPECT_THAT(refusal(friction("law = \"lugre\"\nremedy = \"none\"")), HasSubstr("'remedy' is not read"));
}

TEST(UnreadKeys, WhatEveryLawReadsAlwaysPasses) {
  for (const LawEntry& law : law_table())
    EXPECT_EQ(refusal(friction("law = \"" + std::string(law.name) + "\"\nvibration = { amplitude = 0.1 }")),
              "");
}

TEST(UnreadKeys, ASetIsJudgedAsAWhole) {
  const auto set = [](const std::string& lines) {
    return friction("stick_stiffness_per_m = 150\nlaw = \"coulomb\"") + "[[set]]\n" + lines + "\n";
  };
  EXPECT_EQ(refusal(set("friction.law = [\"stick-slip\", \"coulomb\"]")), "");
  EXPECT_EQ(refusal(set("seed = 1\n[[set]]\nfriction.law = \"finger-pad\"")), "");
  EXPECT_THAT(
      refusal(set("friction.law = [\"none\", \"coulomb\"]")),
      StartsWith("s.toml:6:1: 'stick_stiffness_per_m' is not read by law \"none\" or law \"coulomb\";"));
  EXPECT_THAT(refusal(set("friction.law = \"stick-slip\"\nfriction.elastic_share = [0.1, 0.2]")),
              AllOf(StartsWith("s.toml:10:"), EndsWith("it is read by: elasto-plastic")));
}

TEST(UnreadKeys, AJobThatIsRefusedForAnotherReasonStillReadsItsKeys) {
  EXPECT_EQ(refusal(friction("stick_stiffness_per_m = 150") +
                    "[[set]]\nfriction.law = \"stick-slip\"\nplane.mu_static = -1\n"
                    "[[set]]\nfriction.law = \"none\"\n"),
            "");
}

TEST(UnreadKeys, AJobsTextMayHoldWhatOtherJobsOfItsSetRead) {
  const SceneFile file = read_scene_text(
      friction("stick_stiffness_per_m = 150") + "[[set]]\nfriction.law = [\"coulomb\", \"finger-pad\"]\n",
      "s.toml");
  ASSERT_EQ(file.jobs.size(), 2u);
  const std::string& text = file.jobs[0].scene.text;
  EXPECT_THAT(text, HasSubstr("stick_stiffness_per_m = 150"));
  EXPECT_THAT(refusal(text), HasSubstr("is not read by law \"coulomb\""));
  EXPECT_EQ(read_scene_text(text, "s.toml", Unread::passed_over).scene.text, text);
  EXPECT_EQ(read_recorded_scene(text, "", "s.h5").friction.law, "coulomb");
}

TEST(UnreadKeys, TolerancesThatNothingIsChosenByAreRefused) {
  const auto contact = [](const std::string& lines) { return plane_scene + "[contact]\n" + lines + "\n"; };
  EXPECT_EQ(refusal(contact("force_tolerance = 0.1")), "");
  EXPECT_EQ(refusal(contact("method = \"proxy\"\nnormals = \"auto\"\nmu_tolerance = 0.1")), "");
  EXPECT_EQ(
      refusal(contact("method = \"proxy\"\ngreatest_force_n = 5")),
      "s.toml:7:1: 'greatest_force_n' is not read by method \"proxy\" with normals \"smooth\"; it is read "
      "by: auto");
}

}  // namespace
}  // namespace fingerpad::unread_keys_test
