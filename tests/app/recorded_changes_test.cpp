// Changes of a scene that were made while it was touched come with its trace, and are made again with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"
#include "trace/trace.hpp"

namespace fingerpad::recorded_changes_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string plane =
    "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\nstiffness_n_per_m = 1000\n"
    "[friction]\nv_min_m_per_s = 0.02\n";
const std::string changes =
    "t_s,key,value\n0.1,part.0.mu_static,0.9\n0.1,part.0.mu_dynamic,0.7\n0.2,friction.law,dahl\n"
    "0.3,part.0.stiffness_n_per_m,400\n";

/// A folder with a recording, run.csv, its changes beside it, and a scene that follows it, again.toml.
fs::path recording() {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "run.toml",
                   plane +
                       "[motion]\nkind = \"sine\"\ncentre_m = [0, 0, -0.001]\ndirection = [1, 0, 0]\n"
                       "amplitude_m = 0.005\nfrequency_hz = 4\nduration_s = 0.4\nrate_hz = 1000\n");
  const auto made = test::fingerpad("replay run.toml --format csv --out . --quiet", folder);
  EXPECT_EQ(made.exit_code, 0) << made.err;
  test::write_file(folder, "run.changes.csv", changes);
  test::write_file(folder, "again.toml", plane + "[motion]\nfile = \"run.csv\"\n");
  return folder;
}

double force_at(const Trace& trace, std::size_t row) {
  return trace.rows[row].friction_W_n.norm();
}

TEST(RecordedChanges, AreMadeAgainAtTheSameTicksAndStandInTheNewTrace) {
  const fs::path folder = recording();
  const auto csv = test::fingerpad("replay again.toml --format csv --out csv", folder);
  ASSERT_EQ(csv.exit_code, 0) << csv.err;
  const auto h5 = test::fingerpad("replay again.toml --out h5 --quiet", folder);
  ASSERT_EQ(h5.exit_code, 0) << h5.err;
  EXPECT_EQ(test::bytes_of(folder / "csv" / "again.changes.csv"), changes);
  const Trace before = read_trace((folder / "run.csv").string());
  const Trace table = read_trace((folder / "csv" / "again.csv").string());
  const Trace whole = read_trace((folder / "h5" / "again.h5").string());
  EXPECT_EQ(scene_changes_text(whole.info.changes), changes);
  EXPECT_EQ(table.info.changes, whole.info.changes);
  ASSERT_EQ(whole.rows.size(), 401u);
  for (std::size_t i = 0; i < 401; ++i) {
    ASSERT_EQ(table.rows[i].force_W_n, whole.rows[i].force_W_n) << i;
    if (i >= 100) continue;
    ASSERT_EQ(table.rows[i].force_W_n, before.rows[i].force_W_n) << i;
  }
  EXPECT_EQ(whole.rows[299].normal_force_n, before.rows[299].normal_force_n);
  EXPECT_NEAR(whole.rows[300].normal_force_n, 0.4 * before.rows[300].normal_force_n, 1e-9);
  EXPECT_NE(force_at(whole, 150), force_at(before, 150));
}

TEST(RecordedChanges, ALiveTouchOfTheRecordingFeelsThemBitForBit) {
  const fs::path folder = recording();
  const auto replayed = test::fingerpad("replay again.toml --format csv --out r --quiet", folder);
  ASSERT_EQ(replayed.exit_code, 0) << replayed.err;
  for (const char* ending : {".csv", ".h5"}) {
    const auto live = test::fingerpad(
        std::string("touch again.toml --headless --device recorded --record live") + ending, folder);
    ASSERT_EQ(live.exit_code, 0) << live.err;
  }
  EXPECT_EQ(test::bytes_of(folder / "live.csv"), test::bytes_of(folder / "r" / "again.csv"));
  EXPECT_EQ(test::bytes_of(folder / "live.changes.csv"), changes);
  EXPECT_EQ(scene_changes_text(read_trace((folder / "live.h5").string()).info.changes), changes);
}

TEST(RecordedChanges, ThatTheSceneCannotHaveAreRefusedByName) {
  const fs::path folder = recording();
  test::write_file(folder, "run.changes.csv", "t_s,key,value\n0.1,part.3.mu_static,0.9\n");
  const auto told = test::fingerpad("replay again.toml --format csv --out r", folder);
  EXPECT_NE(told.exit_code, 0);
  EXPECT_THAT(told.err, HasSubstr("part.3.mu_static"));
  test::write_file(folder, "run.changes.csv", "t_s,key\n");
  const auto damaged = test::fingerpad("replay again.toml --format csv --out r", folder);
  EXPECT_NE(damaged.exit_code, 0);
  EXPECT_THAT(damaged.err, HasSubstr("run.changes.csv"));
}

TEST(RecordedChanges, OfAnOlderTouchDoNotStayBesideANewTrace) {
  const fs::path folder = recording();
  const auto made = test::fingerpad("replay run.toml --format csv --out . --quiet", folder);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_FALSE(fs::exists(folder / "run.changes.csv"));
}

}  // namespace
}  // namespace fingerpad::recorded_changes_test
