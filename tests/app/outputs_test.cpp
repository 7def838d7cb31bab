#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/calm_scene.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"

// What the program says of the files that it writes, and of names that are none for them.

namespace fingerpad::outputs_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using test::calm_scene;
using test::ShellResult;
using testing::HasSubstr;
using testing::Not;

fs::path folder_with_inputs() {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "calm.toml") << calm_scene("calm");
  std::ofstream(folder / "box.stl") << test::text_stl(test::box_soup({10, 20, 30}));
  std::ofstream(folder / "points.csv") << "x_m,y_m,z_m\n0,0,0.012\n";
  return folder;
}

fs::path folder_with_trace() {
  const fs::path folder = folder_with_inputs();
  EXPECT_EQ(test::fingerpad("replay calm.toml --out o --quiet", folder).exit_code, 0);
  return folder;
}

void expect_told(const ShellResult& result, int code, const std::string& words) {
  EXPECT_EQ(result.exit_code, code) << result.err;
  EXPECT_THAT(result.err, HasSubstr(words));
}

TEST(Outputs, AreToldInOneLineUnlessQuietOrStandardOutputItself) {
  const fs::path folder = folder_with_trace();
  const auto out = [&](const std::string& call) { return test::fingerpad(call, folder).out; };
  EXPECT_EQ(out("export o/calm.h5 --out e.csv"), "wrote e.csv (501 ticks as CSV)\n");
  EXPECT_EQ(out("export o/calm.h5 --out e.vtp"), "wrote e.vtp (501 ticks as VTP, for ParaView)\n");
  EXPECT_EQ(out("export o/calm.h5 --out e.csv --quiet"), "");
  const std::string table = bytes_of(folder / "e.csv");
  EXPECT_EQ(out("export o/calm.h5 --out -"), table);
  fs::create_symlink("/proc/self/fd/1", folder / "stdout.csv");
  EXPECT_EQ(out("export o/calm.h5 --out stdout.csv"), table);
#ifdef FINGERPAD_VIEW
  EXPECT_EQ(out("plot o/calm.h5 --out p.svg"), "wrote p.svg (history of 501 ticks)\n");
  EXPECT_EQ(out("plot o/calm.h5 --out p.svg --quiet"), "");
  EXPECT_EQ(out("view o/calm.h5 --png v.png --at 0.25"), "wrote v.png (1280 x 800 pixels, at 0.25 s)\n");
  EXPECT_EQ(out("view box.stl --png v.png --size 300x200"), "wrote v.png (300 x 200 pixels)\n");
  EXPECT_EQ(out("view box.stl --png v.png --quiet"), "");
#endif
}

TEST(Outputs, OfAnEndingThatIsNotTheirsAreRefusedWithWhatThereIs) {
  const fs::path folder = folder_with_trace();
  expect_told(test::fingerpad("query box.stl points.csv --out q.mat", folder), 2,
              "q.mat: query writes .csv files");
  EXPECT_EQ(test::fingerpad("query box.stl points.csv --out plain", folder).exit_code, 0)
      << "a name without an ending promises nothing";
  const std::string measured = (test::source_dir() / "scenes/measurements/synthetic_finger.csv").string();
  expect_told(test::fingerpad("fit " + measured + " --out f.mat", folder), 2,
              "f.mat: fit writes .toml files");
  expect_told(test::fingerpad("export o/calm.h5 --out e.mat", folder), 2,
              "export writes .csv, .vtp or .vtm files");
#ifdef FINGERPAD_VIEW
  expect_told(test::fingerpad("view box.stl --png v.jpg", folder), 2, "v.jpg: view --png writes .png files");
  expect_told(test::fingerpad("plot o/calm.h5 --out p.bmp", folder), 2, "plot writes .png or .svg files");
  expect_told(test::fingerpad("touch calm.toml --record r.mat", folder), 2,
              "r.mat: touch --record writes .h5 or .csv files");
#endif
  for (const char* name : {"q.mat", "f.mat", "e.mat", "v.jpg", "p.bmp", "r.mat"})
    EXPECT_FALSE(fs::exists(folder / name));
}

TEST(Outputs, WithoutANameAreUsageAndSaidSo) {
  const fs::path folder = folder_with_trace();
  for (const char* call : {"query box.stl points.csv --out ''", "export o/calm.h5 --out ''",
                           "replay calm.toml --out ''", "study friction --out ''",
#ifdef FINGERPAD_VIEW
                           "plot o/calm.h5 --out ''"
#endif
       })
    expect_told(test::fingerpad(call, folder), 2, "--out: is empty: give a name");
#ifdef FINGERPAD_VIEW
  expect_told(test::fingerpad("view box.stl --png ''", folder), 2, "--png: is empty");
  expect_told(test::fingerpad("touch box.stl --record ''", folder), 2, "--record: is empty");
#endif
}

