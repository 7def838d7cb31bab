#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.hpp"
#include "support/paths.hpp"

namespace fingerpad::set_test {
namespace {

using test::plane_scene;
using test::refusal;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Each job's values as one text: "a b c".
std::vector<std::string> jobs_of(const SceneFile& file) {
  std::vector<std::string> jobs;
  for (const SceneJob& job : file.jobs) {
    std::string text;
    for (const auto& [key, value] : job.set_keys) text += (text.empty() ? "" : " ") + value;
    jobs.push_back(text);
  }
  return jobs;
}

std::vector<std::string> jobs_of(const std::string& text) {
  return jobs_of(read_scene_text(text, "s.toml"));
}

TEST(SceneSet, TheLastKeyVariesFastest) {
  EXPECT_THAT(jobs_of(plane_scene + "[[set]]\nseed = [3, 1]\nfriction.law = [\"stick-slip\", \"coulomb\"]\n"),
              ElementsAre("3 stick-slip", "3 coulomb", "1 stick-slip", "1 coulomb"));
}

TEST(SceneSet, KeysKeepTheOrderWrittenWhateverTheirAlphabet) {
  EXPECT_THAT(
      jobs_of(plane_scene + "[[set]]\nmotion = [\"b\", \"a\"]\nfriction.restick = [\"level\"]\n"
                            "contact.normals = [\"smooth\", \"facet\"]\nfriction.law = \"stick-slip\"\n"),
      ElementsAre("b level smooth stick-slip", "b level facet stick-slip", "a level smooth stick-slip",
                  "a level facet stick-slip"));
}

TEST(SceneSet, KeysMayBeDottedQuotedOrTables) {
  const auto dotted =
      jobs_of(plane_scene + "[[set]]\nfriction.law = [\"none\", \"coulomb\"]\nseed = [1, 2]\n");
  EXPECT_EQ(jobs_of(plane_scene + "[[set]]\n\"friction.law\" = [\"none\", \"coulomb\"]\nseed = [1, 2]\n"),
            dotted);
  EXPECT_EQ(jobs_of(plane_scene + "[[set]]\nfriction = { law = [\"none\", \"coulomb\"] }\nseed = [1, 2]\n"),
            dotted);
  EXPECT_THAT(jobs_of(plane_scene + "[[set]]\nseed = 1\n[set.friction]\nlaw = [\"none\", \"coulomb\"]\n"),
              ElementsAre("1 none", "1 coulomb"));
}

TEST(SceneSet, EntriesFollowOneAnotherAndJobsCountFromOne) {
  const SceneFile file =
      read_scene_text(plane_scene + "[[set]]\nseed = [1, 2]\n[[set]]\nfriction.law = \"none\"\n", "s.toml");
  EXPECT_TRUE(file.is_set);
  EXPECT_THAT(jobs_of(file), ElementsAre("1", "2", "none"));
  EXPECT_EQ(file.jobs[0].number, 1);
  EXPECT_EQ(file.jobs[2].number, 3);
  EXPECT_EQ(file.jobs[2].set_keys[0].first, "friction.law");
  EXPECT_EQ(file.jobs[2].scene.friction.law, "none");
  EXPECT_EQ(file.jobs[2].scene.name, "plane");
  EXPECT_EQ(file.jobs[1].scene.seed, 2u);
}

TEST(SceneSet, NumbersAreToldAsWritten) {
  EXPECT_THAT(jobs_of(plane_scene + "[[set]]\nmotion.rate_hz = [1e3, 5_00, 250.0]\n"),
              ElementsAre("1e3", "5_00", "250.0"));
}

TEST(SceneSet, EveryKindOfKeyReachesItsPlace) {
  const SceneFile file = read_scene_text(
      plane_scene +
          "[[part]]\nmesh = \"a\"\n[[part]]\nmesh = \"b\"\n[[set]]\nmesh = \"c\"\nfinger.radius_m = 0.001\n"
          "hand.mass_kg = 0.2\npart.stiffness_n_per_m = 5\nplane.mu_static = 0.9\npart.rotation.axis = [1, "
          "0, 0]\n"
          "part.rotation.angle_deg = 10\nfriction.vibration.amplitude = 0.5\nmotion.file = \"m.csv\"\n",
      "d/s.toml");
  ASSERT_EQ(file.jobs.size(), 1u);
  ASSERT_EQ(file.jobs[0].error, "");
  const Scene& s = file.jobs[0].scene;
  EXPECT_EQ(s.parts[0].mesh_path, "d/c");
  EXPECT_EQ(s.parts[1].mesh, "b");
  EXPECT_EQ(s.finger.radius_m, 0.001);
  EXPECT_EQ(s.hand->mass_kg, 0.2);
  EXPECT_EQ(s.parts[0].surface.stiffness_n_per_m, 5);
  EXPECT_EQ(s.parts[1].surface.stiffness_n_per_m, 1000);
  EXPECT_EQ(s.planes[0].surface.mu_static, 0.9);
  EXPECT_NE(s.parts[0].rotation, Mat3(Mat3::Identity()));
  EXPECT_EQ(s.friction.vibration->amplitude, 0.5);
  EXPECT_EQ(s.motion.file_path, "d/m.csv");
}

TEST(SceneSet, VectorsInAListAreListsOfLists) {
  EXPECT_THAT(jobs_of(plane_scene + "[[set]]\nfinger.direction = [[0, 1, 0], [0, 0, -1]]\n"),
              ElementsAre("[0, 1, 0]", "[0, 0, -1]"));
  const SceneFile one = read_scene_text(plane_scene + "[[set]]\nfinger.direction = [1, 0, 0]\n", "s.toml");
  ASSERT_EQ(one.jobs.size(), 1u);
  EXPECT_EQ(one.jobs[0].scene.finger.direction, Vec3(Vec3::UnitX()));
}

TEST(SceneSet, GlobsAreSortedByNameAndStayRelative) {
  const auto folder = test::scratch_dir();
  for (const char* name : {"p/b.stl", "p/a.stl", "p/B.stl", "p/c.obj", "p/d.stl/x"})
    test::write_file(folder / name, "");
  const std::string text = "[[set]]\nmesh = [\"p/*.stl\", \"other.stl\"]\n";
  const SceneFile file = read_scene_text(text, (folder / "s.toml").string());
  EXPECT_THAT(jobs_of(file), ElementsAre("p/B.stl", "p/a.stl", "p/b.stl", "other.stl"));
  EXPECT_EQ(file.jobs[1].scene.parts[0].mesh_path, (folder / "p/a.stl").string());
  EXPECT_EQ(file.jobs[1].scene.text.find(folder.string()), std::string::npos);

  const SceneFile absolute =
      read_scene_text("[[set]]\nmesh = \"" + (folder / "p/?.obj").string() + "\"\n", "s.toml");
  EXPECT_THAT(jobs_of(absolute), ElementsAre((folder / "p/c.obj").string()));
}

TEST(SceneSet, GlobsWorkInFoldersWithGlobCharacters) {
  const auto folder = test::scratch_dir() / "[x]*";
  test::write_file(folder / "a.stl", "");
  EXPECT_THAT(jobs_of(read_scene_text("[[set]]\nmesh = \"*.stl\"\n", (folder / "s.toml").string())),
              ElementsAre("a.stl"));
}

TEST(SceneSet, AJobsTextGivesTheSameJobAgain) {
  const std::string text =
      "name = \"q \\\" ü\"\n" + plane_scene.substr(plane_scene.find('\n') + 1) +
      "[[part]]\nmesh = \"a\"\nposition_m = [1e-7, 2, 3.5]\nrotation = { axis = [0,0,1], angle_deg = 30 }\n"
      "[motion]\nkind = \"line\"\nfrom_m = [0,0,0]\nto_m = [1,0,0]\nspeed_m_per_s = 0.1\n"
      "[[set]]\nmesh = [\"b\", \"c\"]\nfriction.vibration = [false, { amplitude = 0.01 }]\nseed = [5]\n"
      "[[set]]\nmotion = \"m.csv\"\npart.rotation.angle_deg = [1, 2]\n";
  const SceneFile file = read_scene_text(text, "d/s.toml");
  ASSERT_EQ(file.jobs.size(), 6u);
  for (const SceneJob& job : file.jobs) {
    ASSERT_EQ(job.error, "");
    const SceneFile again = read_scene_text(job.scene.text, "d/s.toml");
    EXPECT_FALSE(again.is_set);
    EXPECT_EQ(again.scene.text, job.scene.text);
    EXPECT_EQ(again.scene.name, "q \" ü");
    EXPECT_EQ(again.scene.seed, job.scene.seed);
    EXPECT_EQ(again.scene.parts[0].mesh_path, job.scene.parts[0].mesh_path);
    EXPECT_EQ(again.scene.parts[0].position_m, Vec3(1e-7, 2, 3.5));
    EXPECT_EQ(again.scene.parts[0].rotation, job.scene.parts[0].rotation);
    EXPECT_EQ(again.scene.motion.file_path, job.scene.motion.file_path);
    EXPECT_EQ(again.scene.motion.scripted.has_value(), job.scene.motion.scripted.has_value());
    EXPECT_EQ(again.scene.friction.vibration.has_value(), job.scene.friction.vibration.has_value());
  }
  EXPECT_EQ(file.jobs[1].scene.friction.vibration->amplitude, 0.01);
  EXPECT_EQ(file.jobs[4].scene.motion.file, "m.csv");  // the file drove the scripted motion out
}

TEST(SceneSet, AJobsTextKeepsTheOrderOfTheFile) {
  const SceneFile file = read_scene_text(
      "seed = 2\nname = \"n\"\n[motion]\nrate_hz = 500\nfile = \"m\"\n[[plane]]\npoint_m = [0, 0, "
      "1e-30]\nnormal = "
      "[0, 0, 1]\n[[set]]\nfriction.law = \"none\"\nseed = 3\n",
      "s.toml");
  EXPECT_EQ(file.jobs[0].scene.text,
            "seed = 3\nname = \"n\"\n\n[motion]\nrate_hz = 500\nfile = \"m\"\n\n[[plane]]\npoint_m = [0, 0, "
            "1e-30]\n"
            "normal = [0, 0, 1]\n\n[friction]\nlaw = \"none\"\n");
}

TEST(SceneSet, AValueOutOfRangeFailsItsJobAlone) {
  const SceneFile file =
      read_scene_text(plane_scene + "[[set]]\nplane.mu_static = [0.3,\n  0.1, 0.5]\n", "s.toml");
  ASSERT_EQ(file.jobs.size(), 3u);
  EXPECT_EQ(file.jobs[0].error, "");
  EXPECT_THAT(file.jobs[1].error, StartsWith("s.toml:7:3: mu_dynamic 0.2 is above mu_static 0.1"));
  EXPECT_EQ(file.jobs[1].scene.name, "plane");
  EXPECT_EQ(file.jobs[1].number, 2);
  EXPECT_EQ(file.jobs[2].error, "");
}

TEST(SceneSet, AnUnknownKeyRefusesTheWholeFileAtItsLine) {
  EXPECT_THAT(refusal(plane_scene + "[[set]]\nfriction.lw = [\"none\"]\n"),
              StartsWith("s.toml:6:10: unknown key 'friction.lw' in [[set]]; did you mean 'friction.law'?"));
  EXPECT_THAT(refusal(plane_scene + "[[set]]\nmotion.turs = 1\n"),
              HasSubstr("; did you mean 'motion.turns'?"));
  EXPECT_THAT(refusal(plane_scene + "[[set]]\nmotion.bogus = 1\n"), Not(HasSubstr("did you mean")))
      << "a table's name says nothing";
  EXPECT_THAT(refusal(plane_scene + "[[set]]\nfrction.law = 1\n"),
              HasSubstr("; did you mean 'friction.law'?"));
  EXPECT_THAT(refusal(plane_scene + "[[set]]\nname = [\"a\"]\n"),
              StartsWith("s.toml:6:1: unknown key 'name'"));
  EXPECT_THAT(refusal(plane_scene + "[[set]]\ncolour = 1\n"), StartsWith("s.toml:6:1: unknown key 'colour'"));
  EXPECT_THAT(refusal(plane_scene + "[set]\nseed = 1\n"), HasSubstr("write it as [[set]]"));
}

TEST(SceneSet, WhatGivesNoJobsIsRefused) {
  EXPECT_THAT(refusal(plane_scene + "[[set]]\nseed = []\n"), StartsWith("s.toml:6:1: "));
  EXPECT_THAT(refusal(plane_scene + "[[set]]\nmesh = \"none/*.stl\"\n"),
              StartsWith("s.toml:6:8: no file matches 'none/*.stl'"));
  EXPECT_THAT(refusal(plane_scene + "[[set]]\nmesh = \"a\"\npart.mesh = \"b\"\n"), HasSubstr("the same key"));
}

TEST(SceneSet, AProductTooLargeToHoldIsRefused) {
  std::string text = plane_scene + "[[set]]\n";
  for (const char* key : {"seed", "motion.rate_hz", "plane.stiffness_n_per_m", "finger.radius_m"}) {
    text += std::string(key) + " = [1";
    for (int i = 2; i <= 100; ++i) text += ", " + std::to_string(i);
    text += "]\n";
  }
  EXPECT_THAT(refusal(text), StartsWith("s.toml: the set has over 100000 jobs"));
}

TEST(SceneSet, ASetMayGiveTheMeshThatThePartLacks) {
  EXPECT_THAT(jobs_of("[[part]]\nunit = \"m\"\n[[set]]\nmesh = [\"a\", \"b\"]\n"), ElementsAre("a", "b"));
  EXPECT_THAT(refusal("[[part]]\nunit = \"m\"\n[[set]]\nseed = 1\n"),
              StartsWith("s.toml:1:1: [[part]] needs"));
}

TEST(SceneSet, AKeyOfATableThatTheSceneHasNotIsRefusedOnceWithWhatIsWrong) {
  EXPECT_EQ(refusal(plane_scene + "[[set]]\nseed = [1, 2]\npart.mu_static = [0.3, 0.4]\n"),
            "s.toml:" + std::to_string(1 + std::count(plane_scene.begin(), plane_scene.end(), '\n') + 2) +
                ":6: 'part.mu_static' in [[set]] is of the first [[part]], and the scene has none");
  EXPECT_THAT(refusal("[[part]]\nmesh = \"a\"\n[[set]]\nplane.point_m = [0, 0, 1]\n"),
              HasSubstr("'plane.point_m' in [[set]] is of the first [[plane]], and the scene has none"));
  // What makes the table by itself does.
  EXPECT_THAT(jobs_of(plane_scene + "[[set]]\nmesh = [\"a\", \"b\"]\npart.mu_static = 0.4\n"),
              ElementsAre("a 0.4", "b 0.4"));
  EXPECT_EQ(jobs_of("[[part]]\nmesh = \"a\"\n[[set]]\nplane.point_m = [0, 0, 1]\nplane.normal = [0, 0, 1]\n")
                .size(),
            1u);
}

TEST(SceneSet, ARangeOfAKeyThatTakesWholeNumbersGivesThese) {
  const auto told = [](const std::string& range) {
    return refusal(plane_scene + "[[set]]\nseed = " + range + "\n");
  };
  EXPECT_THAT(told("{ from = 1, to = 4, steps = 3 }"),
              HasSubstr("'seed' in [[set]] takes whole numbers, and 2.5 is none of them"));
  EXPECT_THAT(told("{ values = [1, 2.5] }"), HasSubstr("takes whole numbers, and 2.5 is none"));
  EXPECT_THAT(refusal(plane_scene + "[[set]]\nhand.delay_ticks = { from = 0, to = 1, steps = 3 }\n"),
              HasSubstr("'hand.delay_ticks' in [[set]] takes whole numbers, and 0.5 is none of them"));
  EXPECT_THAT(jobs_of(plane_scene + "[[set]]\nseed = { from = 1.0, to = 3.0, steps = 3 }\n"),
              ElementsAre("1", "2", "3"));
}

TEST(SceneSet, AListOfAKeyThatTakesWholeNumbersIsRefusedOnce) {
  EXPECT_EQ(
      refusal("[[set]]\nseed = [1.5, 2]\n"),
      "s.toml:2:9: 'seed' in [[set]] takes whole numbers, and 1.5 is none of them; give such from 0 on");
  EXPECT_EQ(
      refusal("[[set]]\nhand.delay_ticks = 0.5\n"),
      "s.toml:2:20: 'hand.delay_ticks' in [[set]] takes whole numbers, and 0.5 is none of them; give such "
      "from 0 to 10000");
  EXPECT_EQ(refusal("seed = 1.5\n" + plane_scene),
            "s.toml:1:8: 'seed' in the scene must be a whole number, and 1.5 is none");
}

TEST(SceneSet, AMisspeltWordOfAListIsRefusedOnceWithTheOneThatItIsLike) {
  const auto told = [](const std::string& line) { return refusal(plane_scene + "[[set]]\n" + line + "\n"); };
  EXPECT_THAT(told(R"(friction.law = ["dahl", "coulmb"])"),
              testing::AllOf(
                  HasSubstr(":25: unknown law 'coulmb' in [[set]]; did you mean 'coulomb'? (known: none, "),
                  HasSubstr("kikuuwe")));
  EXPECT_THAT(told(R"(contact.method = ["proxi"])"),
              HasSubstr("unknown method 'proxi' in [[set]]; did you mean 'proxy'?"));
  EXPECT_THAT(told(R"(contact.normals = { values = ["smooth", "smoth"] })"),
              HasSubstr("did you mean 'smooth'?"));
  EXPECT_THAT(told(R"(friction.events = "ticks")"), HasSubstr("did you mean 'tick'?"));
  EXPECT_EQ(jobs_of(plane_scene + "[[set]]\nfriction.law = [3]\n").size(), 1u)
      << "no word at all: as in a plain scene";
}

TEST(SceneSet, ARangeIsItsEvenValuesAndAListMayBeNamedSo) {
  EXPECT_THAT(jobs_of(plane_scene + "[[set]]\nplane.mu_static = { from = 0.2, to = 0.5, steps = 4 }\n"),
              ElementsAre("0.2", "0.3", "0.4", "0.5"));
  EXPECT_THAT(jobs_of(plane_scene + "[[set]]\nseed = { from = 1, to = 5, steps = 3 }\n"),
              ElementsAre("1", "3", "5"));
  EXPECT_THAT(jobs_of(plane_scene + "[[set]]\nmotion.rate_hz = { values = [500, 1000] }\n"),
              ElementsAre("500", "1000"));
  const SceneFile file = read_scene_text(
      plane_scene + "[[set]]\nplane.mu_static = { from = 0.5, to = 0.2, steps = 4 }\n", "s.toml");
  EXPECT_EQ(file.jobs[2].scene.planes[0].surface.mu_static, 0.3) << "and not 0.30000000000000004";
}

TEST(SceneSet, ZippedListsGoSideBySide) {
  EXPECT_THAT(jobs_of(plane_scene + "[[set]]\nzip = true\nseed = [1, 2, 3]\nmotion.rate_hz = 700\n"
                                    "plane.mu_static = { from = 0.2, to = 0.4, steps = 3 }\n"),
              ElementsAre("1 700 0.2", "2 700 0.3", "3 700 0.4"));
  EXPECT_THAT(refusal(plane_scene + "[[set]]\nzip = true\nseed = [1, 2, 3]\nmotion.rate_hz = [700, 800]\n"),
              HasSubstr("the lists go side by side, but 'seed' has 3 values and 'motion.rate_hz' 2"));
  EXPECT_THAT(refusal(plane_scene + "[[set]]\nzip = 1\nseed = [1, 2]\n"),
              HasSubstr("'zip' in [[set]] is true or false"));
}

TEST(SceneSet, AZippedListOfOneBesideLongerOnesIsNoValueForAll) {
  const std::string zipped = plane_scene + "[[set]]\nzip = true\nseed = [1, 2]\n";
  EXPECT_THAT(
      refusal(zipped + "motion.rate_hz = [700]\n"),
      HasSubstr("s.toml:5:1: with zip the lists go side by side, but 'seed' has 2 values and "
                "'motion.rate_hz' 1; a value that is to go with all of them is written without a list"));
  EXPECT_THAT(refusal(zipped + "motion.rate_hz = { values = [700] }\n"), HasSubstr("'motion.rate_hz' 1;"));
  EXPECT_THAT(refusal(zipped + "plane.point_m = [[0, 0, 0]]\n"), HasSubstr("'plane.point_m' 1;"));
  EXPECT_THAT(jobs_of(zipped + "motion.rate_hz = 700\n"), ElementsAre("1 700", "2 700"));
  EXPECT_EQ(read_scene_text(zipped + "plane.point_m = [0, 0, 0]\n", "s.toml").jobs.size(), 2u);
  EXPECT_EQ(
      read_scene_text(plane_scene + "[[set]]\nzip = true\nseed = [1]\nmotion.rate_hz = [700]\n", "s.toml")
          .jobs.size(),
      1u);
}

/// A set's values as its jobs have them, and as the jobs' own texts say, which must be the same.
template <class Of>
std::vector<double> values_in_jobs(const std::string& set, Of of) {
  const SceneFile file = read_scene_text(plane_scene + "[[set]]\n" + set, "s.toml");
  std::vector<double> values;
  for (const SceneJob& job : file.jobs) {
    EXPECT_EQ(job.error, "");
    values.push_back(static_cast<double>(of(job.scene)));
    const SceneFile again = read_scene_text(job.scene.text, "s.toml");
    EXPECT_EQ(static_cast<double>(of(again.scene)), values.back()) << job.scene.text;
  }
  return values;
}

TEST(SceneSet, AJobHasTheNumberThatItsLabelSays) {
  const auto damping = [](const Scene& scene) { return scene.planes[0].surface.damping_n_s_per_m; };
  const auto rate = [](const Scene& scene) { return scene.motion.rate_hz; };
  const auto seed = [](const Scene& scene) { return scene.seed; };
  const std::string key = "plane.damping_n_s_per_m = ";
  EXPECT_THAT(values_in_jobs(key + "{ from = 1, to = 5, steps = 2 }\n", damping), ElementsAre(1, 5));
  EXPECT_THAT(values_in_jobs(key + "{ from = 1, to = 5, steps = 3 }\n", damping), ElementsAre(1, 3, 5));
  EXPECT_THAT(values_in_jobs(key + "{ from = 5, to = 1, steps = 5 }\n", damping), ElementsAre(5, 4, 3, 2, 1));
  EXPECT_THAT(values_in_jobs(key + "{ from = 1, to = 2, steps = 3 }\n", damping), ElementsAre(1, 1.5, 2));
  EXPECT_THAT(values_in_jobs(key + "{ from = 1.0, to = 5, steps = 2 }\n", damping), ElementsAre(1, 5));
  EXPECT_THAT(values_in_jobs(key + "{ from = 0.5, to = 1.5, steps = 3 }\n", damping),
              ElementsAre(0.5, 1, 1.5));
  EXPECT_THAT(values_in_jobs(key + "{ values = [1, 5, 0.5] }\n", damping), ElementsAre(1, 5, 0.5));
  EXPECT_THAT(values_in_jobs(key + "[1, 5, 2.5]\n", damping), ElementsAre(1, 5, 2.5));
  EXPECT_THAT(values_in_jobs(key + "5\n", damping), ElementsAre(5));
  EXPECT_THAT(values_in_jobs("seed = { from = 1, to = 5, steps = 3 }\n", seed), ElementsAre(1, 3, 5));
  EXPECT_THAT(values_in_jobs("seed = { values = [4, 2] }\n", seed), ElementsAre(4, 2));
  EXPECT_THAT(values_in_jobs("seed = [4, 2]\n", seed), ElementsAre(4, 2));
  const std::string zipped = "zip = true\nseed = { from = 1, to = 3, steps = 3 }\n" + key +
                             "[3, 1, 2]\nmotion.rate_hz = { from = 500, to = 1500, steps = 3 }\n";
  EXPECT_THAT(values_in_jobs(zipped, seed), ElementsAre(1, 2, 3));
  EXPECT_THAT(values_in_jobs(zipped, damping), ElementsAre(3, 1, 2));
  EXPECT_THAT(values_in_jobs(zipped, rate), ElementsAre(500, 1000, 1500));
}

TEST(SceneSet, ARangeThatIsNoneIsTold) {
  const auto told = [](const std::string& range) {
    return refusal(plane_scene + "[[set]]\nseed = " + range + "\n");
  };
  EXPECT_THAT(told("{ from = 1, to = 3 }"), HasSubstr("'seed' in [[set]] lacks 'steps'; write { from = 0.2"));
  EXPECT_THAT(told("{ from = 1, to = 3, steps = 1 }"), HasSubstr("needs steps of 2 or more"));
  EXPECT_THAT(told("{ from = 1, to = \"b\", steps = 2 }"), HasSubstr("has no number for 'to'"));
  EXPECT_THAT(told("{ from = 1, till = 3, steps = 2 }"), HasSubstr("knows no 'till'"));
  EXPECT_THAT(told("{ values = 3 }"), HasSubstr("has values that are no list"));
  EXPECT_THAT(told("{ values = [3], steps = 2 }"), HasSubstr("has values and a range"));
  EXPECT_THAT(told("{ from = 1, to = 2, steps = 2000000 }"), HasSubstr("over 100000 jobs"));
}

}  // namespace
}  // namespace fingerpad::set_test
