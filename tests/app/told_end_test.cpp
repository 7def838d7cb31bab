#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"

// What a person is told unasked: a part in the wrong unit, and what went wrong in runs that are done.

namespace fingerpad::told_end_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

constexpr const char* rub =
    "[motion]\nkind = \"line\"\nfrom_m = [0, 0, 0.0149]\nto_m = [0.01, 0, 0.0149]\nspeed_m_per_s = 0.1\n";
constexpr const char* laid =
    "[motion]\nkind = \"on_surface\"\nsize_m = 0.005\nspeed_m_per_s = 0.1\nnormal_force_n = 1\n";

/// A box of 50 mm as a file in metres.
fs::path folder_with_box() {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "box.stl", test::binary_stl(test::box_soup({0.05, 0.05, 0.03})));
  return folder;
}

std::string box_scene(const std::string& unit, const std::string& motion) {
  return "name = \"s\"\n[[part]]\nmesh = \"box.stl\"\nunit = \"" + unit + "\"\n" + motion;
}

TEST(UnlikelyUnit, IsToldByAllThatTouchAPart) {
  const fs::path folder = folder_with_box();
  test::write_file(folder, "s.toml", box_scene("mm", rub));
  test::write_file(folder, "laid.toml", box_scene("mm", laid));
  test::write_file(folder, "p.csv", "x_m,y_m,z_m\n0,0,0\n");
  const auto told =
      HasSubstr("box.stl: is 0.05 mm long; --unit m (in a scene: unit = \"m\") reads it as 50 mm\n");
  struct Call {
    const char* arguments;
    int code;
  };
  for (const Call& call :
       {Call{"replay s.toml --out o", 0}, Call{"replay s.toml --out o --resume", 0},
        Call{"replay laid.toml --out o2", 3}, Call{"query box.stl p.csv", 0}, Call{"check box.stl", 0},
#ifdef FINGERPAD_VIEW
        Call{"view box.stl --png v.png", 0}, Call{"view s.toml --png v.png", 0},
#endif
        Call{"touch s.toml --headless --device recorded --seconds 0.1", 0}}) {
    const auto result = test::fingerpad(call.arguments, folder);
    EXPECT_EQ(result.exit_code, call.code) << call.arguments << result.err;
    EXPECT_THAT(result.err, told) << call.arguments;
  }
  const auto checked = nlohmann::json::parse(test::fingerpad("check box.stl --json", folder).out);
  EXPECT_THAT(checked[0]["hint"].get<std::string>(), HasSubstr("is 0.05 mm long"));
  EXPECT_THAT(test::fingerpad("query box.stl p.csv --unit m", folder).err, Not(HasSubstr("long;")));
  test::write_file(folder, "s.toml", box_scene("m", rub));
  EXPECT_THAT(test::fingerpad("replay s.toml --out o", folder).err, Not(HasSubstr("long;")));
}

#ifdef FINGERPAD_VIEW
TEST(UnlikelyUnit, StandsInTheSummaryAndAmongTheReportsTroubles) {
  const fs::path folder = folder_with_box();
  test::write_file(folder, "s.toml", box_scene("mm", rub) + "[[set]]\nseed = [1, 2]\n");
  const std::string hint = "box.stl: is 0.05 mm long; --unit m (in a scene: unit = \"m\") reads it as 50 mm";
  for (const char* options : {"", " --resume"}) {
    ASSERT_EQ(test::fingerpad(std::string("replay s.toml --quiet --out o") + options, folder).exit_code, 0);
    const std::string rows = test::bytes_of(folder / "o/summary.csv");
    EXPECT_THAT(rows, HasSubstr("(in a scene: unit = \"\"m\"\") reads it as 50 mm / s: "))
        << "and never touches";
  }
  ASSERT_EQ(test::fingerpad("report o --quiet --out page.html", folder).exit_code, 0);
  std::string quoted = hint;
  for (std::size_t at = 0; (at = quoted.find('"', at)) != std::string::npos; at += 2)
    quoted.insert(at, 1, '\\');
  EXPECT_THAT(test::bytes_of(folder / "page.html"), HasSubstr("\"trouble\":\"" + quoted));
}
#endif

