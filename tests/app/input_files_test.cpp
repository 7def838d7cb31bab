// Files that are no files, streams, and outputs without a place, through the program itself. A regression
// would hang: every call has a watchdog, whose exit code is 124.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"

namespace fingerpad::input_files_test {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::ShellResult;
using testing::HasSubstr;
using testing::StartsWith;

const std::string plane = "[[plane]]\npoint_m = [0, 0, 0.01]\nnormal = [0, 0, 1]\n";
const std::string points = "x_m,y_m,z_m\n0,0,0.012\n0.02,0,0\n";
constexpr const char* motion = "t_s,x_m,y_m,z_m\n0,0,0,0.009\n0.01,0.001,0,0.009\n0.02,0.002,0,0.009\n";

fs::path folder_with_inputs() {
  const fs::path folder = test::scratch_dir();
  const TriangleSoup box = test::box_soup({10, 20, 30});
  std::ofstream(folder / "box.stl") << test::text_stl(box);
  std::ofstream(folder / "box.obj") << test::obj_text(box);
  std::ofstream(folder / "box.ply") << test::ply_text(box);
  std::ofstream(folder / "box.off") << test::off_text(box);
  std::ofstream(folder / "points.csv") << points;
  std::ofstream(folder / "m.csv") << motion;
  std::ofstream(folder / "s.toml") << "name = \"s\"\n" << plane << "[motion]\nfile = \"m.csv\"\n";
  return folder;
}

/// `fingerpad ARGUMENTS`, ended with 124 if it takes a minute. @param before  what stands before it, a pipe
ShellResult run(const std::string& arguments, const fs::path& folder, const std::string& before = "") {
  return test::shell(before + "timeout 60 '" + test::program().string() + "' " + arguments, folder);
}

void expect_told(const ShellResult& result, int code, const std::string& words) {
  EXPECT_EQ(result.exit_code, code) << result.err;
  EXPECT_THAT(result.err, HasSubstr("fingerpad: error: "));
  EXPECT_THAT(result.err, HasSubstr(words));
}

/// Every way by which an input comes in, with X in its place, and how it is told when it is no file. The
/// scenes are written by the test.
const std::vector<std::string>& calls_with_an_input() {
  static const std::vector<std::string> calls{"query box.stl X",
                                              "query X points.csv",
                                              "check X",
                                              "replay X --out o",
                                              "replay motion.toml --out o",
                                              "replay mesh.toml --out o",
                                              "replay profile.toml --out o",
                                              "export X --out o.csv",
                                              "study contact --exact exact --out o",
#ifdef FINGERPAD_VIEW
                                              "plot X --out o.png",
                                              "view X --png o.png"
#endif
  };
  return calls;
}

void expect_refused_everywhere(const std::string& file, const std::string& words) {
  const fs::path folder = folder_with_inputs();
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  fs::create_directory(folder / "folder");
  fs::create_symlink("loop", folder / "loop");
  fs::create_directory(folder / "exact");
  fs::create_symlink(file.starts_with('/') ? file : "../" + file, folder / "exact" / "meshes.csv");
  std::ofstream(folder / "motion.toml") << plane << "[motion]\nfile = \"" << file << "\"\n";
  std::ofstream(folder / "mesh.toml") << "[[part]]\nmesh = \"" << file << "\"\n[motion]\nfile = \"m.csv\"\n";
  std::ofstream(folder / "profile.toml") << plane << "[finger]\nprofile = \"" << file << "\"\n";
  for (std::string call : calls_with_an_input()) {
    const std::size_t place = call.find('X');
    if (place != std::string::npos) call.replace(place, 1, file);
    SCOPED_TRACE(call);
    expect_told(run(call, folder), 3, words);
  }
}

TEST(InputFiles, APipeIsRefusedWhereverAFileShouldStand) {
  expect_refused_everywhere("pipe", "is a pipe, not a regular file");
}

TEST(InputFiles, ADeviceIsRefusedWhereverAFileShouldStand) {
  expect_refused_everywhere("/dev/zero", "is a device, not a regular file");
}

TEST(InputFiles, AFolderIsRefusedWhereverAFileShouldStand) {
  expect_refused_everywhere("folder", "is a folder, not a");
}

TEST(InputFiles, ALinkLoopIsRefusedWhereverAFileShouldStand) {
  expect_refused_everywhere("loop", "leads back to itself");
}

TEST(InputFiles, AFileInTheFoldersPlaceIsTold) {
  expect_refused_everywhere("m.csv/x", "a file, not a folder");
}

TEST(Streams, PointsAndMeshesComeFromStandardInputAndFromPipesOfTheShell) {
  const fs::path folder = folder_with_inputs();
  const std::string table = run("query box.stl points.csv", folder).out;
  ASSERT_THAT(table, StartsWith("distance_m,"));
  EXPECT_EQ(run("query box.stl - < points.csv", folder).out, table);
  EXPECT_EQ(run("query box.stl /dev/stdin", folder, "cat points.csv | ").out, table);
  EXPECT_EQ(run("query box.stl <(cat points.csv)", folder).out, table);
  EXPECT_EQ(run("query box.stl points.csv --out -", folder).out, table);
  EXPECT_EQ(run("query box.obj points.csv --out /dev/stdout | cat", folder).out,
            run("query box.obj points.csv", folder).out);
  for (const char* mesh : {"box.stl", "box.obj", "box.ply", "box.off"}) {
    SCOPED_TRACE(mesh);
    const std::string cat = std::string("cat ") + mesh + " | ";
    const std::string of_file = run(std::string("query ") + mesh + " points.csv", folder).out;
    EXPECT_EQ(run("query - points.csv", folder, cat).out, of_file);
    const std::string verdict = run(std::string("check ") + mesh, folder).out;
    EXPECT_EQ(run("check -", folder, cat).out, "-" + verdict.substr(verdict.find(':')));
  }
  expect_told(run("check -", folder, "echo hello | "), 3, "no mesh that its first words tell");
  expect_told(run("query - -", folder, "cat box.stl | "), 2, "cannot be both the mesh and the points");
}

TEST(Streams, TracesGoThroughPipes) {
  const fs::path folder = folder_with_inputs();
  ASSERT_EQ(run("replay s.toml --out o --quiet", folder).exit_code, 0);
  ASSERT_EQ(run("export o/s.h5 --out o/s.csv", folder).exit_code, 0);
  const std::string table = bytes_of(folder / "o" / "s.csv");
  EXPECT_EQ(run("export o/s.h5 --out -", folder).out, table);
  EXPECT_EQ(run("export - --out -", folder, "cat o/s.csv | ").out, table);
  expect_told(run("export - --out -", folder, "cat o/s.h5 | "), 3, "cannot be read from a stream");
  const ShellResult full = run("export o/s.h5 --out - > /dev/full", folder);
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.err, HasSubstr("standard output: cannot be written: No space left on device"));
}