TEST(Outputs, OfAShardAreNamedAsTheyAre) {
  const fs::path folder = folder_with_inputs();
  EXPECT_EQ(test::fingerpad("replay calm.toml --out o --shard 1/2", folder).out,
            "1 of 1 job done, traces and summary-1of2.csv in o\n");
  EXPECT_TRUE(fs::exists(folder / "o" / "summary-1of2.csv"));
}

TEST(Outputs, OfAnEarlierRunAreToldWhereThisOneFailed) {
  const fs::path folder = folder_with_inputs();
  const std::string left = "calm.csv: is an earlier run's, since this one failed\n";
  ASSERT_THAT(test::fingerpad("replay calm.toml --out o --format csv", folder).err, Not(HasSubstr(left)));
  const std::string call =
      "ulimit -f 8; '" + test::program().string() + "' replay --format csv calm.toml --out ";
  expect_told(test::shell(call + "o", folder), 1, "fingerpad: warning: o/" + left);
  EXPECT_THAT(test::shell(call + "fresh", folder).err, Not(HasSubstr(left))) << "nothing was there";
  std::ofstream(folder / "calm.toml") << calm_scene("calm") + "[[part]]\nmesh = \"none.stl\"\n";
  expect_told(test::fingerpad("replay calm.toml --out o --format csv", folder), 3,
              "fingerpad: warning: o/" + left);
}

TEST(Outputs, OfAnEarlierRunAreToldInOneLineWhereManyJobsFailed) {
  const fs::path folder = folder_with_inputs();
  for (const char* seeds : {"[1, 2, 3]", "[1, 2]"}) {
    const std::string set = std::string("[[set]]\nseed = ") + seeds + "\n";
    std::ofstream(folder / "calm.toml") << calm_scene("calm") + set;
    ASSERT_EQ(test::fingerpad("replay calm.toml --out o --format csv", folder).exit_code, 0);
    std::ofstream(folder / "calm.toml") << calm_scene("calm") + "[[part]]\nmesh = \"none.stl\"\n" + set;
    const std::string more = *(seeds + 5) == ']' ? "1 more trace" : "2 more traces";
    expect_told(test::fingerpad("replay calm.toml --out o --format csv", folder), 4,
                "fingerpad: warning: o/calm-0001.csv and " + more +
                    ": are an earlier run's, since these jobs failed\n");
  }
}

TEST(Outputs, AnHdf5TraceIntoADeviceIsRefusedAndACsvIsNot) {
  const fs::path folder = folder_with_inputs();
  fs::create_directory(folder / "o");
  for (const char* name : {"calm.h5", "calm.csv"}) fs::create_symlink("/dev/null", folder / "o" / name);
  expect_told(test::fingerpad("replay calm.toml --out o", folder), 1,
              "o/calm.h5: is no regular file, which an HDF5");
  EXPECT_EQ(test::fingerpad("replay calm.toml --out o --format csv", folder).exit_code, 0);
}

TEST(Outputs, BehindALinkToNowhereAreToldPlainly) {
  const fs::path folder = folder_with_inputs();
  fs::create_directory(folder / "o");
  for (const std::string ending : {"h5", "csv"}) {
    fs::create_symlink("no/t", folder / "o" / ("calm." + ending));
    expect_told(test::fingerpad("replay calm.toml --out o --format " + ending, folder), 1,
                "o/calm." + ending + ": cannot be created: is a link to no/t, which is not there\n");
  }
}

#ifdef FINGERPAD_VIEW
TEST(Moments, OutsideOfATraceAreTold) {
  const fs::path folder = folder_with_trace();
  const ShellResult late = test::fingerpad("view o/calm.h5 --png v.png --at 99", folder);
  expect_told(late, 0, "fingerpad: warning: --at: 99 s is outside of 0 to 0.5 s: 0.5 s is shown\n");
  EXPECT_THAT(late.out, HasSubstr("at 0.5 s"));
  EXPECT_EQ(test::fingerpad("view o/calm.h5 --png v.png --at 0.5", folder).err, "");
  fs::remove(folder / "v.png");
  for (const char* moment : {"nan", "inf", "-1"})
    expect_told(test::fingerpad("view o/calm.h5 --png v.png --at=" + std::string(moment), folder), 2, "--at");
  EXPECT_FALSE(fs::exists(folder / "v.png"));
}
#endif

