// Motions of a laboratory through a whole run: what they come to, and what is told of them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "replay/batch.hpp"
#include "replay/never_touches.hpp"
#include "scene/scene_file.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "trace/trace.hpp"

namespace fingerpad::recording_job_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* plane = "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n";

BatchJob run(const fs::path& folder, const std::string& scene, bool resume = false) {
  std::ofstream(folder / "s.toml") << scene;
  auto jobs = batch_jobs({(folder / "s.toml").string()});
  BatchOptions options;
  options.out_dir = (folder / "out").string();
  options.resume = resume;
  options.version = "test";
  run_batch(jobs, options, Ranks(), [](const BatchJob&) {});
  EXPECT_EQ(jobs[0].status, "ok");
  return jobs[0];
}

/// Strokes of 20 mm at 240 Hz, 0.5 mm deep, in a laboratory's words; pressed with 1.5 N and not always.
std::string laboratory_rows() {
  std::string rows = "Zeit;PosX;PosY;PosZ;Kraft\n";
  for (int i = 0; i < 480; ++i) {
    const double x_mm = 20 * std::sin(0.02 * i);
    std::string row =
        fmt::format("{:.4f};{:.3f};0;-0.5;{}\n", 1e3 * i / 240.0, x_mm, i < 400 ? "1.5" : "-0.2");
    std::replace(row.begin(), row.end(), '.', ',');
    rows += row;
  }
  return rows;
}

const std::string laboratory_keys =
    "[motion]\nfile = \"lab.csv\"\n"
    "columns = { t = \"Zeit\", x = \"PosX\", y = \"PosY\", z = \"PosZ\", fn = \"Kraft\" }\n"
    "unit = \"mm\"\ntime_unit = \"ms\"\ndecimal = \",\"\n";

TEST(RecordingJob, RunsALaboratorysFileAtItsOwnRateWithItsForce) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "lab.csv") << laboratory_rows();
  const BatchJob job = run(folder, plane + laboratory_keys + "normal_force = \"measured\"\n");
  const Trace trace = read_trace((folder / "out" / "s.h5").string());
  EXPECT_EQ(trace.info.rate_hz, 240);
  ASSERT_EQ(trace.rows.size(), 480u);
  for (std::size_t i = 0; i < 480; ++i) {
    EXPECT_NEAR(trace.rows[i].p_WQ.x(), 0.02 * std::sin(0.02 * static_cast<double>(i)), 6e-7);
    EXPECT_NEAR(trace.rows[i].normal_force_n, i < 400 ? 1.5 : 0, 1e-9) << i;
  }
  EXPECT_THAT(trace.info.motion_notes, testing::ContainerEq(job.motion_notes));
  EXPECT_THAT(job.motion_notes,
              ElementsAre(HasSubstr("lab.csv: t is 'Zeit', x is 'PosX'"), HasSubstr("240 Hz")));
  EXPECT_THAT(job.warnings, IsEmpty());

  // The trace's own scene gives the same run again.
  const std::string text = trace.info.scene_text;
  fs::rename(folder / "out" / "s.h5", folder / "first.h5");
  run(folder, text);
  const Trace again = read_trace((folder / "out" / "s.h5").string());
  ASSERT_EQ(again.rows.size(), trace.rows.size());
  for (std::size_t i = 0; i < trace.rows.size(); ++i)
    EXPECT_EQ(again.rows[i].force_W_n, trace.rows[i].force_W_n);
}

TEST(RecordingJob, IsKeptByAResumedRunAndToldAgain) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "lab.csv") << laboratory_rows();
  const std::string scene = plane + laboratory_keys + "smoothing_hz = 10\n";
  const BatchJob first = run(folder, scene);
  const BatchJob second = run(folder, scene, true);
  EXPECT_FALSE(first.kept);
  EXPECT_TRUE(second.kept);
  EXPECT_EQ(second.motion_notes, first.motion_notes);
  EXPECT_THAT(second.figures, testing::Pointwise(testing::NanSensitiveDoubleEq(), first.figures));
}

TEST(RecordingJob, AMotionInAnotherUnitIsToldThatItNeverTouches) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "box.ply", test::binary_ply(test::box_soup({100, 60, 20})));
  std::ofstream(folder / "m.csv") << "t_s,x_m,y_m,z_m\n0,-40,0,35\n1,40,10,12\n";
  const std::string scene = "[[part]]\nmesh = \"box.ply\"\n[motion]\nfile = \"m.csv\"\nrate_hz = 100\n";
  for (const bool resume : {false, true}) {
    const BatchJob job = run(folder, scene, resume);
    ASSERT_EQ(job.warnings.size(), 1u);
    EXPECT_THAT(job.warnings[0],
                AllOf(HasSubstr("s: the motion never touches: it comes nearest at t = "),
                      HasSubstr("from part 1 (box.ply)"), HasSubstr("the part is 100 x 60 x 20 mm"),
                      HasSubstr("the motion spans 80000 x 10000 x 23000 mm"),
                      HasSubstr("check [motion] unit and [[part]] unit")));
  }
  EXPECT_THAT(run(folder, scene + "unit = \"mm\"\n").warnings,
              ElementsAre(HasSubstr("spans 80 x 10 x 23 mm")));
  std::ofstream(folder / "m.csv") << "t_s,x_m,y_m,z_m\n0,-40,0,35\n1,40,10,9\n";
  EXPECT_THAT(run(folder, scene + "unit = \"mm\"\n").warnings, IsEmpty());
}