TEST(Streams, ASceneFromStandardInputFindsItsFilesInTheCurrentFolder) {
  const fs::path folder = folder_with_inputs();
  ASSERT_EQ(run("replay s.toml --out a --quiet", folder).exit_code, 0);
  ASSERT_EQ(run("replay - --out b --quiet", folder, "cat s.toml | ").exit_code, 0);
  EXPECT_EQ(bytes_of(folder / "a" / "s.h5"), bytes_of(folder / "b" / "s.h5"));
  const ShellResult unnamed = run("replay <(tail -n +2 s.toml) --out c --quiet", folder);
  EXPECT_EQ(unnamed.exit_code, 0) << unnamed.err;
  EXPECT_TRUE(fs::exists(folder / "c" / "scene.h5"));
  std::ofstream(folder / "dash.toml") << plane << "[motion]\nfile = \"-\"\n";
  expect_told(run("replay dash.toml --out d --quiet < m.csv", folder), 3, "read more than once");
}

TEST(Streams, WithoutAnEndAreReadToALimit) {
  const fs::path folder = folder_with_inputs();
  expect_told(run("query box.stl - < /dev/zero", folder), 3, "is a line of over 1 MiB");
  expect_told(run("query box.stl -", folder, "yes | "), 3, "no column 'x_m'");
  expect_told(run("replay - --out o", folder, "yes '#' | "), 3, "does not end within 4 MiB");
  expect_told(run("export /dev/stdin --out - < /dev/zero", folder), 3, "is a line of over 1 MiB");
}

