#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>

#include "support/effort.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"

// `replay --resume`: keeps what an earlier run finished of the very same batch, and nothing else.

namespace fingerpad::resume_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using test::ShellResult;
using testing::HasSubstr;
using testing::Not;

std::string box_off(double size_mm) {
  const std::string s = std::to_string(size_mm);
  return "OFF\n8 12 0\n0 0 0\n" + s + " 0 0\n" + s + " " + s + " 0\n0 " + s + " 0\n0 0 10\n" + s + " 0 10\n" +
         s + " " + s + " 10\n0 " + s +
         " 10\n3 0 3 2\n3 0 2 1\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 "
         "0 4\n"
         "3 3 4 7\n";
}

std::string rub_csv(double depth_m) {
  std::string text = "t_s,x_m,y_m,z_m\n";
  for (int i = 0; i <= 100; ++i) {
    text += std::to_string(i * 0.002) + "," + std::to_string(0.002 + 5e-5 * i) + ",0.005," +
            std::to_string(0.01 - depth_m) + "\n";
  }
  return text;
}

std::string profile_toml(double axis_m) {
  return "lateral_axis_m = " + std::to_string(axis_m) +
         "\nlongitudinal_axis_m = 0.002\nlateral_slope_per_deg = 0.005\nlongitudinal_slope_per_deg = 0.005\n"
         "source = \"made for this test\"\n";
}

/// What a scene's author can change.
struct Choices {
  std::string law = "finger-pad", method = "proxy", normals = "smooth";
  double stiffness = 1000;
};

void write_scene(const fs::path& folder, const Choices& choices) {
  std::ofstream(folder / "s.toml") << "name = \"s\"\n[[part]]\nmesh = \"box.off\"\nstiffness_n_per_m = "
                                   << choices.stiffness << "\n[contact]\nmethod = \"" << choices.method
                                   << "\"\nnormals = \"" << choices.normals << "\"\n[friction]\nlaw = \""
                                   << choices.law
                                   << "\"\n[finger]\nprofile = \"pad.toml\"\n[motion]\nfile = \"rub.csv\"\n";
}

fs::path folder_with_scene(const Choices& choices) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "box.off") << box_off(10);
  std::ofstream(folder / "rub.csv") << rub_csv(0.0005);
  std::ofstream(folder / "pad.toml") << profile_toml(0.002);
  write_scene(folder, choices);
  return folder;
}