TEST(Refusals, OfACheckAreToldOnce) {
  const fs::path folder = folder_with_inputs();
  const ShellResult text = test::fingerpad("check absent.stl box.stl", folder);
  EXPECT_EQ(text.exit_code, 3);
  EXPECT_EQ(text.err, "fingerpad: error: absent.stl: cannot be read: there is no such file\n");
  EXPECT_THAT(text.out, Not(HasSubstr("cannot be read")));
  EXPECT_THAT(text.out, HasSubstr("absent.stl: refused\n"));
  EXPECT_THAT(text.out, HasSubstr("box.stl: can be touched"));
}

TEST(Refusals, OfAStepFileNameWhatMakesAMeshOfIt) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "part.step") << "ISO-10303-21;\nHEADER;\n";
  for (const char* way : {"CAD program", "FreeCAD", "gmsh"})
    expect_told(test::fingerpad("check part.step", folder), 3, way);
}

TEST(Refusals, OfAMissingFileSayThatItIsNotThere) {
  const fs::path folder = folder_with_inputs();
  const std::string plane = "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n";
  const std::string line = "[motion]\nfile = \"points.csv\"\n";
  std::ofstream(folder / "motion.toml") << plane << "[motion]\nfile = \"nope\"\n";
  std::ofstream(folder / "mesh.toml")
      << "[[part]]\nmesh = \"nope\"\n[motion]\nkind = \"line\"\nfrom_m = [0, 0, "
         "0]\nto_m = [1, 0, 0]\nspeed_m_per_s = 1\n";
  std::ofstream(folder / "profile.toml") << plane << "[finger]\nprofile = \"nope\"\n" << line;
  for (const char* call :
       {"replay motion.toml --out o", "replay mesh.toml --out o", "replay profile.toml --out o",
        "replay nope --out o", "check nope", "check motion.toml", "query box.stl nope",
        "query nope points.csv", "export nope --out e.csv"}) {
    SCOPED_TRACE(call);
    const ShellResult result = test::fingerpad(call, folder);
    expect_told(result, 3, "cannot be read: there is no such file");
    EXPECT_THAT(result.err, HasSubstr("nope"));
  }
}

TEST(Refusals, OfAFingerTooLargeAreTheSameForCheckAndReplay) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "rub.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0\n1,0.001,0,0\n";
  const auto told = [&](const char* radius_m) {
    std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"box.stl\"\nunit = \"mm\"\n[finger]\nradius_m = "
                                     << radius_m << "\n[motion]\nfile = \"rub.csv\"\n";
    return test::fingerpad("check s.toml", folder);
  };
  const ShellResult huge = told("7");
  expect_told(huge, 3, "s.toml:5:12: a finger of radius_m = 7, where the longest part is");
  EXPECT_EQ(test::fingerpad("replay s.toml --out o", folder).exit_code, 3);
  expect_told(told("0.3"), 0, "a finger of radius_m = 0.3");
  const ShellResult usual = told("0.007");
  EXPECT_EQ(usual.exit_code, 0);
  EXPECT_THAT(usual.err, Not(HasSubstr("a finger of")));
}

TEST(Refusals, OfAMotionAreTheSameForCheckAndReplay) {
  const fs::path folder = folder_with_inputs();
  fs::create_directory(folder / "folder.csv");
  std::ofstream(folder / "mesh.csv") << "solid box\nendsolid box\n";
  std::ofstream(folder / "rub.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0\n0.001,0,0,0\n0.002,0.5,0,0\n0.002,0,0,0\n";
  for (const char* motion : {"file = \"folder.csv\"", "file = \"mesh.csv\"", "file = \"box.stl\"",
                             "file = \"-\"", "file = \"rub.csv\"\ncolumns = { x = \"across\" }"}) {
    std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"box.stl\"\nunit = \"mm\"\n[motion]\n"
                                     << motion << "\n";
    const ShellResult check = test::fingerpad("check s.toml", folder);
    EXPECT_EQ(check.exit_code, 3) << motion;
    EXPECT_THAT(check.out, testing::EndsWith("s.toml: refused\n")) << motion;
    const ShellResult replay = test::fingerpad("replay s.toml --out o", folder);
    EXPECT_EQ(replay.exit_code, 3) << motion;
    EXPECT_EQ(check.err, replay.err) << motion;
  }
}

TEST(Refusals, OfASceneOrAMeshAsAMotionSayWhatItIs) {
  const fs::path folder = folder_with_inputs();
  for (const auto& [motion, is] :
       {std::pair("s.toml", "a scene or a profile"), std::pair("box.stl", "a mesh")}) {
    std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"box.stl\"\nunit = \"mm\"\n[motion]\nfile = \""
                                     << motion << "\"\n";
    expect_told(test::fingerpad("replay s.toml --out o", folder), 3,
                std::string(motion) + ": is by its name " + is + ", and no motion");
  }
}

TEST(Check, SaysWhereThereIsNoMotionToReplay) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"box.stl\"\nunit = \"mm\"\n";
  const ShellResult check = test::fingerpad("check s.toml", folder);
  EXPECT_EQ(check.exit_code, 0);
  EXPECT_THAT(check.out, testing::EndsWith("s.toml: has no [motion]: to touch and to view, not to replay\n"));
}

