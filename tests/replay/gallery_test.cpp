// The gallery of failure (scenes/gallery): what each contact method is expected to do with each named
// failure.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "replay/batch.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"

namespace fingerpad::gallery_test {
namespace {
namespace fs = std::filesystem;

constexpr double stiffness_n_per_m = 1000;  // of every gallery part: the default
/// A proxy's push changes by at most three times as much as the finger goes. The share above is rounding of
/// forces over motions of 10 um.
constexpr double most_steps = 3 * (1 + 1e-6);

struct GalleryRun {
  std::string scene, method, mesh, normals;
  std::map<std::string, double, std::less<>> figures;
  double operator[](const std::string& figure) const { return figures.at(figure); }
  double steps() const { return figures.at("max_apparent_stiffness_n_per_m") / stiffness_n_per_m; }
};

std::string set_key(const BatchJob& job, const std::string& wanted) {
  for (const auto& [key, value] : job.job.set_keys) {
    if (key == wanted) return value;
  }
  return "";
}

/// Every run of the gallery, made once for all tests of this process.
const std::vector<GalleryRun>& gallery() {
  static const std::vector<GalleryRun> runs = [] {
    std::vector<std::string> scenes;
    for (const auto& entry : fs::directory_iterator(test::source_dir() / "scenes" / "gallery")) {
      if (entry.path().extension() == ".toml") scenes.push_back(entry.path().string());
    }
    std::sort(scenes.begin(), scenes.end());
    BatchOptions options;
    options.out_dir = test::scratch_dir().string();
    options.format = TraceFormat::csv;
    options.threads = 2;
    options.version = "test";
    std::vector<BatchJob> jobs = batch_jobs(scenes);
    run_batch(jobs, options, Ranks(), [](const BatchJob&) {});
    std::vector<GalleryRun> found;
    for (const BatchJob& job : jobs) {
      EXPECT_EQ(job.status, "ok") << job.job.scene.name;
      GalleryRun run{job.job.scene.name,
                     set_key(job, "contact.method"),
                     set_key(job, "mesh"),
                     set_key(job, "contact.normals"),
                     {}};
      for (std::size_t i = 0; i < job.figures.size(); ++i)
        run.figures[std::string(Figures::names()[i])] = job.figures[i];
      found.push_back(std::move(run));
    }
    return found;
  }();
  return runs;
}

std::vector<GalleryRun> runs_of(const std::string& scene, const std::string& method) {
  std::vector<GalleryRun> runs;
  std::copy_if(gallery().begin(), gallery().end(), std::back_inserter(runs),
               [&](const GalleryRun& run) { return run.scene == scene && run.method == method; });
  EXPECT_FALSE(runs.empty()) << scene << " with " << method;
  return runs;
}

TEST(Gallery, HasASceneForEachNamedFailure) {
  for (const char* name :
       {"thin_plate", "knife_edge", "concave_corner", "cone_tip", "internal_edges", "sliver_triangles",
        "coordinates_1e4", "start_inside", "fast_strike", "v_near_zero", "n_near_zero", "right_angle_edge"}) {
    runs_of(name, "closest-point");
    runs_of(name, "proxy");
  }
}

TEST(Gallery, EveryForceIsFiniteAndFrictionStaysWithinItsLimit) {
  for (const GalleryRun& run : gallery()) {
    EXPECT_EQ(run["nonfinite_ticks"], 0) << run.scene;
    EXPECT_LE(run["max_mu"], 0.3 * (1 + 1e-9)) << run.scene;
  }
}

TEST(Gallery, TheProxyNeverPopsThroughAndNeverJumps) {
  for (const GalleryRun& run : gallery()) {
    if (run.method != "proxy") continue;
    EXPECT_EQ(run["pop_throughs"], 0) << run.scene << " " << run.mesh;
    EXPECT_LE(run.steps(), most_steps) << run.scene << " " << run.mesh;
  }
}

TEST(Gallery, ThinPlatesHoldTheProxyAndLetTheClosestPointThrough) {
  for (const auto& [scene, depth_m] :
       std::map<std::string, double>{{"thin_plate", 5.5e-3}, {"fast_strike", 5.7e-3}}) {
    for (const GalleryRun& run : runs_of(scene, "proxy")) {
      // The whole depth pushes back; tops lie in z = 0 exactly, so only rounding is left.
      EXPECT_NEAR(run["max_normal_force_n"], stiffness_n_per_m * depth_m, 1e-9) << run.mesh;
    }
    for (const GalleryRun& run : runs_of(scene, "closest-point")) {
      EXPECT_EQ(run["pop_throughs"], 1) << scene << " " << run.mesh;
      EXPECT_LE(run["max_normal_force_n"], 0.5 + 1e-9) << "at most half of the 1 mm plate's thickness";
    }
  }
}

TEST(Gallery, ABladeHoldsTheProxyOnTheFlankThatItMet) {
  const GalleryRun proxy = runs_of("knife_edge", "proxy")[0];
  // 1 mm below the edge the flank lies 0.0875 mm off the middle: 5.0875 mm through it, times cos 5 degrees.
  EXPECT_NEAR(proxy["max_normal_force_n"], 5.068, 1e-2);
  EXPECT_EQ(runs_of("knife_edge", "closest-point")[0]["pop_throughs"], 1);
}

TEST(Gallery, AConesTipTurnsTheClosestPointRoundAndTheProxySlipsPastIt) {
  for (const GalleryRun& run : runs_of("cone_tip", "closest-point")) {
    // Smooth normals hide the turn: over a flank's long facets they lean up to the tip's own.
    EXPECT_EQ(run["pop_throughs"], run.normals == "facet" ? 1 : 0) << run.normals;
  }
  for (const GalleryRun& run : runs_of("cone_tip", "proxy")) {
    // Half a millimetre below the tip the flank is 0.13 mm away; going round it, a little more.
    EXPECT_LT(run["max_normal_force_n"], 0.2) << run.normals;
  }
}

TEST(Gallery, BothWallsOfACornerHoldTheProxyAtOnce) {
  // 0.8 and 1.2 mm into the walls, each of which pushes by itself.
  EXPECT_NEAR(runs_of("concave_corner", "proxy")[0]["max_normal_force_n"], 0.8 + 1.2, 1e-9);
  const GalleryRun closest = runs_of("concave_corner", "closest-point")[0];
  EXPECT_NEAR(closest["max_normal_force_n"], 1.2, 1e-9) << "the nearer wall alone";
  EXPECT_GT(closest.steps(), 10) << "a quarter turn of a newton within a tick";
}

TEST(Gallery, EdgesInAFlatFaceAreNotFelt) {
  for (const std::string scene : {"internal_edges", "sliver_triangles"}) {
    for (const std::string method : {"closest-point", "proxy"}) {
      const auto runs = runs_of(scene, method);
      EXPECT_EQ(runs.size(), 3u) << "facet, smooth and curved";
      for (const GalleryRun& run : runs)
        EXPECT_LT(run["max_force_step_n"], 1e-9) << scene << " " << run.normals;
    }
  }
}

TEST(Gallery, TenThousandUnitsAwayAPartFeelsTheSame) {
  for (const std::string method : {"closest-point", "proxy"}) {
    const auto runs = runs_of("coordinates_1e4", method);
    ASSERT_EQ(runs.size(), 2u);
    // 10 m away positions round to 1.8e-15 m, a micrometre's force to 1e-12 N; normals of 6 mm facets turn by
    // as little.
    for (const char* figure : {"mean_normal_force_n", "max_normal_force_n", "max_force_step_n"})
      EXPECT_NEAR(runs[0][figure], runs[1][figure], 1e-9) << method << " " << figure;
  }
}

TEST(Gallery, AStartInsideIsToldAndTheProxyIsNotTurnedRoundByNearerFaces) {
  const GalleryRun proxy = runs_of("start_inside", "proxy")[0];
  EXPECT_EQ(proxy["inside_starts"], 1);
  EXPECT_NEAR(proxy["max_normal_force_n"], 5, 1e-9);
  EXPECT_GT(runs_of("start_inside", "closest-point")[0].steps(), 10) << "5 N turn by a right angle in a tick";
}

/// Boxes of 20 mm left of x = 0 and right of `gap_m`.
std::shared_ptr<const World> two_boxes(double gap_m) {
  const TriangleSoup box = test::box_soup(Vec3(0.02, 0.02, 0.02));
  return test::world_of(
      test::joined(test::moved(box, Vec3(-0.01, 0, 0)), test::moved(box, Vec3(0.01 + gap_m, 0, 0))));
}

/// A finger on a wall that faces +x or -x.
TickRecord on_wall(double x, double normal_x, double depth_m) {
  TickRecord record;
  record.phase = Phase::slip;
  record.walls = 1;
  record.p_WQ = Vec3(x, 1e-4, 2e-4);
  record.normal_W = Vec3(normal_x, 0, 0);
  record.depth_m = depth_m;
  record.contact_W = record.p_WQ + depth_m * record.normal_W;
  return record;
}

TickRecord free_at(double x) {
  TickRecord record;
  record.p_WQ = Vec3(x, 1e-4, 2e-4);
  return record;
}

long pops_over(const std::shared_ptr<const World>& world, const std::vector<TickRecord>& rows) {
  PopThroughs pops(world, 0);
  for (const TickRecord& row : rows) pops.observe(row);
  return pops.count();
}

TEST(PopThroughs, AreATurnOfThePushInsideAWallAndNotTheOtherSideOfASlot) {
  const auto world = two_boxes(0.001);
  // From 0.1 mm in the left wall to 0.2 mm in the right one, within a tick.
  EXPECT_EQ(pops_over(world, {on_wall(-1e-4, 1, 1e-4), on_wall(1.2e-3, -1, 2e-4)}), 0);
  // As far inside of the left box, whose push turns round all the same.
  EXPECT_EQ(pops_over(world, {on_wall(-1.4e-3, 1, 1e-4), on_wall(-1e-4, -1, 2e-4)}), 1);
  // By less than the depths together, it can have left no wall.
  EXPECT_EQ(pops_over(nullptr, {on_wall(0, 1, 1e-4), on_wall(2e-4, -1, 2e-4)}), 1);
}

TEST(PopThroughs, AreWaysThroughAPartThatNothingShows) {
  const auto world = two_boxes(0.001);
  EXPECT_EQ(pops_over(world, {free_at(-0.03), free_at(5e-4)}), 1) << "through the left box";
  EXPECT_EQ(pops_over(world, {free_at(2e-4), free_at(8e-4)}), 0) << "within the slot";
}

TEST(PopThroughs, AreFirstTouchesThatPushOnAndContactsThatVanish) {
  const auto world = two_boxes(0.001);
  EXPECT_EQ(pops_over(world, {free_at(2e-4), on_wall(-1e-4, 1, 1e-4)}), 0) << "pushed back";
  EXPECT_EQ(pops_over(world, {free_at(2e-4), on_wall(-1e-4, -1, 1e-4)}), 1) << "pushed on";
  EXPECT_EQ(pops_over(world, {on_wall(-1e-3, 1, 1e-3), free_at(-8e-4)}), 1) << "1 mm deep, moved by 0.2 mm";
  EXPECT_EQ(pops_over(world, {on_wall(-1e-3, 1, 1e-3), free_at(2e-4)}), 0) << "moved out";
}

}  // namespace
}  // namespace fingerpad::gallery_test
