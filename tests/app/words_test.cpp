// Words of files and their names, which a terminal must not obey.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"

namespace fingerpad::words_test {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::ShellResult;
using testing::HasSubstr;
using testing::Not;

const std::string plane = "[[plane]]\npoint_m = [0, 0, 0.01]\nnormal = [0, 0, 1]\n";
const std::string points = "x_m,y_m,z_m\n0,0,0.012\n0.02,0,0\n";
constexpr const char* motion = "t_s,x_m,y_m,z_m\n0,0,0,0.009\n0.01,0.001,0,0.009\n0.02,0.002,0,0.009\n";

fs::path folder_with_inputs() {
  const fs::path folder = test::scratch_dir();
  const TriangleSoup box = test::box_soup({10, 20, 30});
  std::ofstream(folder / "box.stl") << test::text_stl(box);
  std::ofstream(folder / "m.csv") << motion;
  return folder;
}

/// `fingerpad ARGUMENTS`, ended with 124 if it takes a minute.
ShellResult run(const std::string& arguments, const fs::path& folder) {
  return test::shell("timeout 60 '" + test::program().string() + "' " + arguments, folder);
}

void expect_told(const ShellResult& result, int code, const std::string& words) {
  EXPECT_EQ(result.exit_code, code) << result.err;
  EXPECT_THAT(result.err, HasSubstr("fingerpad: error: "));
  EXPECT_THAT(result.err, HasSubstr(words));
}

const std::string nasty_name =
    "a\x1b[2Jb\nfingerpad: \xe2\x80\xae"
    "c";

/// Neither ESC nor any other control character but line ends, no marks of direction, nothing that is no
/// UTF-8.
void expect_plain(const std::string& told) {
  for (const char c : told)
    EXPECT_TRUE(c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f)) << told;
  EXPECT_THAT(told, Not(HasSubstr("\xe2\x80\xae")));
  EXPECT_THAT(told, Not(HasSubstr("\xe9")));
}

TEST(Words, OfPointsThatAreAllFarFromTheMeshDoubtTheirUnit) {
  const fs::path folder = folder_with_inputs();  // a box of 10 x 20 x 30 mm, 37 mm from corner to corner
  const auto told = [&](const std::string& points, const std::string& options = "") {
    std::ofstream(folder / "p.csv") << "x_m,y_m,z_m\n" << points;
    const ShellResult result = run("query box.stl p.csv" + options, folder);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr(options.empty() ? "distance_m" : ""));
    return result.err;
  };
  EXPECT_THAT(told("12,0,0\n0,-20,3\n"),
              HasSubstr("fingerpad: p.csv: all 2 points are 12 m or more from box.stl, "
                        "which is 0.0374 m large; points are in metres: are these in mm or cm or in?\n"));
  EXPECT_THAT(told("0.25,0.35,0.55\n"), HasSubstr("are these in in or cm or mm?\n")) << "the likeliest first";
  EXPECT_THAT(told("12,0,0\n", " --out o.csv"), HasSubstr("p.csv: its point is 12 m or more"));
  EXPECT_THAT(told("1e6,0,0\n"), HasSubstr("points are in metres (is --unit that of the mesh?)"));
  const auto no_doubt = Not(HasSubstr("points are in metres"));
  EXPECT_THAT(told("12,0,0\n0,0,0.02\n"), no_doubt) << "one is near";
  EXPECT_THAT(told("0.3,0,0\n"), no_doubt) << "ten times its size at most";
  EXPECT_THAT(told(""), no_doubt);
}

TEST(Words, OfATableWithoutPointsSaySo) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "p.csv") << "x_m,y_m,z_m\n";
  for (const char* options : {"", " --out o.csv"}) {
    const ShellResult result = run(std::string("query box.stl p.csv") + options, folder);
    EXPECT_EQ(result.exit_code, 0) << "it has its answer";
    EXPECT_THAT(result.err,
                HasSubstr("fingerpad: p.csv: has a header and no point below it, so the answer is a "
                          "header alone\n"));
  }
  EXPECT_EQ(test::bytes_of(folder / "o.csv"), "distance_m,px_m,py_m,pz_m,nx,ny,nz,triangle\n");
}

