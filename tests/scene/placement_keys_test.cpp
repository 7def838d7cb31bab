#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "scene/scene_reader.hpp"
#include "scene/scene_text.hpp"

// Where a motion lies: in the world, in the first part's coordinates, or on its surface.

namespace fingerpad::placement_keys_test {
namespace {

using test::plane_scene;
using test::read_scene;
using test::refusal;
using testing::HasSubstr;
using testing::StartsWith;

const std::string part_scene = "name = \"s\"\n[[part]]\nmesh = \"a.stl\"\nstiffness_n_per_m = 500\n";
const std::string rub = "[motion]\nkind = \"on_surface\"\nsize_m = 0.02\nspeed_m_per_s = 0.1\n";

TEST(PlacementKeys, LayAMotionOnTheFirstPart) {
  const Scene scene =
      read_scene(part_scene + rub + "shape = \"spiral\"\nplace = 7\nturns = 3\ndepth_m = 0.001\n");
  ASSERT_TRUE(scene.motion.laid);
  EXPECT_FALSE(scene.motion.scripted);
  EXPECT_TRUE(scene.motion.given());
  EXPECT_EQ(scene.motion.laid->shape, SurfaceMotion::Shape::spiral);
  EXPECT_EQ(scene.motion.laid->place, 7);
  EXPECT_EQ(scene.motion.laid->size_m, 0.02);
  EXPECT_EQ(scene.motion.laid->turns, 3);
  EXPECT_EQ(scene.motion.laid->speed_m_per_s, 0.1);
  EXPECT_EQ(pressed_depth_m(scene), 0.001);
}

TEST(PlacementKeys, ANormalForceIsPressedOverThePartsStiffness) {
  EXPECT_EQ(pressed_depth_m(read_scene(part_scene + rub + "normal_force_n = 2\n")), 2 / 500.0);
}

TEST(PlacementKeys, AreToldWhereTheyDoNotGoTogether) {
  EXPECT_THAT(refusal(part_scene + rub), HasSubstr("'depth_m' or by 'normal_force_n': give one of them"));
  EXPECT_THAT(refusal(part_scene + rub + "depth_m = 0.001\nnormal_force_n = 1\n"),
              HasSubstr("give one of them"));
  EXPECT_THAT(refusal(plane_scene + rub + "depth_m = 0.001\n"),
              StartsWith("s.toml:6:8: 'kind' in [motion] is of the first [[part]], and the scene has none"));
  EXPECT_THAT(refusal(plane_scene + "[motion]\nfile = \"m.csv\"\nframe = \"part\"\n"),
              HasSubstr("'frame' in [motion] is of the first [[part]]"));
  EXPECT_THAT(refusal(part_scene + rub + "depth_m = 0.001\nposition_m = [0, 0, 0]\n"),
              HasSubstr("'position_m' in [motion] does not go with kind = \"on_surface\""));
  EXPECT_THAT(refusal(part_scene + "[motion]\nfile = \"m.csv\"\nplace = 3\n"),
              HasSubstr("needs kind = \"on_surface\""));
  EXPECT_THAT(refusal(part_scene + rub + "depth_m = 0.001\nturns = 100\nplace = -1\n"),
              HasSubstr("'place' in [motion]"));
  const std::string slow =
      "[motion]\nkind = \"on_surface\"\nsize_m = 1\nspeed_m_per_s = 1e-9\ndepth_m = 0.001\n";
  EXPECT_THAT(refusal(part_scene + slow), HasSubstr("the motion lasts"));
}

TEST(PlacementKeys, PutAMotionIntoAFrame) {
  const MotionPlacement placement =
      read_scene(part_scene +
                 "[motion]\nfile = \"m.csv\"\nframe = \"part\"\nposition_m = [1, 2, 3]\n"
                 "rotation = { axis = [0, 0, 1], angle_deg = 90 }\n")
          .motion.placement;
  EXPECT_TRUE(placement.in_part);
  EXPECT_EQ(placement.position_m, Vec3(1, 2, 3));
  EXPECT_LT((placement.rotation * Vec3(1, 0, 0) - Vec3(0, 1, 0)).norm(), 1e-15);
  EXPECT_TRUE(read_scene(part_scene + "[motion]\nfile = \"m.csv\"\n").motion.placement.is_world());
}

TEST(PlacementKeys, OfASetAreManyPlaces) {
  const SceneFile file =
      read_scene_text(part_scene + rub +
                          "depth_m = 0.001\n[[set]]\nmotion.place = { from = 1, to = 20, steps "
                          "= 20 }\nmotion.shape = [\"line\", \"circle\"]\n",
                      "s.toml");
  ASSERT_EQ(file.jobs.size(), 40U);
  EXPECT_EQ(file.jobs[39].error, "");
  EXPECT_EQ(file.jobs[39].scene.motion.laid->place, 20);
  EXPECT_EQ(file.jobs[39].scene.motion.laid->shape, SurfaceMotion::Shape::circle);

  const SceneFile moved = read_scene_text(
      part_scene +
          "[motion]\nfile = \"m.csv\"\nframe = \"part\"\n[[set]]\nmotion.position_m = [[0, 0, 0], [0.01, 0, "
          "0]]\nmotion.rotation.axis = [0, 0, 1]\nmotion.rotation.angle_deg = [0, 90]\n",
      "s.toml");
  ASSERT_EQ(moved.jobs.size(), 4U);
  EXPECT_EQ(moved.jobs[3].error, "");
  EXPECT_EQ(moved.jobs[3].scene.motion.placement.position_m, Vec3(0.01, 0, 0));
  EXPECT_LT((moved.jobs[3].scene.motion.placement.rotation * Vec3(1, 0, 0) - Vec3(0, 1, 0)).norm(), 1e-15);
}

}  // namespace
}  // namespace fingerpad::placement_keys_test
