#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <utility>
#include <vector>

#include "support/paths.hpp"
#include "support/shell.hpp"
#include "trace/hdf5_file.hpp"

// Shards put together, and results set against each other.

namespace fingerpad::merge_compare_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using testing::HasSubstr;
using testing::Not;

/// A set of five jobs over a plane.
fs::path folder_with_set(const std::string& mu = "0.2") {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\nmu_dynamic = " << mu
      << "\n[motion]\nkind = \"line\"\nfrom_m = [0, 0, -0.001]\nto_m = [0.02, 0, -0.001]\nspeed_m_per_s = "
         "0.2\n"
         "[[set]]\nseed = { from = 1, to = 5, steps = 5 }\n";
  return folder;
}

/// Runs it; `out` may have options behind it.
void replay_into(const fs::path& folder, const std::string& out) {
  EXPECT_EQ(test::fingerpad("replay s.toml --quiet --out " + out, folder).exit_code, 0) << out;
}

/// Gives the scene other words in the place of these.
void change_scene(const fs::path& folder, const std::string& words, const std::string& others) {
  std::string text = bytes_of(folder / "s.toml");
  text.replace(text.find(words), words.size(), others);
  std::ofstream(folder / "s.toml") << text;
}

TEST(Merge, OfShardsIsByteForByteASingleRun) {
  const fs::path folder = folder_with_set();
  std::ofstream(folder / "plain.toml") << "[[part]]\nmesh = \"none.stl\"\n[motion]\nfile = \"none.csv\"\n";
  const std::string scenes = "replay s.toml plain.toml --quiet --out ";
  EXPECT_EQ(test::fingerpad(scenes + "whole", folder).exit_code, 4) << "plain.toml has no mesh";
  for (const char* shard : {"1", "2", "3"}) {
    test::fingerpad(scenes + "apart" + shard + " --shard " + shard + "/3", folder);
    test::fingerpad(scenes + "beside --shard " + std::string(shard) + "/3", folder);
  }
  const auto merged = test::fingerpad("merge apart2 apart1 apart3 --out merged", folder);
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(merged.out, "3 shards: 6 jobs, 5 traces and summary.csv in merged\n");
  ASSERT_EQ(test::fingerpad("merge beside --out beside", folder).exit_code, 0);
  for (const char* name :
       {"summary.csv", "jobs.csv", "s-0001.h5", "s-0005.h5", ".fingerpad/s-0004.h5.proof"}) {
    EXPECT_EQ(bytes_of(folder / "whole" / name), bytes_of(folder / "merged" / name)) << name;
    EXPECT_EQ(bytes_of(folder / "whole" / name), bytes_of(folder / "beside" / name)) << name;
  }
}

TEST(Merge, OfShardsWithoutTracesPutsTheirTablesTogether) {
  const fs::path folder = folder_with_set();
  std::ofstream(folder / "plain.toml") << bytes_of(folder / "s.toml")
                                              .substr(0, bytes_of(folder / "s.toml").find("[[set]]"))
                                              .replace(8, 1, "p");
  for (const std::string scenes : {"s.toml", "plain.toml", "s.toml plain.toml"}) {
    const std::string call = "replay " + scenes + " --format none --quiet --out ";
    fs::remove_all(folder / "o");
    fs::remove_all(folder / "whole");
    ASSERT_EQ(test::fingerpad(call + "whole", folder).exit_code, 0);
    for (const char* shard : {"1/2", "2/2"})
      ASSERT_EQ(test::fingerpad(call + "o --shard " + shard, folder).exit_code, 0);
    const auto merged = test::fingerpad("merge o --out o", folder);
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_THAT(merged.out, HasSubstr(", 0 traces and summary.csv in o\n"));
    EXPECT_EQ(bytes_of(folder / "whole" / "summary.csv"), bytes_of(folder / "o" / "summary.csv"));
  }
}

