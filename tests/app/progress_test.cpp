#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <optional>

#include "app/count_bar.hpp"
#include "support/effort.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"

// What a person sees of a load that takes its time: a bar on a terminal, and nothing anywhere else.

namespace fingerpad::progress_test {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const int subdivisions = test::sanitized() ? 7 : 8;  // 131,072 triangles; 524,288: over a second

/// A folder with a mesh that takes longer than half a second, one that does not, and a point to ask them for.
/// @param finer  by how often each triangle of the first is parted in four, where a load must last much
/// longer; below 0 where it need not last
fs::path folder_with_meshes(int finer = 0) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "ball.ply", test::binary_ply(test::sphere_soup(50, subdivisions + finer)));
  test::write_file(folder, "box.ply", test::binary_ply(test::box_soup({9, 9, 9})));
  std::ofstream(folder / "points.csv") << "x_m,y_m,z_m\n0,0,0.06\n";
  return folder;
}

/// What a terminal gets from the program's standard error; its standard output goes to out.csv.
std::string on_a_terminal(const std::string& arguments, const fs::path& folder) {
  const std::string call = "'" + test::program().string() + "' " + arguments + " >out.csv";
  return test::shell("script --quiet --return --command \"" + call + "\" /dev/null", folder).out;
}

/// What a terminal gets where Ctrl-C is typed as soon as the program has said something.
std::string interrupted_on_a_terminal(const std::string& said, const std::string& arguments,
                                      const fs::path& folder) {
  const fs::path typist = test::source_dir() / "tests" / "support" / "type_in_terminal";
  return test::shell("'" + typist.string() + "' '" + said + "' '\\x03' '" + test::program().string() + "' " +
                         arguments,
                     folder)
      .out;
}

bool has_script() {
  return test::shell("script --version", test::scratch_dir()).exit_code == 0;
}

TEST(LoadBar, ShowsTheStagesOfALongLoadOnATerminalAndWipesItselfAway) {
  if (!has_script()) GTEST_SKIP() << "no script(1) to play a terminal";
  const fs::path folder = folder_with_meshes();
  const std::string seen = on_a_terminal("query ball.ply points.csv", folder);
  EXPECT_THAT(seen, HasSubstr("% ball.ply: building the search tree"));
  EXPECT_THAT(seen, HasSubstr("\r[==="));
  EXPECT_THAT(seen, Not(HasSubstr("100%"))) << "the end is shown by the bar's being gone";
  const std::size_t last_bar = seen.rfind("\r["), blank = seen.rfind("\r          ");
  EXPECT_NE(blank, std::string::npos);
  EXPECT_GT(blank, last_bar) << "wiped away";
  EXPECT_THAT(test::bytes_of(folder / "out.csv"), HasSubstr("distance_m"));
}

TEST(LoadBar, IsSilentWhereThereIsNoTerminal) {
  const fs::path folder = folder_with_meshes();
  EXPECT_EQ(test::fingerpad("query ball.ply points.csv --out out.csv", folder).err, "");
  EXPECT_EQ(test::fingerpad("check ball.ply", folder).err, "");
}

TEST(LoadBar, AQuickLoadAndARefusedOneLeaveNoTrace) {
  if (!has_script()) GTEST_SKIP() << "no script(1) to play a terminal";
  const fs::path folder = folder_with_meshes(1 - subdivisions);  // the first is not asked for
  EXPECT_EQ(on_a_terminal("query box.ply points.csv", folder), "");
  const std::string refused = on_a_terminal("query absent.ply points.csv", folder);
  EXPECT_EQ(refused.rfind("fingerpad: error: absent.ply", 0), 0u) << refused;
}

