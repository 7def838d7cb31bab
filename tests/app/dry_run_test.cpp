#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"
#include "trace/trace.hpp"

// What `replay --dry-run` says before anything is written.

namespace fingerpad::dry_run_test {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(DryRun, ListsJobsWithTheirTicksAndReckonsTimeAndDisk) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = \"sine\"\n"
         "centre_m = [0, 0, -0.001]\ndirection = [1, 0, 0]\namplitude_m = 0.05\nfrequency_hz = 1\n"
         "duration_s = 10\n[[set]]\nmotion.rate_hz = [500, 1000]\nplane.mu_static = { from = 0.3, to = 0.4, "
         "steps = 2 }\n";
  const auto planned = test::fingerpad("replay s.toml --out o --dry-run --jobs 1", folder);
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_THAT(planned.out, HasSubstr("s-0001.h5: rate_hz 500, mu_static 0.3: 5001 ticks\n"));
  EXPECT_THAT(planned.out, HasSubstr("s-0004.h5: rate_hz 1000, mu_static 0.4: 10001 ticks\n"));
  EXPECT_THAT(planned.out, HasSubstr("4 jobs, 30004 ticks: about "));
  EXPECT_THAT(planned.out, HasSubstr("on 1 thread, "));
  EXPECT_FALSE(fs::exists(folder / "o")) << "nothing is written";

  // A row is some 200 bytes: the disk is reckoned to a fifth.
  ASSERT_EQ(test::fingerpad("replay s.toml --out o --quiet", folder).exit_code, 0);
  double bytes = 0;
  for (const char* name : {"s-0001.h5", "s-0002.h5", "s-0003.h5", "s-0004.h5"}) {
    bytes += static_cast<double>(fs::file_size(folder / "o" / name));
  }
  const std::size_t at = planned.out.find("thread, ");
  EXPECT_NEAR(std::stod(planned.out.substr(at + 8)) * 1e6, bytes, 0.2 * bytes) << planned.out;
}

/// The ticks that a dry run lists, by job.
std::vector<long> listed_ticks(const std::string& plan) {
  std::vector<long> ticks;
  std::istringstream lines(plan);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t end = line.rfind(" ticks"), begin = line.rfind(": ");
    if (line.ends_with(" ticks") && begin < end) ticks.push_back(std::stol(line.substr(begin + 2)));
  }
  return ticks;
}

/// Where the rate is chosen, a motion's ticks depend on more than [motion]: on the law, the surface, the
/// part.
TEST(DryRun, CountsTheTicksOfMotionsAtAChosenRateByTheWholeScene) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "ball.ply") << test::binary_ply(test::sphere_soup(30, 3));
  std::ofstream(folder / "plate.ply") << test::binary_ply(test::box_soup({80, 80, 20}));
  const std::string part = "[[part]]\nmesh = \"plate.ply\"\n[friction]\nlaw = \"finger-pad\"\n";
  const std::string set =
      "[[set]]\nmesh = [\"ball.ply\", \"plate.ply\"]\nfriction.law = [\"coulomb\", \"finger-pad\"]\n"
      "contact.mu_tolerance = [0.02, 0.5]\n";
  for (const std::string motion :
       {"[motion]\nkind = \"on_surface\"\nshape = \"circle\"\nsize_m = 0.01\nspeed_m_per_s = 0.02\ndepth_m = "
        "0.001\nplace = 1\nrate_hz = \"auto\"\n",
        "[motion]\nkind = \"line\"\nfrom_m = [0, 0, 0.0299]\nto_m = [0.004, 0, 0.0299]\nspeed_m_per_s = "
        "0.01\n"
        "rate_hz = \"auto\"\n"}) {
    std::ofstream(folder / "s.toml") << "name = \"s\"\n" << part << motion << set;
    const auto planned = test::fingerpad("replay s.toml --out o --dry-run", folder);
    ASSERT_EQ(planned.exit_code, 0) << planned.err;
    ASSERT_EQ(test::fingerpad("replay s.toml --out o --quiet", folder).exit_code, 0);
    std::vector<long> ticks;
    for (int job = 1; job <= 8; ++job)
      ticks.push_back(
          std::ssize(read_trace((folder / ("o/s-000" + std::to_string(job) + ".h5")).string()).rows));
    EXPECT_EQ(listed_ticks(planned.out), ticks);
    EXPECT_GT(std::set(ticks.begin(), ticks.end()).size(), 1U) << "rates differ, or this shows nothing";
  }
}

TEST(DryRun, SaysOfEachJobOfAMotionThatCannotBeReadThatItWouldFail) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml")
      << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nfile = \"a.csv\"\n[[set]]\nmotion "
         "= \"*.csv\"\nseed = [1, 2]\n";
  std::ofstream(folder / "a.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0\n0.001,0,0,0\n";
  std::ofstream(folder / "b.csv") << "t_s,x_m\n0,0\n";
  const std::string told = test::fingerpad("replay s.toml --out o --dry-run", folder).out;
  EXPECT_THAT(told, HasSubstr("s-0003.h5: b.csv, seed 1: would fail: b.csv:1: "));
  EXPECT_THAT(told, HasSubstr("s-0004.h5: b.csv, seed 2: would fail as s-0003.h5\n"));
  EXPECT_THAT(told, HasSubstr("4 jobs, of which 2 would fail, "));
}