ShellResult replay(const fs::path& folder, const std::string& rest) {
  ShellResult result = test::fingerpad("replay s.toml " + rest, folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result;
}

class Resume : public testing::TestWithParam<const char*> {
 protected:
  const std::string format = std::string(" --format ") + GetParam();
  const std::string trace = std::string("s.") + GetParam();
};

TEST_P(Resume, KeepsNothingOldAfterAnyChange) {
  struct Change {
    const char* what;
    std::function<void(const fs::path&)> make;
    const char* told;
    const char* of_hdf5 = "";  // which keeps its scene
  };
  const std::vector<Change> changes = {
      {"law", [](const fs::path& f) { write_scene(f, {.law = "coulomb"}); }, "the scene has",
       ": law finger-pad; now law coulomb"},
      {"contact", [](const fs::path& f) { write_scene(f, {.method = "closest-point", .normals = "facet"}); },
       "the scene has", ": method proxy, normals smooth; now method closest-point, normals facet"},
      {"stiffness", [](const fs::path& f) { write_scene(f, {.stiffness = 700}); }, "the scene has",
       ": stiffness_n_per_m 1000; now stiffness_n_per_m 700"},
      {"mesh", [](const fs::path& f) { std::ofstream(f / "box.off") << box_off(4); }, "a mesh file has"},
      {"motion", [](const fs::path& f) { std::ofstream(f / "rub.csv") << rub_csv(0.0007); },
       "the motion has"},
      {"profile", [](const fs::path& f) { std::ofstream(f / "pad.toml") << profile_toml(0.0012); },
       "the profile has"},
  };
  for (const Change& change : changes) {
    const fs::path folder = folder_with_scene({});
    replay(folder, "--out out" + format);
    const std::string before = bytes_of(folder / "out" / trace);
    change.make(folder);
    EXPECT_THAT(replay(folder, "--out out --resume" + format).err,
                HasSubstr("fingerpad: out: no trace was kept: 1 of 1 job was made again: " +
                          std::string(change.told) + " changed since" +
                          (GetParam() == std::string("h5") ? change.of_hdf5 : "") + "\n"))
        << change.what;
    replay(folder, "--out fresh" + format);
    EXPECT_NE(bytes_of(folder / "fresh" / trace), before) << change.what << ": shows in the trace";
    EXPECT_TRUE(bytes_of(folder / "fresh" / trace) == bytes_of(folder / "out" / trace)) << change.what;
    EXPECT_EQ(bytes_of(folder / "fresh" / "summary.csv"), bytes_of(folder / "out" / "summary.csv"))
        << change.what;
  }
}

TEST_P(Resume, KeepsAFinishedTraceAndItsFigures) {
  const fs::path folder = folder_with_scene({});
  replay(folder, "--out out" + format);
  const auto made = fs::last_write_time(folder / "out" / trace);
  const std::string summary = bytes_of(folder / "out" / "summary.csv");
  const ShellResult again = replay(folder, "--out out --resume" + format);
  EXPECT_EQ(again.out, "1 of 1 job done (1 kept from before), traces and summary.csv in out\n");
  EXPECT_THAT(again.err, Not(HasSubstr("made again")));
  EXPECT_EQ(fs::last_write_time(folder / "out" / trace), made);
  EXPECT_EQ(bytes_of(folder / "out" / "summary.csv"), summary);
}

TEST_P(Resume, KeepsAFinishedTraceInWhichARemedyActed) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[friction]\nlaw = "
         "\"stick-slip\"\n"
         "stick_stiffness_per_m = 1e5\nremedy = \"cap\"\n[hand]\nmass_kg = 0.01\n[motion]\nkind = \"sine\"\n"
         "centre_m = [0, 0, -0.001]\ndirection = [1, 0, 0]\namplitude_m = 0.001\nfrequency_hz = 1\n"
         "duration_s = 0.3\n";
  EXPECT_THAT(replay(folder, "--out out" + format).err, HasSubstr("friction.remedy acted"));
  const std::string summary = bytes_of(folder / "out" / "summary.csv");
  const auto again = replay(folder, "--out out --resume" + format);
  EXPECT_THAT(again.out, HasSubstr("1 kept from before"));
  EXPECT_THAT(again.err, HasSubstr("friction.remedy acted"));
  EXPECT_EQ(bytes_of(folder / "out" / "summary.csv"), summary) << "remedied_ticks among the figures";
}

TEST_P(Resume, MakesATraceAgainThatIsNotWhatWasWritten) {
  const fs::path folder = folder_with_scene({});
  replay(folder, "--out out" + format);
  const fs::path path = folder / "out" / trace;
  const std::string whole = bytes_of(path);
  const auto expect_whole_again = [&](const char* what) {
    const bool is_there = fs::exists(path);
    const std::string told = replay(folder, "--out out --resume" + format).err;
    EXPECT_TRUE(bytes_of(path) == whole) << what;
    EXPECT_EQ(told.find("made again: it is not, byte for byte, what was written\n") != std::string::npos,
              is_there)
        << told;
  };
  // An HDF5 trace ends with a seal of 32 bytes; a run may be killed just before it is written.
  fs::resize_file(path, whole.size() - 32);
  expect_whole_again("cut short");
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(5000) << '7';
  expect_whole_again("a byte changed");
  fs::resize_file(path, 0);
  expect_whole_again("empty");
  fs::remove(path);
  expect_whole_again("gone");
}

TEST_P(Resume, CleansUpWhatAKilledRunLeft) {
  const fs::path folder = folder_with_scene({});
  replay(folder, "--out out" + format);
  const fs::path proof = folder / "out" / ".fingerpad" / (trace + ".proof");
  ASSERT_TRUE(fs::exists(proof));
  const std::string proven = bytes_of(proof);
  for (const bool proof_too : {false, true}) {
    for (const std::string& left : {trace, std::string("summary.csv"), std::string("timing.csv")})
      std::ofstream(folder / "out" / (left + ".part")) << "half";
    std::ofstream(proof.string() + ".part") << "half";
    if (proof_too) std::ofstream(proof) << proven.substr(0, proven.size() / 2);
    replay(folder, "--out out --resume" + format);
    for (const auto& entry : fs::recursive_directory_iterator(folder / "out"))
      EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  }
}

