#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "replay/batch.hpp"
#include "replay/job_board.hpp"
#include "replay/rank_log.hpp"
#include "replay/run_lock.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"

// Batches on a file system without locks, and ranks that come when the others have done.

namespace fingerpad::no_locks_test {
namespace {

bool without_locks = false;

/// While it lives, this program is on a file system without locks.
struct WithoutLocks {
  WithoutLocks() { without_locks = true; }
  ~WithoutLocks() { without_locks = false; }
  WithoutLocks(const WithoutLocks&) = delete;
  WithoutLocks& operator=(const WithoutLocks&) = delete;
};

}  // namespace
}  // namespace fingerpad::no_locks_test

/// In the place of the C library's, for the whole of this program.
extern "C" int flock(int file, int how) noexcept {
  if (!fingerpad::no_locks_test::without_locks) return static_cast<int>(syscall(SYS_flock, file, how));
  errno = ENOLCK;
  return -1;
}

namespace fingerpad::no_locks_test {
namespace {
namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<BatchJob> jobs_of_set(const fs::path& folder, const std::string& name) {
  const fs::path scene = folder / (name + ".toml");
  std::ofstream(scene)
      << "name = \"" << name
      << "\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = \"line\"\n"
         "from_m = [0, 0, -0.001]\nto_m = [0.01, 0, -0.001]\nspeed_m_per_s = 0.2\n"
         "[[set]]\nseed = [1, 2]\n";
  return batch_jobs({scene.string()});
}

BatchOptions options_without_traces(const fs::path& out) {
  BatchOptions options;
  options.out_dir = out.string();
  options.traces = false;
  options.version = "test";
  return options;
}

std::string words_of_error(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(AFileSystemWithoutLocks, HasTheIndexWrittenAndTheSummaryOfAnotherSceneKept) {
  const fs::path folder = test::scratch_dir(), out = folder / "out";
  BatchOptions options = options_without_traces(out);
  std::vector<std::string> kept;
  options.on_kept = [&kept](const std::string& what) { kept.push_back(what); };
  const WithoutLocks none;
  auto first = jobs_of_set(folder, "a"), second = jobs_of_set(folder, "b");
  EXPECT_TRUE(run_batch(first, options, {}, [](const BatchJob&) {}).lost.empty());
  const std::string summary = test::bytes_of(out / "summary.csv");
  EXPECT_TRUE(fs::exists(out / "jobs.csv"));
  EXPECT_FALSE(fs::exists(out / state_folder));
  run_batch(second, options, {}, [](const BatchJob&) {});
  EXPECT_THAT(kept, ElementsAre(HasSubstr("is kept as summary.kept-1.csv")));
  EXPECT_EQ(test::bytes_of(out / "summary.kept-1.csv"), summary);
  EXPECT_THAT(test::bytes_of(out / "jobs.csv"), HasSubstr("\n1,,b,"));
}

TEST(AFileSystemWithoutLocks, IsToldToRanksThatLoseThemOnTheWay) {
  const fs::path folder = test::scratch_dir();
  JobOrder order;
  order.groups.push_back({0, 1, 1});
  order.jobs.push_back(0);
  JobBoard::create((folder / "board").string(), order, 7);
  JobBoard board((folder / "board").string(), 7);
  const WithoutLocks none;
  const std::string held = words_of_error([&] { board.claim(2, 0); });
  EXPECT_THAT(held, HasSubstr("board: cannot be locked (No locks available)"));
  EXPECT_THAT(held, HasSubstr("--shard K/N"));
  EXPECT_THAT(words_of_error([&] { RankLog(folder.string(), 0); }), HasSubstr("cannot be locked"));
}

TEST(ALateRank, LeavesWhereTheOthersHaveToldAllAndSaysSoWhereTheyHaveNot) {
  const fs::path folder = test::scratch_dir(), out = folder / "out";
  auto jobs = jobs_of_set(folder, "a");
  fs::create_directory(out);
  RunLock others(out.string(), {"summary.csv"}, "run");  // at work still, but without what ranks share
  others.stays_last();
  const BatchOptions options = options_without_traces(out);
  const Ranks late{1, 2, "run", getppid()};
  const auto run = [&] { return run_batch(jobs, options, late, [](const BatchJob&) {}).tells; };
  using std::chrono::hours;
  std::ofstream(out / "summary.csv") << "scene,job,status\na,1,ok\n";
  fs::last_write_time(out / "summary.csv", fs::file_time_type::clock::now() - hours(1));
  EXPECT_THAT(words_of_error(run), HasSubstr("board")) << "an earlier run's summary";
  fs::last_write_time(out / "summary.csv", fs::file_time_type::clock::now() + hours(1));
  EXPECT_FALSE(run());
}

}  // namespace
}  // namespace fingerpad::no_locks_test
