#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "rank_batch.hpp"
#include "support/shell.hpp"

// A batch that real ranks share, under mpirun and under Slurm, and what is left when one of them dies.

#ifdef FINGERPAD_MPI

namespace fingerpad::ranks_test {
namespace {
namespace fs = std::filesystem;
using test::all_bytes;
using test::bytes_of;
using test::folder_with_batch;
using test::ShellResult;
using testing::AnyOf;
using testing::HasSubstr;

/// Without hwloc's look at an X server, with which mpirun would end.
std::string as_ranks(int count, const std::string& options = "") {
  return "HWLOC_COMPONENTS=-gl OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun "
         "--oversubscribe " +
         options + " -n " + std::to_string(count) + " '" + test::program().string() + "' ";
}

std::string support(const std::string& name) {
  return "'" + (test::source_dir() / "tests" / "support" / name).string() + "' ";
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
    EXPECT_THAT(ranks.err, HasSubstr("fingerpad: error: 2 jobs (parts-0003, parts-0004): broken.off"));
    EXPECT_EQ(all_bytes(folder / out), one) << count;
  }
  for (const char* shard : {"3", "1", "2"})
    test::shell(as_ranks(2) + batch + "shards --shard " + shard + "/3", folder);
  ASSERT_EQ(test::fingerpad("merge shards --out merged", folder).exit_code, 0);
  EXPECT_EQ(all_bytes(folder / "merged"), one) << "ranks within shards, in any order";
}

TEST(Ranks, WithoutTracesALostJobNamesNoResume) {
  const fs::path folder = folder_with_batch(100000, 40);  // a job that writes nothing ends soon
  const ShellResult run = test::shell(
      support("kill_rank") + "o 1 worker env " + as_ranks(2) + "replay plane.toml --out o --format none",
      folder);
  EXPECT_EQ(run.exit_code, 4) << run.err;
  EXPECT_THAT(run.err, HasSubstr("its process was ended by signal 9 (Killed); without traces the same "
                                 "command does all again"));
  EXPECT_THAT(run.err, Not(HasSubstr("--resume")));
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
  // The launcher lets the others be for a second before it kills them, which is little on a busy machine.
  const std::string patient = "--mca odls_base_sigkill_timeout 5";
  const ShellResult run = test::shell(
      support("kill_rank") + "o 0 rank env " + as_ranks(2, patient) + "replay plane.toml --out o", folder);
  EXPECT_EQ(run.exit_code, 137) << "128 and the signal: " << run.err;
  // Where the other rank is through before the launcher ends it, that tells what was lost.
  EXPECT_THAT(run.err,
              AnyOf(HasSubstr("fingerpad: warning: o: rank 0 was killed: where nobody asked for the "
                              "end, what started the ranks ends the others for that; the same "
                              "command with --resume does the rest. Open MPI lets the others go on "
                              "where it is told `mpirun --enable-recovery`\n"),
                    HasSubstr("that rank was killed; the same command with --resume does the rest")));
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

TEST(Ranks, ShareABatchUnderSlurmByTheScriptsInTools) {
  const fs::path folder = folder_with_batch(250000);
  const std::string tool = "'" + (test::source_dir() / "tools").string() + "/";
  // As `sbatch --wait`, which looks after 2 s and then after 8 more.
  std::ofstream(folder / "batch") << R"sh(job=$(sbatch --parsable "$@")
until scontrol --oneliner show job "$job" |
  awk '!/JobState=(COMPLETED|FAILED|NODE_FAIL|CANCELLED) / { left = 1 } END { exit left || NR == 0 }'; do sleep 0.1; done
exit "$(scontrol --oneliner show job "$job" | sed -nE 's/.* ExitCode=([0-9]+):.*/\1/p' | sort -n | tail -n 1)"
)sh";
  std::ofstream(folder / "on_slurm")
      << "set -e\nexport FINGERPAD='" << test::program().string()
      << "'\n"
      // Shards in any order: the last first, the others when it is done.
      << "SHARDS=3 bash batch --array=3 --cpus-per-task=1 " << tool << "slurm_shards' shards plane.toml\n"
      << "SHARDS=3 bash batch --array=1,2 --cpus-per-task=1 " << tool << "slurm_shards' shards plane.toml\n"
      << "bash batch --nodes=1 --ntasks-per-node=2 --cpus-per-task=1 " << tool
      << "slurm_ranks' ranks plane.toml\n"
      << support("kill_rank") << "killed 1 rank bash batch --nodes=1 --ntasks-per-node=2 --cpus-per-task=1 "
      << tool << "slurm_ranks' killed plane.toml && code=0 || code=$?\n"
      << "echo killed $code\n"
      << "bash batch --nodes=1 --ntasks-per-node=2 --cpus-per-task=1 " << tool
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
