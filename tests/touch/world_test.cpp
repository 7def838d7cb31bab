#include "touch/world.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"
#include "support/worlds.hpp"

namespace fingerpad::world_test {
namespace {

TEST(World, NamesItsSurfacesAsPeopleAreTold) {
  Surface part = test::world_of(test::box_soup(Vec3(1, 1, 1)))->surfaces.front();
  part.mesh = "some/where/bracket.stl";
  EXPECT_EQ(shown_name(part), "bracket.stl");
  EXPECT_EQ(shown_name(test::plane_world()->surfaces.front()), "plane");
}

TEST(World, CountsPartsAndPlanesEachFromOne) {
  World world = *test::world_of(test::box_soup(Vec3(1, 1, 1)));
  world.surfaces.push_back(world.surfaces.front());
  world.surfaces[0].mesh = "a.stl";
  world.surfaces[1].mesh = "b.stl";
  for (int k = 0; k < 2; ++k) world.surfaces.push_back(test::plane_world()->surfaces.front());
  EXPECT_EQ(counted_name(world, 0), "part 1 (a.stl)");
  EXPECT_EQ(counted_name(world, 1), "part 2 (b.stl)");
  EXPECT_EQ(counted_name(world, 2), "plane 1");
  EXPECT_EQ(counted_name(world, 3), "plane 2");
}

TEST(World, NeedsNoMethodWhereNeitherPartsNorCornersAreAmongItsPlanes) {
  World world = *test::plane_world();
  world.surfaces.emplace_back();
  EXPECT_TRUE(needs_no_method(world));
  EXPECT_EQ(triangles_of(world.surfaces), 0);
  World corner = world;
  corner.surfaces.back().plane_normal_W = Vec3::UnitX();
  EXPECT_FALSE(needs_no_method(corner));
  world.surfaces.push_back(test::world_of(test::box_soup(Vec3(1, 1, 1)))->surfaces.front());
  world.surfaces.push_back(world.surfaces.back());
  EXPECT_FALSE(needs_no_method(world));
  EXPECT_EQ(triangles_of(world.surfaces), 24);
}

}  // namespace
}  // namespace fingerpad::world_test
