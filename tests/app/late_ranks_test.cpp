#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "rank_batch.hpp"
#include "support/shell.hpp"

// Ranks that come late, or never, or are called again; each is a process that the shell starts.

#ifdef FINGERPAD_MPI

namespace fingerpad::late_ranks_test {
namespace {
namespace fs = std::filesystem;
using test::all_bytes;
using test::bytes_of;
using test::folder_with_batch;
using test::ShellResult;
using testing::HasSubstr;

/// A rank of a run of two, started by the shell.
std::string as_rank(int rank) {
  return "OMPI_COMM_WORLD_SIZE=2 PMIX_NAMESPACE=x OMPI_COMM_WORLD_RANK=" + std::to_string(rank) + " '" +
         test::program().string() + "' replay plane.toml --out o --wait-for-ranks 0\n";
}

TEST(Ranks, ThatComeWhenTheOthersHaveDoneAllDoNothing) {
  const fs::path folder = folder_with_batch();
  for (const int first : {0, 1}) {
    fs::remove_all(folder / "o");
    const ShellResult run =
        test::shell(as_rank(first) + "echo changed > o/plane-0001.h5\n" + as_rank(1 - first), folder);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, "4 of 4 jobs done, traces and summary.csv in o\n") << "told by the one that did them";
    EXPECT_THAT(run.err, HasSubstr("1 of 2 ranks never came"));
    EXPECT_EQ(bytes_of(folder / "o" / "plane-0001.h5"), "changed\n") << first;
    EXPECT_FALSE(fs::exists(folder / "o" / ".fingerpad" / "ranks-1of1"));
  }
  // Another launcher's ranks that happen to have the same name.
  const ShellResult again = test::shell(as_rank(0), folder);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(bytes_of(folder / "o" / "plane-0001.h5"), "changed\n");
}

/// Its patience is a day: one that sits it out is ended, and says so.
TEST(Ranks, ThatComeLateDoNotWaitForARootThatHasLeft) {
  const fs::path folder = folder_with_batch();
  std::string late = as_rank(1);
  late.replace(late.find("--wait-for-ranks 0\n"), 19, "--wait-for-ranks 86400 &\n");
  const ShellResult run =
      test::shell(as_rank(0) + late +
                      "late=$!\ntimeout 60 tail --pid=$late -f /dev/null || kill -9 $late\nwait $late\n"
                      "echo ended $?\n",
                  folder);
  EXPECT_THAT(run.out, HasSubstr("in o\nended 0\n")) << run.err;
}

/// A rank that waits for its root in folder `o`, and is told to stop while it does.
ShellResult waited_and_was_stopped(const fs::path& folder) {
  std::string waiting = as_rank(1);
  waiting.replace(waiting.find("--wait-for-ranks 0\n"), 19, "--wait-for-ranks 86400 &\n");
  // SIGTERM is the 15th: caught once the 4 of the fourth digit stands in the mask.
  return test::shell(
      waiting +
          "rank=$!\nuntil grep -q '^SigCgt:.*[4-7c-f]...$' /proc/$rank/status; do sleep .02; done\n"
          "kill -TERM $rank\ntimeout 60 tail --pid=$rank -f /dev/null || kill -9 $rank\n"
          "wait $rank\necho ended $?\n",
      folder);
}

TEST(Ranks, ThatWaitForTheRootStopWhereTheyAreAskedTo) {
  const fs::path folder = folder_with_batch();
  const ShellResult run = waited_and_was_stopped(folder);
  EXPECT_THAT(run.out, HasSubstr("ended 4\n")) << run.err;
  EXPECT_THAT(run.err, HasSubstr("--resume"));
  EXPECT_FALSE(fs::exists(folder / "o" / "summary.csv"));
  ASSERT_EQ(test::fingerpad("replay plane.toml --out o --quiet --resume", folder).exit_code, 0);
  ASSERT_EQ(test::fingerpad("replay plane.toml --out one --quiet", folder).exit_code, 0);
  EXPECT_EQ(all_bytes(folder / "o"), all_bytes(folder / "one"));
}

/// As where the root was refused because another run was at work, which has ended since.
TEST(Ranks, ThatAreToldToStopBeforeTheirRootHasComeLeaveTheTablesOfAnotherRun) {
  const fs::path folder = folder_with_batch();
  ASSERT_EQ(test::fingerpad("replay plane.toml --out o --quiet", folder).exit_code, 0);
  const auto before = all_bytes(folder / "o");
  const ShellResult run = waited_and_was_stopped(folder);
  EXPECT_THAT(run.out, HasSubstr("ended 4\n")) << run.err;
  EXPECT_EQ(all_bytes(folder / "o"), before);
}

/// As where one script that is started with ranks calls it twice.
TEST(Ranks, WhoseRootIsCalledAgainByOneLauncherDoItAgain) {
  const fs::path folder = folder_with_batch();
  const ShellResult twice = test::shell(as_rank(0) + "echo changed > o/plane-0001.h5\n" + as_rank(0), folder);
  EXPECT_EQ(twice.exit_code, 0) << twice.err;
  const std::string done = "4 of 4 jobs done, traces and summary.csv in o\n";
  EXPECT_EQ(twice.out, done + done);
  EXPECT_NE(bytes_of(folder / "o" / "plane-0001.h5"), "changed\n");
}

TEST(Ranks, OfWhichNobodySaysOfWhatRunAreRefusedAndOneByItselfIsNoRank) {
  const fs::path folder = folder_with_batch();
  const std::string replay = "'" + test::program().string() + "' replay plane.toml --format none --quiet ";
  const ShellResult many = test::shell("PMI_RANK=1 PMI_SIZE=2 PMI_ID=1 " + replay + "--out o", folder);
  EXPECT_EQ(many.exit_code, 2) << many.err;
  EXPECT_THAT(many.err, HasSubstr("PMI_RANK: says that this is rank 1 of 2, but PMI_JOBID does not say"));
  EXPECT_THAT(many.err, HasSubstr("--shard K/N"));
  EXPECT_FALSE(fs::exists(folder / "o"));
  for (const char* one :
       {"PMI_RANK=0 PMI_SIZE=1 ", "OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=1 PMIX_NAMESPACE=x "}) {
    EXPECT_EQ(test::shell(one + replay + "--out one", folder).exit_code, 0) << one;
    EXPECT_FALSE(fs::exists(folder / "one" / ".fingerpad")) << one << "leaves it registered";
  }
}

}  // namespace
}  // namespace fingerpad::late_ranks_test

#endif
