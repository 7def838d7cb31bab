#include "view/camera_look.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "view/layout.hpp"
#include "view/picture.hpp"
#include "view/pixel_statistics.hpp"
#include "view/rub.hpp"
#include "view/screenshot.hpp"

namespace fingerpad::camera_look_test {
namespace {

TEST(CameraLook, PresetsStandWhereTheirNamesSay) {
  const auto towards = [](std::string_view name) { return named_look(name)->towards_eye_W; };
  EXPECT_LT((towards("front") - Vec3(0, -1, 0)).norm(), 1e-12);
  EXPECT_LT((towards("back") - Vec3(0, 1, 0)).norm(), 1e-12);
  EXPECT_LT((towards("left") - Vec3(-1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((towards("right") - Vec3(1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((towards("top") - Vec3(0, 0, 1)).norm(), 1e-12);
  EXPECT_LT((towards("bottom") - Vec3(0, 0, -1)).norm(), 1e-12);
  EXPECT_LT((towards("isometric") - Vec3(1, -1, 1).normalized()).norm(), 1e-12);
  EXPECT_LT((named_look("top")->up_W - Vec3(0, 1, 0)).norm(), 1e-12) << "y upwards, x to the right";
  EXPECT_FALSE(named_look("askew"));
}

TEST(CameraLook, IsReadAsANameOrAnglesWithAZoom) {
  EXPECT_EQ(read_look("top").zoom, 1);
  EXPECT_EQ(read_look("top,3").zoom, 3);
  EXPECT_LT((read_look("90,0").towards_eye_W - Vec3(1, 0, 0)).norm(), 1e-12);
  EXPECT_EQ(read_look("30,45,2.5").zoom, 2.5);
  for (const char* wrong : {"", "up", "30", "30,100", "30,45,0", "30,45,2,1", "nan,0", "top,nan"})
    EXPECT_THROW(read_look(wrong), Error) << wrong;
}

TEST(CameraLook, APictureFromTheTopShowsTheTorusRound) {
  ViewInput input = test::torus_rub(0.0);
  input.rows.clear();
  ViewState state;
  state.hud = false;
  const auto share = [&](const char* look) {
    state.look = read_look(look);
    const Pixels pixels = view_pixels(input, 400, 400, std::nullopt, state);
    return test::share_drawn(pixels, {180, 180, 40, 40});
  };
  // Through the hole one sees the ground; from the front the tube stands before it, shaded.
  EXPECT_LT(share("top"), 0.05);
  EXPECT_GT(share("front"), 0.2);
}

TEST(Theme, DarkPicturesHaveDarkPaperAndKeepTheColoursOfPhases) {
  const ViewInput input = test::torus_rub(0.5);
  ViewState state;
  state.dark = true;
  const Pixels dark = view_pixels(input, 640, 480, std::nullopt, state);
  state.dark = false;
  const Pixels light = view_pixels(input, 640, 480, std::nullopt, state);
  const Layout layout = layout_for(640, 480, true, true);
  EXPECT_LT(test::share_of(dark, layout.charts, colours::white), 0.02);
  EXPECT_GT(test::share_of(light, layout.charts, colours::white), 0.2);
  const Box strip{layout.charts.left, layout.charts.top() - 3 * layout.em, layout.charts.width,
                  3 * layout.em};
  EXPECT_GT(test::share_of(dark, strip, colours::orange), 0.02);
  EXPECT_LT(test::share_of(dark, layout.charts, colours::pale_grey), 0.005) << "the grid is dark too";
}

TEST(Wireframe, ShowsTheGroundBetweenTheEdges) {
  ViewInput input = test::torus_rub(0.0);
  input.rows.clear();
  ViewState state;
  state.hud = false;
  state.look = read_look("top");
  const Pixels faces = view_pixels(input, 400, 400, std::nullopt, state);
  state.wireframe = true;
  const Pixels wires = view_pixels(input, 400, 400, std::nullopt, state);
  const auto bright = [](const Pixels& pixels) {  // shares of the ground's own colours
    double hits = 0, all = 0;
    test::for_pixels(pixels, {40, 150, 60, 60}, [&](const std::uint8_t* rgb) {
      ++all;
      hits += rgb[0] > 235 && rgb[1] > 235 ? 1 : 0;
    });
    return hits / all;
  };
  EXPECT_GT(bright(wires), bright(faces) + 0.2);
}

TEST(Notice, APictureOfATraceWithoutItsMeshSaysSo) {
  ViewInput input = test::torus_rub(0.3);
  input.world = nullptr;
  const Pixels without = view_pixels(input, 640, 480, std::nullopt, {});
  input.notice = "The parts are not shown: parts/torus.stl: does not exist";
  const Pixels with = view_pixels(input, 640, 480, std::nullopt, {});
  const Box scene = layout_for(640, 480, true, true).scene;
  const Colour paper{255, 244, 214};
  EXPECT_LT(test::share_of(without, scene, paper), 0.001);
  EXPECT_GT(test::share_of(with, scene, paper), 0.02);
}

ViewInput named_input(const std::string& file, const std::string& recording) {
  ViewInput input;
  input.title = "a/b";
  input.file = file;
  input.recording = recording;
  return input;
}

TEST(Screenshot, GoesBesideTheRecordingElseHereAndOverwritesNothing) {
  const auto folder = test::scratch_dir();
  const std::string run = (folder / "run.h5").string();
  EXPECT_EQ(next_screenshot_name(named_input(run, run)), (folder / "run-view-001.png").string());
  EXPECT_EQ(next_screenshot_name(named_input("parts/knob.stl", run)),
            (folder / "knob-view-001.png").string());
  std::ofstream(folder / "run-view-001.png") << "mine";
  std::filesystem::create_symlink("nowhere", folder / "run-view-002.png");
  EXPECT_EQ(next_screenshot_name(named_input(run, run)), (folder / "run-view-003.png").string());
  EXPECT_EQ(next_screenshot_name(named_input("parts/knob.stl", "")), "knob-view-001.png")
      << "not among the parts";
  EXPECT_EQ(next_screenshot_name(named_input("-", "-")), "a-b-view-001.png");
}

}  // namespace
}  // namespace fingerpad::camera_look_test
