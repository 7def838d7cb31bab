#include "touch/mesh_store.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"

namespace fingerpad::mesh_store_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// All that a load said of itself.
struct News {
  std::vector<std::string> stages;  ///< without repetitions
  std::vector<double> shares;

  LoadProgress listener() {
    return [this](std::string_view stage, double share_done) {
      if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
      shares.push_back(share_done);
    };
  }
};

Scene scene_of_box(const std::filesystem::path& folder) {
  Scene scene = test::plane_scene("coulomb");
  PartEntry entry;
  entry.mesh = "box.ply";
  entry.mesh_path = test::write_file(folder, "box.ply", test::binary_ply(test::box_soup({9, 9, 9}))).string();
  scene.parts.push_back(entry);
  return scene;
}

TEST(MeshStore, TellsTheStagesOfALoadInOrderWithTheFile) {
  const Scene scene = scene_of_box(test::scratch_dir());
  News news;
  load_world(scene, news.listener());
  EXPECT_THAT(news.stages, ElementsAre("box.ply: reading", "box.ply: reading through OpenMesh",
                                       "box.ply: joining triangles", "box.ply: making normals",
                                       "box.ply: hashing", "box.ply: building the search tree",
                                       "box.ply: ready", "box.ply: measuring its walls and edges"));
  EXPECT_TRUE(std::is_sorted(news.shares.begin(), news.shares.end())) << "a bar never goes back";
  EXPECT_GE(news.shares.front(), 0);
  EXPECT_LE(news.shares.back(), 1);
}

TEST(MeshStore, HasNothingToTellOfWhatIsLoadedAlready) {
  const Scene scene = scene_of_box(test::scratch_dir());
  News news;
  MeshStore meshes(2, news.listener());
  load_world(scene, meshes);
  news = {};
  load_world(scene, meshes);
  EXPECT_THAT(news.stages, IsEmpty());
}

TEST(MeshStore, ARefusedMeshIsRefusedWhoeverListens) {
  Scene scene = scene_of_box(test::scratch_dir());
  scene.parts[0].mesh_path += ".gone";
  News news;
  EXPECT_THROW(load_world(scene, news.listener()), Error);
  EXPECT_THAT(news.stages, ElementsAre("box.ply.gone: reading"));
}

}  // namespace
}  // namespace fingerpad::mesh_store_test
