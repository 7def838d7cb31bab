#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cstdlib>
#include <functional>

#include "view/coarse_meshes_vtk.hpp"
#include "view/pixel_statistics.hpp"
#include "view/png_vtk.hpp"
#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/stage_vtk.hpp"
#include "view/touch_chart.hpp"

// What a window keeps from frame to frame is the same picture as one that is drawn whole.

namespace fingerpad::kept_test {
namespace {

using test::torus_rub;

constexpr std::size_t early = 200, late = 620;  // rows of torus_rub, one of stick, one of slip

/// Pixels of which a channel differs by more than rounding.
long differences(const Pixels& a, const Pixels& b) {
  EXPECT_EQ(a.rgb.size(), b.rgb.size());
  constexpr int rounding = 2;  // samples are summed up in another order where they were copied
  long count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) count += std::abs(a.rgb[i] - b.rgb[i]) > rounding;
  return count;
}

struct Shown {
  explicit Shown(const ViewInput& view, bool keeping = true)
      : input(view), stage(input, 700, 500, true, true) {
    stage.set_keeping(keeping);
    stage.show_chart(touch_chart(input.rows, Vec3::UnitX(), touch_levels(input)));
  }
  Pixels at(std::size_t row) {
    stage.show(input.rows[row], 0.1);
    stage.render();
    return pixels_of(stage.window());
  }
  ViewInput input;
  Stage stage;
};

TEST(Kept, PictureIsTheSameAsDrawnWhole) {
  const VirtualScreen screen;
  Shown kept(torus_rub(1)), whole(torus_rub(1), false);
  const Pixels first = kept.at(early);
  const Pixels second = kept.at(late);
  EXPECT_EQ(kept.stage.still_drawn(), 1);
  EXPECT_EQ(kept.stage.charts_drawn(), 1);
  EXPECT_GT(differences(first, second), 1000) << "the finger has moved";
  EXPECT_EQ(differences(second, whole.at(late)), 0);
  EXPECT_EQ(whole.stage.still_drawn(), 1);
}

/// Of the colour of a finger's skin on white.
double skin(Shown& shown) {
  const Pixels pixels = shown.at(late);
  double count = 0;
  test::for_pixels(pixels, shown.stage.layout().scene, [&](const std::uint8_t* rgb) {
    count += rgb[0] > rgb[2] + 30 && rgb[0] > rgb[1] + 15 && rgb[2] > 60 ? 1 : 0;
  });
  return count;
}

TEST(Kept, FingerIsHiddenByThePart) {
  const VirtualScreen screen;
  Shown kept(torus_rub(1)), whole(torus_rub(1), false);
  for (Shown* shown : {&kept, &whole}) {
    shown->stage.state().path = false;
    vtkCamera* const camera = shown->stage.scene()->GetActiveCamera();
    camera->Azimuth(180);  // to the far side: the part is between the eye and the finger's tip
    camera->Elevation(-75);
    camera->OrthogonalizeViewUp();
    shown->at(early);
  }
  EXPECT_EQ(differences(kept.at(late), whole.at(late)), 0);
  const double half_hidden = skin(kept);
  EXPECT_EQ(kept.stage.still_drawn(), 1);
  kept.stage.world().show_surface(0, false);
  const double not_hidden = skin(kept);
  EXPECT_GT(half_hidden, 0.05 * not_hidden);
  EXPECT_LT(half_hidden, 0.9 * not_hidden);
}

struct Change {
  const char* name;
  std::function<void(Stage&)> make;
};
std::ostream& operator<<(std::ostream& out, const Change& change) {
  return out << change.name;
}

class KeptIsStale : public testing::TestWithParam<Change> {};

TEST_P(KeptIsStale, AfterAChange) {
  const VirtualScreen screen;
  Shown shown(torus_rub(1));
  const Pixels before = shown.at(early);
  shown.at(late);
  ASSERT_EQ(shown.stage.still_drawn(), 1);
  GetParam().make(shown.stage);
  const Pixels after = shown.at(early);
  EXPECT_EQ(shown.stage.still_drawn(), 2);
  EXPECT_TRUE(before.rgb.size() != after.rgb.size() || differences(before, after) > 100);
  shown.stage.set_keeping(false);
  EXPECT_EQ(differences(after, shown.at(early)), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Of, KeptIsStale,
    testing::Values(Change{"Size", [](Stage& stage) { stage.resize(640, 480); }},
                    Change{"Dark", [](Stage& stage) { stage.state().dark = true; }},
                    Change{"Colour",
                           [](Stage& stage) { stage.world().part_property()->SetColor(0.9, 0.8, 0.2); }},
                    Change{"Visibility", [](Stage& stage) { stage.world().show_surface(0, false); }},
                    Change{"Wireframe", [](Stage& stage) { stage.state().wireframe = true; }},
                    Change{"Camera", [](Stage& stage) { stage.scene()->GetActiveCamera()->Azimuth(10); }},
                    Change{"Zoom", [](Stage& stage) { stage.zoom(1.3); }},
                    Change{"Path", [](Stage& stage) { stage.state().path = false; }},
                    Change{"ColourMap", [](Stage& stage) { stage.state().colouring = PathColouring::force; }},
                    Change{"SmoothEdges", [](Stage& stage) { stage.window()->SetMultiSamples(0); }}),
    [](const auto& info) { return info.param.name; });

TEST(Kept, ChartsAreDrawnAnewWhenTheyChange) {
  const VirtualScreen screen;
  Shown shown(torus_rub(1));
  shown.at(early);
  shown.at(late);
  EXPECT_EQ(shown.stage.charts_drawn(), 1);
  const std::span<const TickRecord> half(shown.input.rows.data(), shown.input.rows.size() / 2);
  shown.stage.show_chart(touch_chart(half, Vec3::UnitX(), touch_levels(shown.input)));
  const Pixels after = shown.at(late);
  EXPECT_EQ(shown.stage.charts_drawn(), 2);
  EXPECT_EQ(shown.stage.still_drawn(), 1);
  shown.stage.set_keeping(false);
  EXPECT_EQ(differences(after, shown.at(late)), 0);
}

TEST(Kept, CloseUpOfWhatIsNearIsThatOfAll) {
  const VirtualScreen screen;
  Shown near(torus_rub(1));
  ViewInput input = torus_rub(1);
  auto world = std::make_shared<World>(*input.world);
  world->surfaces[0].tree = nullptr;  // so that nothing is left out
  input.world = world;
  Shown all(input);
  // A pixel between two triangles may be either's.
  for (const std::size_t row : {early, late}) EXPECT_LT(differences(near.at(row), all.at(row)), 20);
}

TEST(WorldProps, WhatIsNotShownIsNotUnderTheMouse) {
  const VirtualScreen screen;
  Shown shown(torus_rub(0.2));
  const Vec3 above(50, 0, 200), below(50, 0, -200);
  EXPECT_TRUE(shown.stage.world().first_hit(above, below));
  shown.stage.world().show_surface(0, false);
  EXPECT_FALSE(shown.stage.world().first_hit(above, below));
}

ViewInput fine_torus_rub() {
  ViewInput input = torus_rub(0.2);
  auto world = std::make_shared<World>(*input.world);
  world->surfaces[0].part =
      std::make_shared<const Part>(make_part(test::torus_soup(0.05, 0.02, 320, 160), 0.5));
  world->surfaces[0].tree = nullptr;
  input.world = world;
  return input;
}

TEST(Coarse, MeshIsNearThePartAndTheSameEachTime) {
  const ViewInput input = fine_torus_rub();
  const auto mesh = coarse_mesh(input.world->surfaces[0], {});
  const auto again = coarse_mesh(input.world->surfaces[0], {});
  EXPECT_GT(mesh->GetNumberOfCells(), 5000);
  EXPECT_LT(mesh->GetNumberOfCells(), 30'000);
  ASSERT_EQ(mesh->GetNumberOfPoints(), again->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
    const Vec3 p(mesh->GetPoint(i));
    EXPECT_EQ(p, Vec3(again->GetPoint(i)));
    const double from_tube = std::hypot(std::hypot(p.x(), p.y()) - 50, p.z()) - 20;
    EXPECT_NEAR(from_tube, 0, 1.8);  // the side of a cell [mm]
  }
}

TEST(Coarse, ViewIsShownWhileItTurnsAndTheWholeOneAtRest) {
  const VirtualScreen screen;
  Shown shown(fine_torus_rub());
  shown.stage.set_pace(Stage::Pace::coarse);
  shown.stage.window()->SetMultiSamples(0);  // or slow frames would give smooth edges up in between
  vtkCamera* const camera = shown.stage.scene()->GetActiveCamera();
  shown.at(0);
  EXPECT_FALSE(shown.stage.shows_coarse());
  // Until its thread has made it the part is shown whole.
  while (!shown.stage.shows_coarse()) {
    camera->Azimuth(3);
    shown.at(0);
  }
  const Pixels coarse = pixels_of(shown.stage.window());
  while (!shown.stage.has_come_to_rest()) {
  }
  const Pixels whole = shown.at(0);
  EXPECT_FALSE(shown.stage.shows_coarse());
  EXPECT_FALSE(shown.stage.has_come_to_rest());
  EXPECT_GT(differences(coarse, whole), 100);
  shown.stage.set_keeping(false);
  EXPECT_EQ(differences(whole, shown.at(0)), 0);
}

}  // namespace
}  // namespace fingerpad::kept_test
