#include "trace/motion_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_file.hpp"
#include "support/paths.hpp"
#include "trace_rows.hpp"

namespace fingerpad::motion_source_test {
namespace {

using testing::HasSubstr;

Scene scene_with(const std::string& motion, const std::filesystem::path& folder) {
  return read_scene_text(
             "[[plane]]\npoint_m = [0,0,0]\nnormal = [0,0,1]\n[finger]\ndirection = [0,0,-1]\n[motion]\n" +
                 motion,
             (folder / "s.toml").string())
      .scene;
}

TEST(MotionSource, ReadsMotionTablesBesideTheScene) {
  const auto folder = test::scratch_dir();
  std::ofstream(folder / "m.csv") << "t_s,x_m,y_m,z_m\n1,0,0,0\n2,1,0,0\n";
  const FingerPath path = load_finger_path(scene_with("file = \"m.csv\"\nrate_hz = 4\n", folder));
  ASSERT_EQ(path.tick_count(), 5);
  EXPECT_EQ(path.at(1).t_s, 1.25);
  EXPECT_EQ(path.at(1).p_WQ, Vec3(0.25, 0, 0));
  EXPECT_EQ(path.at(1).direction_W, Vec3(0, 0, -1));
}

TEST(MotionSource, ATraceIsAMotionInEitherFormat) {
  const auto folder = test::scratch_dir();
  const auto rows = test::some_rows(200);
  test::write_trace(folder / "t.h5", TraceFormat::hdf5, rows);
  test::write_trace(folder / "t.csv", TraceFormat::csv, rows);
  for (const char* name : {"t.h5", "t.csv"}) {
    const FingerPath path =
        load_finger_path(scene_with("file = \"" + std::string(name) + "\"\nrate_hz = 1000\n", folder));
    ASSERT_EQ(path.tick_count(), 200) << name;
    for (long k = 0; k < 200; ++k) {
      // Resampled at its own rate a position moves by no more than the rounding of t between two rows 1 mm
      // apart.
      EXPECT_LT((path.at(k).p_WQ - rows[static_cast<std::size_t>(k)].p_WQ).norm(), 1e-14) << name;
    }
  }
}

TEST(MotionSource, ScriptedMotionsNeedNoFile) {
  const FingerPath path = load_finger_path(scene_with(
      "kind = \"line\"\nfrom_m = [0,0,0]\nto_m = [1,0,0]\nspeed_m_per_s = 0.5\nrate_hz = 10\n", "x"));
  EXPECT_EQ(path.tick_count(), 21);
}

TEST(MotionSource, RefusesScenesWithoutAMotionAndFilesThatAreNone) {
  const auto folder = test::scratch_dir();
  const auto told = [&](const std::string& motion) {
    try {
      load_finger_path(scene_with(motion, folder));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(told("rate_hz = 10\n"), HasSubstr("s.toml: the scene has no motion to follow"));
  EXPECT_THAT(told("file = \"absent.csv\"\n"), HasSubstr("absent.csv: cannot be read"));
  test::write_trace(folder / "none.h5", TraceFormat::hdf5, {});
  EXPECT_THAT(told("file = \"none.h5\"\n"), HasSubstr("none.h5: the trace has no rows"));
  TraceWriter::create((folder / "cut.h5").string(), TraceFormat::hdf5, test::some_info(), World());
  EXPECT_THAT(told("file = \"cut.h5\"\n"), HasSubstr("cut.h5: the trace has no rows: it is of a recording "
                                                     "that was cut short or is still being written"));
  auto rows = test::some_rows(5);
  rows[3].t_s = rows[2].t_s;
  test::write_trace(folder / "still.h5", TraceFormat::hdf5, rows);
  EXPECT_THAT(told("file = \"still.h5\"\n"),
              HasSubstr("still.h5: row 4: time 0.002 s does not come after 0.002 s"));
  rows = test::some_rows(5);
  rows[2].p_WQ.y() = 1e35;
  test::write_trace(folder / "wild.h5", TraceFormat::hdf5, rows);
  EXPECT_THAT(told("file = \"wild.h5\"\n"), HasSubstr("wild.h5: row 3: y_m is 1e+35 m; a finger is at most"));
  std::ofstream(folder / "long.csv") << "t_s,x_m,y_m,z_m\n0,0,0,0\n1e9,1,0,0\n";
  EXPECT_THAT(told("file = \"long.csv\"\nrate_hz = 1e6\n"),
              HasSubstr("long.csv: the motion lasts 1000000000 s, which is 1e+15 ticks at 1000000 Hz"));
}

}  // namespace
}  // namespace fingerpad::motion_source_test