TEST(Check, TellsTheBoxOfALongScriptedMotionAtOnce) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "s.toml") << R"(
[[plane]]
point_m = [0, 0, 0]
normal = [0, 0, 1]
[motion]
kind = "circle"
centre_m = [0, 0, 0]
radius_m = 0.01
frequency_hz = 1
duration_s = 2000000
rate_hz = 1000
)";
  const ShellResult check = test::fingerpad("check s.toml", folder);
  EXPECT_THAT(check.out, HasSubstr("  motion         2000000001 ticks at 1000 Hz, 2000000 s\n"
                                   "  in a box of    20 x 20 x 0 mm, from (-10, -10, 0) mm\n"))
      << check.err;
}

TEST(Check, TellsHowAScenesMotionWasReadAndHowFarItGoes) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "rub.csv") << "time;X;Y;Z\n0;-10;5;0\n2;-10;7;0\n4;20;6;-1,5\n";
  std::ofstream(folder / "s.toml")
      << "[[part]]\nmesh = \"box.stl\"\nunit = \"mm\"\n[motion]\nfile = \"rub.csv\"\n"
      << "unit = \"mm\"\ntime_unit = \"ms\"\nseparator = \"auto\"\ndecimal = \",\"\n"
      << "columns = { t = \"time\", x = \"X\", y = \"Y\", z = \"Z\" }\n";
  const ShellResult check = test::fingerpad("check s.toml", folder);
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_THAT(check.out, testing::EndsWith("s.toml: rub.csv can be followed\n"
                                           "  motion         3 ticks at 500 Hz, 0.004 s\n"
                                           "  in a box of    30 x 2 x 1.5 mm, from (-10, 5, -1.5) mm\n"));
  for (const char* said :
       {"x is 'X'", "cells parted by ';'", "decimal mark ','", "positions in mm", "times in ms"})
    EXPECT_THAT(check.err, HasSubstr(said));
  const auto report = nlohmann::json::parse(test::fingerpad("check s.toml --json", folder).out);
  ASSERT_EQ(report.size(), 1u) << "an object for each mesh";
  const auto& motion = report[0]["motion"];
  EXPECT_EQ(motion["name"], "rub.csv");
  EXPECT_EQ(motion["ticks"], 3);
  EXPECT_EQ(motion["rate_hz"], 500);
  EXPECT_NEAR(motion["duration_s"], 0.004, 1e-12);
  EXPECT_NEAR(motion["bounds_m"]["max"][0], 0.02, 1e-12);
  EXPECT_EQ(motion["nearest_m"], 0) << "the way from tick to tick goes through the box";
}

TEST(Check, TellsOfAMotionThatTouchesNothingAndOfOneThatGoesFarBeyond) {
  const fs::path folder = folder_with_inputs();
  const auto check = [&folder](const std::string& finger, const std::string& motion) {
    std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"box.stl\"\n[finger]\n" + finger + "\n[motion]\n" +
                                            motion;
    const ShellResult told = test::fingerpad("check s.toml", folder);
    EXPECT_EQ(told.exit_code, 0) << told.err;
    return told.err;
  };
  const std::string over =
      "kind = \"line\"\nfrom_m = [0, 0, 0.1]\nto_m = [0.01, 0, 0.1]\nspeed_m_per_s = 0.01\n";
  const std::string nothing = "s.toml: the motion never touches: it comes nearest at t = ";
  // Over the middle of the box, whose top is at 15 mm, a ball of 2 mm at 100 mm; said as by replay.
  const std::string told = check("radius_m = 0.002", over);
  EXPECT_THAT(told, HasSubstr(nothing + "0 s, 83 mm from part 1 (box.stl)"));
  EXPECT_THAT(test::fingerpad("replay s.toml --out o", folder).err,
              HasSubstr(told.substr(told.find("the motion never touches"))));
  const auto report = nlohmann::json::parse(test::fingerpad("check s.toml --json", folder).out);
  EXPECT_NEAR(report[0]["motion"]["nearest_m"].get<double>(), 0.083, 1e-9);
  EXPECT_THAT(check("radius_m = 0.1", over), Not(HasSubstr("never touches"))) << "a ball of that size does";
  EXPECT_THAT(check("radius_m = 0.002",
                    "kind = \"line\"\nfrom_m = [-20, 0, 0]\nto_m = [20, 0, 0]\nspeed_m_per_s = 40\n"),
              HasSubstr("the motion goes 40000 mm far, "));
  // A sheet has no inside: behind it is off it, and to go through it is to touch it.
  std::ofstream(folder / "box.stl") << test::text_stl(test::square_soup(0.01, 2));
  const auto sheet = [&check](const char* from, const char* to) {
    return check("radius_m = 0.002", fmt::format("kind = \"line\"\nfrom_m = [0, 0, {}]\nto_m = [0, 0, {}]\n"
                                                 "speed_m_per_s = 40\nrate_hz = 1000\n",
                                                 from, to));
  };
  EXPECT_THAT(sheet("-0.1", "-0.06"), HasSubstr(nothing + "0.001 s, 58 mm"));
  EXPECT_THAT(sheet("-0.03", "0.01"), Not(HasSubstr("never touches")));
}