TEST(RecordingJob, AMotionInAnotherUnitIsToldThatItPressesTooDeep) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "m.csv") << "t_s,x_m,y_m,z_m\n0,-40,0,2\n1,40,10,-1\n";
  const std::string scene = plane + std::string("[motion]\nfile = \"m.csv\"\nrate_hz = 100\n");
  EXPECT_THAT(run(folder, scene).warnings, testing::Contains(AllOf(HasSubstr("mm deep, which no finger is"),
                                                                   HasSubstr("check [motion] unit"))));
  EXPECT_THAT(run(folder, scene + "unit = \"mm\"\n").warnings, IsEmpty());
}

TEST(NeverTouches, KnowsTheNearestOfAllSurfacesAndTheFingersRadius) {
  auto world = std::make_shared<World>(*test::world_of(test::box_soup({0.1, 0.06, 0.02})));
  world->surfaces[0].mesh = "box.stl";
  world->surfaces.emplace_back();
  world->surfaces[1].plane_point_W = Vec3(0, 0, -0.05);
  Motion motion;
  motion.t_s = {0, 1, 2};
  motion.p_WQ.resize(3, 3);
  motion.p_WQ << 0, 0.01, 0.02, 0, 0, 0, 0.04, 0.025, 0.03;
  const std::string part = never_touches(*world, FingerPath(motion, 10, Vec3::UnitX()), 0.007);
  EXPECT_THAT(part,
              AllOf(HasSubstr("at t = 1 s, 8 mm from part 1 (box.stl)"), HasSubstr("spans 20 x 0 x 15 mm")));
  motion.p_WQ.row(2) << -0.03, -0.045, -0.02;
  const std::string below = never_touches(*world, FingerPath(motion, 10, Vec3::UnitX()), 0.002);
  EXPECT_THAT(below, AllOf(HasSubstr("at t = 1 s, 3 mm from plane 1; the motion"), HasSubstr("unit")));
  motion.p_WQ.row(2) << 0.04, 0.0, 0.04;
  EXPECT_EQ(never_touches(*world, FingerPath(motion, 10, Vec3::UnitX()), 0.0), "") << "inside of the box";
}

TEST(NeverTouches, LooksAtEveryTickAndTakesASheetForNothingMore) {
  auto world = std::make_shared<World>(*test::world_of(test::square_soup(0.1, 3)));
  world->surfaces[0].mesh = "sheet.stl";
  // Behind the sheet, 20 mm off but for one tick of ten thousand.
  Motion motion;
  constexpr long ticks = 10000, near_tick = 5003;
  motion.p_WQ.resize(3, ticks);
  for (long k = 0; k < ticks; ++k) {
    motion.t_s.push_back(1e-3 * static_cast<double>(k));
    motion.p_WQ.col(k) = Vec3(0.01, 0.01, k == near_tick ? -0.005 : -0.02);
  }
  const auto told = [&] { return never_touches(*world, FingerPath(motion, 1000, Vec3::UnitX()), 0.002); };
  EXPECT_THAT(told(), HasSubstr("nearest at t = 5.003 s, 3 mm from part 1 (sheet.stl)"));
  motion.p_WQ(2, near_tick) = -0.001;
  EXPECT_EQ(told(), "") << "a ball of 2 mm touches it there";
}

TEST(NeverTouches, NamesAColumnThatIsMirroredOrSwapped) {
  auto world = std::make_shared<World>(*test::world_of(test::box_soup({0.1, 0.06, 0.02})));
  world->surfaces[0].mesh = "box.stl";
  Motion motion;
  motion.t_s = {0, 1, 2};
  motion.p_WQ.resize(3, 3);
  const auto told = [&](const Mat3& written, bool is_placed = false) {
    Motion taken = motion;
    taken.p_WQ = written * motion.p_WQ;
    return never_touches(*world, FingerPath(taken, 10, Vec3::UnitX()), 0.002, is_placed);
  };
  // Over the box's top, off its middle.
  motion.p_WQ << 0.02, 0.03, 0.045, 0.01, 0.01, 0.01, 0.013, 0.011, 0.013;
  world->surfaces[0].p_WP = Vec3(0.05, 0.03, 0.01);
  motion.p_WQ.colwise() += world->surfaces[0].p_WP;
  EXPECT_EQ(told(Mat3::Identity()), "");
  Mat3 other = Mat3::Identity();
  other(0, 0) = -1;
  EXPECT_THAT(told(other), HasSubstr("; with x mirrored"));
  EXPECT_THAT(told(other, true), AllOf(HasSubstr("never touches"), testing::Not(HasSubstr("mirrored"))))
      << "its own columns are not the world's";
  other = Mat3::Identity();
  other.row(0).swap(other.row(2));
  EXPECT_THAT(told(other),
              AllOf(HasSubstr("x and z swapped"), HasSubstr("it does: is a column's sign turned")));
  EXPECT_THAT(told(1e3 * Mat3::Identity()), testing::EndsWith("check [motion] unit and [[part]] unit"));
}

}  // namespace
}  // namespace fingerpad::recording_job_test
