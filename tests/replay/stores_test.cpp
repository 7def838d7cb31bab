#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "replay/batch_files.hpp"
#include "replay/batch_plan.hpp"
#include "replay/motion_store.hpp"
#include "replay/planned_ticks.hpp"
#include "scene/scene_file.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "touch/mesh_store.hpp"

// What the jobs of a batch share: meshes and motions, each loaded once.

namespace fingerpad::stores_test {
namespace {
namespace fs = std::filesystem;

MeshStore no_meshes(1);

Scene scene_of(const fs::path& folder, const std::string& motion) {
  std::ofstream(folder / "s.toml") << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\n"
                                   << motion;
  return read_scene_file((folder / "s.toml").string()).jobs.front().scene;
}

/// A recording of `count` samples.
void write_motion(const fs::path& path, int count) {
  std::ofstream file(path);
  file << "t_s,x_m,y_m,z_m\n";
  for (int k = 0; k < count; ++k) file << 0.001 * k << ",0,0,0\n";
}

TEST(MotionStore, ReadsAMotionOnceForThoseWhoFollowItAlike) {
  const fs::path folder = test::scratch_dir();
  write_motion(folder / "a.csv", 10);
  MotionStore store(1 << 20);
  const Scene slow = scene_of(folder, "file = \"a.csv\"\nrate_hz = 1000\n");
  const auto first = store.load(slow, no_meshes);
  EXPECT_EQ(store.load(slow, no_meshes), first);
  EXPECT_EQ(store.read_count(), 1);
  const auto quick = store.load(scene_of(folder, "file = \"a.csv\"\nrate_hz = 2000\n"), no_meshes);
  EXPECT_EQ(store.read_count(), 2) << "another rate is another way";
  EXPECT_NE(quick->motion.path.tick_count(), first->motion.path.tick_count());
  EXPECT_EQ(quick->hash, first->hash);
}

TEST(MotionStore, LetsGoOfTheOldestBeyondItsBound) {
  const fs::path folder = test::scratch_dir();
  write_motion(folder / "a.csv", 100);
  write_motion(folder / "b.csv", 100);
  const Scene a = scene_of(folder, "file = \"a.csv\"\n"), b = scene_of(folder, "file = \"b.csv\"\n");
  MotionStore roomy(100 * 32 * 2), small(100 * 32);
  for (MotionStore* store : {&roomy, &small}) {
    for (int round = 0; round < 2; ++round) {
      store->load(a, no_meshes);
      store->load(b, no_meshes);
    }
  }
  EXPECT_EQ(roomy.read_count(), 2);
  EXPECT_EQ(small.read_count(), 4);
}

TEST(MotionStore, TellsEveryoneWhatIsWrongWithAMotion) {
  const fs::path folder = test::scratch_dir();
  MotionStore store(1 << 20);
  const Scene scene = scene_of(folder, "file = \"none.csv\"\n");
  for (int i = 0; i < 2; ++i) EXPECT_ANY_THROW(store.load(scene, no_meshes));
}

PartEntry mesh_in(const fs::path& folder, const std::string& name) {
  test::write_file(folder, name, test::binary_ply(test::box_soup({9, 9, 9})));
  PartEntry entry;
  entry.mesh = name;
  entry.mesh_path = (folder / name).string();
  return entry;
}

TEST(MeshStore, CountsWhatAMeshTakesInMemory) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "ball.ply", test::binary_ply(test::sphere_soup(9, 4)));
  PartEntry entry;
  entry.mesh = "ball.ply";
  entry.mesh_path = (folder / "ball.ply").string();
  const auto mesh = MeshStore(1).load(entry);
  const std::size_t n = 8 * 256, vertices = 4 * 256 + 2;
  ASSERT_EQ(mesh->part->triangle_count(), static_cast<int>(n));
  // Three coordinates of each vertex, its normal, and those of facets, edges and corners; corners, welded
  // corners and neighbours; the file's number and the creases of each triangle.
  const std::size_t arrays = 8 * (6 * vertices + 3 * n + 9 * n + 9 * n) + 4 * 9 * n + 4 * n + n;
  EXPECT_EQ(mesh->bytes, arrays + mesh->tree->memory_bytes());
}

