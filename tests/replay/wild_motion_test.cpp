// Motions and hands that leave what a scene is about: no number of theirs ends a batch.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "base/random_stream.hpp"
#include "replay/batch.hpp"
#include "replay/pop_throughs.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "trace/trace.hpp"

namespace fingerpad::wild_motion_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

const std::string plane = "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n";
const std::string press =
    "[motion]\nkind = \"sine\"\ncentre_m = [0, 0, 0.001]\ndirection = [0, 0, 1]\namplitude_m = 0.004\n"
    "frequency_hz = 1\nduration_s = 20\n";

std::string write_scene(const fs::path& folder, const std::string& name, const std::string& rest) {
  const fs::path path = folder / (name + ".toml");
  std::ofstream(path) << "name = \"" << name << "\"\n" << rest;
  return path.string();
}

void run(std::vector<BatchJob>& jobs, const fs::path& out) {
  BatchOptions options;
  options.out_dir = out.string();
  options.version = "test";
  const Ranks ranks;
  run_batch(jobs, options, ranks, [](const BatchJob&) {});
}

std::string summary_of(const fs::path& out) {
  std::ifstream file(out / "summary.csv");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(WildMotion, ALoopThatDivergesIsAFailedJobThatSaysSo) {
  const auto folder = test::scratch_dir();
  auto jobs =
      batch_jobs({write_scene(folder, "stiff", plane + "stiffness_n_per_m = 1e6\n" + press + "[hand]\n"),
                  write_scene(folder, "soft", plane + press + "[hand]\nstiffness_n_per_m = 150\n")});
  run(jobs, folder / "out");
  EXPECT_EQ(jobs[0].exit_code, 3);
  EXPECT_THAT(jobs[0].status, AllOf(HasSubstr("stiff.toml: the hand's loop diverged at t = "),
                                    HasSubstr("stiffness_n_per_m 1000000 is above 1001 N/m")));
  EXPECT_EQ(jobs[1].status, "ok");
  const std::string summary = summary_of(folder / "out");
  EXPECT_THAT(summary, AllOf(HasSubstr("\nstiff,0,"), HasSubstr("diverged"), HasSubstr("\nsoft,0,ok,")));
  // What there was until then stays behind, marked as not whole.
  const Trace trace = read_trace((folder / "out" / "stiff.h5").string());
  EXPECT_FALSE(trace.complete);
  EXPECT_GT(trace.rows.size(), 10U);
  for (const TickRecord& row : trace.rows) ASSERT_TRUE(row.p_WQ.allFinite());
}

TEST(WildMotion, AHandWithoutMassLosesNoSummary) {
  const auto folder = test::scratch_dir();
  auto jobs = batch_jobs({write_scene(folder, "massless", plane + press + "[hand]\n"),
                          write_scene(folder, "soft", plane + press)});
  jobs[0].job.scene.hand->mass_kg = 1e-300;  // no scene file can say so
  run(jobs, folder / "out");
  EXPECT_EQ(jobs[0].exit_code, 3);
  EXPECT_THAT(summary_of(folder / "out"), AllOf(HasSubstr("\nmassless,0,"), HasSubstr("\nsoft,0,ok,")));
}

TEST(WildMotion, ACoordinateOf1e35IsARowThatNamesItsLine) {
  const auto folder = test::scratch_dir();
  test::write_file(folder, "box.stl", test::binary_stl(test::box_soup(Vec3(20, 20, 20))));
  std::ofstream(folder / "wild.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0.02\n0.1,0,0,1e35\n0.2,0,0,0.02\n";
  auto jobs = batch_jobs(
      {write_scene(folder, "wild", "[[part]]\nmesh = \"box.stl\"\n[motion]\nfile = \"wild.csv\"\n"),
       write_scene(folder, "soft", plane + press)});
  run(jobs, folder / "out");
  EXPECT_THAT(summary_of(folder / "out"),
              AllOf(HasSubstr("wild.csv:3: z_m is 1e+35 m"), HasSubstr("\nsoft,0,ok,")));
}

TEST(PopThroughs, AreCountedAlongAnyWay) {
  const auto world = test::world_of(test::box_soup(Vec3(0.02, 0.02, 0.02)));
  PopThroughs pops(world, 0);
  RandomStream random(3);
  const double kinds[] = {0,           0.005, 1,     1e9,   1e19,
                          1e35,        1e60,  1e200, 1e308, std::numeric_limits<double>::infinity(),
                          std::nan("")};
  for (int k = 0; k < 20000; ++k) {
    TickRecord record;
    for (int i = 0; i < 3; ++i)
      record.p_WQ[i] =
          (random.uniform() < 0.5 ? -1 : 1) * kinds[static_cast<int>(random.uniform() * std::size(kinds))];
    pops.observe(record);
  }
  EXPECT_GT(pops.count(), 0);
}

}  // namespace
}  // namespace fingerpad::wild_motion_test
