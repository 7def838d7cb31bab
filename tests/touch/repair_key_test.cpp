#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "touch/mesh_store.hpp"

namespace fingerpad::repair_key_test {
namespace {

TEST(RepairKey, APartIsRepairedWhereItsSceneAsksForItAndOnlyThere) {
  using namespace test;
  PartEntry entry;
  entry.mesh_path =
      write_file(scratch_dir(), "inverted.ply", binary_ply(reversed(box_soup({1, 1, 1})))).string();
  MeshStore meshes(2);
  const auto as_it_is = meshes.load(entry);
  EXPECT_LT(as_it_is->verdict.volume_m3, 0);
  entry.repair = true;
  const auto repaired = meshes.load(entry);
  EXPECT_GT(repaired->verdict.volume_m3, 0);
  EXPECT_THAT(repaired->verdict.warnings, testing::ElementsAre("repaired: 1 closed shell turned outwards"));
  EXPECT_EQ(repaired->hash, as_it_is->hash) << "of the file's bytes";
}

}  // namespace
}  // namespace fingerpad::repair_key_test