// In millimetres and read as metres: replay says so after its run, and check before it.
TEST(Check, TellsOfARecordingThatIsPressedFarIntoAPlane) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "press.csv") << "t_s,x_m,y_m,z_m\n0,0,0,1\n0.1,5,0,-0.5\n";
  std::ofstream(folder / "s.toml") << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n"
                                      "[motion]\nfile = \"press.csv\"\n";
  const std::string deep = "s: the finger is pressed 500 mm deep, which no finger is: check [motion] unit";
  EXPECT_THAT(test::fingerpad("replay s.toml --out o", folder).err, HasSubstr(deep));
  EXPECT_THAT(test::fingerpad("check s.toml", folder).err, HasSubstr(".toml" + deep.substr(1)));
  const auto report = nlohmann::json::parse(test::fingerpad("check s.toml --json", folder).out);
  ASSERT_EQ(report.size(), 1u) << "one for the scene, which has no mesh";
  EXPECT_EQ(report[0]["file"], "s.toml");
  EXPECT_EQ(report[0]["touchable"], true);
  EXPECT_EQ(report[0]["motion"]["ticks"], 2);
  ASSERT_EQ(report[0]["motion"]["warnings"].size(), 1u);
  EXPECT_THAT(report[0]["motion"]["warnings"][0].get<std::string>(), HasSubstr("500 mm deep"));
}

TEST(Check, LooksAtAllRecordingsOfASet) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "touches.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0.1\n0.1,0,0,0\n";
  std::ofstream(folder / "misses.csv") << "t_s,x_m,y_m,z_m\n0,0,0,1\n0.1,0.01,0,1\n";
  const auto check = [&folder](const std::string& files, const std::string& how) {
    std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"box.stl\"\n[motion]\nfile = \"touches.csv\"\n"
                                        "[[set]]\nmotion.file = [" +
                                            files + "]\nfinger.radius_m = [0.001, 0.002]\n";
    return test::fingerpad("check s.toml" + how, folder);
  };
  const std::string two = "\"touches.csv\", \"misses.csv\"";
  const ShellResult told = check(two, "");
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.err, HasSubstr("s.toml: a set of 4 jobs: each mesh and each motion is looked at once"));
  EXPECT_THAT(told.out, testing::EndsWith(
                            "s.toml: 2 motions: 2 can be followed, 1 of these with a warning, 0 refused\n"));
  EXPECT_THAT(told.err, HasSubstr("s.toml: misses.csv: the motion never touches: it comes nearest at t = "));
  EXPECT_THAT(told.out,
              testing::ContainsRegex("touches.csv can be followed(.|\n)*misses.csv can be followed"));
  const auto report = nlohmann::json::parse(check(two, " --json").out);
  ASSERT_EQ(report.size(), 1u) << "an object for each mesh";
  EXPECT_EQ(report[0]["motion"]["name"], "touches.csv");
  ASSERT_EQ(report[0]["motions"].size(), 2u) << "each once";
  EXPECT_EQ(report[0]["motions"][0]["warnings"].size(), 0u);
  EXPECT_EQ(report[0]["motions"][1]["warnings"].size(), 1u);
  const std::string bad = "\"touches.csv\", \"nowhere.csv\", \"misses.csv\"";
  const ShellResult lacking = check(bad, "");
  EXPECT_EQ(lacking.exit_code, 3);
  EXPECT_THAT(lacking.err, HasSubstr("nowhere.csv, which cannot be read"));
  const std::string sums = "s.toml: 3 motions: 2 can be followed, 1 of these with a warning, 1 refused\n";
  EXPECT_THAT(lacking.out, HasSubstr(sums)) << "what is wrong with one keeps none from being told";
  EXPECT_THAT(check("\"nowhere.csv\", \"touches.csv\", \"misses.csv\"", "").out, HasSubstr(sums));
  EXPECT_THAT(nlohmann::json::parse(check(bad, " --json").out)[0]["motions"][1]["error"].get<std::string>(),
              HasSubstr("nowhere.csv"));
  EXPECT_THAT(check("\"touches.csv\", \"./touches.csv\", \"misses.csv\"", "").out,
              HasSubstr("2 motions: 2 can be followed"));
  // The same file taken otherwise is another motion; a job of a wrong number is told.
  const ShellResult units = check("\"touches.csv\"]\nmotion.unit = [\"m\", \"mm\"", "");
  EXPECT_THAT(units.out, HasSubstr("s.toml: 2 motions: 2 can be followed"));
  EXPECT_THAT(check("\"touches.csv\"]\ncontact.force_tolerance = [0.03, -1", "").err, HasSubstr("job 3: "));
}

