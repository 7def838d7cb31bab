#include "replay/batch.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>

#include "base/error.hpp"
#include "replay/batch_results.hpp"
#include "support/paths.hpp"

namespace fingerpad::batch_test {
namespace {
namespace fs = std::filesystem;

constexpr const char* plane = "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n";
constexpr const char* rub =
    "[motion]\nkind = \"sine\"\ncentre_m = [0, 0, -0.001]\ndirection = [1, 0, 0]\namplitude_m = 0.05\n"
    "frequency_hz = 1\nduration_s = 1\n";

std::string write_scene(const fs::path& folder, const std::string& name, const std::string& rest) {
  const fs::path path = folder / (name + ".toml");
  std::ofstream(path) << "name = \"" << name << "\"\n" << rest;
  return path.string();
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<BatchJob> run(const std::vector<std::string>& scenes, BatchOptions options) {
  auto jobs = batch_jobs(scenes);
  options.version = "test";
  const Ranks ranks;
  run_batch(jobs, options, ranks, [](const BatchJob&) {});
  return jobs;
}

BatchOptions options_for(const fs::path& out, int threads = 1) {
  BatchOptions options;
  options.out_dir = out.string();
  options.threads = threads;
  return options;
}

const std::string sweep = std::string(plane) + rub +
                          "[[set]]\nfriction.law = [\"coulomb\", \"stick-slip\", "
                          "\"finger-pad\"]\nmotion.frequency_hz = [0.5, 1, 2]\n";

TEST(Batch, GivesTheSameBytesOnAnyNumberOfThreads) {
  const auto folder = test::scratch_dir();
  const auto scene = write_scene(folder, "sweep", sweep);
  run({scene}, options_for(folder / "one", 1));
  for (const int threads : {2, 5}) {
    const auto out = folder / std::to_string(threads);
    run({scene}, options_for(out, threads));
    EXPECT_EQ(bytes_of(folder / "one" / "summary.csv"), bytes_of(out / "summary.csv"));
    for (int k = 1; k <= 9; ++k) {
      const std::string name = "sweep-000" + std::to_string(k) + ".h5";
      EXPECT_EQ(bytes_of(folder / "one" / name), bytes_of(out / name)) << name;
    }
  }
}

TEST(Batch, OneBadJobDoesNotStopTheRest) {
  const auto folder = test::scratch_dir();
  const auto good = write_scene(folder, "good", std::string(plane) + rub);
  const auto bad = write_scene(folder, "bad", std::string("[[part]]\nmesh = \"absent.stl\"\n") + rub);
  const auto broken = write_scene(folder, "broken", "[[plane\n");
  const auto jobs = run({bad, broken, good}, options_for(folder / "out", 2));
  ASSERT_EQ(jobs.size(), 3u);
  EXPECT_NE(jobs[0].status.find("absent.stl"), std::string::npos);
  EXPECT_EQ(jobs[0].exit_code, 3);
  EXPECT_NE(jobs[1].status.find("broken.toml:2"), std::string::npos) << jobs[1].status;
  EXPECT_EQ(jobs[2].status, "ok");
  EXPECT_TRUE(fs::exists(folder / "out" / "good.h5"));
}

TEST(Batch, AJobIsUnderWayFromItsBeginningOn) {
  const auto folder = test::scratch_dir();
  const auto scene = write_scene(folder, "sweep", sweep);
  const auto bad = write_scene(folder, "bad", std::string("[[part]]\nmesh = \"absent.stl\"\n") + rub);
  BatchOptions options = options_for(folder / "out", 2);
  std::mutex mutex;
  std::map<std::string, double> first_share;  // told of each job
  options.on_ticks = [&](const BatchJob& job, double share) {
    const std::lock_guard lock(mutex);
    first_share.try_emplace(job.job.scene.name + std::to_string(job.job.number), share);
  };
  run({bad, scene}, options);
  EXPECT_EQ(first_share.size(), 10u);
  for (const auto& [job, share] : first_share) EXPECT_EQ(share, 0) << job;
}

/// Whoever ends it then loses no table.
TEST(Batch, ALoneSceneKeepsAnotherOnesSummaryAsItBegins) {
  const auto folder = test::scratch_dir();
  const auto other = write_scene(folder, "other", std::string(plane) + rub);
  run({other}, options_for(folder / "out"));
  const std::string summary = bytes_of(folder / "out" / "summary.csv");
  BatchOptions options = options_for(folder / "out");
  options.on_ticks = [&](const BatchJob&, double share) {
    const fs::path kept = folder / "out" / "summary.kept-1.csv";
    EXPECT_EQ(fs::exists(kept), share > 0) << share;
    if (share > 0) {
      EXPECT_EQ(bytes_of(kept), summary);
    }
  };
  run({write_scene(folder, "alone", std::string(plane) + rub)}, options);
  EXPECT_TRUE(fs::exists(folder / "out" / "summary.csv"));
  EXPECT_FALSE(fs::exists(folder / "out" / "summary.kept-2.csv"));
}

TEST(Batch, ShardsTogetherMakeTheWhole) {
  const auto folder = test::scratch_dir();
  const auto scene = write_scene(folder, "sweep", sweep);
  run({scene}, options_for(folder / "whole"));
  for (int shard = 1; shard <= 2; ++shard) {
    BatchOptions options = options_for(folder / "shards");
    options.shard = shard;
    options.shard_count = 2;
    run({scene}, options);
  }
  for (int k = 1; k <= 9; ++k) {
    const std::string name = "sweep-000" + std::to_string(k) + ".h5";
    EXPECT_EQ(bytes_of(folder / "whole" / name), bytes_of(folder / "shards" / name)) << name;
  }
}

TEST(Batch, AKeptTableIsNoShards) {
  const auto folder = test::scratch_dir();
  const std::string set = "[[set]]\nseed = [1, 2, 3, 4]\n";
  const auto scene = write_scene(folder, "set", std::string(plane) + rub + set);
  const auto run_shard = [&](int shard, bool resume) {
    BatchOptions options = options_for(folder / "out");
    options.shard = shard;
    options.shard_count = 2;
    options.resume = resume;
    run({scene}, options);
  };
  run_shard(1, false);
  run_shard(2, false);
  write_scene(folder, "set", "[[part]]\nmesh = \"absent.stl\"\n" + std::string(rub) + set);
  run_shard(1, false);
  ASSERT_TRUE(fs::exists(folder / "out" / "summary-1of2.kept-1.csv"));
  write_scene(folder, "set", std::string(plane) + rub + set);
  run_shard(1, true);
  EXPECT_EQ(read_batch_results((folder / "out").string()).jobs.size(), 4U);
}

TEST(Batch, NoKeptTableIsWrittenOver) {
  const auto folder = test::scratch_dir();
  for (const char* name : {"first", "second"})
    run({write_scene(folder, name, std::string(plane) + rub)}, options_for(folder / "out"));
  const fs::path timing = folder / "out" / "timing.kept-1.csv";
  const std::string bytes = bytes_of(timing);
  fs::remove(folder / "out" / "summary.kept-1.csv");
  run({write_scene(folder, "third", std::string(plane) + rub)}, options_for(folder / "out"));
  EXPECT_EQ(bytes_of(timing), bytes);
  EXPECT_TRUE(fs::exists(folder / "out" / "summary.kept-2.csv"));
}

TEST(Batch, ResumeKeepsFinishedTracesOfTheSameRunOnly) {
  const auto folder = test::scratch_dir();
  const auto scene = write_scene(folder, "s", std::string(plane) + rub);
  BatchOptions options = options_for(folder / "out");
  options.resume = true;
  run({scene}, options);
  const auto trace = folder / "out" / "s.h5";
  const std::string summary = bytes_of(folder / "out" / "summary.csv");
  const auto made = fs::last_write_time(trace);

  run({scene}, options);
  EXPECT_EQ(fs::last_write_time(trace), made) << "a finished run is kept";
  EXPECT_EQ(bytes_of(folder / "out" / "summary.csv"), summary) << "and its figures are the same";

  const std::string first = bytes_of(trace);
  write_scene(folder, "s", std::string(plane) + rub + "[friction]\nlaw = \"coulomb\"\n");
  run({scene}, options);
  EXPECT_NE(bytes_of(trace), first) << "another run is made again";

  std::ofstream(trace, std::ios::trunc) << "torn";
  const auto jobs = run({scene}, options);
  EXPECT_EQ(jobs[0].status, "ok");
  EXPECT_GT(fs::file_size(trace), 1000u) << "what is no trace is made again";
}

TEST(Batch, TellsOfTracesThatAnEarlierLargerSetHasLeft) {
  const auto folder = test::scratch_dir();
  const std::string set = std::string(plane) + rub + "[[set]]\nseed = ";
  std::vector<std::string> told;
  BatchOptions options = options_for(folder / "out");
  options.resume = true;
  options.on_kept = [&told](const std::string& words) { told.push_back(words); };
  run({write_scene(folder, "s", set + "[1, 2, 3, 4]\n")}, options);
  // Neither another set's, nor a file that no replay has made.
  run({write_scene(folder, "s-2", set + "[1, 2]\n")}, options);
  std::ofstream(folder / "out" / "s-0009.csv") << "mine";
  told.clear();
  const auto jobs = run({write_scene(folder, "s", set + "[1, 2]\n")}, options);
  EXPECT_TRUE(jobs[0].kept && jobs[1].kept) << "by content, whatever the number of jobs";
  ASSERT_EQ(told.size(), 2u) << "after the line on the other set's summary";
  EXPECT_EQ(told[1], (folder / "out").string() +
                         ": 2 traces are there from an earlier run, which this one does "
                         "not write: s-0003.h5 to s-0004.h5; delete them where nobody needs them");
  told.clear();
  run({write_scene(folder, "s", set + "[1, 2, 3, 4]\n")}, options);
  EXPECT_TRUE(told.empty());
}

TEST(Batch, RefusesTwoScenesOfOneName) {
  const auto folder = test::scratch_dir();
  fs::create_directories(folder / "b");
  const auto a = write_scene(folder, "same", std::string(plane) + rub);
  const auto b = write_scene(folder / "b", "same", std::string(plane) + rub);
  try {
    batch_jobs({a, b});
    FAIL() << "two scenes of one name were taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_NE(std::string(error.what()).find("same"), std::string::npos);
  }
}

TEST(Batch, SummaryHasEverySetKeyAsWrittenAndTheFigures) {
  const auto folder = test::scratch_dir();
  run({write_scene(folder, "sweep", sweep)}, options_for(folder / "out", 2));
  std::istringstream lines(bytes_of(folder / "out" / "summary.csv"));
  std::string header, first, second;
  std::getline(lines, header);
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_EQ(header.rfind("scene,job,friction.law,motion.frequency_hz,status,ticks,contact_ticks,", 0), 0u)
      << header;
  EXPECT_EQ(first.rfind("sweep,1,coulomb,0.5,ok,1001,1001,", 0), 0u) << first;
  EXPECT_EQ(second.rfind("sweep,2,coulomb,1,ok,1001,1001,", 0), 0u) << second;
}

TEST(Batch, AnOutputFolderThatCannotBeMadeIsTheCallersFault) {
  const auto folder = test::scratch_dir();
  std::ofstream(folder / "file") << "x";
  try {
    run({write_scene(folder, "s", std::string(plane) + rub)}, options_for(folder / "file" / "out"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
  }
}

TEST(Figures, CountCoarseTeethAndTheWorkOfFriction) {
  Figures figures;
  TickRecord record;
  record.normal_force_n = 1;
  const auto observe = [&](int ruptures, double x, double friction) {
    record.phase = ruptures > 0 ? Phase::slip : Phase::stick;
    record.ruptures = ruptures;
    record.p_WQ.x() = x;
    record.friction_W_n = Vec3(friction, 0, 0);
    figures.observe(record);
  };
  observe(1, 0, -0.2);
  for (int k = 1; k <= 9; ++k) observe(0, 0.001 * k, -0.2);
  observe(1, 0.010, -0.2);
  EXPECT_EQ(figures.teeth(), 1);
  EXPECT_EQ(figures.coarse_teeth(), 0);
  observe(0, 0.011, -0.2);
  observe(1, 0.012, -0.2);
  EXPECT_EQ(figures.coarse_teeth(), 0) << "two ticks show it";
  observe(1, 0.013, -0.2);
  EXPECT_EQ(figures.coarse_teeth(), 1) << "one tick does not";
  observe(3, 0.014, -0.2);
  EXPECT_EQ(figures.values()[4], 7) << "ruptures";
  EXPECT_EQ(figures.teeth(), 6);
  EXPECT_EQ(figures.coarse_teeth(), 4) << "nor do three in one tick show";
  EXPECT_NEAR(figures.values()[12], -0.2 * 0.014, 1e-15);
}

TEST(Figures, AToothThatAJumpOfTheContactBreaksIsNotTooCoarse) {
  Figures figures;
  TickRecord record;
  record.normal_force_n = 1;
  const auto observe = [&](int ruptures, int k, double contact_x) {
    record.phase = ruptures > 0 ? Phase::slip : Phase::stick;
    record.ruptures = ruptures;
    record.p_WQ.x() = 0.001 * k;
    record.contact_W = Vec3(contact_x, 0, 0);
    figures.observe(record);
  };
  observe(1, 0, 0);
  observe(1, 1, 0.001 + 0.01);  // ten times as far as the finger
  EXPECT_EQ(figures.teeth(), 1);
  EXPECT_EQ(figures.coarse_teeth(), 0);
  observe(1, 2, 0.01 + 0.002);
  EXPECT_EQ(figures.teeth(), 2);
  EXPECT_EQ(figures.coarse_teeth(), 1) << "the next one has no jump in it";
}

TEST(Figures, TeethOfTwoWallsOneAfterTheOtherAreNotTooCoarse) {
  Figures figures;
  TickRecord record;
  record.normal_force_n = 1;
  const auto observe = [&](int ruptures, int k, int walls) {
    record.phase = Phase::stick;
    record.ruptures = ruptures;
    record.walls = walls;
    record.p_WQ.x() = record.contact_W.x() = 0.001 * k;
    figures.observe(record);
  };
  observe(1, 0, 1);
  observe(1, 1, 2);
  observe(2, 2, 2);
  EXPECT_EQ(figures.coarse_teeth(), 0) << "each wall gave way once in a tick";
  observe(3, 3, 2);
  EXPECT_EQ(figures.coarse_teeth(), 1) << "one of them gave way twice";
  for (int k = 4; k < 8; ++k) observe(0, k, 1);
  observe(1, 8, 1);
  observe(1, 9, 1);
  EXPECT_EQ(figures.coarse_teeth(), 2) << "one wall by itself";
}

}  // namespace
}  // namespace fingerpad::batch_test
