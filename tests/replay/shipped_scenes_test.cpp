#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "part/import.hpp"
#include "scene/scene_file.hpp"
#include "support/effort.hpp"
#include "support/paths.hpp"
#include "touch/closed_loop.hpp"
#include "trace/motion_source.hpp"

// The scenes and parts that come with fingerpad hold what scenes/README.md promises.

namespace fingerpad::shipped_scenes_test {
namespace {
namespace fs = std::filesystem;

const long most_ticks = test::sanitized() ? 1000 : 100000;

std::vector<fs::path> files_in(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ending) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(ShippedParts, AreClosedWoundOutwardAndWhole) {
  const auto parts = files_in(test::source_dir() / "scenes" / "parts", ".stl");
  EXPECT_GE(parts.size(), 6u);
  for (const auto& path : parts) {
    const Verdict verdict = import_part(path.string(), 1e-3, std::numbers::pi / 6).verdict;
    EXPECT_TRUE(verdict.touchable && verdict.closed && verdict.winding_consistent) << path;
    EXPECT_EQ(verdict.components, 1) << path;
    EXPECT_GT(verdict.volume_m3, 0) << path;
    EXPECT_EQ(verdict.degenerate, 0) << path;
    EXPECT_TRUE(verdict.warnings.empty()) << path << ": " << verdict.warnings[0];
  }
}

TEST(ShippedScenes, RubWithStickAndSlipWithinTheLimits) {
  const auto scenes = files_in(test::source_dir() / "scenes", ".toml");
  EXPECT_GE(scenes.size(), 6u);
  for (const auto& path : scenes) {
    const SceneFile file = read_scene_file(path.string());
    const Scene& scene = file.jobs.front().scene;
    ASSERT_EQ(file.jobs.front().error, "") << path;
    ClosedLoop loop(load_world(scene), scene, load_finger_path(scene));
    long stick = 0, slip = 0;
    const long ticks = std::min(loop.tick_count(), most_ticks);
    for (long k = 0; k < ticks; ++k) {
      const TickRecord row = loop.next();
      ASSERT_TRUE(row.force_W_n.allFinite()) << path << " tick " << k;
      // Vibration in the normal force is not in the friction: mu may be larger by its share.
      const double mu_limit = scene.friction.vibration ? 0.4 : 0.3 * (1 + 1e-9);
      ASSERT_LE(row.mu, mu_limit) << path << " tick " << k;
      ASSERT_LT(row.depth_m, 0.005) << path << " tick " << k << ": the motions press by a millimetre or two";
      stick += row.phase == Phase::stick ? 1 : 0;
      slip += row.phase == Phase::slip ? 1 : 0;
    }
    if (ticks < loop.tick_count()) continue;
    const std::string name = path.stem().string();
    const bool pushes_only =
        name == "figure7" || name == "figure8";    // the paper's subjects tried not to slip
    const bool strokes_only = name == "figure11";  // one long stroke
    EXPECT_GT(stick, strokes_only ? 0 : ticks / 50) << path;
    if (pushes_only) {
      EXPECT_EQ(slip, 0) << path;
    } else {
      EXPECT_GT(slip, ticks / 50) << path;
    }
  }
}

TEST(ShippedScenes, StayUnderNineMegabytes) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(test::source_dir() / "scenes")) {
    if (entry.is_regular_file()) bytes += entry.file_size();
  }
  EXPECT_LT(bytes, 9'000'000u);
}

}  // namespace
}  // namespace fingerpad::shipped_scenes_test
