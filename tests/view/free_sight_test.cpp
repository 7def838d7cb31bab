// The camera of a picture sees the contact, also where a part stands around it.
#include "view/free_sight.hpp"

#include <gtest/gtest.h>

#include "support/worlds.hpp"
#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/stage_vtk.hpp"
#include "view/surface_hit.hpp"

namespace fingerpad::free_sight_test {
namespace {

/// A finger that rubs to and fro on the floor of a shed of five walls: the one at +x is missing.
ViewInput in_a_shed(bool closed) {
  TriangleSoup shed;
  const auto wall = [&](const Vec3& size_m, const Vec3& at_m) {
    const TriangleSoup box = test::moved(test::box_soup(size_m), at_m);
    shed = shed.triangles.cols() == 0 ? box : test::joined(shed, box);
  };
  wall({0.1, 0.1, 0.002}, {0, 0, -0.05});
  wall({0.1, 0.1, 0.002}, {0, 0, 0.05});
  wall({0.1, 0.002, 0.098}, {0, -0.05, 0});
  wall({0.1, 0.002, 0.098}, {0, 0.05, 0});
  wall({0.002, 0.098, 0.098}, {-0.05, 0, 0});
  if (closed) wall({0.002, 0.098, 0.098}, {0.05, 0, 0});
  ViewInput input;
  input.title = "shed";
  input.world = test::world_of(shed);
  for (int i = 0; i < 200; ++i) {
    TickRecord row;
    row.t_s = 1e-3 * i;
    row.phase = Phase::slip;
    row.contact_W = Vec3(0.02 * std::sin(0.06 * i), 0, -0.049);
    row.normal_W = Vec3::UnitZ();
    row.p_WQ = row.contact_W - 1e-3 * row.normal_W;
    row.normal_force_n = 1;
    row.friction_W_n = Vec3(-0.2, 0, 0);
    row.force_W_n = Vec3(-0.2, 0, 1);
    row.surface = 0;
    row.triangle = 0;
    input.rows.push_back(row);
  }
  return input;
}

TEST(FreeSight, LooksThroughTheOpenSideOfWhatStandsAround) {
  const VirtualScreen screen;
  const ViewInput input = in_a_shed(false);
  Stage stage(input, 600, 400, true, true);
  for (std::size_t row = 0; row < input.rows.size(); row += 20) {
    stage.show(input.rows[row], 0.1);
    const Vec3 towards_eye_W = stage.pointed().towards_eye_W;
    const Vec3 from_W = input.rows[row].contact_W + Vec3(0, 0, 1e-4);
    EXPECT_FALSE(line_hit(input.world->surfaces[0], from_W, from_W + towards_eye_W)) << row;
    EXPECT_GT(towards_eye_W.x(), 0.5);
  }
}

TEST(FreeSight, StaysAsWantedWhereThatSeesTheOnlyContactThereIs) {
  ViewInput input = in_a_shed(false);
  for (std::size_t row = 0; row < input.rows.size(); ++row) {
    if (row != 77) input.rows[row].phase = Phase::free;
  }
  const Vec3 level = Vec3(1, 0.1, 0.3).normalized();
  EXPECT_EQ(free_sight(input, &input.rows[77], level), level);
}

TEST(FreeSight, StaysAsWantedWhereThatSeesTheContactOrNothingDoes) {
  const Vec3 from_above = Vec3(0.3, -0.4, 0.9).normalized();
  EXPECT_EQ(free_sight(in_a_shed(true), nullptr, from_above), from_above);
  EXPECT_EQ(free_sight(test::torus_rub(0.3), nullptr, Vec3::UnitZ()), Vec3(Vec3::UnitZ()));
  const Vec3 level = Vec3(1, 0.1, 0.3).normalized();
  EXPECT_EQ(free_sight(in_a_shed(false), nullptr, level), level);
  EXPECT_NE(free_sight(in_a_shed(false), nullptr, from_above), from_above);
}

}  // namespace
}  // namespace fingerpad::free_sight_test