TEST(Merge, OfWhatIsNoWholeBatchIsRefused) {
  const fs::path folder = folder_with_set();
  for (const char* shard : {"1/3", "2/3", "1/2"}) {
    const std::string out = std::string("o") + shard[0] + shard[2];
    ASSERT_EQ(test::fingerpad("replay s.toml --quiet --out " + out + " --shard " + shard, folder).exit_code,
              0);
  }
  const auto told = [&](const std::string& folders) {
    const auto result = test::fingerpad("merge " + folders + " --out m", folder);
    EXPECT_EQ(result.exit_code, 3) << folders;
    return result.err;
  };
  EXPECT_THAT(told("o13 o23"), HasSubstr("shard 3 of 3 is in none of the folders"));
  EXPECT_THAT(told("o13 o13 o23"), HasSubstr("shard 1 of 3 is there twice"));
  EXPECT_THAT(told("o13 o12"), HasSubstr("merge one batch at a time"));
  fs::create_directory(folder / "empty");
  EXPECT_THAT(told("empty"), HasSubstr("empty: holds no shard of a batch"));
  replay_into(folder, "o13 --shard 3/3");
  fs::remove(folder / "o23" / "s-0002.h5");
  EXPECT_THAT(told("o13 o23"), HasSubstr("s-0002.h5: is gone, but its shard's summary has it as done"));
  const std::string summary = bytes_of(folder / "o13" / "summary-1of3.csv");
  std::ofstream(folder / "o13" / "summary-1of3.csv") << summary.substr(0, summary.rfind("s,4,"));
  EXPECT_THAT(told("o13 o23"), HasSubstr("summary-1of3.csv: has 1 of 2 jobs: run that shard to its end (with "
                                         "--resume where it writes traces)"));
  std::ofstream(folder / "o13" / "summary-1of3.csv") << summary;
  std::ofstream(folder / "o13" / "summary-3of3.csv") << "scene,job,seed,status\ns,3,3,ok\n";
  EXPECT_THAT(told("o13 o23"), HasSubstr("it is of another batch"));
  EXPECT_FALSE(fs::exists(folder / "m"));
}

TEST(Compare, TellsWhatChangedByJobAndColumn) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a");
  replay_into(folder, "b --format h5 --jobs 1");
  const auto alike = test::fingerpad("compare a b", folder);
  EXPECT_EQ(alike.exit_code, 0) << alike.out;
  EXPECT_EQ(alike.out, "0 of 5 traces changed from a to b\n");

  change_scene(folder, "mu_dynamic = 0.2", "mu_dynamic = 0.1");
  replay_into(folder, "c");
  fs::remove(folder / "c" / "s-0005.h5");
  const auto changed = test::fingerpad("compare a c", folder);
  EXPECT_EQ(changed.exit_code, 4);
  EXPECT_THAT(changed.out, HasSubstr("s-0002.h5 (seed 2): ffx_n differs by up to 0.1 N at t = "));
  EXPECT_THAT(changed.out, HasSubstr("s-0005.h5 (seed 5): is in a alone"));
  EXPECT_THAT(changed.out, Not(HasSubstr(": fn_n differs")));
  EXPECT_THAT(changed.out, HasSubstr("5 of 5 traces changed from a to c"));
  fs::remove(folder / "a" / "s-0005.h5");
  const auto tolerated = test::fingerpad("compare a c --tolerance 2", folder);
  EXPECT_EQ(tolerated.exit_code, 0) << tolerated.out;
}

TEST(Compare, OfAFolderThatHoldsNothingToCompareIsRefused) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a");
  fs::create_directory(folder / "none");
  for (const char* folders : {"none none", "none a", "a none"}) {
    const auto refused = test::fingerpad(std::string("compare ") + folders, folder);
    EXPECT_EQ(refused.exit_code, 3) << folders;
    EXPECT_THAT(refused.err, HasSubstr("none: holds no traces, and no summary of jobs")) << folders;
  }
  replay_into(folder, "b --format none");
  fs::remove(folder / "a" / "summary.csv");
  EXPECT_THAT(test::fingerpad("compare a b", folder).err,
              HasSubstr("b: holds no traces, and a no summary of jobs to compare by"));
}