INSTANTIATE_TEST_SUITE_P(Hdf5, Resume, testing::Values("h5"));
INSTANTIATE_TEST_SUITE_P(Csv, Resume, testing::Values("csv"));

// A ball that jumps about on a sphere of 81,920 facets, where its proxy lags: that is in no trace, and
// is told all the same where the proof is gone.
TEST(ResumeWithoutAProof, TellsWhereAProxyLagged) {
  if (!test::forks_beside_threads()) GTEST_SKIP() << "a trace without proof is read by a child";
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "ball.stl") << test::text_stl(test::sphere_soup(0.05, 6));
  std::ofstream motion(folder / "m.csv");
  motion << "t_s,x_m,y_m,z_m\n";
  for (int k = 0; k < 200; ++k) {
    const double turn = 2.2 * (k / 10);
    motion << 0.001 * k << ',' << 0.049 * std::cos(turn) << ',' << 0.049 * std::sin(turn) << ",0\n";
  }
  motion.close();
  std::ofstream(folder / "s.toml") << "name = \"s\"\n[[part]]\nmesh = \"ball.stl\"\nunit = \"m\"\n[contact]\n"
                                      "method = \"proxy\"\n[finger]\nradius_m = 0.02\n[motion]\nfile = "
                                      "\"m.csv\"\nrate_hz = 1000\n";
  replay(folder, "--out out");
  const std::string summary = bytes_of(folder / "out" / "summary.csv");
  const auto column = [&summary](const std::string& name) {
    std::istringstream lines(summary);
    std::string header, row, cell;
    std::getline(lines, header);
    std::getline(lines, row);
    std::istringstream names(header), cells(row);
    for (std::string one; std::getline(names, one, ',') && std::getline(cells, cell, ',');)
      if (one == name) return cell;
    return std::string();
  };
  ASSERT_GT(std::stoi(column("unsettled_ticks")), 0) << summary;
  fs::remove_all(folder / "out" / ".fingerpad");
  fs::remove(folder / "out" / "summary.csv");
  EXPECT_THAT(replay(folder, "--out out --resume").out, HasSubstr("1 kept from before"));
  EXPECT_EQ(bytes_of(folder / "out" / "summary.csv"), summary);
}

TEST(ResumeWithAProofOfAnotherRun, MakesTheTraceAgain) {
  const fs::path folder = folder_with_scene({});
  replay(folder, "--out out");
  const fs::path proof = folder / "out" / ".fingerpad" / "s.h5.proof";
  const std::string proven = bytes_of(proof);
  std::string other = proven;  // as another build of this version would have written it
  const std::size_t run = other.find("run ") + 4;
  other[run] = other[run] == '0' ? '1' : '0';
  std::ofstream(proof, std::ios::binary) << other;
  const auto again = replay(folder, "--out out --resume");
  EXPECT_THAT(again.out, Not(HasSubstr("kept")));
  EXPECT_THAT(again.err, Not(HasSubstr("another build"))) << "the scene may have been another";
  EXPECT_EQ(bytes_of(proof), proven);
}

TEST(ResumeWithOtherColumns, SaysThatTheOptionsAreOthers) {
  const fs::path folder = folder_with_scene({});
  replay(folder, "--out out");
  EXPECT_THAT(
      replay(folder, "--out out --resume --every 2").err,
      HasSubstr("1 of 1 job was made again: the format, --columns, --every or --compress is another now"));
  EXPECT_THAT(replay(folder, "--out out --resume --quiet").err, Not(HasSubstr("made again")));
}