/// A rub over a part of 182 mm, as `set` varies it.
std::string scene_of_rubs(const fs::path& folder, const std::string& set) {
  fs::copy_file(test::source_dir() / "scenes/parts/housing_coarse.stl", folder / "housing.stl");
  return "name = \"s\"\n[[part]]\nmesh = \"housing.stl\"\n[motion]\nkind = \"on_surface\"\nshape = \"line\"\n"
         "size_m = 0.004\nspeed_m_per_s = 0.02\ndepth_m = 0.001\nrate_hz = 1000\n[[set]]\n" +
         set;
}

/// One fails since its own rub has no room, whichever is the first over their part.
TEST(DryRun, SaysThatAJobWouldFailOfThoseAloneThatDo) {
  const fs::path folder = test::scratch_dir();
  const std::string sizes[] = {"[5, 0.004]", "[0.004, 5]"};
  const std::string scene = scene_of_rubs(folder, "seed = [1, 2]\nmotion.size_m = ");
  for (const std::string& size : sizes) {
    std::ofstream(folder / "s.toml") << scene << size << "\n";
    const auto planned = test::fingerpad("replay s.toml --out o --dry-run", folder);
    const auto done = test::fingerpad("replay s.toml --out o --quiet", folder);
    EXPECT_EQ(planned.exit_code, 4);
    EXPECT_EQ(done.exit_code, 4);
    EXPECT_THAT(planned.out, HasSubstr("seed 1, size_m 5: would fail: s.toml: housing.stl: none of 300 "));
    EXPECT_THAT(planned.out, HasSubstr("seed 2, size_m 5: would fail as "));
    EXPECT_THAT(planned.out, HasSubstr("4 jobs, of which 2 would fail, "));
    EXPECT_THAT(planned.out, HasSubstr("(from 1 of 1 kinds of jobs tried; nothing was written)"));
    std::vector<long> ticks;
    for (int job = 1; job <= 4; ++job) {
      const fs::path trace = folder / ("o/s-000" + std::to_string(job) + ".h5");
      if (fs::exists(trace)) ticks.push_back(std::ssize(read_trace(trace.string()).rows));
    }
    EXPECT_EQ(listed_ticks(planned.out), ticks);
    EXPECT_EQ(ticks.size(), 2U);
    fs::remove_all(folder / "o");
  }
}

TEST(DryRun, SaysOfHowManyMotionsItDoesNotKnowWhetherTheyCanBeLaid) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml") << scene_of_rubs(
      folder, "motion.size_m = { from = 0.001, to = 0.002, steps = 258 }\nseed = [1, 2]\n");
  EXPECT_THAT(test::fingerpad("replay s.toml --out o --dry-run", folder).out,
              HasSubstr("tried; not tried whether the motion of 4 jobs can be laid; nothing was written)"));
}

TEST(DryRun, TellsWhatIsOddInAMotion) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml") << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nfile = "
                                      "\"m.csv\"\nrate_hz = 1000\n[[set]]\nseed = [1, 2]\n";
  std::ofstream file(folder / "m.csv");
  file << "t_s,x_m,y_m,z_m\n";
  for (int i = 0; i < 30; ++i) file << i << "," << 1e-5 * i << ",0,0\n";
  file.close();
  const auto planned = test::fingerpad("replay s.toml --out o --dry-run", folder);
  EXPECT_THAT(planned.err, testing::StartsWith("fingerpad: warning: m.csv: its samples are 1 s apart"));
  EXPECT_EQ(std::count(planned.err.begin(), planned.err.end(), '\n'), 1) << planned.err;
}

/// At most eight kinds are tried, however many small ones stand before the large ones.
TEST(DryRun, ReckonsTheDiskOfPartsThatItDoesNotTryByTheirMeshes) {
  const fs::path folder = test::scratch_dir();
  for (int k = 0; k < 16; ++k)
    std::ofstream(folder / (std::string(1, static_cast<char>('a' + k)) + ".stl"))
        << test::binary_stl(test::sphere_soup(10, k < 9 ? 1 : 4));
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[part]]\nmesh = \"a.stl\"\n[motion]\nkind = \"line\"\nfrom_m = [0, 0, 0.009]\nto_m "
         "= "
         "[0.001, 0, 0.009]\nspeed_m_per_s = 0.1\nrate_hz = 1000\n[[set]]\nmesh = \"*.stl\"\n";
  const auto planned = test::fingerpad("replay s.toml --out o --dry-run --jobs 1", folder);
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_THAT(planned.out, HasSubstr("from 8 of 16 kinds of jobs tried"));
  ASSERT_EQ(test::fingerpad("replay s.toml --out o --quiet", folder).exit_code, 0);
  double bytes = 0;
  for (const auto& entry : fs::directory_iterator(folder / "o"))
    bytes += entry.path().extension() == ".h5" ? static_cast<double>(fs::file_size(entry)) : 0;
  const std::size_t at = planned.out.find("thread, ");
  ASSERT_THAT(planned.out.substr(at), testing::ContainsRegex("^thread, [0-9.]+ MB")) << planned.out;
  EXPECT_NEAR(std::stod(planned.out.substr(at + 8)) * 1e6, bytes, 0.2 * bytes) << planned.out;
}