TEST(Compare, SetsHdf5TracesAgainstThoseOfCsvAndSaysSo) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a");
  replay_into(folder, "b --format csv");
  const auto alike = test::fingerpad("compare a b", folder);
  EXPECT_EQ(alike.exit_code, 0) << alike.out;
  EXPECT_EQ(alike.out,
            "a: 5 traces are HDF5 here and CSV in b: the numbers in them are compared\n"
            "0 of 5 traces changed from a to b\n");
  change_scene(folder, "mu_dynamic = 0.2", "mu_dynamic = 0.1");
  replay_into(folder, "c --format csv --shard 1/5");
  const auto changed = test::fingerpad("compare c a", folder);
  EXPECT_EQ(changed.exit_code, 4);
  EXPECT_THAT(changed.out, HasSubstr("c: 1 trace is CSV here and HDF5 in a"));
  EXPECT_THAT(changed.out, HasSubstr("s-0001.csv (seed 1): ffx_n differs by up to 0.1 N at t = "));
  EXPECT_THAT(changed.out, HasSubstr("4 jobs are in a alone: s-0002.h5"));
  // Of a job that has both, those of one format.
  replay_into(folder, "a --format csv");
  EXPECT_THAT(test::fingerpad("compare a b", folder).out,
              testing::AllOf(Not(HasSubstr("here and")), HasSubstr("5 jobs are in a alone: s-0001.h5")));
}

/// A table as other programs write one, which has names of a trace's columns.
void write_foreign_table(const fs::path& path) {
  hdf5::Handle file = hdf5::create_file(path.string());
  for (const char* name : {"t_s", "fx_n"}) {
    const hdf5::Handle column = hdf5::create_column(file, name, hdf5::NumberType::float64, "");
    hdf5::append(column, 0, std::vector<double>{0, 1, 2});
  }
  hdf5::close_file(std::move(file));
}

TEST(Compare, CountsNoTableOfAnotherProgram) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a");
  replay_into(folder, "b");
  write_foreign_table(folder / "a" / "forces.h5");
  const auto alike = test::fingerpad("compare a b", folder);
  EXPECT_EQ(alike.exit_code, 0);
  EXPECT_EQ(alike.out,
            "a: 1 file with a trace's ending but no trace in it is passed over: forces.h5\n"
            "0 of 5 traces changed from a to b\n");
  fs::create_directory(folder / "tables");
  write_foreign_table(folder / "tables" / "forces.h5");
  EXPECT_THAT(test::fingerpad("compare tables tables", folder).err, HasSubstr("tables: holds no traces"));
  // In the place of a trace it is told, as what is damaged.
  write_foreign_table(folder / "b" / "s-0003.h5");
  const auto replaced = test::fingerpad("compare a b", folder);
  EXPECT_EQ(replaced.exit_code, 4);
  EXPECT_THAT(replaced.out, HasSubstr("1 of 5 traces changed from a to b\n"));
}

TEST(Compare, TellsADamagedTraceAndComparesTheRest) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a --format csv");
  replay_into(folder, "b --format csv");
  std::ofstream(folder / "b/s-0001.csv") << "t_s,x_m,y_m,z_m,pha";
  std::ofstream(folder / "b/s-0002.csv") << "";
  std::ofstream(folder / "a/s-0003.csv") << "t_s,x_m,y_m,z_m,pha";
  const auto found = test::fingerpad("compare a b", folder);
  EXPECT_EQ(found.exit_code, 4);
  EXPECT_THAT(found.out, Not(HasSubstr("alone")));
  EXPECT_THAT(found.out, HasSubstr("3 of 5 traces changed from a to b\n"));
  for (const std::string damage : {"b/s-0001.csv: ends within its header", "b/s-0002.csv: is empty",
                                   "a/s-0003.csv: ends within its header"}) {
    EXPECT_THAT(found.err, HasSubstr("fingerpad: error: " + damage));
    EXPECT_THAT(found.out, HasSubstr("cannot be compared: " + damage));
  }
  replay_into(folder, "h");
  std::ofstream(folder / "h/s-0004.h5") << "no HDF5";
  EXPECT_THAT(test::fingerpad("compare h a", folder).err, HasSubstr("fingerpad: error: h/s-0004.h5"));
}

