#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_text.hpp"

namespace fingerpad::contact_keys_test {
namespace {

using test::plane_scene;
using test::read_scene;
using test::refusal;
using testing::HasSubstr;
using testing::StartsWith;

TEST(SceneContact, DefaultsAreTheDocumentedOnes) {
  const ContactSettings contact = read_scene(plane_scene).contact;
  EXPECT_EQ(contact.method, automatic_method);
  EXPECT_EQ(contact.normals, Normals::smooth);
  EXPECT_FALSE(contact.automatic_normals);
  EXPECT_EQ(contact.force_tolerance, 0.03);
  EXPECT_EQ(contact.mu_tolerance, 0.1);
  EXPECT_EQ(contact.greatest_force_n, 10);
}

TEST(SceneContact, EveryKeyIsReadAndWrittenIntoTheScenesText) {
  const std::string text = plane_scene +
                           "[contact]\nmethod = \"auto\"\nnormals = \"auto\"\nforce_tolerance = 0.05\n"
                           "mu_tolerance = 1\ngreatest_force_n = 2.5\n";
  const Scene scene = read_scene(text);
  EXPECT_TRUE(scene.contact.automatic_normals);
  EXPECT_EQ(scene.contact.force_tolerance, 0.05);
  EXPECT_EQ(scene.contact.mu_tolerance, 1);
  EXPECT_EQ(scene.contact.greatest_force_n, 2.5);
  EXPECT_EQ(read_scene(scene.text).contact.greatest_force_n, 2.5);
  EXPECT_EQ(read_scene(plane_scene + "[contact]\nnormals = \"curved\"\n").contact.normals, Normals::curved);
}

TEST(SceneContact, TolerancesCanBeSetKeyByKeyInASet) {
  const SceneFile file = read_scene_text(
      plane_scene + "[[set]]\ncontact.force_tolerance = [0.01, 0.5]\ncontact.normals = [\"auto\"]\n",
      "s.toml");
  ASSERT_EQ(file.jobs.size(), 2u);
  EXPECT_EQ(file.jobs[0].scene.contact.force_tolerance, 0.01);
  EXPECT_EQ(file.jobs[1].scene.contact.force_tolerance, 0.5);
  EXPECT_TRUE(file.jobs[1].scene.contact.automatic_normals);
}

TEST(SceneContact, RefusesWhatIsOutOfRangeWithLineAndColumn) {
  const auto with = [](const std::string& line) { return plane_scene + "[contact]\n" + line + "\n"; };
  EXPECT_THAT(refusal(with("force_tolerance = 0")),
              StartsWith("s.toml:6:19: 'force_tolerance' in [contact]"));
  EXPECT_THAT(refusal(with("force_tolerance = 1.5")), StartsWith("s.toml:6:19: "));
  EXPECT_THAT(refusal(with("mu_tolerance = \"low\"")), StartsWith("s.toml:6:16: "));
  EXPECT_THAT(refusal(with("mu_tolerance = -0.1")), StartsWith("s.toml:6:16: "));
  EXPECT_THAT(refusal(with("greatest_force_n = 0")), StartsWith("s.toml:6:20: "));
  EXPECT_THAT(refusal(with("greatest_force_n = nan")), StartsWith("s.toml:6:20: "));
  EXPECT_THAT(refusal(with("normals = \"automatic\"")),
              AllOf(StartsWith("s.toml:6:11: "), HasSubstr("auto")));
  EXPECT_THAT(refusal(with("greatest_force = 3")),
              AllOf(StartsWith("s.toml:6:1: "), HasSubstr("greatest_force_n")));
}

}  // namespace
}  // namespace fingerpad::contact_keys_test
