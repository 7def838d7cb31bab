#include "view/touch_doubts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "contact/triangle_tree.hpp"
#include "part/part.hpp"
#include "support/shapes.hpp"
#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/touch_window.hpp"

// What a live touch tells of a finger that is pressed too deep, or that is too large for a place.

namespace fingerpad::touch_doubts_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Kind = WindowEvent::Kind;

/// A box about a place.
Surface box_of(const Vec3& size_m, const Vec3& at_m) {
  Surface surface;
  surface.part = std::make_shared<const Part>(make_part(test::box_soup(size_m), 0.5));
  surface.tree = std::make_shared<const TriangleTree>(surface.part);
  surface.p_WP = at_m;
  return surface;
}

TickRecord pressed(double depth_m) {
  TickRecord row;
  row.phase = Phase::stick;
  row.surface = 0;
  row.contact_W = Vec3(0.002, 0.001, 0.0015);
  row.normal_W = Vec3::UnitZ();
  row.depth_m = depth_m;
  return row;
}

TEST(TooDeep, IsToldWhereThePartIsThinnerThanThePressIsDeep) {
  World world;
  world.surfaces = {box_of(Vec3(0.04, 0.04, 0.003), Vec3::Zero()), Surface{}};
  EXPECT_EQ(too_deep_words(world, pressed(0.0029)), "");
  EXPECT_EQ(too_deep_words(world, pressed(0.02)), "20 mm deep, through the part: press less, or stiffen it");
  TickRecord row = pressed(0.02);
  row.surface = 1;
  EXPECT_EQ(too_deep_words(world, row), "") << "a plane has no other side";
  row.surface = 0;
  row.phase = Phase::free;
  EXPECT_EQ(too_deep_words(world, row), "");
}

// A finger in a hole's mouth is held by both rims. What they push together leads out through the mouth, and
// a line along it from one of them goes through air into the other.
TEST(TooDeep, IsNotToldOfAFingerThatTwoRimsHold) {
  World world;
  world.surfaces = {box_of(Vec3(0.02, 0.04, 0.02), Vec3(0.013, 0, -0.01))};
  TickRecord row = pressed(0.005);
  row.contact_W = Vec3(0.003, 0, 0);  // on the box's upper edge
  row.normal_W = Vec3(-0.6, 0, 0.8);
  EXPECT_EQ(too_deep_words(world, row), "") << "into the box, which is thick";
  row.contact_W = Vec3(0.003 - 1e-4, 0, -1e-4);  // of the other rim, in the air before the box
  EXPECT_EQ(too_deep_words(world, row), "") << "the line goes into the box, not out of it";
  row.depth_m = 0.05;
  row.contact_W = Vec3(0.013, 0, 0);
  EXPECT_NE(too_deep_words(world, row), "") << "through it and out";
}

/// A floor between two walls, so far apart.
World groove(double width_m) {
  World world;
  const double half_m = 0.01, off_m = width_m / 2 + half_m;
  world.surfaces = {Surface{}, box_of(Vec3::Constant(2 * half_m), Vec3(off_m, 0, half_m)),
                    box_of(Vec3::Constant(2 * half_m), Vec3(-off_m, 0, half_m))};
  return world;
}

TEST(TooLarge, IsAFingerInAGrooveThatIsTooNarrowForIt) {
  const Vec3 up = Vec3::UnitZ(), spot = Vec3::Zero();
  EXPECT_TRUE(is_too_large_for(groove(0.006), spot, up, 0.005));
  EXPECT_FALSE(is_too_large_for(groove(0.011), spot, up, 0.005));
  EXPECT_FALSE(is_too_large_for(groove(0.006), spot, up, 0.002));
  EXPECT_FALSE(is_too_large_for(groove(0.006), spot, up, 0)) << "a point goes everywhere";
  EXPECT_FALSE(is_too_large_for(groove(0.006), Vec3(0.013, 0, 0.02), up, 0.005)) << "on top of a wall";
}

/// What the title line of a window on a torus told at last, of a finger that rests far above. The ring's hole
/// is 60 mm wide; the pointer is over its far side, or over the ring's outer one.
std::string hint_of(double radius_m, bool in_hole) {
  const VirtualScreen screen;
  TouchWindowInput input;
  input.view = test::torus_rub(0.0);
  input.view.rows.clear();
  input.view.scene->finger.radius_m = radius_m;
  input.set_target = [](const FingerSample&) {};
  TickRecord row;
  row.p_WQ = Vec3(0, 0, 1);
  input.latest = [&] { return row; };
  input.recent = [&](double) { return std::vector<TickRecord>(1, row); };
  WindowOptions options;
  options.width = 600;
  options.height = 400;
  options.events = {{0.1, Kind::move, "", 189, in_hole ? 242 : 90}, {3.0, Kind::key, "q"}};
  std::string hint;
  options.on_frame = [&](const WindowReport& report) { hint = report.hint; };
  run_touch_window(input, options);
  return hint;
}

TEST(TooLarge, IsToldInTheTitleLineOfAWindow) {
  const char* const words = "the finger is too large for what is under the pointer";
  EXPECT_THAT(hint_of(0.04, true), HasSubstr(words));
  EXPECT_THAT(hint_of(0.04, false), Not(HasSubstr(words)));
  EXPECT_THAT(hint_of(0.005, true), Not(HasSubstr(words)));
}

}  // namespace
}  // namespace fingerpad::touch_doubts_test
