#include "replay/contact_store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "replay/batch.hpp"
#include "replay/job_runner.hpp"
#include "scene/scene_file.hpp"
#include "support/effort.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/closed_loop.hpp"

// Where a finger touches is found out once for the jobs that differ in friction alone.

namespace fingerpad::contact_store_test {
namespace {
namespace fs = std::filesystem;

/// A finger that circles in a ring's hollow side, and now and then leaves it.
ScriptedMotion around_ring(double radius_m = 0.0305) {
  ScriptedMotion motion;
  motion.kind = ScriptedMotion::Kind::circle;
  motion.centre_m = {0.0004, 0, 0.009};
  motion.amplitude_m = radius_m;
  motion.frequency_hz = 0.5;
  motion.duration_s = 2;
  return motion;
}

Scene ring_scene(const std::string& method, const std::string& law) {
  Scene scene = test::plane_scene(law);
  scene.contact.method = method;
  scene.contact.normals = Normals::smooth;
  scene.finger.radius_m = 0.0025;
  return scene;
}

std::vector<TickRecord> run(const std::shared_ptr<const World>& world, const Scene& scene,
                            ContactStore* store) {
  const FingerPath path(around_ring(), 1000, Vec3::UnitX());
  ContactStore::Share share = store != nullptr ? store->share(scene, *world, path) : ContactStore::Share();
  ClosedLoop loop(world, scene, path, {}, share.wrap());
  std::vector<TickRecord> rows;
  while (static_cast<long>(rows.size()) < loop.tick_count()) rows.push_back(loop.next());
  share.finish();
  return rows;
}

/// Of a place that may be none.
std::array<std::uint64_t, 3> bits_of(const Vec3& v) {
  return {std::bit_cast<std::uint64_t>(v.x()), std::bit_cast<std::uint64_t>(v.y()),
          std::bit_cast<std::uint64_t>(v.z())};
}

TEST(ContactStore, ChangesNothingOfAJob) {
  const auto world = test::world_of(test::torus_soup(0.03, 0.01, 40, 20));
  for (const char* method : {"closest-point", "proxy"}) {
    ContactStore store(1 << 24);
    int touching = 0;
    for (const char* law : {"finger-pad", "coulomb", "lugre", "finger-pad"}) {
      const Scene scene = ring_scene(method, law);
      const auto alone = run(world, scene, nullptr), shared = run(world, scene, &store);
      for (std::size_t k = 0; k < alone.size(); ++k) {
        ASSERT_EQ(shared[k].force_W_n, alone[k].force_W_n) << method << " " << law << " " << k;
        ASSERT_EQ(shared[k].contact_W, alone[k].contact_W);
        ASSERT_EQ(shared[k].triangle, alone[k].triangle);
        ASSERT_EQ(bits_of(shared[k].stick_centre_W), bits_of(alone[k].stick_centre_W)) << k;
        ASSERT_EQ(shared[k].unsettled, alone[k].unsettled);
        touching += shared[k].normal_force_n > 0 ? 1 : 0;
      }
    }
    EXPECT_GT(touching, 2000);
    EXPECT_EQ(store.played_count(), 3) << "all but the first";
  }
}

TEST(ContactStore, TakesNoOtherWayNorSurfaceForTheSame) {
  const auto world = test::world_of(test::torus_soup(0.03, 0.01, 40, 20));
  const Scene scene = ring_scene("closest-point", "coulomb");
  ContactStore store(1 << 24);
  run(world, scene, &store);
  const FingerPath path(around_ring(), 1000, Vec3::UnitX());
  const auto plays = [&](const Scene& other, const World& touched, const FingerPath& way) {
    const long before = store.played_count();
    store.share(other, touched, way);
    return store.played_count() > before;
  };
  EXPECT_TRUE(plays(scene, *world, path));
  EXPECT_FALSE(plays(scene, *world, FingerPath(around_ring(0.0306), 1000, Vec3::UnitX())));
  EXPECT_FALSE(plays(scene, *world, path.with_rate(2000)));
  EXPECT_FALSE(plays(scene, *test::world_of(test::torus_soup(0.03, 0.01, 40, 20)), path)) << "loaded anew";
  World moved = *world;
  moved.surfaces[0].p_WP.x() += 1e-9;
  EXPECT_FALSE(plays(scene, moved, path));
  World two = *world;
  two.surfaces.emplace_back();
  EXPECT_FALSE(plays(scene, two, path));
  Scene other = scene;
  other.finger.radius_m *= 2;
  EXPECT_FALSE(plays(other, *world, path));
  other = scene;
  other.contact.normals = Normals::facet;
  EXPECT_FALSE(plays(other, *world, path));
  other = scene;
  other.hand.emplace();
  EXPECT_FALSE(plays(other, *world, path)) << "there friction moves the finger";
  other = scene;
  other.friction.law = "lugre";
  other.seed = 7;
  EXPECT_TRUE(plays(other, *world, path));
}

TEST(ContactStore, KeepsNoMoreThanItsBound) {
  const auto world = test::world_of(test::torus_soup(0.03, 0.01, 40, 20));
  const Scene near = ring_scene("closest-point", "coulomb");
  Scene far = near;
  far.finger.radius_m *= 1.1;
  constexpr std::size_t a_tape = 2001 * 72;
  ContactStore roomy(3 * a_tape), narrow(a_tape * 3 / 2), small(a_tape / 2);
  for (ContactStore* store : {&roomy, &narrow, &small}) {
    for (const Scene& scene : {near, far, near}) run(world, scene, store);
  }
  EXPECT_EQ(roomy.played_count(), 1);
  EXPECT_EQ(narrow.played_count(), 0) << "the second has taken the first one's room";
  EXPECT_EQ(small.played_count(), 0) << "not even one has room";
}

TEST(ContactStore, IsUsedByABatchOfLaws) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "ring.stl", test::binary_stl(test::torus_soup(0.03, 0.01, 40, 20)));
  std::ofstream(folder / "s.toml")
      << "name = \"s\"\n[[part]]\nmesh = \"ring.stl\"\nunit = \"m\"\n[motion]\nkind = \"on_surface\"\n"
      << "shape = \"circle\"\nsize_m = 0.004\nturns = 1\nspeed_m_per_s = 0.05\ndepth_m = 0.0005\n"
      << "rate_hz = 1000\n[[set]]\nfriction.law = [\"finger-pad\", \"lugre\", \"coulomb\"]\n"
      << "motion.speed_m_per_s = [0.03, 0.05]\n";
  auto jobs = batch_jobs({(folder / "s.toml").string()});
  BatchOptions options;
  options.out_dir = folder.string();
  options.traces = false;
  JobRunner runner(jobs, options);
  std::size_t next = 0;
  runner.run([&](std::size_t) { return next < jobs.size() ? std::optional(next++) : std::nullopt; },
             [](std::size_t) {});
  EXPECT_EQ(runner.played_contacts(), 4) << "of three laws at two speeds";
}

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(ContactStore, WritesTheTracesThatEachJobWritesAlone) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "ring.stl", test::binary_stl(test::torus_soup(0.03, 0.01, 40, 20)));
  std::vector<std::string> laws = {"finger-pad", "lugre", "coulomb", "friction-cone"};
  if (test::sanitized()) laws.resize(2);
  const auto run_set = [&](const std::string& name, const std::string& laws_toml) {
    std::ofstream(folder / (name + ".toml"))
        << "name = \"" << name
        << "\"\n[[part]]\nmesh = \"ring.stl\"\nunit = \"m\"\n[finger]\nradius_m = 0.0025\n"
        << "[motion]\nkind = \"on_surface\"\nshape = \"circle\"\nsize_m = 0.004\nturns = 2\n"
        << "speed_m_per_s = 0.05\ndepth_m = 0.0005\nrate_hz = 1000\n[[set]]\nmotion.speed_m_per_s = [0.03, "
           "0.05]\n"
        << "friction.law = " << laws_toml << "\n";
    auto jobs = batch_jobs({(folder / (name + ".toml")).string()});
    BatchOptions options;
    options.out_dir = (folder / name).string();
    options.format = TraceFormat::csv;
    options.threads = 2;
    options.version = "test";
    run_batch(jobs, options, Ranks(), [](const BatchJob&) {});
    for (const BatchJob& job : jobs) EXPECT_EQ(job.status, "ok");
  };
  run_set("all", fmt::format("[\"{}\"]", fmt::join(laws, "\", \"")));
  for (std::size_t i = 0; i < laws.size(); ++i) {
    run_set(laws[i], "[\"" + laws[i] + "\"]");
    for (std::size_t speed = 0; speed < 2; ++speed) {
      const auto trace = [&](const std::string& set, std::size_t number) {
        return text_of(folder / set / (set + "-000" + std::to_string(number) + ".csv"));
      };
      const std::string alone = trace(laws[i], speed + 1);
      EXPECT_GT(alone.size(), 100000u);
      EXPECT_EQ(trace("all", speed * laws.size() + i + 1), alone) << laws[i];
    }
  }
}

}  // namespace
}  // namespace fingerpad::contact_store_test