TEST(ResumeWithANumberWrittenOtherwise, SaysThatNoKeyHasAnotherValue) {
  const fs::path folder = folder_with_scene({});
  replay(folder, "--out out");
  std::string text = bytes_of(folder / "s.toml");
  text.replace(text.find("= 1000\n"), 7, "= 1000.0\n");
  std::ofstream(folder / "s.toml") << text;
  EXPECT_THAT(
      replay(folder, "--out out --resume").err,
      HasSubstr("made again: the scene has changed since, though none of its keys has another value\n"));
}

TEST(ResumeOfASetThatHasBecomeLonger, TellsAFewOfManyReasons) {
  const fs::path folder = folder_with_scene({});
  const auto add_set = [&](const std::string& seeds) {
    write_scene(folder, {});
    std::ofstream(folder / "s.toml", std::ios::app) << "[[set]]\nseed = [" + seeds + "]\n";
  };
  add_set("1, 2, 3, 4, 5, 6, 7");
  replay(folder, "--out out");
  add_set("2, 3, 4, 5, 6, 7, 8");
  const std::string told = replay(folder, "--out out --resume").err;
  EXPECT_THAT(told,
              HasSubstr("1 of 7 jobs was made again: the scene has changed since: seed 1; now seed 2\n"));
  EXPECT_THAT(told, HasSubstr("now seed 6\nfingerpad: out: and 2 more of them for other reasons\n"));
}

/// A set of three jobs, of which two traces are there as another build would have left them.
TEST(ResumeAfterAnotherBuild, SaysWhichBuildAndHowManyJobsAreMadeAgain) {
  const fs::path folder = folder_with_scene({});
  std::ofstream(folder / "s.toml", std::ios::app) << "[[set]]\nseed = [1, 2, 3]\n";
  replay(folder, "--out out");
  const std::string summary = bytes_of(folder / "out" / "summary.csv");
  EXPECT_THAT(replay(folder, "--out out --resume").err, Not(HasSubstr("build")));
  for (const char* job : {"1", "3"}) {
    const fs::path proof = folder / "out" / ".fingerpad" / (std::string("s-000") + job + ".h5.proof");
    std::string text = bytes_of(proof);
    const std::size_t run = text.find("\nrun ") + 5, build = text.find("\nbuild ") + 7;
    ASSERT_LT(build, text.size());
    text.replace(run, 4, "~~~~").replace(build, 12, "0123456789ab");
    std::ofstream(proof, std::ios::binary) << text;
  }
  const auto again = replay(folder, "--out out --resume");
  EXPECT_THAT(again.out, HasSubstr("3 of 3 jobs done (1 kept from before)"));
  EXPECT_THAT(again.err,
              HasSubstr("fingerpad: out: holds traces of another build of the program (0123456789ab; "
                        "this one is "));
  EXPECT_THAT(
      again.err,
      HasSubstr("fingerpad: warning: out: 2 of 3 jobs were made again: it was made by another build of the "
                "program (0123456789ab; this one is "));
  EXPECT_EQ(bytes_of(folder / "out" / "summary.csv"), summary);
  EXPECT_THAT(replay(folder, "--out out --resume").err, Not(HasSubstr("build")))
      << "all are this build's again";
}

TEST(ResumeWithoutProof, TakesAnHdf5TraceAtItsWordAndMakesACsvAgain) {
  if (!test::forks_beside_threads()) GTEST_SKIP() << "a trace without proof is read by a child";
  const fs::path folder = folder_with_scene({});
  for (const std::string& format : std::vector<std::string>{"h5", "csv"}) {
    replay(folder, "--out out --format " + format);
    const std::string summary = bytes_of(folder / "out" / "summary.csv");
    const std::string proof = bytes_of(folder / "out" / ".fingerpad" / ("s." + format + ".proof"));
    fs::remove_all(folder / "out" / ".fingerpad");
    const auto again = replay(folder, "--out out --resume --format " + format);
    EXPECT_EQ(again.out.find("kept") != std::string::npos, format == "h5") << again.out;
    EXPECT_EQ(bytes_of(folder / "out" / "summary.csv"), summary) << "counted again";
    EXPECT_EQ(bytes_of(folder / "out" / ".fingerpad" / ("s." + format + ".proof")), proof);
  }
}

}  // namespace
}  // namespace fingerpad::resume_test