TEST(MeshStore, LetsGoOfAMeshAfterItsLastAnnouncedUse) {
  const fs::path folder = test::scratch_dir();
  const PartEntry a = mesh_in(folder, "a.ply"), b = mesh_in(folder, "b.ply");
  MeshStore store(8);
  for (const PartEntry* entry : {&a, &a, &b}) store.expect(*entry);
  store.load(a);
  store.load(b);
  store.done(a);
  EXPECT_EQ(store.kept_count(), 2u);
  const std::weak_ptr<const LoadedMesh> mesh = store.load(a);
  EXPECT_FALSE(mesh.expired());
  store.done(a);
  EXPECT_TRUE(mesh.expired());
  EXPECT_EQ(store.kept_count(), 1u);
}

TEST(MeshStore, KeepsWhatFitsIntoItsMemoryAndKnowsWhatDoesNot) {
  const fs::path folder = test::scratch_dir();
  const PartEntry a = mesh_in(folder, "a.ply"), b = mesh_in(folder, "b.ply");
  const std::size_t bytes = MeshStore(8).load(a)->bytes;
  for (const auto& [bound, kept] :
       {std::pair(2 * bytes, 2u), std::pair(2 * bytes - 1, 1u), std::pair(bytes - 1, 1u)}) {
    MeshStore store(8);
    store.bound_memory(bound);
    store.load(a);
    store.load(b);
    EXPECT_EQ(store.kept_count(), kept);
    EXPECT_EQ(store.oversize(b), bound < bytes ? bytes : 0u);
  }
}

TEST(MeshStore, HasRoomForAnotherMeshWhereOneAsLargeAsTheLargestFits) {
  const fs::path folder = test::scratch_dir();
  const PartEntry a = mesh_in(folder, "a.ply"), b = mesh_in(folder, "b.ply");
  const std::size_t bytes = MeshStore(8).load(a)->bytes;
  MeshStore store(8), unbound(8);
  store.bound_memory(2 * bytes);
  EXPECT_TRUE(unbound.has_room_for_another());
  EXPECT_FALSE(store.has_room_for_another()) << "nothing is known of meshes yet";
  PartEntry gone = a;
  gone.mesh_path += ".gone";
  EXPECT_ANY_THROW(store.load(gone));
  store.load(a);
  EXPECT_TRUE(store.has_room_for_another()) << "what could not be loaded takes no room";
  store.load(b);
  EXPECT_FALSE(store.has_room_for_another());
}

/// Those of motions that are laid at a rate that is chosen: each must be laid for its ticks.
TEST(PlannedBatch, LoadsEachMeshOnceWhereItLaysMotions) {
  const fs::path folder = test::scratch_dir();
  const int meshes = 10;  // more than stay loaded
  for (int k = 0; k < meshes; ++k)
    std::ofstream(folder / (std::to_string(k) + ".stl")) << test::binary_stl(test::sphere_soup(30, 2));
  std::ofstream(folder / "s.toml")
      << "[[part]]\nmesh = \"0.stl\"\n[motion]\nkind = \"on_surface\"\nshape = \"line\"\nsize_m = "
         "0.01\nspeed_m_per_s = 0.1\ndepth_m = 0.001\nrate_hz = \"auto\"\n[[set]]\nseed = [1, 2, 3]\nmesh = "
         "\"*.stl\"\n";
  BatchOptions options;
  std::multiset<std::string> loaded;
  options.on_load = [&loaded](std::string_view stage, double) {
    if (stage.ends_with(": hashing")) loaded.emplace(stage);
  };
  options.out_dir = (folder / "o").string();
  const BatchPlan plan = plan_batch(batch_jobs({(folder / "s.toml").string()}), options);
  EXPECT_EQ(plan.jobs.size(), 3U * meshes);
  for (const PlannedJob& job : plan.jobs) EXPECT_EQ(job.error, "");
  for (const std::string& mesh : std::set(loaded.begin(), loaded.end()))
    EXPECT_LE(loaded.count(mesh), 2U) << mesh << ": for its ticks, and for a try if it did not stay";
  EXPECT_LE(loaded.size(), 2U * meshes);

  MeshStore store(1);
  PlannedTicks ticks;
  for (const BatchJob& job : batch_jobs({(folder / "s.toml").string()})) ticks.of(job.job.scene, store);
  EXPECT_EQ(store.kept_count(), 1U) << "its meshes are those of who asks";
}

}  // namespace
}  // namespace fingerpad::stores_test