TEST(JobBar, NamesTheMeshThatABatchWaitsForAndKeepsItsLastLine) {
  if (!has_script()) GTEST_SKIP() << "no script(1) to play a terminal";
  const fs::path folder = folder_with_meshes();
  std::ofstream(folder / "ball.toml")
      << "[[part]]\nmesh = \"ball.ply\"\n[motion]\nkind = \"line\"\nfrom_m = [0, 0, 0.051]\n"
         "to_m = [0, 0, 0.0499]\nspeed_m_per_s = 0.1\n";
  const std::string seen = on_a_terminal("replay ball.toml --out o", folder);
  EXPECT_THAT(seen, HasSubstr("0/1 ball.ply: building the search tree"));
  EXPECT_THAT(seen, testing::ContainsRegex("====\\] 100% 1/1(, [^ ]+ jobs/s, 0 s left)? ball"));
  EXPECT_THAT(on_a_terminal("replay ball.toml --out q --quiet", folder), Not(HasSubstr("[")));
}

/// A scene whose only job has a million ticks a metre; a few metres under a sanitizer, where each takes ten
/// times as long.
fs::path folder_with_long_job(int length_m) {
  if (test::sanitized()) length_m = (length_m + 5) / 6;  // its ticks take longer
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "long.toml")
      << "name = \"long\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[friction]\nlaw = \"none\"\n"
         "[motion]\nkind = \"line\"\nfrom_m = [0, 0, -0.001]\nspeed_m_per_s = 0.001\nto_m = ["
      << length_m << ", 0, -0.001]\n";
  return folder;
}

TEST(JobBar, ShowsHowFarALongJobIs) {
  if (!has_script()) GTEST_SKIP() << "no script(1) to play a terminal";
  const fs::path folder = folder_with_long_job(4);
  const std::string seen = on_a_terminal("replay long.toml --out o --format none", folder);
  EXPECT_THAT(seen, testing::ContainsRegex("0/1 long [1-9][0-9]*%"));
  EXPECT_THAT(seen, testing::ContainsRegex("====\\] 100% 1/1(, [^ ]+ jobs/s, 0 s left)? long"));
}

TEST(JobBar, KeepsBothEndsOfANameThatIsTooLong) {
  if (!has_script()) GTEST_SKIP() << "no script(1) to play a terminal";
  const fs::path folder = test::scratch_dir();
  const std::string name = "a_scene_of_a_name_that_is_longer_than_any_line_has_room_for_beside_its_bar_12345";
  std::ofstream(folder / "s.toml")
      << "name = \"" << name << "\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n"
      << "[motion]\nkind = \"line\"\nfrom_m = [0, 0, -0.001]\nto_m = [0.01, 0, -0.001]\n"
         "speed_m_per_s = 0.1\n";
  const std::string narrow = on_a_terminal("replay s.toml --out o", folder);
  EXPECT_THAT(narrow, HasSubstr("100% 1/1"));
  EXPECT_THAT(narrow, HasSubstr("..."));
  EXPECT_THAT(narrow, HasSubstr("_12345"));
  EXPECT_THAT(narrow, Not(HasSubstr(name)));
  const std::string call = "stty cols 180; '" + test::program().string() + "' replay s.toml --out o";
  const std::string wide =
      test::shell("script --quiet --return --command \"" + call + "\" /dev/null", folder).out;
  EXPECT_THAT(wide, HasSubstr(name)) << "where the terminal has room";
}

TEST(LoadBar, ThatCtrlCEndsLeavesAWholeLine) {
  const fs::path folder = folder_with_meshes(1);  // a bar comes after half a second, and then Ctrl-C is typed
  const std::string seen =
      interrupted_on_a_terminal("% ball.ply", "query ball.ply points.csv --out out.csv", folder);
  EXPECT_THAT(seen, testing::EndsWith("\nfingerpad: stopped by Ctrl-C\r\n")) << seen;
}

TEST(JobBar, SaysThatItStopsAndWhatItWaitsFor) {
  const fs::path folder = folder_with_long_job(12);
  const std::string seen =
      interrupted_on_a_terminal("0/1 long ", "replay long.toml --out o --format none", folder);
  const std::string told = "fingerpad: stopping: 1 under way ends first; Ctrl-C again ends at once";
  EXPECT_LE(told.size(), 80u);
  EXPECT_THAT(seen, HasSubstr("\r" + told + "\r\n\r[")) << "whole, in a line above the bar";
  EXPECT_EQ(seen.find(told), seen.rfind(told)) << "once";
  EXPECT_THAT(seen, HasSubstr("0/1 stopping: 1 under way ends "));
}

