#include "view/stage_vtk.hpp"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>

#include "view/overlay_hud.hpp"
#include "view/pixel_statistics.hpp"
#include "view/png_vtk.hpp"
#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/touch_chart.hpp"
#include "view/value_label_vtk.hpp"

namespace fingerpad::test {
namespace {

long pixels_that_differ(const Pixels& a, const Pixels& b) {
  long count = 0;
  for (std::size_t i = 0; i + 2 < a.rgb.size(); i += 3) {
    count += a.rgb[i] != b.rgb[i] || a.rgb[i + 1] != b.rgb[i + 1] || a.rgb[i + 2] != b.rgb[i + 2];
  }
  return count;
}

TEST(Stage, PaintsTheValueThatTheMouseAsksFor) {
  const VirtualScreen screen;
  const ViewInput input = torus_rub(1);
  Stage stage(input, 900, 600, true, true);
  stage.show_chart(touch_chart(input.rows, Vec3::UnitX(), touch_levels(input)));
  stage.show(input.rows.front(), 0);
  stage.render();
  const Pixels before = pixels_of(stage.window());
  const Box lowest = stage.charts().place().panels.back();
  const int x = static_cast<int>(lowest.left + 0.6 * lowest.width);
  for (int y = static_cast<int>(lowest.bottom); y < lowest.top() && stage.charts().told().empty(); ++y) {
    stage.charts().move(x, y);
  }
  ASSERT_NE(stage.charts().told(), "");
  stage.render();
  // A box of a dozen letters.
  EXPECT_GT(pixels_that_differ(before, pixels_of(stage.window())), 500);
}

TEST(ValueLabel, StandsWholeInTheWindowWhereverTheMouseIs) {
  for (double x = 0; x <= 640; x += 16) {
    for (double y = 0; y <= 480; y += 16) {
      const Box box = value_label_box({x, y}, {190, 16}, 640, 480);
      EXPECT_GE(box.left, 0);
      EXPECT_GE(box.bottom, 0);
      EXPECT_LE(box.right(), 640);
      EXPECT_LE(box.top(), 480);
      EXPECT_FALSE(box.holds(x, y)) << "it would hide what is pointed at: " << x << ", " << y;
    }
  }
}

TEST(Stage, OfALiveTouchShowsThePartBesideTheReadings) {
  const VirtualScreen screen;
  ViewInput input = torus_rub(0);
  input.rows.clear();
  Stage stage(input, 1280, 800, true, false);
  const auto hidden = [&] {
    int count = 0;
    const Box& scene = stage.layout().scene;
    for (double y = scene.bottom + 5; y < scene.top(); y += 10) {
      for (double x = scene.left + 5; x < scene.left + readings_width_em * stage.layout().em; x += 10) {
        const auto [near, far] = stage.line_of_sight(x, y);
        count += stage.world().first_hit(near, far).has_value();
      }
    }
    return count;
  };
  ASSERT_GT(hidden(), 10);
  stage.keep_clear_of_readings();
  EXPECT_EQ(hidden(), 0);
  stage.look(*named_look("top"));
  EXPECT_EQ(hidden(), 0);
  stage.resize(400, 300);
  const auto [near, far] = stage.line_of_sight(stage.layout().scene.centre().x(), 20);
  EXPECT_TRUE(near.allFinite() && far.allFinite());
}

TEST(Stage, LeavesNothingOfAPageThatIsClosedAtAnySize) {
  const VirtualScreen screen;
  const ViewInput input = torus_rub(1);
  Stage stage(input, 520, 340, true, true);
  stage.words().help = std::vector<std::string>(30, "key: what it does");
  stage.show(input.rows.front(), 0);
  for (const auto& [width, height] : {std::pair(520, 340), std::pair(601, 433), std::pair(901, 607)}) {
    stage.resize(width, height);
    stage.render();
    const Pixels before = pixels_of(stage.window());
    stage.state().help = true;
    stage.render();
    EXPECT_GT(pixels_that_differ(before, pixels_of(stage.window())), 1000);
    stage.state().help = false;
    stage.render();
    EXPECT_EQ(pixels_that_differ(before, pixels_of(stage.window())), 0) << width;
  }
}

/// How much wider than the scene the part stands: over 1 where something of it is cut off.
double width_share(Stage& stage, const Vec3& right_mm) {
  const auto [near, far] = stage.line_of_sight(0, 0);
  const double px_per_mm = 1 / (stage.line_of_sight(1, 0).first - near).norm();
  return 2 * right_mm.norm() * px_per_mm / stage.layout().scene.width;
}

TEST(Stage, FitsAViewThatNobodyHasChangedToANewSize) {
  const VirtualScreen screen;
  const ViewInput input = torus_rub(1);
  Stage stage(input, 1000, 400, false, false);
  stage.look(*named_look("top"));
  const Vec3 torus_mm(70, 0, 0);
  EXPECT_LT(width_share(stage, torus_mm), 1);
  stage.resize(400, 700);
  EXPECT_LT(width_share(stage, torus_mm), 1);
  EXPECT_GT(width_share(stage, torus_mm), 0.8) << "and fills it";
  stage.zoom(3);
  const double scale = stage.scene()->GetActiveCamera()->GetParallelScale();
  stage.resize(500, 700);
  EXPECT_EQ(stage.scene()->GetActiveCamera()->GetParallelScale(), scale) << "as it was asked for";
}

/// Where a place stands in a scene, from 0 at its left foot to 1.
Vec2 share_in_scene(const Stage& stage, const Vec3& p_W) {
  const SightLines lines = stage.pointed().lines;
  const Vec3 from_corner_mm = stage.space().to_draw(p_W) - lines.near_mm;
  const Vec2 px(from_corner_mm.dot(lines.right_mm) / lines.right_mm.squaredNorm(),
                from_corner_mm.dot(lines.up_mm) / lines.up_mm.squaredNorm());
  const Box& scene = stage.layout().scene;
  return {(px.x() - scene.left) / scene.width, (px.y() - scene.bottom) / scene.height};
}

TEST(Stage, PresetsOfALiveTouchHoldTheWholeFingerWhereverItHovers) {
  const VirtualScreen screen;
  for (const double radius_m : {0.0, 0.007}) {
    ViewInput input = torus_rub(0);
    input.rows.clear();
    input.scene->finger.radius_m = radius_m;
    Stage stage(input, 1280, 800, true, false);
    stage.keep_clear_of_readings();
    TickRecord row;
    for (const Vec3& direction : {Vec3(0.35, -0.6, 0.72), Vec3(0, 0, 1), Vec3(1, 0, 0.2)}) {
      row.p_WQ = 0.085 * direction.normalized();
      stage.show(row, 0);
      for (const char* look : {"front", "back", "left", "right", "top", "bottom", "isometric"}) {
        stage.look(*named_look(look));
        for (const auto& [width, height] : {std::pair(1280, 800), std::pair(640, 480)}) {
          stage.resize(width, height);
          const double drawn_m = 1e-3 * 0.9 * 8 * stage.layout().em * stage.pointed().lines.up_mm.norm();
          const Vec3 back = -input.scene->finger.direction * (radius_m > 0 ? 4 * radius_m : drawn_m);
          for (const Vec3& place : {row.p_WQ, Vec3(row.p_WQ + back)}) {
            const Vec2 at = share_in_scene(stage, place);
            EXPECT_TRUE(at.minCoeff() > 0 && at.maxCoeff() < 1) << look << " at " << at.transpose();
          }
        }
        for (const Vec3& side : {Vec3(0.07, 0, 0), Vec3(0, 0.07, 0), Vec3(0, 0, 0.02)}) {
          for (const double sign : {-1, 1}) {
            const Vec2 at = share_in_scene(stage, sign * side);
            EXPECT_TRUE(at.minCoeff() > 0 && at.maxCoeff() < 1) << look << ": the torus too";
          }
        }
      }
    }
  }
}

TEST(Readings, OfASmallSceneAreBriefAndNeedNoLegend) {
  OverlayFacts facts;
  facts.row.emplace();
  facts.readings = {{"median tick", "2 us"}};
  facts.tick_bars.heights = {1};
  const Vec2 whole = readings_size(facts, 9);
  facts.brief = true;
  EXPECT_LT(readings_size(facts, 9).y(), 0.35 * whole.y());
  EXPECT_EQ(legend_size(facts, {}, 9), Vec2(0, 0));
  const VirtualScreen screen;
  ViewInput input = torus_rub(1);
  Stage stage(input, 400, 300, true, false);
  stage.show(input.rows.back(), 0);
  stage.words().readings = {{"median tick", "2 us"}, {"99.9 % of ticks", "9 us"}};
  stage.words().tick_bars = {{1, 1}, "1 us", "2 us"};
  stage.state().close_up = false;  // which stands elsewhere without them
  stage.render();
  const Pixels with = pixels_of(stage.window());
  stage.state().hud = false;
  stage.render();
  // Phase and two forces: a small part of the picture.
  const long over_the_scene = pixels_that_differ(with, pixels_of(stage.window()));
  EXPECT_GT(over_the_scene, 1000);
  EXPECT_LT(over_the_scene, 0.07 * 400 * 300);
}

TEST(Stage, OfAnotherSizeIsLookedAtFromWhereItWas) {
  const VirtualScreen screen;
  ViewInput input = torus_rub(1);
  const std::size_t count = input.rows.size();
  for (std::size_t i = 0; i < count; ++i) {  // first on the top, later and not so long beneath
    TickRecord& row = input.rows[i];
    const double side = i < 2 * count / 3 ? 1 : -1;
    const Vec3 outwards = Vec3(row.p_WQ.x(), row.p_WQ.y(), 0).normalized();
    row.contact_W = row.p_WQ = 0.05 * outwards + Vec3(0, 0, 0.02 * side);
    row.normal_W = Vec3(0, 0, side);
  }
  Stage stage(input, 700, 500, true, true);
  const auto from = [&] { return Vec3(stage.scene()->GetActiveCamera()->GetDirectionOfProjection()); };
  stage.show(input.rows.back(), 0);
  stage.reset_camera();
  const Vec3 last = from();
  stage.show(input.rows[count / 2 - 1], 0);
  stage.reset_camera();
  const Vec3 first = from();
  ASSERT_LT(first.dot(last), 0.9) << "or there is nothing to tell";
  stage.show(input.rows.back(), 0);
  stage.resize(500, 500);
  EXPECT_GT(from().dot(first), 1 - 1e-9);
}

TEST(ContactGlyphs, OfAFingerOnSeveralWallsHaveAStickCentreThatIsSeenThroughIt) {
  ContactMoment moment;
  moment.row.phase = Phase::stick;
  moment.row.contact_W = Vec3(0.01, 0, 0);
  moment.row.normal_W = Vec3::UnitZ();
  moment.row.stick_centre_W = Vec3(0.02, 0, 0);
  GlyphChoice choice;
  choice.finger = choice.forces = choice.frame = false;
  const auto right_end_mm = [&] {
    double x = 0;
    for (const Vec3& point : contact_glyphs(moment, {}, choice).solid.points)
      x = std::max<double>(x, point.x());
    return x;
  };
  moment.row.walls = 1;
  const double on_one = right_end_mm();
  moment.row.walls = 2;
  EXPECT_GT(right_end_mm(), on_one + 0.1 * choice.size_mm) << "a larger ball";
  moment.row.stick_centre_W = moment.row.contact_W;
  const double beside = right_end_mm();
  moment.row.walls = 1;
  EXPECT_EQ(right_end_mm(), beside) << "which would hide the contact that it stands on";
}

TEST(CloseUp, ShowsTheStickCentreOfAFingerOnSeveralWallsToo) {
  ContactMoment moment;
  moment.row.phase = Phase::stick;
  moment.row.contact_W = Vec3(0.01, 0, 0);
  moment.row.normal_W = Vec3::UnitZ();
  moment.row.walls = 2;  // of which it has no region
  const auto points = [&] { return close_up_glyphs(moment, {}, 0, 1, {}).solid.points.size(); };
  const auto contact_alone = points();
  moment.row.stick_centre_W = Vec3(0.011, 0, 0);
  EXPECT_EQ(points(), 2 * contact_alone) << "a ball each";
}

TEST(Finger, PressedThroughASmallPartStaysInSight) {
  ContactMoment moment;
  moment.row.phase = Phase::stick;
  moment.row.depth_m = 0.9e-3;
  moment.row.contact_W = Vec3::Zero();
  moment.row.normal_W = Vec3::UnitZ();
  moment.row.p_WQ = Vec3(0, 0, -0.9e-3);
  const auto lowest_mm = [&](double size_mm) {
    GlyphChoice choice;
    choice.size_mm = size_mm;
    choice.forces = choice.frame = false;
    double z = 0;
    for (const Vec3& point : contact_glyphs(moment, {}, choice).clear.points) z = std::min(z, point.z());
    return z;
  };
  EXPECT_NEAR(lowest_mm(3), -0.9, 1e-9) << "of a usual part it is where it is";
  EXPECT_NEAR(lowest_mm(0.01), -0.01, 1e-9);
}

TEST(Stage, OfTwoWallsDrawsNoRegionOfOneOfThem) {
  const ViewInput input = torus_rub(1);
  TickRecord row = *std::find_if(input.rows.begin(), input.rows.end(),
                                 [](const TickRecord& one) { return one.phase == Phase::stick; });
  EXPECT_TRUE(contact_moment(input, row).region);
  const double reach_m = contact_moment(input, row).region_reach_m;
  row.walls = 2;
  EXPECT_FALSE(contact_moment(input, row).region);
  EXPECT_GT(reach_m, 0);
  EXPECT_EQ(contact_moment(input, row).region_reach_m, reach_m) << "the close-up shows as much as before";
}

}  // namespace
}  // namespace fingerpad::test
