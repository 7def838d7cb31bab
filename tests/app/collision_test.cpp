#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "support/paths.hpp"
#include "support/shell.hpp"

// Outputs that would fall on one another, on an input, or on what another run is writing.

namespace fingerpad::collision_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using test::ShellResult;
using testing::AllOf;
using testing::HasSubstr;

constexpr const char* plane = "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n";
constexpr const char* line =
    "[motion]\nkind = \"line\"\nfrom_m = [0, 0, -0.001]\nto_m = [0.01, 0, -0.001]\nspeed_m_per_s = 0.1\n";

/// Ten thousand ticks: more than a pipe holds.
constexpr const char* slow_line =
    "[motion]\nkind = \"line\"\nfrom_m = [0, 0, -0.001]\nto_m = [0.01, 0, -0.001]\nspeed_m_per_s = 0.001\n";

void write_scene(const fs::path& path, const std::string& name, const std::string& rest = line) {
  std::ofstream(path) << "name = \"" << name << "\"\n" << plane << rest;
}

std::string rub_csv() {
  return "t_s,x_m,y_m,z_m\n0,0,0,-0.001\n0.1,0.01,0,-0.001\n";
}

/// Every file below a folder with its bytes.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    files[entry.path().string()] = entry.is_regular_file() ? bytes_of(entry.path()) : "";
  return files;
}

/// The call is refused, for a reason with these words, and nothing at all is written.
void expect_refused(const fs::path& folder, const std::string& call, const std::vector<std::string>& words) {
  const auto before = contents(folder);
  const ShellResult result = test::fingerpad(call, folder);
  EXPECT_EQ(result.exit_code, 3) << call << "\n" << result.err;
  for (const std::string& word : words) EXPECT_THAT(result.err, HasSubstr(word)) << call;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_TRUE(contents(folder) == before) << call << ": something was written";
}

TEST(Collisions, OfTwoTracesAreRefused) {
  const fs::path folder = test::scratch_dir();
  write_scene(folder / "a.toml", "a", std::string(line) + "[[set]]\nseed = [1, 2]\n");
  write_scene(folder / "b.toml", "a-0001");
  for (const std::string& rest : std::vector<std::string>{"", " --format csv", " --shard 1/3"}) {
    expect_refused(folder, "replay a.toml b.toml --out o" + rest, {"a-0001", "job 1 of set 'a'", "`name`"});
  }
}

TEST(Collisions, OfATraceAndATableAreRefused) {
  const fs::path folder = test::scratch_dir();
  write_scene(folder / "a.toml", "summary");
  write_scene(folder / "b.toml", "timing");
  write_scene(folder / "c.toml", "summary-2of8");
  expect_refused(folder, "replay a.toml --out o --format csv", {"a.toml", "summary.csv"});
  expect_refused(folder, "replay b.toml --out o --format csv", {"b.toml", "timing.csv"});
  expect_refused(folder, "replay c.toml --out o --format csv --shard 1/8", {"c.toml", "summary-2of8.csv"});
  EXPECT_EQ(test::fingerpad("replay a.toml b.toml c.toml --out o", folder).exit_code, 0) << "HDF5 does not";
  EXPECT_EQ(test::fingerpad("replay c.toml --out o --format csv", folder).exit_code, 0) << "nor one shard";
}

TEST(Collisions, OfATraceAndAnInputAreRefused) {
  const fs::path folder = test::scratch_dir();
  fs::create_directories(folder / "o");
  const std::string from_file = "[motion]\nfile = \"o/m.csv\"\n";
  std::ofstream(folder / "o" / "m.csv") << rub_csv();
  write_scene(folder / "m.toml", "m", from_file);
  expect_refused(folder, "replay m.toml --out o --format csv", {"o/m.csv", "scene 'm'"});
  expect_refused(folder, "replay m.toml --out ./o/../o --format csv", {"m.csv"});

  fs::create_symlink("../o/m.csv", folder / "o" / "soft.csv");
  fs::create_hard_link(folder / "o" / "m.csv", folder / "o" / "hard.h5");
  write_scene(folder / "soft.toml", "soft", from_file);
  write_scene(folder / "hard.toml", "hard", from_file);
  expect_refused(folder, "replay soft.toml --out o --format csv", {"o/soft.csv", "o/m.csv"});
  expect_refused(folder, "replay hard.toml --out o", {"o/hard.h5", "o/m.csv"});

  write_scene(folder / "o" / "scene.csv", "scene");
  expect_refused(folder, "replay o/scene.csv --out o --format csv", {"o/scene.csv"});

  fs::rename(folder / "o" / "m.csv", folder / "o" / "part.csv.part");
  write_scene(folder / "part.toml", "part", "[motion]\nfile = \"o/part.csv.part\"\n");
  expect_refused(folder, "replay part.toml --out o --format csv", {"o/part.csv.part"});
}

