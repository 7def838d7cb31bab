#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/calm_scene.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"

// The contract of the command line, as a user meets it: exit codes, messages, files.

namespace fingerpad::program_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using test::ShellResult;

constexpr const char* cube_off =
    "OFF\n8 12 0\n0 0 0\n10 0 0\n10 10 0\n0 10 0\n0 0 10\n10 0 10\n10 10 10\n0 10 10\n"
    "3 0 3 2\n3 0 2 1\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 "
    "4 7\n";

constexpr const char* cube_scene =
    "name = \"cube\"\n[[part]]\nmesh = \"cube.off\"\n[motion]\nkind = \"line\"\nfrom_m = [0.001, 0.005, "
    "0.0095]\n"
    "to_m = [0.009, 0.005, 0.0095]\nspeed_m_per_s = 0.02\n";

/// A fresh folder with a cube of 10 mm and a scene that rubs over it.
fs::path folder_with_cube() {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "cube.off") << cube_off;
  std::ofstream(folder / "cube.toml") << cube_scene;
  return folder;
}

void expect_told(const ShellResult& result, int code, const std::string& word) {
  EXPECT_EQ(result.exit_code, code) << result.err;
  EXPECT_NE(result.err.find("fingerpad: error: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find(word), std::string::npos) << "no '" << word << "' in: " << result.err;
}

TEST(Program, HelpNamesEverySubcommandAndEachHasItsOwn) {
  const fs::path folder = test::scratch_dir();
  const ShellResult help = test::fingerpad("--help", folder);
  EXPECT_EQ(help.exit_code, 0);
  std::vector<std::string> names = {"check", "query", "replay", "export", "touch"};
#ifdef FINGERPAD_VIEW
  names.insert(names.end(), {"view", "plot", "report"});
#endif
  for (const std::string& name : names) {
    EXPECT_NE(help.out.find("\n  " + name), std::string::npos) << name;
    EXPECT_EQ(test::fingerpad(name + " --help", folder).exit_code, 0) << name;
  }
  EXPECT_NE(test::fingerpad("--version", folder).out.find("fingerpad "), std::string::npos);
}

#ifdef FINGERPAD_VIEW
TEST(Program, ABrokenFolderOfExactSurfacesEndsThreeWithItsPlace) {
  const fs::path folder = test::scratch_dir();
  fs::create_directories(folder / "exact");
  std::ofstream(folder / "exact" / "meshes.csv")
      << "level,deflection_m,turn_rad,facet_m,triangles\n1,no,1,1,1\n";
  expect_told(test::fingerpad("study contact --out out --exact exact", folder), 3, "exact/meshes.csv");
  expect_told(test::fingerpad("study contact --out out --exact nowhere", folder), 3, "nowhere");
  EXPECT_FALSE(fs::exists(folder / "out"));
}
#endif

TEST(Program, WrongUseEndsTwo) {
  const fs::path folder = folder_with_cube();
  for (const char* call :
       {"", "nonsense", "query", "check", "replay cube.toml", "replay cube.toml --out o --shard 3/2",
        "replay cube.toml --out o --format xml", "check cube.off --unit ft", "export x.h5 --out x.png"}) {
    expect_told(test::fingerpad(call, folder), 2, "");
  }
}

TEST(Program, RefusedInputsEndThreeAndNameTheFile) {
  const fs::path folder = folder_with_cube();
  std::ofstream(folder / "empty.stl");
  std::ofstream(folder / "points.csv") << "x_m,y_m,z_m\n1,zwei,3\n";
  expect_told(test::fingerpad("check absent.stl", folder), 3, "absent.stl");
  expect_told(test::fingerpad("check cube.off empty.stl", folder), 3, "empty.stl");
  expect_told(test::fingerpad("query cube.off points.csv", folder), 3, "points.csv:2");
  expect_told(test::fingerpad("replay absent.toml --out o", folder), 3, "absent.toml");
  expect_told(test::fingerpad("export cube.off --out x.csv", folder), 3, "cube.off");
}

TEST(Program, CheckTellsTheCubeInTextAndJson) {
  const fs::path folder = folder_with_cube();
  EXPECT_EQ(test::fingerpad("check cube.off", folder).exit_code, 0);
  const auto report = nlohmann::json::parse(test::fingerpad("check cube.off --json --unit mm", folder).out);
  ASSERT_EQ(report.size(), 1u);
  EXPECT_EQ(report[0]["triangles"], 12);
  EXPECT_EQ(report[0]["closed"], true);
  EXPECT_EQ(report[0]["components"], 1);
  EXPECT_NEAR(report[0]["volume_m3"].get<double>(), 1e-6, 1e-18);
  EXPECT_NEAR(report[0]["thinnest_wall_m"].get<double>(), 0.01, 1e-7);  // rays are float32
  EXPECT_EQ(report[0]["metres_per_unit"], 1e-3);
  EXPECT_EQ(report[0]["hint"], "");
}

TEST(Program, ReplayThenExportGivesTheCsvThatReplayWrites) {
  const fs::path folder = folder_with_cube();
  ASSERT_EQ(test::fingerpad("replay cube.toml --out h --quiet", folder).exit_code, 0);
  ASSERT_EQ(test::fingerpad("replay cube.toml --out c --format csv --quiet", folder).exit_code, 0);
  ASSERT_EQ(test::fingerpad("export h/cube.h5 --out e.csv", folder).exit_code, 0);
  EXPECT_EQ(bytes_of(folder / "e.csv"), bytes_of(folder / "c" / "cube.csv"));
  EXPECT_EQ(test::fingerpad("export h/cube.h5 --out e.vtp", folder).exit_code, 0);
}

TEST(Program, ATraceIsAMotionAndRepeatsTheRunExactly) {
  const fs::path folder = folder_with_cube();
  ASSERT_EQ(test::fingerpad("replay cube.toml --out h --quiet", folder).exit_code, 0);
  ASSERT_EQ(test::fingerpad("export h/cube.h5 --out first.csv", folder).exit_code, 0);
  std::ofstream(folder / "again.toml") << "[[part]]\nmesh = \"cube.off\"\n[motion]\nfile = \"h/cube.h5\"\n";
  ASSERT_EQ(test::fingerpad("replay again.toml --out a --format csv --quiet", folder).exit_code, 0);
  EXPECT_EQ(bytes_of(folder / "first.csv"), bytes_of(folder / "a" / "again.csv"));
}

TEST(Program, RefusesToNavigateABatchWithABadSceneButRunsTheRest) {
  const fs::path folder = folder_with_cube();
  std::ofstream(folder / "worse.toml") << "[[part]]\nmesh = \"no.off\"\n[motion]\nfile = \"no.csv\"\n";
  const ShellResult both = test::fingerpad("replay cube.toml worse.toml --out b --quiet", folder);
  expect_told(both, 4, "no.");
  EXPECT_TRUE(fs::exists(folder / "b" / "cube.h5"));
  expect_told(test::fingerpad("replay worse.toml --out b --quiet", folder), 3, "no.");
}

TEST(Program, PrintsNoProgressWhenPiped) {
  const fs::path folder = folder_with_cube();
  const ShellResult result = test::fingerpad("replay cube.toml --out h", folder);
  EXPECT_EQ(result.err.find('\r'), std::string::npos) << "a progress bar redraws its line";
  EXPECT_EQ(result.out, "1 of 1 job done, traces and summary.csv in h\n");
}

TEST(Program, WarnsWhereTicksAreTooCoarseForTheSawtooth) {
  const fs::path folder = folder_with_cube();
  // 0.1 mm of tooth at 20 mm/s and 1 kHz: five ticks, which show it.
  const ShellResult slow = test::fingerpad("replay cube.toml --out h --quiet", folder);
  EXPECT_EQ(slow.err.find("under two ticks"), std::string::npos) << slow.err;
  std::ofstream(folder / "fast.toml")
      << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = \"line\"\n"
         "from_m = [0, 0, -0.001]\nto_m = [0.01, 0, -0.001]\nspeed_m_per_s = 0.08\n";
  const ShellResult fast = test::fingerpad("replay fast.toml --out h --quiet", folder);
  EXPECT_NE(fast.err.find("under two ticks"), std::string::npos) << fast.err;
}

TEST(Program, TellsWhatItChoseForAPartAndWhyOnceAndNotWhenQuiet) {
  const fs::path folder = folder_with_cube();
  std::ofstream(folder / "set.toml") << cube_scene << "[[set]]\nfriction.law = [\"coulomb\", \"none\"]\n";
  const std::string told =
      "fingerpad: cube.off: proxy, because walls are 10 mm thick and 10 N at 1000 N/m presses 10 mm deep "
      "(auto)\n";
  const std::string loud = test::fingerpad("replay set.toml --out h", folder).err;
  EXPECT_EQ(loud.find(told), 0u) << loud;
  EXPECT_EQ(loud.find("(auto)"), loud.rfind("(auto)")) << "one line for two jobs: " << loud;
  const std::string quiet = test::fingerpad("replay set.toml --out h --quiet", folder).err;
  EXPECT_EQ(quiet.find("(auto)"), std::string::npos) << quiet;
  std::ofstream(folder / "given.toml") << cube_scene << "[contact]\nmethod = \"proxy\"\n";
  const std::string given = test::fingerpad("replay given.toml --out g", folder).err;
  EXPECT_EQ(given.find("(auto)"), std::string::npos) << "the scene's own words: " << given;
}

TEST(Program, OfSeveralScenesOverOneMeshTellsWhoseChoiceItWas) {
  const fs::path folder = folder_with_cube();
  for (const char* name : {"one", "two", "hard"})
    std::ofstream(folder / (std::string(name) + ".toml"))
        << "name = \"" << name << "\"\n"
        << std::string(cube_scene).substr(std::string("name = \"cube\"\n").size())
        << (std::string(name) == "hard" ? "[contact]\ngreatest_force_n = 20\n" : "");
  const std::string told = test::fingerpad("replay one.toml two.toml hard.toml --out h", folder).err;
  EXPECT_NE(told.find("fingerpad: one, two: cube.off: proxy, because"), std::string::npos) << told;
  EXPECT_NE(told.find("fingerpad: hard: cube.off: proxy, because"), std::string::npos) << told;
}

TEST(Program, OnOneProcessorStartsItsThreadsWithoutAWarning) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "calm.toml") << test::calm_scene("calm") << "[[set]]\nseed = [1, 2, 3, 4]\n";
  const ShellResult bound =
      test::shell("first=$(taskset -cp $$ | sed 's/.*: //; s/[,-].*//')\ntaskset -c $first '" +
                      test::program().string() + "' replay calm.toml --out o --jobs 4",
                  folder);
  EXPECT_EQ(bound.exit_code, 0);
  EXPECT_EQ(bound.err, "");
  EXPECT_EQ(bound.out, "4 of 4 jobs done, traces and summary.csv in o\n");
}

TEST(Program, RanksShareABatchAndChangeNothing) {
  const fs::path folder = folder_with_cube();
#ifndef FINGERPAD_MPI
  GTEST_SKIP() << "built with FINGERPAD_MPI=OFF";
#endif
  std::ofstream(folder / "sweep.toml")
      << cube_scene << "[[set]]\nfriction.law = [\"coulomb\", \"stick-slip\", \"none\"]\n";
  ASSERT_EQ(test::fingerpad("replay sweep.toml --out one --quiet", folder).exit_code, 0);
  const ShellResult ranks = test::shell(
      "HWLOC_COMPONENTS=-gl OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun "
      "--oversubscribe -n 2 '" +
          test::program().string() + "' replay sweep.toml --out two --quiet",
      folder);
  ASSERT_EQ(ranks.exit_code, 0) << ranks.err;
  for (const char* name : {"cube-0001.h5", "cube-0002.h5", "cube-0003.h5", "summary.csv"}) {
    EXPECT_EQ(bytes_of(folder / "one" / name), bytes_of(folder / "two" / name)) << name;
  }
}

}  // namespace
}  // namespace fingerpad::program_test
