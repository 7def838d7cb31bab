#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "support/paths.hpp"
#include "support/shell.hpp"

// A batch that real ranks share, under mpirun and under Slurm, and what is left when one of them dies.

#ifdef FINGERPAD_MPI

namespace fingerpad::ranks_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using test::ShellResult;
using testing::HasSubstr;
using testing::Not;

/// Eight rubs over two parts and a plane, in three scenes, one with a mesh that cannot be read.
fs::path folder_with_batch(int rate_hz = 1000) {
  const fs::path folder = test::scratch_dir();
  const std::string rub =
      "[motion]\nkind = \"sine\"\ncentre_m = [0, 0, -0.001]\ndirection = [1, 0, 0]\n"
      "amplitude_m = 0.02\nfrequency_hz = 1\nduration_s = 2\nrate_hz = " +
      std::to_string(rate_hz) + "\n";
  std::ofstream(folder / "few.off")
      << "OFF\n4 4 0\n0 0 0\n40 0 0\n0 40 0\n0 0 40\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  std::ofstream(folder / "broken.off") << "OFF\n";
  std::ofstream(folder / "parts.toml")
      << "name = \"parts\"\n[[part]]\nmesh = \"few.off\"\n" + rub +
             "[[set]]\nmesh = [\"few.off\", \"broken.off\"]\nseed = [1, 2]\n";
  std::ofstream(folder / "plane.toml")
      << "name = \"plane\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n" + rub +
             "[[set]]\nseed = [1, 2, 3, 4]\n";
  return folder;
}

/// Without hwloc's look at an X server, with which mpirun would end.
std::string as_ranks(int count, const std::string& options = "") {
  return "HWLOC_COMPONENTS=-gl OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun "
         "--oversubscribe " +
         options + " -n " + std::to_string(count) + " '" + test::program().string() + "' ";
}

std::string support(const std::string& name) {
  return "'" + (test::source_dir() / "tests" / "support" / name).string() + "' ";
}