#ifdef FINGERPAD_MPI
TEST(Collisions, AreToldOnceByManyRanks) {
  const fs::path folder = test::scratch_dir();
  write_scene(folder / "a.toml", "summary");
  const ShellResult result = test::shell(
      "HWLOC_COMPONENTS=-gl OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun "
      "--oversubscribe -n 2 '" +
          test::program().string() + "' replay a.toml --out o --format csv",
      folder);
  EXPECT_EQ(result.exit_code, 3) << result.err;
  const std::size_t told = result.err.find("fingerpad: error: ");
  EXPECT_NE(told, std::string::npos);
  EXPECT_EQ(told, result.err.rfind("fingerpad: error: ")) << result.err;
  EXPECT_FALSE(fs::exists(folder / "o"));
}
#endif

TEST(Collisions, OfATraceThatAnotherJobReadsAreRefused) {
  const fs::path folder = test::scratch_dir();
  write_scene(folder / "first.toml", "first");
  write_scene(folder / "second.toml", "second", "[motion]\nfile = \"o/first.h5\"\n");
  expect_refused(folder, "replay first.toml second.toml --out o", {"o/first.h5"});
  ASSERT_EQ(test::fingerpad("replay first.toml --out o --quiet", folder).exit_code, 0);
  EXPECT_EQ(test::fingerpad("replay second.toml --out o --quiet", folder).exit_code, 0)
      << "one after another";
}

TEST(Collisions, OfTracesThatAreOneFileThroughLinksAreRefused) {
  const fs::path folder = test::scratch_dir();
  fs::create_directories(folder / "o");
  std::ofstream(folder / "o" / "a.h5") << "old";
  fs::create_hard_link(folder / "o" / "a.h5", folder / "o" / "b.h5");
  write_scene(folder / "a.toml", "a");
  write_scene(folder / "b.toml", "b");
  expect_refused(folder, "replay a.toml b.toml --out o", {"o/b.h5", "o/a.h5"});
}