TEST(Check, TellsAFingerOfASetThatIsTooLarge) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "touches.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0.1\n0.1,0,0,0\n";
  std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"box.stl\"\n[motion]\nfile = \"touches.csv\"\n"
                                      "[[set]]\nfinger.radius_m = [0.001, 70]\n";
  const ShellResult told = test::fingerpad("check s.toml", folder);
  EXPECT_EQ(told.exit_code, 3);
  EXPECT_THAT(told.err, HasSubstr("a finger of radius_m = 70"));
  const auto report = nlohmann::json::parse(test::fingerpad("check s.toml --json", folder).out);
  ASSERT_EQ(report.size(), 2u);
  EXPECT_EQ(report[1]["refused"][0]["job"], 2);
  EXPECT_EQ(report[0]["motions"].size(), 1u) << "what is wrong with the finger is no motion";
}

TEST(Check, TellsWhatLooksAtARecording) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "m.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0.1\n0.1,0,0,0\n";
  const ShellResult told = test::fingerpad("check m.csv", folder);
  EXPECT_EQ(told.exit_code, 3);
  EXPECT_THAT(told.err, HasSubstr("m.csv: a recording is looked at with a scene that follows it"));
  EXPECT_THAT(test::fingerpad("check nowhere.csv", folder).err, Not(HasSubstr("recording")));
}

TEST(Check, LooksAtAllMeshesOfASet) {
  const fs::path folder = folder_with_inputs();
  fs::copy_file(folder / "box.stl", folder / "other.stl");
  std::ofstream(folder / "bad.stl") << "solid nothing\nendsolid nothing\n";
  std::ofstream(folder / "touches.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0.1\n0.1,0,0,0\n";
  const auto check = [&folder](const std::string& meshes, const std::string& how) {
    std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"box.stl\"\n[motion]\nfile = \"touches.csv\"\n"
                                        "[[set]]\nmesh = [" +
                                            meshes + "]\n";
    return test::fingerpad("check s.toml" + how, folder);
  };
  const std::string good = "\"box.stl\", \"./box.stl\", \"other.stl\"";
  const ShellResult told = check(good, "");
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("other.stl: can be touched"));
  EXPECT_THAT(told.out, HasSubstr("s.toml: 2 meshes: 2 can be touched, 0 refused\n"));
  for (const char* meshes :
       {"\"box.stl\", \"bad.stl\", \"other.stl\"", "\"bad.stl\", \"box.stl\", \"other.stl\""}) {
    const ShellResult lacking =
        check(std::string(meshes) + "]\nmotion = [\"touches.csv\", \"nowhere.csv\"", "");
    EXPECT_EQ(lacking.exit_code, 3) << meshes;
    EXPECT_THAT(lacking.out, HasSubstr("bad.stl: refused"));
    EXPECT_THAT(lacking.out, HasSubstr("other.stl: can be touched")) << "whatever is wrong with another";
    EXPECT_THAT(lacking.out, HasSubstr("s.toml: 3 meshes: 2 can be touched, 1 refused\n"));
    EXPECT_THAT(lacking.out,
                HasSubstr("s.toml: 2 motions: 1 can be followed, 0 of these with a warning, 1 refused\n"));
    EXPECT_THAT(lacking.err, HasSubstr("error: bad.stl")) << lacking.err;
    const auto report = nlohmann::json::parse(
        check(std::string(meshes) + "]\nmotion = [\"touches.csv\", \"nowhere.csv\"", " --json").out);
    ASSERT_EQ(report.size(), 4u)
        << "an object for each mesh, and the scene's that says what is wrong with it";
    for (const auto& object : report)
      EXPECT_TRUE(object["motions"].is_array() && object["overlaps"].is_array());
    EXPECT_NE(report[0]["touchable"], report[1]["touchable"]);
    EXPECT_EQ(report[2]["file"], "other.stl");
    EXPECT_EQ(report[report[0]["touchable"] ? 0 : 1]["motion"]["name"], "touches.csv");
    EXPECT_EQ(report[3]["file"], "s.toml");
    EXPECT_THAT(report[3]["error"].get<std::string>(), HasSubstr("nowhere.csv"));
    EXPECT_EQ(report[3]["refused"].size(), 1u);
  }
  // One file by two names, and two by names that look alike.
  fs::create_directories(folder / "x" / "y");
  fs::create_directory_symlink("x/y", folder / "link");
  std::ofstream(folder / "x" / "box.stl") << "solid nothing\nendsolid nothing\n";
  EXPECT_EQ(check("\"box.stl\", \"link/../box.stl\"", "").exit_code, 3);
  EXPECT_THAT(check("\"box.stl\", \"" + (folder / "box.stl").string() + "\"", "").out,
              Not(HasSubstr("meshes:")));
  const ShellResult missing = check("\"box.stl\", \"nowhere.stl\"", "");
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_THAT(missing.err, HasSubstr("nowhere.stl"));
}