/// Every file but the times, its name first.
std::vector<std::pair<std::string, std::string>> all_bytes(const fs::path& folder) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().filename() != "timing.csv")
      files.emplace_back(fs::relative(entry.path(), folder).string(), bytes_of(entry.path()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Rows of the summary whose job is lost with a rank.
long lost_jobs(const fs::path& out) {
  std::ifstream summary(out / "summary.csv");
  long lost = 0;
  for (std::string line; std::getline(summary, line);)
    lost += line.find("lost with rank") != std::string::npos;
  return lost;
}

void expect_resumed_to_the_same_bytes(const fs::path& folder, const std::string& scene) {
  ASSERT_EQ(test::fingerpad("replay " + scene + " --out one --quiet", folder).exit_code, 0);
  const ShellResult resumed = test::shell(as_ranks(2) + "replay " + scene + " --out o --resume", folder);
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_THAT(resumed.out, HasSubstr(" kept from before)"));
  EXPECT_EQ(all_bytes(folder / "o"), all_bytes(folder / "one"));
}

TEST(Ranks, LeaveTheBytesOfOneProcessAndOfShards) {
  const fs::path folder = folder_with_batch();
  const std::string batch = "replay parts.toml plane.toml --quiet --out ";
  ASSERT_EQ(test::fingerpad(batch + "one", folder).exit_code, 4) << "a mesh is broken";
  const auto one = all_bytes(folder / "one");
  for (const int count : {2, 4}) {
    const std::string out = "ranks" + std::to_string(count);
    const ShellResult ranks = test::shell(as_ranks(count) + batch + out, folder);
    EXPECT_EQ(ranks.exit_code, 4) << ranks.err;
    EXPECT_THAT(ranks.err, HasSubstr("fingerpad: error: 2 jobs (3, 4): broken.off"));
    EXPECT_EQ(all_bytes(folder / out), one) << count;
  }
  for (const char* shard : {"3", "1", "2"})
    test::shell(as_ranks(2) + batch + "shards --shard " + shard + "/3", folder);
  ASSERT_EQ(test::fingerpad("merge shards --out merged", folder).exit_code, 0);
  EXPECT_EQ(all_bytes(folder / "merged"), one) << "ranks within shards, in any order";
}

TEST(Ranks, WhoseProcessDiesLoseWhatItHadBegunAndTheRestIsDone) {
  const fs::path folder = folder_with_batch(100000);
  const ShellResult run = test::shell(
      support("kill_rank") + "o 1 worker env " + as_ranks(2) + "replay plane.toml --out o", folder);
  EXPECT_EQ(run.exit_code, 4) << run.err;
  EXPECT_THAT(run.out, HasSubstr("3 of 4 jobs done, traces and summary.csv in o\n"));
  EXPECT_THAT(run.err, HasSubstr("lost with rank 1 on "));
  EXPECT_THAT(run.err,
              HasSubstr("its process was ended by signal 9 (Killed); the same command with --resume"));
  EXPECT_EQ(lost_jobs(folder / "o"), 1);
  EXPECT_FALSE(fs::exists(folder / "o" / ".fingerpad" / "ranks-1of1"));
  expect_resumed_to_the_same_bytes(folder, "plane.toml");
}

/// What is told where a rank was killed as a whole at one of four jobs.
void expect_one_lost_with_its_rank(const ShellResult& run, const fs::path& folder) {
  EXPECT_THAT(run.out, HasSubstr("3 of 4 jobs done, traces and summary.csv in o\n"));
  EXPECT_THAT(run.err, HasSubstr("that rank was killed; the same command with --resume"));
  EXPECT_EQ(lost_jobs(folder / "o"), 1);
}

TEST(Ranks, ThatDieAltogetherDoNotEndTheOthersWhereTheLauncherIsAskedToGoOn) {
  const fs::path folder = folder_with_batch(100000);
  const ShellResult run = test::shell(
      support("kill_rank") + "o 0 rank env " + as_ranks(2, "--enable-recovery") + "replay plane.toml --out o",
      folder);
  EXPECT_EQ(run.exit_code, 0) << "such a launcher keeps its ranks' codes to itself: " << run.err;
  expect_one_lost_with_its_rank(run, folder);
  expect_resumed_to_the_same_bytes(folder, "plane.toml");
}

TEST(Ranks, ThatDieAltogetherEndTheScriptOnOpenMpisLauncherWithFour) {
  const fs::path folder = folder_with_batch(100000);
  const std::string script =
      "env HWLOC_COMPONENTS=-gl OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
      "OMPI_MCA_rmaps_base_oversubscribe=1 LAUNCHER=mpirun RANKS=2 FINGERPAD='" +
      test::program().string() + "' '" + (test::source_dir() / "tools" / "slurm_ranks").string() +
      "' o plane.toml";
  const ShellResult run = test::shell(support("kill_rank") + "o 0 rank " + script, folder);
  EXPECT_EQ(run.exit_code, 4) << run.err;
  expect_one_lost_with_its_rank(run, folder);
  EXPECT_THAT(run.err, HasSubstr("slurm_ranks: some jobs are not done: the same command again does them"));
  const ShellResult again = test::shell(script, folder);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  ASSERT_EQ(test::fingerpad("replay plane.toml --out one --quiet", folder).exit_code, 0);
  EXPECT_EQ(all_bytes(folder / "o"), all_bytes(folder / "one"));
}

TEST(Ranks, ThatDieAltogetherEndTheRunOfALauncherThatIsNotAsked) {
  const fs::path folder = folder_with_batch(100000);
  const ShellResult run =
      test::shell(support("kill_rank") + "o 0 rank env " + as_ranks(2) + "replay plane.toml --out o", folder);
  EXPECT_EQ(run.exit_code, 137) << "128 and the signal: " << run.err;
  EXPECT_THAT(run.err,
              HasSubstr("fingerpad: warning: o: rank 0 was killed, and what started the ranks ends the "
                        "others for that; the same command with --resume does the rest. Open MPI lets "
                        "the others go on where it is told `mpirun --enable-recovery`\n"));
  // What was done stays; a run by itself does the rest.
  ASSERT_EQ(test::fingerpad("replay plane.toml --out o --quiet --resume", folder).exit_code, 0);
  ASSERT_EQ(test::fingerpad("replay plane.toml --out one --quiet", folder).exit_code, 0);
  EXPECT_EQ(all_bytes(folder / "o"), all_bytes(folder / "one"));
}

TEST(Ranks, ThatAreAllKilledLeaveNothingThatARunByItselfDoesNotPutRight) {
  const fs::path folder = folder_with_batch();
  fs::create_directories(folder / "o" / ".fingerpad" / "ranks-1of1");
  std::ofstream(folder / "o" / ".fingerpad" / "ranks-1of1" / "board") << "left behind";
  ASSERT_EQ(test::fingerpad("replay plane.toml --out o --quiet --resume", folder).exit_code, 0);
  ASSERT_EQ(test::fingerpad("replay plane.toml --out one --quiet", folder).exit_code, 0);
  EXPECT_EQ(all_bytes(folder / "o"), all_bytes(folder / "one"));
}

TEST(Ranks, WhoseLauncherIsGoneBeforeTheyBeginWriteNothing) {
  const fs::path folder = folder_with_batch();
  for (const char* rank : {"0", "1"}) {
    // Nobody reads its standard error, as when mpirun was killed.
    const ShellResult run = test::shell(
        "exec 2> >(exit 0)\nwait $!\nOMPI_COMM_WORLD_SIZE=2 PMIX_NAMESPACE=x "
        "OMPI_COMM_WORLD_RANK=" +
            std::string(rank) + " '" + test::program().string() + "' replay plane.toml --out o\necho ended",
        folder);
    EXPECT_EQ(run.out, "ended\n");
    EXPECT_FALSE(fs::exists(folder / "o")) << rank;
  }
}

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

TEST(Ranks, ShareABatchUnderSlurmByTheScriptsInTools) {
  const fs::path folder = folder_with_batch(100000);
  const std::string tool = "'" + (test::source_dir() / "tools").string() + "/";
  std::ofstream(folder / "on_slurm")
      << "set -e\nexport FINGERPAD='" << test::program().string()
      << "'\n"
      // Shards in any order: the last first, the others when it is done.
      << "SHARDS=3 sbatch --quiet --wait --array=3 --cpus-per-task=1 " << tool
      << "slurm_shards' shards plane.toml\n"
      << "SHARDS=3 sbatch --quiet --wait --array=1,2 --cpus-per-task=1 " << tool
      << "slurm_shards' shards plane.toml\n"
      << "sbatch --quiet --wait --nodes=1 --ntasks-per-node=2 --cpus-per-task=1 " << tool
      << "slurm_ranks' ranks plane.toml\n"
      << support("kill_rank")
      << "killed 1 rank sbatch --quiet --wait --nodes=1 --ntasks-per-node=2 --cpus-per-task=1 " << tool
      << "slurm_ranks' killed plane.toml && code=0 || code=$?\n"
      << "echo killed $code\n"
      << "sbatch --quiet --wait --nodes=1 --ntasks-per-node=2 --cpus-per-task=1 " << tool
      << "slurm_ranks' killed plane.toml\n";
  const ShellResult run = test::shell(support("with_slurm") + "bash on_slurm", folder);
  if (run.exit_code == 77) GTEST_SKIP() << run.err;
  std::string logs;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".log") logs += bytes_of(entry.path());
  }
  ASSERT_EQ(run.exit_code, 0) << run.err << logs;
  EXPECT_THAT(run.out, HasSubstr("killed 4\n"));
  EXPECT_THAT(logs, HasSubstr("lost with rank 1 on "));
  EXPECT_THAT(logs, HasSubstr("3 of 4 jobs done"));
  ASSERT_EQ(test::fingerpad("replay plane.toml --out one --quiet", folder).exit_code, 0);
  ASSERT_EQ(test::fingerpad("merge shards --out merged", folder).exit_code, 0);
  for (const char* out : {"merged", "ranks", "killed"})
    EXPECT_EQ(all_bytes(folder / out), all_bytes(folder / "one")) << out;
}

}  // namespace
}  // namespace fingerpad::ranks_test

#endif
