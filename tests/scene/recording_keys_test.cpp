#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.hpp"

namespace fingerpad::recording_keys_test {
namespace {

using test::plane_scene;
using test::refusal;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string motion(const std::string& lines) {
  return plane_scene + "[motion]\nfile = \"m.csv\"\n" + lines + "\n";
}

TEST(RecordingKeys, SayHowAFileIsRead) {
  const MotionSettings settings =
      test::read_scene(motion("columns = { t = \"time\", x = \"X\", fn = \"Fz\" }\nunit = \"mm\"\n"
                              "time_unit = \"us\"\nforce_unit = \"mN\"\nseparator = \";\"\ndecimal = "
                              "\",\"\nencoder_m = 1e-4\n"
                              "smoothing_hz = 20\nnormal_force = \"measured\""))
          .motion;
  EXPECT_EQ(settings.format.headers[0], "time");
  EXPECT_EQ(settings.format.headers[1], "X");
  EXPECT_EQ(settings.format.headers[2], "");
  EXPECT_EQ(settings.format.headers.back(), "Fz");
  EXPECT_EQ(settings.format.metres_per_unit, 1e-3);
  EXPECT_EQ(settings.format.seconds_per_unit, 1e-6);
  EXPECT_EQ(settings.format.newtons_per_unit, 1e-3);
  EXPECT_TRUE(settings.format.says_force_unit);
  EXPECT_EQ(settings.format.dialect.separator, ';');
  EXPECT_EQ(settings.format.dialect.decimal, ',');
  EXPECT_EQ(settings.encoder_m, 1e-4);
  EXPECT_EQ(settings.smoothing_hz, 20);
  EXPECT_TRUE(settings.format.reads_normal_force);
  EXPECT_EQ(settings.table_key, "columns");
}

TEST(RecordingKeys, AreTheProgramsOwnFormWhereNotWritten) {
  const MotionSettings settings = test::read_scene(motion("")).motion;
  EXPECT_EQ(settings.format.metres_per_unit, 1);
  EXPECT_EQ(settings.format.seconds_per_unit, 1);
  EXPECT_EQ(settings.format.newtons_per_unit, 1);
  EXPECT_FALSE(settings.format.says_force_unit);
  EXPECT_EQ(settings.format.dialect.separator, found_separator);
  EXPECT_FALSE(settings.format.reads_normal_force);
  EXPECT_EQ(settings.table_key, "");
}

TEST(RecordingKeys, TellAnOwnRateFromAWrittenOne) {
  EXPECT_TRUE(test::read_scene(motion("")).motion.has_own_rate());
  EXPECT_FALSE(test::read_scene(motion("rate_hz = 1000")).motion.has_own_rate());
  const MotionSettings sine =
      test::read_scene(plane_scene +
                       "[motion]\nkind = \"sine\"\ncentre_m = [0,0,0]\namplitude_m = 1\nfrequency_hz = 1\n"
                       "duration_s = 1\n")
          .motion;
  EXPECT_FALSE(sine.has_own_rate());
  EXPECT_EQ(sine.rate_hz, 1000);
  // 2e9 turns a tick at 1 Hz: asked of a recording's own rate once that is known.
  EXPECT_EQ(refusal(motion("[hand]\nmass_kg = 1e-6\nstiffness_n_per_m = 1e9")), "");
  EXPECT_THAT(refusal(motion("rate_hz = 1000\n[hand]\nmass_kg = 1e-6\nstiffness_n_per_m = 1e9")),
              HasSubstr("moves too quickly"));
}

TEST(RecordingKeys, AreRefusedAtTheirPlaceWithWhatTheyMayBe) {
  const struct {
    std::string lines, message;
  } cases[] = {
      {"columns = { time = \"T\" }", "s.toml:7:13: unknown key 'time' in columns of [motion]"},
      {"columns = { t = 1 }", "'t' in columns of [motion] must be a string"},
      {"columns = { t = \"\" }", "'t' in columns of [motion] is empty"},
      {"columns = { t = \" T\" }", "has blanks around it"},
      {"columns = { x = \"P\", z = \"P\" }", "'z' in columns of [motion] and 'x' are both the column 'P'"},
      {"columns = \"X\"", "s.toml:7:11: 'columns' in [motion] must be a table such as { t = \"time\""},
      {"unit = \"ft\"", "unknown unit 'ft'"},
      {"time_unit = \"h\"", "(known: s, ms, us, ns, min)"},
      {"force_unit = \"dyn\"", "(known: N, mN, kN, gf, kgf, cN, lbf)"},
      {"separator = \"|\"", "s.toml:7:13: 'separator' in [motion] must be \"auto\", \",\", \";\", \"tab\""},
      {"decimal = \"'\"", "'decimal' in [motion] must be"},
      {"separator = \",\"\ndecimal = \",\"",
       "s.toml:7:13: 'separator' in [motion] and 'decimal' are both ','"},
      {"encoder_m = -1", "at least 0 and at most 1"},
      {"smoothing_hz = 1e7", "at least 0 and at most 1000000"},
      {"normal_force = \"sensor\"", "(known: model, measured)"},
  };
  for (const auto& c : cases) EXPECT_THAT(refusal(motion(c.lines)), HasSubstr(c.message)) << c.lines;
  for (const char* mark : {"auto", ",", ";", "tab", "\\t", "space", " "})
    EXPECT_EQ(refusal(motion(std::string("separator = \"") + mark + "\"")), "") << mark;
}

TEST(RecordingKeys, DoNotGoWithAFormula) {
  const std::string sine =
      plane_scene +
      "[motion]\nkind = \"sine\"\ncentre_m = [0,0,0]\namplitude_m = 1\nfrequency_hz = 1\nduration_s = 1\n";
  for (const char* key : {"unit = \"mm\"", "force_unit = \"mN\"", "columns = { t = \"T\" }",
                          "smoothing_hz = 5", "encoder_m = 0"}) {
    EXPECT_THAT(
        refusal(sine + key + "\n"),
        AllOf(StartsWith("s.toml:11:"), EndsWith("goes with 'file', and the motion is made from its 'kind'")))
        << key;
  }
}

TEST(RecordingKeys, OfTheFingerItselfDoNotGoWithAHand) {
  EXPECT_THAT(refusal(motion("normal_force = \"measured\"\n[hand]")),
              AllOf(StartsWith("s.toml:7:16: "), HasSubstr("in a scene with a [hand]")));
  EXPECT_THAT(refusal(motion("encoder_m = 1e-4\n[hand]")),
              AllOf(StartsWith("s.toml:7:13: "), HasSubstr("say encoder_m there")));
  EXPECT_EQ(refusal(motion("smoothing_hz = 5\nnormal_force = \"model\"\nencoder_m = 0\n[hand]")), "");
}

TEST(RecordingKeys, StandBesideASetsFilesAndGoWithASetsKind) {
  const std::string set =
      plane_scene +
      "[motion]\nunit = \"mm\"\nsmoothing_hz = 5\n[[set]]\nmotion.file = [\"a.csv\", \"b.csv\"]\n"
      "motion.columns.t = [\"T\", \"U\"]\n";
  const SceneFile file = read_scene_text(set, "s.toml");
  ASSERT_EQ(file.jobs.size(), 4u);
  EXPECT_EQ(file.jobs[3].error, "");
  EXPECT_EQ(file.jobs[3].scene.motion.file, "b.csv");
  EXPECT_EQ(file.jobs[3].scene.motion.format.headers[0], "U");
  EXPECT_EQ(file.jobs[3].scene.motion.format.metres_per_unit, 1e-3);
  const std::string& text = file.jobs[3].scene.text;
  EXPECT_EQ(test::read_scene(text).motion.format.headers[0], "U") << text;

  const SceneFile kinds = read_scene_text(
      motion("unit = \"mm\"") +
          "[[set]]\nmotion.kind = \"sine\"\nmotion.centre_m = [0,0,0]\nmotion.amplitude_m = 1\n"
          "motion.frequency_hz = 1\nmotion.duration_s = 1\n",
      "s.toml");
  EXPECT_EQ(kinds.jobs[0].error, "");
}

}  // namespace
}  // namespace fingerpad::recording_keys_test
