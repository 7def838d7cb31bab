#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "support/paths.hpp"
#include "support/shell.hpp"

// What a person sees of a batch of many jobs, and how it is stopped.

namespace fingerpad::long_batch_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using testing::HasSubstr;
using testing::Not;

/// A set of `jobs` rubs over a plane.
void write_set(const fs::path& folder, int jobs, int rate_hz) {
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = \"sine\"\n"
         "centre_m = [0, 0, -0.001]\ndirection = [1, 0, 0]\namplitude_m = 0.05\nfrequency_hz = 1\n"
         "duration_s = 2\nrate_hz = "
      << rate_hz << "\n[[set]]\nseed = { from = 1, to = " << jobs << ", steps = " << jobs << " }\n";
}

TEST(LongBatch, TellsAReasonOnceForAllTheJobsThatItStopped) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "bad.stl") << "no mesh at all\n";
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[part]]\nmesh = \"bad.stl\"\n[motion]\nkind = \"line\"\n"
         "from_m = [0, 0, 0]\nto_m = [0.1, 0, 0]\nspeed_m_per_s = 1\n[[set]]\n"
         "seed = { from = 1, to = 9, steps = 9 }\n";
  const auto result = test::fingerpad("replay s.toml --out o", folder);
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr("fingerpad: error: 9 jobs (1, 2, 3, 4, 5, 6 and 3 more): bad.stl"));
  const std::string summary = bytes_of(folder / "o" / "summary.csv");
  EXPECT_THAT(summary, HasSubstr("\ns,9,9,")) << "each job has its row, with the reason";
}

TEST(LongBatch, TellsWhichJobAReasonStopped) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml") << "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n"
                                      "[motion]\nfile = \"m.csv\"\n[[set]]\nmotion = \"*.csv\"\n";
  std::ofstream(folder / "bad.csv") << "t_s,x_m\n0,0\n";
  std::ofstream(folder / "m.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0\n0.001,0,0,0\n";
  EXPECT_THAT(test::fingerpad("replay s.toml --out o", folder).err,
              HasSubstr("fingerpad: error: job 1: bad.csv:"));
}

TEST(LongBatch, ToldToStopFinishesWhatItBeganAndIsResumedToTheSameBytes) {
  const fs::path folder = test::scratch_dir();
  constexpr int jobs = 30;
  write_set(folder, jobs, 4000);
  for (const std::string signal : {"INT", "TERM"}) {
    fs::remove_all(folder / "o");
    const auto stopped = test::shell("'" + test::program().string() +
                                         "' replay s.toml --out o --jobs 1 & pid=$!\n"
                                         "until [ -e o/s-0001.h5 ]; do sleep 0.01; done\n"
                                         "kill -" +
                                         signal + " $pid\nwait $pid",
                                     folder);
    EXPECT_EQ(stopped.exit_code, 4) << signal;
    EXPECT_THAT(stopped.err, HasSubstr("jobs were begun; the same command with --resume does the rest in o"));
    EXPECT_THAT(stopped.err, Not(HasSubstr("Ctrl-C"))) << "nobody types into a log";
    EXPECT_THAT(stopped.out, HasSubstr(" of 30 jobs done, traces and summary.csv in o"));
    EXPECT_FALSE(fs::exists(folder / "o" / "s-0030.h5")) << "or the signal came too late for this test";
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "o")) {
      EXPECT_THAT(entry.path().string(), Not(HasSubstr(".part"))) << "no job was cut short";
    }
  }
  const auto resumed = test::fingerpad("replay s.toml --out o --resume", folder);
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_THAT(resumed.out, HasSubstr("30 of 30 jobs done ("));
  EXPECT_THAT(resumed.out, HasSubstr(" kept from before)"));
  ASSERT_EQ(test::fingerpad("replay s.toml --out fresh --quiet", folder).exit_code, 0);
  for (const char* name : {"summary.csv", "jobs.csv", "s-0001.h5", "s-0030.h5"}) {
    EXPECT_EQ(bytes_of(folder / "o" / name), bytes_of(folder / "fresh" / name)) << name;
  }
}

TEST(LongBatch, TellsNowAndThenHowFarItIsWhereThereIsNoTerminal) {
  const fs::path folder = test::scratch_dir();
  write_set(folder, 3, 1000);
  const auto told = test::fingerpad("replay s.toml --out o --progress 0", folder);
  EXPECT_THAT(told.err, HasSubstr("fingerpad: 3 of 3 jobs done, 100%"));
  EXPECT_THAT(test::fingerpad("replay s.toml --out o", folder).err, Not(HasSubstr("jobs done")))
      << "under 10 s";
  EXPECT_THAT(test::fingerpad("replay s.toml --out o --progress 0 --quiet", folder).err,
              Not(HasSubstr("jobs done")));
}

}  // namespace
}  // namespace fingerpad::long_batch_test
