#include "view/material_panel.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "view/rub.hpp"
#include "view/screen.hpp"
#include "view/touch_window.hpp"

namespace fingerpad::material_panel_test {
namespace {

using Row = MaterialPanel::Row;
using Kind = WindowEvent::Kind;

Scene torus_scene() {
  Scene scene;
  scene.parts.emplace_back();
  scene.contact.method = "proxy";
  return scene;
}

std::string value_of(const MaterialPanel& material, int row) {
  return material.panel().rows[static_cast<std::size_t>(row)].value;
}

TEST(MaterialPanel, StepsValuesWithinWhatASceneCanHave) {
  const ViewInput view = test::torus_rub(0.0);
  TouchSwap swap(view.world, torus_scene());
  MaterialPanel material(swap, *view.world, true);
  EXPECT_EQ(value_of(material, Row::mu_static), "0.3");
  EXPECT_EQ(material.step(Row::mu_static, 1), "mu static: 0.35");
  material.step(Row::mu_static, -100);
  EXPECT_EQ(value_of(material, Row::mu_static), "0.2") << "not below mu dynamic";
  material.step(Row::mu_dynamic, 100);
  EXPECT_EQ(value_of(material, Row::mu_dynamic), "0.2") << "not above mu static";
  material.step(Row::stiffness, 3);
  EXPECT_EQ(value_of(material, Row::stiffness), "1950 N/m");
  material.step(Row::damping, 1);
  EXPECT_EQ(value_of(material, Row::damping), "0.5 N s/m");
  material.step(Row::law, 1);
  EXPECT_NE(swap.scene().friction.law, "finger-pad");
  material.step(Row::law, -1);
  EXPECT_EQ(swap.scene().friction.law, "finger-pad");
  material.step(Row::normals, 1);
  EXPECT_NE(swap.scene().contact.normals->name, "smooth");
  material.step(Row::method, 1);
  EXPECT_EQ(swap.scene().contact.method, "closest-point");
  EXPECT_EQ(value_of(material, Row::method), "closest-point");
}

TEST(MaterialPanel, SaysWhereAMotorWouldShake) {
  const ViewInput view = test::torus_rub(0.0);
  Scene scene = torus_scene();
  scene.motion.rate_hz = 1000;
  scene.parts[0].surface.stiffness_n_per_m = 900;
  TouchSwap swap(view.world, scene);
  MaterialPanel material(swap, *view.world, true);
  EXPECT_EQ(material.panel().rows.size(), static_cast<std::size_t>(MaterialPanel::row_count) + 2);
  // b = 0.5 N s/m at 1 kHz holds some 1000 N/m (SCIENCE 4).
  EXPECT_NE(material.step(Row::stiffness, 1).find("; motors shake over 1000 N/m"), std::string::npos)
      << material.step(Row::stiffness, 0);
  EXPECT_EQ(material.panel().rows.size(), static_cast<std::size_t>(MaterialPanel::row_count) + 3);
  EXPECT_EQ(material.step(Row::damping, 4), "damping: 2 N s/m") << "which the wall's own damping prevents";
}

TEST(MaterialPanel, SaysNothingOfMotorsWhereThereAreNone) {
  const ViewInput view = test::torus_rub(0.0);
  Scene scene = torus_scene();
  scene.motion.rate_hz = 1000;
  scene.parts[0].surface.stiffness_n_per_m = 5000;
  TouchSwap swap(view.world, scene);
  MaterialPanel by_mouse(swap, *view.world, false);
  EXPECT_EQ(by_mouse.panel().rows.size(), static_cast<std::size_t>(MaterialPanel::row_count) + 2);
  EXPECT_EQ(by_mouse.step(Row::stiffness, 1), "stiffness: 6250 N/m");
}

TEST(MaterialPanel, SaysWhereAPressGoesThroughTheWholePart) {
  const ViewInput view = test::torus_rub(0.0);  // 140 mm wide, 40 mm high
  auto world = std::make_shared<World>(*view.world);
  world->verdicts.emplace_back().closed = true;
  Scene scene = torus_scene();
  scene.parts[0].surface.stiffness_n_per_m = 26;
  TouchSwap swap(world, scene);
  MaterialPanel material(swap, *world, false);
  EXPECT_EQ(material.step(Row::stiffness, -1),
            "stiffness: 20.8 N/m; 1 N goes 48 mm in, through all its 40 mm");
  EXPECT_EQ(material.panel().rows.size(), static_cast<std::size_t>(MaterialPanel::row_count) + 3);
  EXPECT_EQ(material.step(Row::stiffness, 1), "stiffness: 26 N/m");
  world->verdicts[0].closed = false;
  EXPECT_EQ(material.step(Row::stiffness, -1), "stiffness: 20.8 N/m") << "an open part has no inside";
}

TEST(MaterialPanel, LeavesARecordingsOwnChangesAlone) {
  const ViewInput view = test::torus_rub(0.0);
  TouchSwap swap(view.world, torus_scene());
  swap.schedule({{1, "part.0.mu_static", "0.5"}});
  MaterialPanel material(swap, *view.world, true);
  EXPECT_NE(material.step(Row::mu_static, 1).find("recording"), std::string::npos);
  EXPECT_EQ(swap.scene().parts[0].surface.mu_static, 0.5);
}

TEST(SidePanels, AreHitWhereTheyAreDrawn) {
  const Layout layout = layout_for(1280, 800, true, false);
  SidePanels panels;
  panels.show({"a", "first", {{PanelRow::Kind::check, "one", "", true, false}}});
  panels.show({"b", "second", {{PanelRow::Kind::value, "x", "1", false, false}}});
  const auto boxes = panels.boxes(layout);
  ASSERT_EQ(boxes.size(), 2u);
  const Box& second = boxes[1];
  EXPECT_LT(second.top(), boxes[0].bottom);
  const double y = second.bottom + 1.3 * layout.em;  // the row above the foot
  const auto more = panels.hit(layout, second.right() - 1.2 * layout.em, y);
  ASSERT_TRUE(more);
  EXPECT_EQ(more->panel, "b");
  EXPECT_EQ(more->row, 0);
  EXPECT_EQ(more->steps, 1);
  EXPECT_EQ(panels.hit(layout, second.right() - 3 * layout.em, y)->steps, -1);
  EXPECT_EQ(panels.hit(layout, second.left + 1, y)->steps, 0);
  EXPECT_FALSE(panels.hit(layout, second.left - 1, y));
  panels.hide("a");
  EXPECT_FALSE(panels.shows("a"));
  EXPECT_EQ(panels.boxes(layout).front().top(), boxes[0].top()) << "the other one moves up";
}

TEST(SidePanels, StayWithinASmallSceneAndSayHowManyRowsAreLeftOut) {
  const Layout layout = layout_for(620, 420, true, false);
  SidePanels panels;
  SidePanel first{"a", "first", {}}, second{"b", "second", {}};
  for (int k = 0; k < 10; ++k) first.rows.push_back({PanelRow::Kind::value, "x", "1", false, false});
  for (int k = 0; k < 30; ++k)
    second.rows.push_back({PanelRow::Kind::check, "part " + std::to_string(k), "", true, false});
  panels.show(first);
  panels.show(second);
  const auto boxes = panels.boxes(layout);
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_GE(boxes[1].bottom, layout.scene.bottom + axes_foot_em * layout.em) << "over the axes and the scale";
  EXPECT_LT(boxes[1].top(), boxes[0].bottom);
  Drawing drawing;
  panels.paint(drawing, layout);
  std::string words;
  int parts = 0;
  for (const auto& mark : drawing.marks()) {
    const auto* const text = std::get_if<Drawing::Text>(&mark);
    if (text == nullptr) continue;
    words += text->words + "\n";
    parts += text->words.starts_with("part ") ? 1 : 0;
    EXPECT_GE(text->at.y(), layout.scene.bottom) << text->words;
  }
  EXPECT_GT(parts, 2);
  EXPECT_NE(words.find("and " + std::to_string(30 - parts) + " more: make the window larger"),
            std::string::npos)
      << words;
  const auto foot = panels.hit(layout, boxes[1].left + 1, boxes[1].bottom + 1.3 * layout.em);
  ASSERT_TRUE(foot);
  EXPECT_EQ(foot->row, -1) << "it is no row to click";
  // Where the first takes all the room, the second is not there.
  first.rows = second.rows;
  panels.show(first);
  EXPECT_GT(panels.boxes(layout)[0].width, 0);
  EXPECT_EQ(panels.boxes(layout)[1].width, 0);
  EXPECT_FALSE(panels.hit(layout, 1, 1));
}

// Four values and two notes were told as six more.
TEST(SidePanels, CountNoNotesAmongTheRowsThatAreLeftOut) {
  SidePanels panels;
  SidePanel panel{"a", "first", {}};
  for (int k = 0; k < 8; ++k)
    panel.rows.push_back({PanelRow::Kind::value, "row " + std::to_string(k), "1", false, false});
  for (int k = 0; k < 2; ++k) panel.rows.push_back({PanelRow::Kind::note, "a note", "", false, false});
  panels.show(panel);
  std::vector<std::size_t> left_out;
  for (int height_px = 200; height_px <= 400; ++height_px) {
    SCOPED_TRACE(height_px);
    Drawing drawing;
    panels.paint(drawing, layout_for(200, height_px, false, false));
    std::size_t rows = 0, notes = 0, more = 0;
    for (const auto& mark : drawing.marks()) {
      const auto* const text = std::get_if<Drawing::Text>(&mark);
      if (text == nullptr) continue;
      rows += text->words.starts_with("row ") ? 1 : 0;
      notes += text->words == "a note" ? 1 : 0;
      if (text->words.starts_with("and ")) more = std::stoul(text->words.substr(4));
    }
    EXPECT_EQ(more, 8 - rows);
    EXPECT_TRUE(more == 0 || notes == 0) << "a row comes before a note";
    if (left_out.empty() || left_out.back() != more) left_out.push_back(more);
  }
  EXPECT_GT(left_out.size(), 3u) << "looked at in windows that show some, and in one that shows all";
  EXPECT_EQ(left_out.back(), 0u);
}

/// A live window on the torus whose servo stands still.
struct StillTouch {
  ViewInput view = test::torus_rub(0.0);
  Scene scene = torus_scene();
  TouchSwap swap{view.world, scene};
  std::vector<WindowReport> reports;
  FingerSample target;