TEST(Check, TellsAFingerThatIsTooLargeForAFurtherMeshOfASet) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "huge.stl") << test::text_stl(test::box_soup(Vec3(2000, 2000, 2000)));
  std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"huge.stl\"\n"
                                      "[[set]]\nmesh = [\"huge.stl\", \"box.stl\"]\n"
                                      "finger.radius_m = [0.001, 0.6]\n";
  const ShellResult told = test::fingerpad("check s.toml", folder);
  EXPECT_EQ(told.exit_code, 3);
  EXPECT_THAT(told.err, HasSubstr("a finger of radius_m = 0.6"));
}

TEST(Check, OfASetWithoutAGoodMeshTellsItsJobsAndMotionsAllTheSame) {
  const fs::path folder = folder_with_inputs();
  for (const char* bad : {"one.stl", "two.stl"})
    std::ofstream(folder / bad) << "solid nothing\nendsolid nothing\n";
  std::ofstream(folder / "read.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0.1\n0.1,0,0,0\n";
  std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"one.stl\"\n"
                                      "[[set]]\nmesh = [\"one.stl\", \"two.stl\"]\n"
                                      "motion = [\"read.csv\", \"nowhere.csv\"]\n"
                                      "contact.force_tolerance = [0.03, -1]\n";
  const ShellResult told = test::fingerpad("check s.toml", folder);
  EXPECT_EQ(told.exit_code, 3);
  EXPECT_THAT(told.err, HasSubstr("force_tolerance"));
  EXPECT_THAT(told.err, HasSubstr("nowhere.csv"));
  EXPECT_THAT(told.out, HasSubstr("s.toml: read.csv: can be read"));
  EXPECT_THAT(told.out, HasSubstr("s.toml: 2 meshes: 0 can be touched, 2 refused\n"));
  const auto report = nlohmann::json::parse(test::fingerpad("check s.toml --json", folder).out);
  ASSERT_EQ(report.size(), 3u);
  EXPECT_EQ(report[2]["refused"].size(), 2u);
  EXPECT_EQ(report[2]["motions"].size(), 2u);
  // With nothing wrong beside the meshes the motion is told all the same.
  std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"one.stl\"\n[motion]\nfile = \"read.csv\"\n"
                                      "[[set]]\nmesh = [\"one.stl\", \"two.stl\"]\n";
  const auto good = nlohmann::json::parse(test::fingerpad("check s.toml --json", folder).out);
  ASSERT_EQ(good.size(), 3u);
  EXPECT_EQ(good[2]["touchable"], false);
  ASSERT_EQ(good[2]["motions"].size(), 1u);
  EXPECT_EQ(good[2]["motions"][0]["name"], "read.csv");
}

TEST(Check, OfAMeshThatStandsInASceneTwiceKeepsItsPartsApart) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "bad.stl") << "solid nothing\nendsolid nothing\n";
  std::ofstream(folder / "touches.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0.1\n0.1,0,0,0\n";
  fs::copy_file(folder / "box.stl", folder / "other.stl");
  std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"bad.stl\"\nposition_m = [3, 0, 0]\n"
                                      "[[part]]\nmesh = \"box.stl\"\n[[part]]\nmesh = \"box.stl\"\n"
                                      "position_m = [0.001, 0, 0]\n[motion]\nfile = \"touches.csv\"\n"
                                      "[[set]]\npart.mesh = [\"bad.stl\", \"other.stl\"]\n";
  const auto report = nlohmann::json::parse(test::fingerpad("check s.toml --json", folder).out);
  ASSERT_EQ(report.size(), 4u);
  for (const int part : {1, 2}) {
    EXPECT_EQ(report[part]["file"], "box.stl");
    ASSERT_EQ(report[part]["overlaps"].size(), 1u) << part;
    EXPECT_EQ(report[part]["overlaps"][0]["with"], part == 1 ? "part 3 (box.stl)" : "part 2 (box.stl)");
    EXPECT_EQ(report[part]["motions"].size(), 1u) << part;
  }
}