TEST(Words, OfACheckedSceneNameBodiesThatOverlap) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "s.toml")
      << "[[part]]\nmesh = \"box.stl\"\nunit = \"cm\"\n"
         "[[part]]\nmesh = \"box.stl\"\nunit = \"cm\"\nposition_m = [0.08, 0, 0]\n"
         "[[plane]]\npoint_m = [0, 0, -0.15]\nnormal = [0, 0, 1]\n";
  const ShellResult result = run("check s.toml", folder);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err,
              HasSubstr("fingerpad: s.toml: part 1 (box.stl) and part 2 (box.stl) overlap by 20 mm at ("));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << "they stand on the plane";
  EXPECT_THAT(result.out, HasSubstr("300")) << "mm: each part in its own unit";
  const auto parts = nlohmann::json::parse(run("check --json s.toml box.stl", folder).out);
  ASSERT_EQ(parts.size(), 3u);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(parts[i]["overlaps"].size(), 1u) << i;
    EXPECT_EQ(parts[i]["overlaps"][0]["with"], i == 0 ? "part 2 (box.stl)" : "part 1 (box.stl)");
    EXPECT_NEAR(parts[i]["overlaps"][0]["depth_m"].get<double>(), 0.02, 1e-6);
    EXPECT_EQ(parts[i]["overlaps"][0]["at_m"].size(), 3u);
  }
  EXPECT_FALSE(parts[2].contains("overlaps")) << "a mesh alone";
}

TEST(Words, OfACheckedSceneWithoutAMeshSayWhatItHas) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n");
  const ShellResult told = run("check floor.toml", folder);
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_EQ(told.out,
            "floor.toml: can be touched\n  1 plane and no mesh: there is none to look at\n"
            "floor.toml: has no [motion]: to touch and to view, not to replay\n");
  const auto report = nlohmann::json::parse(run("check floor.toml --json", folder).out);
  ASSERT_EQ(report.size(), 1u);
  EXPECT_EQ(report[0], nlohmann::json::parse(R"({"file": "floor.toml", "touchable": true, "error": "",
                                                 "overlaps": [], "motions": [], "warnings": []})"));
}

TEST(Words, OfACheckedSceneThatIsRefusedLetTheOthersBeTold) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "s.toml") << "[[part]]\nmesh = \"box.stl\"\n[[set]]\n"
                                      "friction.law = [\"nonsense\", \"coulomb\"]\n";
  const ShellResult result = run("check s.toml box.stl", folder);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("nonsense"));
  EXPECT_THAT(result.out, HasSubstr("box.stl: can be touched"));
  const ShellResult json = run("check s.toml box.stl --json", folder);
  EXPECT_EQ(json.exit_code, 3);
  EXPECT_THAT(json.out, HasSubstr("nonsense"));
  EXPECT_THAT(json.out, HasSubstr("\"touchable\": true"));
  for (const char* how : {"--unit m", "--repair"}) {
    const ShellResult unread = run(std::string("check s.toml ") + how, folder);
    EXPECT_EQ(unread.exit_code, 2);
    EXPECT_THAT(unread.err, HasSubstr("leave --unit and --repair out"));
  }
}