TEST(ReplayTells, PopThroughsWithTheirJobsAndWhatHoldsThem) {
  const fs::path folder = test::scratch_dir();
  const std::string thin =
      "replay '" + (test::source_dir() / "scenes/gallery/thin_plate.toml").string() + "' --out ";
  EXPECT_THAT(
      test::fingerpad(thin + "all --quiet", folder).err,
      HasSubstr("fingerpad: warning: 2 pop-throughs in 2 jobs (1, 3): the finger went through a wall, or "
                "was pushed out on its far side (pop_throughs in summary.csv); contact.method = \"proxy\" "
                "holds it\n"));
  EXPECT_THAT(test::fingerpad(thin + "one --shard 1/4", folder).err,
              HasSubstr("fingerpad: warning: 1 pop-through in job 1: "));
  EXPECT_THAT(test::fingerpad(thin + "none --shard 2/4", folder).err,
              AllOf(Not(HasSubstr("pop-through")), Not(HasSubstr("unsettled"))));
}

// A ball in a finely meshed hollow that just fits it is near more triangles than a tick may look at.
TEST(ReplayTells, UnsettledTicks) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "hollow.stl", test::binary_stl(test::reversed(test::sphere_soup(0.0072, 5))));
  test::write_file(folder, "hollow.toml",
                   "[[part]]\nmesh = \"hollow.stl\"\nunit = \"m\"\n[contact]\nmethod = \"proxy\"\nnormals = "
                   "\"facet\"\n[finger]\nradius_m = 0.007\n[motion]\nkind = \"circle\"\ncentre_m = [0, 0, "
                   "0]\nradius_m = 0.0006\nfrequency_hz = 2\nduration_s = 0.25\n");
  const auto result = test::fingerpad("replay hollow.toml --out o", folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err,
              MatchesRegex("(.|\n)*fingerpad: warning: [0-9]+ unsettled ticks in hollow: the proxy "
                           "lags behind there(.|\n)*unsettled_ticks in summary.csv(.|\n)*"));
}

// In a narrow valley each of two walls presses 1 / (2 sin of the half angle) times as hard as the finger.
TEST(ReplayTells, ARubThatPressesFarHarderThanAsked) {
  const fs::path folder = test::scratch_dir();
  const auto told_of_roof = [&](double turn_deg) {
    test::write_file(folder, "roof.stl", test::binary_stl(test::roof_soup(0.012, turn_deg * M_PI / 180)));
    test::write_file(folder, "roof.toml",
                     "[[part]]\nmesh = \"roof.stl\"\nunit = \"m\"\n[contact]\nmethod = "
                     "\"proxy\"\n[motion]\nkind = \"on_surface\"\nshape = \"circle\"\nsize_m = "
                     "0.004\nspeed_m_per_s = 0.05\nnormal_force_n = 1\n[[set]]\nmotion.place = { from = 0, "
                     "to = 11, steps = 12 }\n");
    const auto result = test::fingerpad("replay roof.toml --out o --format none", folder);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.err + test::bytes_of(folder / "o/summary.csv");
  };
  const std::string told =
      told_of_roof(-156);  // half of what is left of 180 degrees is 12: 1 / sin 12 deg = 4.81
  EXPECT_THAT(
      told,
      HasSubstr("fingerpad: warning: the normal force is up to 4.81 N where 1 N is asked for, in 3 jobs "
                "(1, 5, 9): several walls or edges hold the finger there (max_normal_force_n"));
  EXPECT_THAT(told, HasSubstr(",the normal force is up to 4.81 N where 1 N is asked for\n"))
      << "in the summary";
  EXPECT_THAT(told_of_roof(-90), Not(HasSubstr("is asked for")));
}