TEST(OutputPlaces, AreToldBeforeTheWork) {
  const fs::path folder = folder_with_inputs();
  ASSERT_EQ(run("replay s.toml --out o --quiet", folder).exit_code, 0);
  ASSERT_EQ(mkfifo((folder / "pipe.csv").c_str(), 0600), 0);
  fs::create_directory(folder / "folder.csv");
  fs::create_symlink("loop.csv", folder / "loop.csv");
  for (const char* call : {"query box.stl points.csv --out ", "export o/s.h5 --out "}) {
    SCOPED_TRACE(call);
    expect_told(run(std::string(call) + "folder.csv", folder), 2, "is a folder: name a file in it");
    expect_told(run(std::string(call) + "no/o.csv", folder), 2, "its folder no is not there");
    expect_told(run(std::string(call) + "m.csv/o.csv", folder), 2, "m.csv is a file, not a folder");
    expect_told(run(std::string(call) + "loop.csv", folder), 2, "leads back to itself");
    expect_told(run(std::string(call) + "pipe.csv", folder), 1, "is a pipe that nobody reads");
    const ShellResult read = run(std::string(call) + "pipe.csv; exec 3>&-; wait", folder,
                                 "exec 3<>pipe.csv; cat < pipe.csv >&2 3>&- & ");
    EXPECT_THAT(read.err, HasSubstr("px_m,py_m,pz_m,nx,ny,nz"));
  }
  // The output is looked at before the input.
  expect_told(run("query no.stl points.csv --out no/o.csv", folder), 2, "its folder no is not there");
  expect_told(run("export no.h5 --out no/o.csv", folder), 2, "its folder no is not there");
#ifdef FINGERPAD_VIEW
  expect_told(run("plot no.h5 --out no/o.png", folder), 2, "its folder no is not there");
  expect_told(run("view no.h5 --png no/o.png", folder), 2, "its folder no is not there");
#endif
}

TEST(OutputPlaces, InAFolderThatTheSystemFillsAreToldPlainly) {
  const fs::path folder = folder_with_inputs();
  for (const char* call : {"replay s.toml --out /proc/none", "replay s.toml --out /proc/none/deeper",
                           "study friction --out /proc/none", "query box.stl points.csv --out /proc/none"}) {
    const ShellResult result = run(call, folder);
    EXPECT_EQ(result.exit_code, 2) << call;
    // Root is told what the system does, others that they have no right to it: neither that something is
    // missing.
    EXPECT_THAT(result.err, AnyOf(HasSubstr("makes no new"), HasSubstr("may not write into"))) << call;
    EXPECT_THAT(result.err, AllOf(HasSubstr(" /proc"), Not(HasSubstr("there is no such file")))) << call;
  }
}

TEST(OutputPlaces, BehindALinkAreWrittenAndTheLinkStays) {
  const fs::path folder = folder_with_inputs();
  const std::string table = run("query box.stl points.csv", folder).out;
  ASSERT_NE(table, "");
  std::ofstream(folder / "real.csv") << "old";
  fs::permissions(folder / "real.csv", fs::perms(0640));
  fs::create_symlink("real.csv", folder / "link.csv");
  fs::create_symlink("new.csv", folder / "dangling.csv");
  fs::create_symlink("/proc/self/fd/1", folder / "stdout.csv");
  for (const char* out : {"link.csv", "dangling.csv", "stdout.csv"}) {
    const ShellResult result = run(std::string("query box.stl points.csv --out ") + out, folder);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(fs::is_symlink(folder / out)) << out;
    EXPECT_EQ(result.out, std::string(out) == "stdout.csv" ? table : "");
  }
  EXPECT_EQ(bytes_of(folder / "real.csv"), table);
  EXPECT_EQ(bytes_of(folder / "new.csv"), table);
  EXPECT_EQ(fs::status(folder / "real.csv").permissions(), fs::perms(0640)) << "who may read it";
}

#ifdef FINGERPAD_VIEW
TEST(Streams, AreViewedToo) {
  const fs::path folder = folder_with_inputs();
  const ShellResult result = run("view - --png seen.png <s.toml", folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(fs::exists(folder / "seen.png"));
}
#endif

TEST(Streams, AreScenesOnlyOnce) {
  expect_told(run("replay - - --out o <s.toml", folder_with_inputs()), 2, "can be read only once");
}

TEST(OutputPlaces, AStudyTriesItsFolderBeforeItWorksForAMinute) {
  const fs::path folder = folder_with_inputs();
  for (const std::string subject : {"friction", "contact", "stability"}) {
    SCOPED_TRACE(subject);
    // Seconds are enough for the refusal, and not for the study.
    const std::string call = "timeout 10 '" + test::program().string() + "' study " + subject + " --out ";
    expect_told(test::shell(call + "m.csv", folder), 2, "m.csv is a file, not a folder");
    expect_told(test::shell(call + "m.csv/deep", folder), 2, "m.csv is a file, not a folder");
    expect_told(test::shell(call + "/proc/fingerpad", folder), 2, "/proc/fingerpad: cannot be made");
    expect_told(test::shell(call + "-", folder), 2, "needs a folder");
  }
}

}  // namespace
}  // namespace fingerpad::input_files_test