TEST(DryRun, TellsTheJobsThatWouldFail) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[part]]\nmesh = \"none.stl\"\n[motion]\nkind = \"line\"\n"
         "from_m = [0, 0, 0]\nto_m = [0.1, 0, 0]\nspeed_m_per_s = 1\n[[set]]\nseed = [1, 2]\n";
  const auto planned = test::fingerpad("replay s.toml --out o --dry-run", folder);
  EXPECT_EQ(planned.exit_code, 4);
  EXPECT_THAT(planned.out,
              HasSubstr("s-0001.h5: none.stl, seed 1: would fail: s.toml: [[part]] mesh names none.stl, "
                        "which cannot be read: there is no such file\n"));
  EXPECT_THAT(planned.out, HasSubstr("s-0002.h5: none.stl, seed 2: would fail as s-0001.h5\n"));
}

TEST(DryRun, SaysOfEachJobOverAMeshThatCannotBeTouchedThatItWouldFail) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "bad.stl") << "no mesh at all\n";
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[part]]\nmesh = \"bad.stl\"\n[motion]\nkind = \"line\"\n"
         "from_m = [0, 0, 0]\nto_m = [0.1, 0, 0]\nspeed_m_per_s = 1\n[[set]]\n"
         "seed = { from = 1, to = 99, steps = 99 }\n";
  const std::string told = test::fingerpad("replay s.toml --out o --dry-run", folder).out;
  EXPECT_THAT(told, HasSubstr("s-0001.h5: bad.stl, seed 1: would fail: bad.stl"));
  EXPECT_THAT(told,
              HasSubstr("s-0099.h5: bad.stl, seed 99: would fail as s-0001.h5\nall 99 jobs would fail; "));
}

/// What the try's own file meets is nothing of the jobs.
TEST(DryRun, PlansWithoutItsOwnFileWhereThereIsNoPlaceForIt) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = \"line\"\n"
         "from_m = [0, 0, -0.001]\nto_m = [0.1, 0, -0.001]\nspeed_m_per_s = 0.01\n";
  const std::string call = "'" + test::program().string() + "' replay s.toml --out o --dry-run --format ";
  for (const std::string limit : {"TMPDIR=/proc ", "TMPDIR=/nonexistent ", "ulimit -f 8; "}) {
    for (const std::string format : {"h5", "csv"}) {
      const auto planned = test::shell(limit + call + format, folder);
      EXPECT_EQ(planned.exit_code, 0) << limit << format << planned.err;
      EXPECT_THAT(planned.out,
                  testing::ContainsRegex("1 job, 10001 ticks: about [^,]*, unknown bytes in o "));
      EXPECT_THAT(planned.err,
                  HasSubstr("warning: no trace could be tried, so the disk is not reckoned: " +
                            std::string(limit == "TMPDIR=/nonexistent " ? "TMPDIR names" : "/")));
    }
  }
  EXPECT_EQ(test::shell("TMPDIR=/proc " + call + "none", folder).err, "") << "nothing to try";
}

TEST(DryRun, RefusesAFolderThatCannotBeWritten) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = \"line\"\n"
         "from_m = [0, 0, 0]\nto_m = [0.1, 0, 0]\nspeed_m_per_s = 1\n";
  std::ofstream(folder / "taken") << "a file";
  const auto planned = test::fingerpad("replay s.toml --out taken --dry-run", folder);
  EXPECT_EQ(planned.exit_code, 2);
  EXPECT_THAT(planned.err, HasSubstr("taken: cannot be made: taken is a file, not a folder"));
  EXPECT_EQ(planned.out, "");
}

TEST(FormatNone, KeepsTheSummaryAlone) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = \"line\"\n"
         "from_m = [0, 0, -0.001]\nto_m = [0.02, 0, -0.001]\nspeed_m_per_s = 0.2\n[[set]]\nseed = [1, 2]\n";
  const auto result = test::fingerpad("replay s.toml --out o --format none", folder);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "2 of 2 jobs done, summary.csv in o\n");
  ASSERT_EQ(test::fingerpad("replay s.toml --out traced --quiet", folder).exit_code, 0);
  EXPECT_EQ(test::bytes_of(folder / "o" / "summary.csv"), test::bytes_of(folder / "traced" / "summary.csv"));
  EXPECT_EQ(test::bytes_of(folder / "o" / "jobs.csv"),
            "number,file,scene,mesh,motion,seed\n1,,s,,,1\n2,,s,,,2\n");
  EXPECT_FALSE(fs::exists(folder / "o" / "s-0001.h5"));
  EXPECT_FALSE(fs::exists(folder / "o" / ".fingerpad" / "s-0001.h5.proof"));
  EXPECT_EQ(test::fingerpad("replay s.toml --out o --format none --resume", folder).exit_code, 2);
}

}  // namespace
}  // namespace fingerpad::dry_run_test