TEST(Failures, OfSeveralSetsNameSetAndJobAndTheSceneWhoseMeshIsMissing) {
  const fs::path folder = folder_with_box();
  for (const std::string name : {"a", "b"})
    test::write_file(
        folder, name + ".toml",
        "[[part]]\nunit = \"m\"\n" + std::string(rub) + "[[set]]\nmesh = [\"box.stl\", \"gone.stl\"]\n");
  const auto two = test::fingerpad("replay a.toml b.toml --out o", folder);
  EXPECT_EQ(two.exit_code, 4);
  EXPECT_THAT(two.err,
              HasSubstr("error: job a-0002: a.toml: [[part]] mesh names gone.stl, which cannot be read"));
  EXPECT_THAT(two.err, HasSubstr("error: job b-0002: b.toml: "));
  EXPECT_THAT(test::fingerpad("replay a.toml --out one", folder).err, HasSubstr("error: job 2: a.toml: "));
}

TEST(DryRun, OfASceneThatWouldFailEndsAsItsReplay) {
  const fs::path folder = folder_with_box();
  test::write_file(folder, "s.toml", box_scene("m", "[motion]\nfile = \"none.csv\"\n"));
  const auto alone = test::fingerpad("replay s.toml --out o --dry-run", folder);
  EXPECT_EQ(alone.exit_code, test::fingerpad("replay s.toml --out o", folder).exit_code);
  EXPECT_EQ(alone.exit_code, 3);
  EXPECT_THAT(alone.out, HasSubstr("the job would fail; nothing was written\n"));
  test::write_file(folder, "set.toml",
                   box_scene("m", rub) + "[[set]]\nmotion = [\"none.csv\", \"neither.csv\"]\n");
  const auto set = test::fingerpad("replay set.toml --out o --dry-run", folder);
  EXPECT_EQ(set.exit_code, 4);
  EXPECT_THAT(set.out, HasSubstr("all 2 jobs would fail; nothing was written\n"));
}

TEST(DryRun, OfAShardWithoutJobsFailsInNothing) {
  const fs::path folder = folder_with_box();
  test::write_file(folder, "s.toml", box_scene("mm", rub));
  const auto empty = test::fingerpad("replay s.toml --out o --shard 2/2 --dry-run", folder);
  EXPECT_EQ(empty.exit_code, 0) << empty.out << empty.err;
  EXPECT_THAT(empty.out, Not(HasSubstr("would fail")));
}

TEST(WrongValues, AreToldByOptionAndWord) {
  const fs::path folder = folder_with_box();
  test::write_file(folder, "s.toml", box_scene("m", rub));
  ASSERT_EQ(test::fingerpad("replay s.toml --out o --quiet", folder).exit_code, 0);
  struct Call {
    const char* arguments;
    int code;
    const char* words;
  };
  for (const Call& call :
       {Call{"compare o o --tolerance -1", 2, "error: --tolerance: is -1; it must be 0 or more\n"},
        Call{"compare o o --tolerance x", 2, "error: --tolerance: 'x' is no number\n"},
        Call{"compare o absent", 3, "error: absent: cannot be read: there is no such folder\n"},
        Call{"compare s.toml o", 3, "error: s.toml: cannot be read: is a file, not a folder\n"},
        Call{"merge absent/ --out m", 3, "error: absent/: cannot be read: there is no such folder\n"},
#ifdef FINGERPAD_VIEW
        Call{"view o/s.h5 --png a.png --at soon", 2, "error: --at: 'soon' is no number\n"},
        Call{"plot o/s.h5 --out a.svg --from 7", 3,
             "error: --from: 7 s leaves nothing of o/s.h5, which goes from 0 "
             "to 0.1 s\n"},
        Call{"plot s.toml --out a.svg", 3,
             "error: s.toml: is a scene, not a trace: `fingerpad replay` makes one"},
#endif
        Call{"export s.toml --out a.csv", 3, "error: s.toml: is a scene, not a trace"}}) {
    const auto result = test::fingerpad(call.arguments, folder);
    EXPECT_EQ(result.exit_code, call.code) << call.arguments;
    EXPECT_THAT(result.err, HasSubstr(call.words));
  }
}

}  // namespace
}  // namespace fingerpad::told_end_test