TEST(JobBar, CountsAJobWhoseMeshIsStillBeingLoadedAsUnderWay) {
  const fs::path folder = folder_with_meshes();
  std::ofstream(folder / "ball.toml")
      << "[[part]]\nmesh = \"ball.ply\"\n[motion]\nkind = \"line\"\nfrom_m = [0, 0, 0.051]\n"
         "to_m = [0, 0, 0.0499]\nspeed_m_per_s = 0.1\n";
  const std::string seen = interrupted_on_a_terminal("0/1 ball.ply: ", "replay ball.toml --out o", folder);
  EXPECT_THAT(seen, HasSubstr("0/1 stopping: 1 under way ends "));
  EXPECT_THAT(seen, Not(HasSubstr("0/1 stopped")));
}

/// What standard error gets while `work` is done, until it has said so much.
std::string said_until(const std::string& awaited, const std::function<void()>& work) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  const int before = dup(STDERR_FILENO);
  dup2(ends[1], STDERR_FILENO);
  work();
  std::string said;
  char byte = 0;
  while (said.find(awaited) == std::string::npos && read(ends[0], &byte, 1) == 1) said += byte;
  dup2(before, STDERR_FILENO);
  for (const int end : {before, ends[0], ends[1]}) close(end);
  return said;
}

TEST(CountBar, IsDrawnOnATerminal) {
  using std::chrono::milliseconds;
  std::optional<CountBar> bar;
  const std::string said = said_until("/12", [&bar] {
    bar.emplace(12, "traces", "read", ShownProgress::bar, milliseconds(0), milliseconds(0));
    for (int k = 0; k < 3; ++k) bar->advance();
  });
  EXPECT_THAT(said, testing::ContainsRegex("\\[=* *\\] +[0-9]+% [1-3]/12"));
}

TEST(CountBar, WritesALineWhereOneIsDue) {
  using std::chrono::milliseconds;
  for (const int between_ms : {0, 100'000'000}) {
    const std::string said = said_until("end", [between_ms] {
      CountBar bar(12, "traces", "read", ShownProgress::lines, milliseconds(between_ms));
      for (int k = 0; k < 2; ++k) bar.advance();
      std::fputs("end", stderr);
    });
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), between_ms == 0 ? 2 : 0) << said;
  }
}

#ifdef FINGERPAD_VIEW
TEST(Report, TellsHowManyTracesItHasRead) {
  const bool has_terminal = has_script();  // in the same folder, which it empties
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = "
         "\"line\"\nfrom_m = [0, 0, -0.001]\nto_m = [0.4, 0, -0.001]\n"
         "speed_m_per_s = 0.05\nrate_hz = 5000\n[[set]]\nseed = { from = 1, to = 12, "
         "steps = 12 }\n";
  ASSERT_EQ(test::fingerpad("replay s.toml --out o --quiet", folder).exit_code, 0);
  const std::string lines = test::fingerpad("report o --progress 0", folder).err;
  EXPECT_THAT(lines, testing::StartsWith("fingerpad: 1 of 12 traces read, 8%"));
  EXPECT_THAT(lines, HasSubstr("fingerpad: 6 of 12 traces read, 50%"));
  EXPECT_EQ(test::fingerpad("report o --progress 0 --quiet", folder).err, "");
  EXPECT_EQ(test::fingerpad("report o --progress 86400", folder).err, "");
  if (!has_terminal) GTEST_SKIP() << "no script(1) to play a terminal";
  EXPECT_EQ(on_a_terminal("report o --quiet", folder), "");
}
#endif

}  // namespace
}  // namespace fingerpad::progress_test