TEST(Collisions, OfOutAndAnInputAreRefusedByEverySubcommand) {
  const fs::path folder = test::scratch_dir();
  write_scene(folder / "s.toml", "s");
  ASSERT_EQ(test::fingerpad("replay s.toml --out . --format csv --quiet", folder).exit_code, 0);
  std::ofstream(folder / "cube.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  std::ofstream(folder / "points.csv") << "x_m,y_m,z_m\n0,0,0.06\n";
  fs::create_symlink("s.csv", folder / "link.csv");
  fs::copy_file(folder / "s.csv", folder / "cut.csv.part");
  expect_refused(folder, "export s.csv --out s.csv", {"s.csv"});
  expect_refused(folder, "export s.csv --out link.csv", {"link.csv", "s.csv"});
  expect_refused(folder, "export cut.csv.part --out cut.csv", {"cut.csv.part"});
  expect_refused(folder, "query cube.off points.csv --out points.csv", {"points.csv"});
  expect_refused(folder, "query cube.off points.csv --out cube.off", {"cube.off"});
#ifdef FINGERPAD_VIEW
  fs::copy_file(folder / "s.csv", folder / "s.png");
  expect_refused(folder, "plot s.png --out s.png", {"s.png"});
  expect_refused(folder, "view s.toml --png s.toml", {"s.toml"});
#endif
}

/// Starts a run whose first trace is a pipe that is open but not read, so that the run stands there as soon
/// as the pipe is full; does `meanwhile`, and then `end`, with the run's number in $run and the pipe's whole
/// text to be read from descriptor 3.
std::string during(const std::string& call, const std::string& meanwhile, const std::string& end) {
  return std::string("mkdir -p o && mkfifo o/long-0001.csv\nsleep 100 <>o/long-0001.csv & holder=$!\n") +
         "trap 'kill -KILL $holder $run 2>/dev/null' EXIT\n'" + test::program().string() + "' " + call +
         " >run.out 2>run.err & run=$!\n" +
         "for i in $(seq 3000); do [ -s o/.fingerpad/run-1.lock ] && break; sleep 0.02; done\n" + meanwhile +
         "\nexec 3<o/long-0001.csv; kill $holder\n" + end +
         "; wait $run; echo $? >code\nrm o/long-0001.csv\n";
}

class TwoRuns : public testing::Test {
 protected:
  const fs::path folder = test::scratch_dir();
  const std::string program = "'" + test::program().string() + "' ";
  const std::string replay_long = "replay long.toml --out o --format csv --quiet";
  void SetUp() override {
    write_scene(folder / "long.toml", "long",
                std::string(slow_line) + "[friction]\nlaw = \"none\"\n[[set]]\nseed = [1, 2, 3, 4]\n");
    write_scene(folder / "short.toml", "short");
  }
};

TEST_F(TwoRuns, OfOneFolderAreRefusedWithTheProcessNamed) {
  const std::string second = program + "replay short.toml --out o 2>second.err; echo $? >second.code";
  test::shell(during(replay_long, second, "kill -KILL $run"), folder);
  EXPECT_EQ(bytes_of(folder / "second.code"), "3\n");
  EXPECT_THAT(bytes_of(folder / "second.err"),
              AllOf(HasSubstr("fingerpad: error: o: summary.csv is being written by process "),
                    HasSubstr(replay_long), HasSubstr("another folder")));
  EXPECT_FALSE(fs::exists(folder / "o" / "short.h5"));
}

TEST_F(TwoRuns, ThatWereKilledAreToldAndTakenOver) {
  test::shell(during(replay_long, "", "kill -KILL $run"), folder);
  EXPECT_EQ(bytes_of(folder / "code"), "137\n");
  const ShellResult next = test::fingerpad(replay_long + " --resume", folder);
  EXPECT_EQ(next.exit_code, 0);
  EXPECT_THAT(next.err, AllOf(HasSubstr("fingerpad: warning: o: process "), HasSubstr(replay_long),
                              HasSubstr("takes its place\n")));
  EXPECT_EQ(test::fingerpad(replay_long + " --resume", folder).err, "") << "told once";
}

TEST_F(TwoRuns, OfTwoShardsGoOnTogetherButNotOfOne) {
  const std::string meanwhile = program + replay_long + " --shard 2/2; echo $? >other.code\n" + program +
                                replay_long + " --shard 1/2 2>same.err; echo $? >same.code\n" + program +
                                replay_long + " 2>whole.err; echo $? >whole.code";
  test::shell(during(replay_long + " --shard 1/2", meanwhile, "cat <&3 >first.csv"), folder);
  EXPECT_EQ(bytes_of(folder / "code"), "0\n") << bytes_of(folder / "run.err");
  EXPECT_EQ(bytes_of(folder / "other.code"), "0\n");
  EXPECT_EQ(bytes_of(folder / "same.code"), "3\n");
  EXPECT_THAT(bytes_of(folder / "same.err"), HasSubstr("is being written by process "));
  EXPECT_EQ(bytes_of(folder / "whole.code"), "3\n");
  for (const char* trace : {"first.csv", "o/long-0002.csv", "o/long-0003.csv", "o/long-0004.csv"})
    EXPECT_THAT(bytes_of(folder / trace), HasSubstr("t_s,")) << trace;
  EXPECT_FALSE(fs::exists(folder / "o" / ".fingerpad" / "run-1.lock"));
}

}  // namespace
}  // namespace fingerpad::collision_test