TEST(Check, HoldsEachMotionThatIsLaidAgainstThePartThatItIsLaidOn) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "big.stl") << test::text_stl(test::box_soup(Vec3(900, 900, 900)));
  std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"box.stl\"\n[finger]\nradius_m = 0.001\n"
                                      "[motion]\nkind = \"on_surface\"\nsize_m = 0.004\n"
                                      "depth_m = 0.0002\nspeed_m_per_s = 0.01\n"
                                      "[[set]]\nmesh = [\"box.stl\", \"big.stl\"]\n";
  const ShellResult told = test::fingerpad("check s.toml", folder);
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("s.toml: 2 motions: 2 can be followed, 0 of these with a warning"));
  EXPECT_THAT(told.err, Not(HasSubstr("never touches"))) << told.err;
}

TEST(Check, TakesOneFileByTwoEndingsForTwo) {
  const fs::path folder = folder_with_inputs();
  fs::create_hard_link(folder / "box.stl", folder / "box.off");
  std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"box.stl\"\n"
                                      "[[set]]\nmesh = [\"box.stl\", \"box.off\"]\n";
  const ShellResult told = test::fingerpad("check s.toml", folder);
  EXPECT_EQ(told.exit_code, 3);
  EXPECT_THAT(told.err, HasSubstr("box.off"));
}

TEST(Check, SaysAllInTheOrderInWhichItIsSaid) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "bad.stl") << "solid nothing\nendsolid nothing\n";
  const ShellResult told = test::fingerpad("check box.stl bad.stl box.stl 2>&1", folder);
  const std::size_t first = told.out.find("box.stl: can be touched"),
                    error = told.out.find("fingerpad: error:");
  ASSERT_NE(error, std::string::npos) << told.out;
  EXPECT_LT(first, error);
  EXPECT_LT(error, told.out.rfind("box.stl: can be touched"));
}

TEST(Refusals, OfASubcommandNameTheNearest) {
  const fs::path folder = test::scratch_dir();
  expect_told(test::fingerpad("repaly scene.toml --out o", folder), 2,
              "there is no subcommand 'repaly'; did you mean 'replay'?");
  const ShellResult far = test::fingerpad("xyzzy", folder);
  expect_told(far, 2, "there is no subcommand 'xyzzy'; there are check, query, replay");
  EXPECT_THAT(far.err, Not(HasSubstr("did you mean")));
}

TEST(Walls, OfAPartAreOneNumberForCheckAndForTheChoice) {
  const fs::path folder = test::scratch_dir();
  const std::string mesh = (test::source_dir() / "scenes" / "parts" / "bracket_coarse.stl").string();
  std::ofstream(folder / "s.toml")
      << "[[part]]\nmesh = \"" << mesh
      << "\"\n[motion]\nkind = \"line\"\nfrom_m = [0, 0, 1]\nto_m = [0, 0, 1.01]\n"
         "speed_m_per_s = 1\n";
  const auto report = nlohmann::json::parse(test::fingerpad("check --json '" + mesh + "'", folder).out);
  const double wall_mm = 1e3 * report[0]["thinnest_wall_m"].get<double>();
  const std::string chosen = test::fingerpad("replay s.toml --out o", folder).err;
  const std::string words = "proxy, because walls are ";
  ASSERT_THAT(chosen, HasSubstr(words));
  EXPECT_NEAR(std::stod(chosen.substr(chosen.find(words) + words.size())), wall_mm, 0.005 * wall_mm)
      << "told to three digits";
}

}  // namespace
}  // namespace fingerpad::outputs_test