TEST(Compare, TellsMixedFormatsInBothDirections) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a --shard 1/2");
  replay_into(folder, "a --shard 2/2 --format csv");
  replay_into(folder, "b --shard 1/2 --format csv");
  replay_into(folder, "b --shard 2/2");
  const auto found = test::fingerpad("compare a b", folder);
  EXPECT_THAT(found.out, HasSubstr("a: 3 traces are HDF5 here and CSV in b"));
  EXPECT_THAT(found.out, HasSubstr("a: 2 traces are CSV here and HDF5 in b"));
}

TEST(Compare, SetsRowsAgainstEachOtherByTheirTime) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "whole --format csv");
  replay_into(folder, "thin --every 10 --format csv");
  const auto found = test::fingerpad("compare whole thin", folder);
  EXPECT_EQ(found.exit_code, 4);
  EXPECT_THAT(found.out,
              HasSubstr("s-0001.csv (seed 1): 101 ticks, then 11; 11 times are in both, and compared\n"));
  EXPECT_THAT(found.out, Not(HasSubstr("differs")));
}

/// A recording's clock may count from 1970, where a double steps by a quarter of a microsecond.
TEST(Compare, SetsRowsOfAClockThatCountsFrom1970ByTheirTimeToo) {
  const fs::path folder = folder_with_set();
  std::ofstream rub(folder / "rub.csv");
  rub << "t_s,x_m,y_m,z_m\n";
  for (int i = 0; i <= 100; ++i) rub << "1700000000." << 100 + i << "," << 1e-4 * i << ",0,-0.001\n";
  rub.close();
  std::ofstream(folder / "s.toml") << "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n"
                                      "[motion]\nfile = \"rub.csv\"\nrate_hz = 1000\n";
  replay_into(folder, "whole");
  replay_into(folder, "thin --every 10");
  const auto found = test::fingerpad("compare whole thin", folder);
  EXPECT_THAT(found.out, Not(HasSubstr("differs")));
  EXPECT_THAT(found.out, HasSubstr("101 ticks, then 11; 11 times are in both"));
}

TEST(Compare, SaysWhereAJobIsAnotherInTheSecondFolder) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a");
  change_scene(folder, "seed = { from = 1, to = 5, steps = 5 }",
               "friction.law = [\"none\", \"none\", \"none\", \"none\", \"none\"]");
  replay_into(folder, "b");
  EXPECT_THAT(test::fingerpad("compare a b", folder).out,
              HasSubstr("s-0001.h5 (seed 1; now law none): ffx_n"));
}

TEST(Compare, CountsJobsOfOneFolderAlone) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a");
  replay_into(folder, "b --shard 1/5");
  const auto few = test::fingerpad("compare a b --out alone.csv", folder);
  EXPECT_EQ(few.exit_code, 4);
  EXPECT_THAT(
      few.out,
      HasSubstr("4 jobs are in a alone: s-0002.h5 (seed 2), s-0003.h5 (seed 3), s-0004.h5 (seed 4) and 1 "
                "more\n4 of 5 traces changed from a to b\n"));
  EXPECT_THAT(few.out, Not(HasSubstr("first summary")));
  const std::string rows = bytes_of(folder / "alone.csv");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 1 + 4);
  const auto quiet = test::fingerpad("compare a b --quiet --out alone.csv", folder);
  EXPECT_EQ(quiet.exit_code, 4);
  EXPECT_EQ(quiet.out, "");
}

TEST(Compare, TellsAFailedJobOnce) {
  const fs::path folder = folder_with_set();
  const std::string text = bytes_of(folder / "s.toml");
  const auto with_speeds = [&](const std::string& speeds) {
    std::ofstream(folder / "s.toml") << text.substr(0, text.find("seed = {"))
                                     << "motion.speed_m_per_s = " << speeds << "\n";
  };
  with_speeds("[0.1, 0.2]");
  replay_into(folder, "a");
  with_speeds("[0.1, -1]");
  ASSERT_EQ(test::fingerpad("replay s.toml --quiet --out b", folder).exit_code, 4);
  const auto found = test::fingerpad("compare a b", folder);
  EXPECT_THAT(found.out, HasSubstr("s job 2 (motion.speed_m_per_s 0.2): was 'ok', is 's.toml"));
  EXPECT_THAT(found.out, HasSubstr("'speed_m_per_s' in [motion] is -1"));
  EXPECT_THAT(found.out, Not(HasSubstr("alone")));
  EXPECT_THAT(found.out, HasSubstr("1 of 2 traces changed from a to b\n"));
}