  void play(std::vector<WindowEvent> events, double end_s) {
    const VirtualScreen screen;
    TouchWindowInput input;
    view.rows.clear();
    view.scene = scene;
    input.view = view;
    input.swap = &swap;
    input.set_target = [this](const FingerSample& aim) { target = aim; };
    input.latest = [] { return TickRecord{}; };
    input.recent = [](double) { return std::vector<TickRecord>(1); };
    WindowOptions options;
    options.width = 900;
    options.height = 600;
    events.push_back({end_s, Kind::key, "q"});
    options.events = std::move(events);
    options.on_frame = [this](const WindowReport& report) { reports.push_back(report); };
    run_touch_window(input, options);
  }
};

TEST(MaterialPanel, IsOpenedByAKeyAndChangedByTheMouseAndTheKeys) {
  const Layout layout = layout_for(900, 600, true, false);
  StillTouch touch;
  SidePanels same;
  same.show(MaterialPanel(touch.swap, *touch.view.world, false).panel());
  const Box box = same.boxes(layout).front();
  const int more_x = static_cast<int>(box.right() - 1.2 * layout.em);
  const int row_y = static_cast<int>(box.top() - layout.em * (2.1 + 1.75 * 1.5));  // mu static
  touch.play({{0.1, Kind::key, "m"},
              {0.2, Kind::press, "", more_x, row_y},
              {0.2, Kind::release, "", more_x, row_y},
              {0.3, Kind::wheel_up, "", more_x, row_y},
              {0.4, Kind::key, "Tab"},
              {0.4, Kind::key, "bracketleft"}},
             0.7);
  const SurfaceProperties& surface = touch.swap.scene().parts[0].surface;
  EXPECT_EQ(surface.mu_static, 0.4);
  EXPECT_EQ(surface.mu_dynamic, 0.15);
  ASSERT_FALSE(touch.reports.empty());
  EXPECT_FALSE(touch.reports.back().pressing) << "a click on the panel is no press";
  EXPECT_EQ(touch.reports.back().press_n, 1) << "the wheel was the panel's";
  EXPECT_EQ(touch.reports.back().message, "mu dynamic: 0.15");
}

TEST(MaterialPanel, TakesWhatItToldWithItWhenItIsClosed) {
  StillTouch open, closed;
  const std::vector<WindowEvent> changed{
      {0.1, Kind::key, "m"}, {0.2, Kind::key, "Tab"}, {0.3, Kind::key, "bracketright"}};
  open.play(changed, 0.8);
  EXPECT_NE(open.reports.back().message, "");
  std::vector<WindowEvent> then = changed;
  then.push_back({0.5, Kind::key, "m"});
  closed.play(then, 0.8);
  EXPECT_EQ(closed.reports.back().message, "");
}

TEST(PartTree, HidesAPartByAClickSoThatTheMouseGoesThroughIt) {
  const Layout layout = layout_for(900, 600, true, false);
  SidePanels same;
  same.show({"parts", "", {{PanelRow::Kind::check, "0  torus.stl", "", true, false}, {}}});
  const Box box = same.boxes(layout).front();
  const int x = static_cast<int>(box.left + 1.2 * layout.em);
  const int y = static_cast<int>(box.top() - layout.em * (2.1 + 0.9));
  // The near side of the ring, of which the window of 600 x 400 has it at 189, 90.
  const int ring_x = static_cast<int>(layout.scene.centre().x());
  const int ring_y = static_cast<int>(layout.scene.bottom + 0.25 * layout.scene.height);
  StillTouch shown, hidden;
  shown.play({{0.1, Kind::move, "", ring_x, ring_y}, {0.2, Kind::press, "", ring_x, ring_y}}, 0.5);
  EXPECT_TRUE(shown.reports.back().pressing);
  hidden.play({{0.1, Kind::key, "t"},
               {0.2, Kind::press, "", x, y},
               {0.2, Kind::release, "", x, y},
               {0.3, Kind::move, "", ring_x, ring_y},
               {0.4, Kind::press, "", ring_x, ring_y}},
              0.7);
  EXPECT_FALSE(hidden.reports.back().pressing);
}

TEST(TouchWindow, SaysHowToPressUntilItWasDoneOnce) {
  const Layout layout = layout_for(900, 600, true, false);
  const int x = static_cast<int>(layout.scene.centre().x());
  const int y = static_cast<int>(layout.scene.bottom + 0.25 * layout.scene.height);
  StillTouch touch;
  // The first event comes late by as long as the first frame takes, and with it the others.
  touch.play({{0, Kind::move, "", 1, 1}, {0.3, Kind::press, "", x, y}, {0.4, Kind::release, "", x, y}}, 0.7);
  EXPECT_TRUE(touch.reports.front().invites);
  EXPECT_FALSE(touch.reports.back().invites);
}

TEST(TouchWindow, TheWheelOverTheChartsIsTheirsAllOver) {
  const Layout layout = layout_for(900, 600, true, false);
  StillTouch touch;
  // Beside the panels, left of the frames.
  touch.play({{0.2, Kind::wheel_up, "", static_cast<int>(layout.charts.left) + 3, 300}}, 0.5);
  EXPECT_EQ(touch.reports.back().press_n, 1);
}

TEST(CameraKeys, LookFromTheSidesAndBringAllIntoSight) {
  StillTouch touch;
  touch.play(
      {{0.1, Kind::key, "5"}, {0.3, Kind::key, "plus"}, {0.3, Kind::key, "plus"}, {0.5, Kind::key, "0"}},
      0.8);
  EXPECT_LT((touch.reports.back().towards_eye_W - Vec3::UnitZ()).norm(), 1e-6);
  double least_mm = 1e9, from_top_mm = 0;
  for (const WindowReport& report : touch.reports) {
    if ((report.towards_eye_W - Vec3::UnitZ()).norm() > 1e-6) continue;
    if (from_top_mm == 0) from_top_mm = report.half_height_mm;
    least_mm = std::min(least_mm, report.half_height_mm);
  }
  EXPECT_LT(least_mm, 0.8 * from_top_mm);
  EXPECT_NEAR(touch.reports.back().half_height_mm, from_top_mm, 1e-9);
}

}  // namespace
}  // namespace fingerpad::material_panel_test