TEST(Words, OfFileNamesNeverReachATerminalRaw) {
  const fs::path folder = folder_with_inputs();
  for (const std::string& name : {nasty_name, std::string("caf\xe9")}) {
    const std::string shown = name == nasty_name ? "a\\x1b[2Jb\\nfingerpad: \\u202ec" : "caf\\xe9";
    std::ofstream(folder / (name + ".stl")) << test::text_stl(test::box_soup({10, 20, 30}));
    std::ofstream(folder / (name + ".csv")) << points << "\x1b,\xc2\x9b,\n";
    std::ofstream(folder / (name + ".toml")) << plane << "[motion]\nfile = \"m.csv\"\n";
    std::ofstream(folder / (name + ".off")) << "OFF\n1 1 1\n\x1b[31m\n";
    const std::string quoted = "'" + name;
    const ShellResult check = run("check " + quoted + ".stl' " + quoted + ".off' " + quoted + ".no'", folder);
    EXPECT_EQ(check.exit_code, 3);
    EXPECT_THAT(check.out, HasSubstr(shown + ".stl: can be touched"));
    EXPECT_THAT(check.err, HasSubstr("fingerpad: error: " + shown + ".off: line 3"));
    const ShellResult json = run("check --json " + quoted + ".stl'", folder);
    EXPECT_EQ(json.exit_code, 0);
    EXPECT_EQ(nlohmann::json::parse(json.out).size(), 1u);
    const ShellResult query = run("query box.stl " + quoted + ".csv'", folder);
    EXPECT_EQ(query.exit_code, 3);
    EXPECT_THAT(query.err, HasSubstr(shown + ".csv:4: '\\x1b' in column 'x_m'"));
    const ShellResult replay =
        run("replay " + quoted + ".toml' " + quoted + ".no.toml' --out " + quoted + "-out'", folder);
    EXPECT_EQ(replay.exit_code, 4) << replay.err;
    EXPECT_THAT(replay.out, HasSubstr("in " + shown + "-out\n"));
    const std::string summary = bytes_of(folder / (name + "-out") / "summary.csv");
    EXPECT_EQ(std::count(summary.begin(), summary.end(), '\n'), 3) << summary;
    const ShellResult exported = run("export " + quoted + "-out'/*.h5 --out " + quoted + "-e.csv'", folder);
    EXPECT_EQ(exported.exit_code, 0) << exported.err;
    const ShellResult usage = run("export x --out " + quoted + "'", folder);
    EXPECT_EQ(usage.exit_code, 2);
    for (const ShellResult* result : {&check, &json, &query, &replay, &exported, &usage}) {
      expect_plain(result->out);
      expect_plain(result->err);
    }
    expect_plain(summary);
  }
}

TEST(Words, OfAFileAreOneLineOfAMessage) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "key.toml") << plane << "[motion]\n\"a\\u001b[31m\\nfingerpad: error: no\" = 1\n";
  std::ofstream(folder / "mesh.toml")
      << "[[part]]\nmesh = \"no\\nfingerpad: error: \\u009b\\u202e.stl\"\n[motion]\nfile = \"m.csv\"\n";
  for (const char* scene : {"key.toml", "mesh.toml"}) {
    const ShellResult result = run(std::string("replay ") + scene + " --out o", folder);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.err.find("fingerpad: error:"), result.err.rfind("\nfingerpad: error:") + 1)
        << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    expect_plain(result.err);
  }
}

TEST(Words, ASetsGlobThatFindsANameThatIsNotUtf8SaysSo) {
  const fs::path folder = folder_with_inputs();
  std::ofstream(folder / "caf\xe9.stl") << test::text_stl(test::box_soup({10, 20, 30}));
  std::ofstream(folder / "set.toml") << "[[part]]\n[motion]\nfile = \"m.csv\"\n[[set]]\nmesh = \"*.stl\"\n";
  expect_told(run("replay set.toml --out o", folder), 3,
              "set.toml:5:8: '*.stl' matches caf\\xe9.stl, whose name is not UTF-8");
}

TEST(Words, ASceneCannotBeNamedLikeAnOptionOrAControl) {
  const fs::path folder = folder_with_inputs();
  for (const char* name : {"-rf", "a/b", "..", "a\\nb", "a\\u202eb", "a\\u009b"}) {
    SCOPED_TRACE(name);
    std::ofstream(folder / "n.toml") << "name = \"" << name << "\"\n"
                                     << plane << "[motion]\nfile = \"m.csv\"\n";
    expect_told(run("replay n.toml --out o", folder), 3, "n.toml:1:8: 'name' names the files");
  }
}

}  // namespace
}  // namespace fingerpad::words_test