/// The rows of a table without its last columns, or with one more.
void write_other_columns(const fs::path& from, const fs::path& to, const std::string& awk) {
  EXPECT_EQ(test::shell("awk -F, -v OFS=, '" + awk + "' '" + from.string() + "' > '" + to.string() + "'",
                        to.parent_path())
                .exit_code,
            0);
}

TEST(Compare, GoesByTheSummariesWhereOneFolderHasNoTraces) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a");
  replay_into(folder, "b --format none");
  const auto alike = test::fingerpad("compare a b", folder);
  EXPECT_EQ(alike.exit_code, 0);
  EXPECT_EQ(alike.out,
            "summary.csv: the other folder has no traces, as of --format none: those of a are not compared\n"
            "0 of 5 jobs changed from a to b\n");
}

TEST(Compare, CountsAJobThatTheFolderWithoutTracesLacks) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a");
  replay_into(folder, "b --format none");
  ASSERT_EQ(test::shell("head -n -1 b/summary.csv >cut && mv cut b/summary.csv", folder).exit_code, 0);
  for (const std::string& pair : {std::string("a b"), std::string("b a")}) {
    const auto found = test::fingerpad("compare " + pair, folder);
    EXPECT_EQ(found.exit_code, 4) << found.out;
    EXPECT_THAT(found.out, HasSubstr("summary alone"));
    EXPECT_THAT(found.out, HasSubstr("1 of 5 jobs changed"));
  }
}

TEST(Compare, WritesOverNothingThatItReadsButOverItsOwnTable) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a");
  replay_into(folder, "b --format csv");
  const std::string before = test::bytes_of(folder / "b/summary.csv");
  for (const std::string out : {"b/summary.csv", "a/../b/summary.csv", "a/jobs.csv"}) {
    const auto refused = test::fingerpad("compare a b --out " + out, folder);
    EXPECT_EQ(refused.exit_code, 3) << out;
    EXPECT_THAT(refused.err, HasSubstr("would be overwritten"));
  }
  EXPECT_EQ(test::bytes_of(folder / "b/summary.csv"), before);
  for (int k = 0; k < 2; ++k)
    EXPECT_EQ(test::fingerpad("compare a b --out b/table.csv", folder).exit_code, 0);
}

TEST(Compare, TellsAColumnThatOneSideLacksAsAbsent) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a --format none");
  fs::create_directory(folder / "b");
  // Without residual_bias_n and residual_lag_s, as an older program's.
  write_other_columns(folder / "a/summary.csv", folder / "b/summary.csv",
                      "{ $(NF-4) = $(NF-2); $(NF-3) = $(NF-1); $(NF-2) = $NF; NF -= 2; print }");
  const auto older = test::fingerpad("compare b a", folder);
  EXPECT_EQ(older.exit_code, 0) << "no job differs";
  EXPECT_EQ(older.out,
            "summary.csv: residual_bias_n is in the second summary alone, and not compared\n"
            "summary.csv: residual_lag_s is in the second summary alone, and not compared\n"
            "0 of 5 jobs changed from b to a\n");

  replay_into(folder, "c --format csv --shard 1/5");
  fs::create_directory(folder / "d");
  write_other_columns(folder / "c/s-0001.csv", folder / "d/s-0001.csv",
                      "{ print $0, NR == 1 ? \"walls\" : 1 }");
  const auto walls = test::fingerpad("compare c d", folder);
  EXPECT_EQ(walls.exit_code, 4);
  EXPECT_EQ(walls.out,
            "s-0001.csv (seed 1): walls is in the second trace alone, and not compared\n"
            "1 of 1 trace changed from c to d\n");

  replay_into(folder, "e --format csv --columns fn_n,mu --shard 1/5");
  EXPECT_THAT(
      test::fingerpad("compare c e", folder).out,
      testing::ContainsRegex("^s-0001.csv \\(seed 1\\): [0-9]+ columns are in the first trace alone, and "
                             "not compared: x_m y_m z_m .*\n1 of 1 trace changed"));
}

