// What the program tells of a laboratory's motion.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"

namespace fingerpad::recording_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(Recording, IsReplayedAsItWasSavedAndTold) {
  const fs::path folder = test::scratch_dir();
  const std::string scene = (test::source_dir() / "scenes" / "laboratory.toml").string();
  const auto told = test::fingerpad("replay '" + scene + "' --out o", folder);
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.err,
              AllOf(HasSubstr("laboratory.csv: t is 'time', x is 'pos x'"),
                    HasSubstr("ticks at the file's own 240 Hz (median of 1200 steps, from 4.1 to 4.2 ms)"),
                    HasSubstr("20 Hz is halved"), HasSubstr("rounded to 0.05 mm")));
  EXPECT_THAT(told.err, Not(HasSubstr("never touches")));
  const auto quiet = test::fingerpad("replay '" + scene + "' --out o --quiet", folder);
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_THAT(quiet.err, Not(HasSubstr("laboratory.csv")));
}

TEST(Recording, ThatNeverTouchesIsAWarningEvenOfAQuietRun) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "m.csv", "t_s,x_m,y_m,z_m\n0,0,0,5\n1,30,0,2\n");
  test::write_file(
      folder, "s.toml",
      "[[plane]]\npoint_m = [0,0,0]\nnormal = [0,0,1]\n[motion]\nfile = \"m.csv\"\nrate_hz = 100\n");
  for (const char* quiet : {"", " --quiet"}) {
    const auto result = test::fingerpad(std::string("replay s.toml --out o") + quiet, folder);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(
        result.err,
        "fingerpad: warning: s: the motion never touches: it comes nearest at t = 1 s, 2000 mm from plane "
        "1; the motion spans 30000 x 0 x 3000 mm: check [motion] unit\n");
  }
}

TEST(Recording, OfOneRowIsTold) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "m.csv", "t_s,x_m,y_m,z_m\n0,0,0,0\n");
  test::write_file(folder, "s.toml",
                   "[[plane]]\npoint_m = [0,0,0]\nnormal = [0,0,1]\n[motion]\nfile = \"m.csv\"\n");
  for (const char* command : {"check s.toml", "replay s.toml --out o"}) {
    EXPECT_THAT(test::fingerpad(command, folder).err,
                HasSubstr("m.csv: has one row: the finger is there for one tick"))
        << command;
  }
}

TEST(Recording, OfASetThatNeverTouchesIsADozenWarningsAndACount) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "m.csv", "t_s,x_m,y_m,z_m\n0,0,0,5\n1,30,0,2\n");
  std::string points;
  for (int i = 1; i <= 40; ++i) points += "[0, 0, " + std::to_string(-i) + "], ";
  test::write_file(folder, "s.toml",
                   "[[plane]]\npoint_m = [0,0,0]\nnormal = [0,0,1]\n[motion]\nfile = \"m.csv\"\n"
                   "rate_hz = 100\n[[set]]\nplane.point_m = [" +
                       points + "]\n");
  const auto result = test::fingerpad("replay s.toml --out o --quiet", folder);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 13) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("at t = 1 s, 3000 mm from plane 1"),
                                HasSubstr("fingerpad: warning: and 28 more such lines; summary.csv has")));
}

TEST(Recording, ThatIsRefusedNamesTheHeadersColumns) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "m.csv", "Time;X;Y;Z\n0;0;0;0\n1;1;1;1\n");
  test::write_file(folder, "s.toml",
                   "[[plane]]\npoint_m = [0,0,0]\nnormal = [0,0,1]\n[motion]\nfile = \"m.csv\"\n"
                   "columns = { t = \"time\" }\n");
  const auto result = test::fingerpad("replay s.toml --out o", folder);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, AllOf(HasSubstr("m.csv:1: no column 'time' (did you mean 'Time'?)"),
                                HasSubstr("it names Time, X, Y, Z")));
}

}  // namespace
}  // namespace fingerpad::recording_test