TEST(Compare, TellsTheWorstJobsAndListsAllInATable) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a --format none");
  replay_into(folder, "b --format none");
  std::string summary = bytes_of(folder / "b" / "summary.csv");
  for (const char* row : {"s,2,2,ok,101,", "s,3,3,ok,101,", "s,5,5,ok,101,"}) {
    ASSERT_NE(summary.find(row), std::string::npos) << summary;
    summary.replace(summary.find(row) + 9, 3, "102");
  }
  // Of the changes only the fourth job's is one of force.
  const auto row = summary.find("s,4,4,ok,"), next = summary.find('\n', row);
  std::string fourth = summary.substr(row, next - row);
  const auto force = fourth.find(",1,1,");  // mean and greatest normal force
  ASSERT_NE(force, std::string::npos) << fourth;
  fourth.replace(force, 5, ",1,3,");
  summary.replace(row, next - row, fourth);
  std::ofstream(folder / "b" / "summary.csv") << summary;
  const auto worst = test::fingerpad("compare a b --most 2 --out all.csv", folder);
  EXPECT_EQ(worst.exit_code, 4);
  EXPECT_EQ(worst.out,
            "s job 4 (seed 4): max_normal_force_n was 1, is 3 N\n"
            "s job 2 (seed 2): ticks was 101, is 102\n"
            "and 2 more jobs, whose forces differ by no more; --most N tells more, --out FILE.csv all\n"
            "4 of 5 jobs changed from a to b\n"
            "wrote all.csv (a row for each job and column that differs)\n");
  EXPECT_EQ(bytes_of(folder / "all.csv"),
            "job,column,most,unit,at_s,what\n"
            "s job 2 (seed 2),ticks,1,,nan,\"ticks was 101, is 102\"\n"
            "s job 3 (seed 3),ticks,1,,nan,\"ticks was 101, is 102\"\n"
            "s job 4 (seed 4),max_normal_force_n,2,N,nan,\"max_normal_force_n was 1, is 3 N\"\n"
            "s job 5 (seed 5),ticks,1,,nan,\"ticks was 101, is 102\"\n");
  EXPECT_EQ(test::fingerpad("compare a b --out all.txt", folder).exit_code, 2);
}

TEST(Compare, WithoutTracesGoesByTheFiguresOfTheSummaries) {
  const fs::path folder = folder_with_set();
  replay_into(folder, "a --format none");
  replay_into(folder, "b --format none");
  EXPECT_EQ(test::fingerpad("compare a b", folder).out, "0 of 5 jobs changed from a to b\n");
  std::string summary = bytes_of(folder / "b" / "summary.csv");
  summary.replace(summary.find(",ok,"), 4, ",lost,");
  summary.erase(summary.rfind("s,5,"));
  std::ofstream(folder / "b" / "summary.csv") << summary;
  const auto changed = test::fingerpad("compare a b", folder);
  EXPECT_EQ(changed.exit_code, 4);
  EXPECT_EQ(changed.out,
            "s job 1 (seed 1): was 'ok', is 'lost'\n"
            "s job 5 (seed 5): is in the first summary alone\n2 of 5 jobs changed from a to b\n");
  change_scene(folder, "mu_dynamic = 0.2", "mu_dynamic = 0.1");
  replay_into(folder, "c --format none");
  const auto figures = test::fingerpad("compare a c", folder);
  EXPECT_EQ(figures.exit_code, 4);
  EXPECT_THAT(figures.out, testing::ContainsRegex("s job 2 .seed 2.: [^\n]*mean_slip_mu was 0.2, is 0.1"));
  EXPECT_THAT(figures.out, HasSubstr("5 of 5 jobs changed from a to c\n"));
  EXPECT_EQ(test::fingerpad("compare a c --tolerance 100", folder).exit_code, 0);
}

}  // namespace
}  // namespace fingerpad::merge_compare_test
