// The program's own windows, with a mouse and keys that X itself moves (xdotool, by XTEST): what a person
// does, from opening to closing. Skipped where no X server can be started.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/error.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"
#include "trace/trace.hpp"
#include "view/close_request.hpp"
#include "view/layout.hpp"
#include "view/overlay.hpp"
#include "view/pixel_statistics.hpp"
#include "view/screen.hpp"
#include "view/side_panels.hpp"
#include "view/xdnd_source.hpp"

namespace fingerpad::real_window_test {
namespace {

namespace fs = std::filesystem;
constexpr int width = 900, height = 600;

Pixels read_png(const fs::path& path) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const vtkImageData* image = reader->GetOutput();
  const int* size = reader->GetOutput()->GetDimensions();
  Pixels pixels{size[0], size[1], {}};
  const auto* bytes = static_cast<const std::uint8_t*>(const_cast<vtkImageData*>(image)->GetScalarPointer());
  if (bytes != nullptr) pixels.rgb.assign(bytes, bytes + std::size_t{3} * size[0] * size[1]);
  return pixels;
}

/// A torus to be touched, on a table.
fs::path workshop() {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "torus.stl", test::binary_stl(test::torus_soup(50, 20, 48, 24)));
  test::write_file(folder, "ring.toml",
                   "[[part]]\nmesh = \"torus.stl\"\n[contact]\nmethod = \"proxy\"\n"
                   "[friction]\nv_min_m_per_s = 0.02\n[finger]\nradius_m = 0.004\n");
  return folder;
}

/// What the scripts of the tests call: `window`, `at X Y` (from the lower left, as the project counts),
/// `drag X Y SECONDS`, `wait_for FILE`.
std::string hands(const VirtualScreen& screen) {
  return "export DISPLAY=" + screen.display() +
         "\nwindow() { for i in $(seq 200); do w=$(xdotool search --name ' - fingerpad' 2>/dev/null | head "
         "-1); "
         "[ -n \"$w\" ] && return 0; sleep 0.05; done; return 1; }\n"
         "at() { xdotool mousemove --window $w $1 $((" +
         std::to_string(height) +
         " - 1 - $2)); }\n"
         "wait_for() { for i in $(seq 200); do [ -s \"$1\" ] && return 0; sleep 0.05; done; return 1; }\n"
         "P='" +
         test::program().string() + "'\n";
}

std::string at(double x, double y) {
  return "at " + std::to_string(static_cast<int>(x)) + " " + std::to_string(static_cast<int>(y)) + "\n";
}

/// The screen; null, with the reason said, where there is none.
std::unique_ptr<VirtualScreen> screen_or_why(std::string& why) {
  try {
    return std::make_unique<VirtualScreen>();
  } catch (const Error& error) {
    why = error.what();
    return nullptr;
  }
}

TEST(RealWindow, IsTouchedChangedPhotographedAndItsTraceScrubbed) {
  std::string why;
  const auto screen = screen_or_why(why);
  if (!screen) GTEST_SKIP() << "no X server can be started: " << why;
  const fs::path folder = workshop();
  const Layout layout = layout_for(width, height, true, false);
  SidePanels panels;
  panels.show({"material", "", std::vector<PanelRow>(9)});
  const Box panel = panels.boxes(layout).front();
  const double row_y = panel.top() - layout.em * (2.1 + 1.75 * 1.5);  // mu static

  // The near side of the ring, slowly and then fast.
  const double y = layout.scene.bottom + 0.25 * layout.scene.height, x = layout.scene.centre().x();
  std::string script =
      hands(*screen) +
      "$P touch ring.toml --size 900x600 --record run.h5 >touch.log 2>&1 &\np=$!\nwindow || exit 9\n" +
      at(x - 30, y) + "xdotool mousedown 1\nsleep 0.4\n";
  for (int i = 0; i < 20; ++i) script += at(x - 30 + i, y) + "sleep 0.03\n";
  for (int i = 0; i < 14; ++i) script += at(x - 10 + (i % 2 == 0 ? 40 : -40), y) + "sleep 0.1\n";
  script += "xdotool key m\nsleep 0.2\nxdotool mouseup 1\n" + at(panel.right() - 1.2 * layout.em, row_y) +
            "xdotool click 1\nsleep 0.2\nxdotool key s\nwait_for ring-view-001.png || exit 8\n"
            "xdotool key q\nwait $p\n";
  const auto touched = test::shell(script, folder);
  ASSERT_EQ(touched.exit_code, 0) << touched.err << test::bytes_of(folder / "touch.log");

  const Trace trace = read_trace((folder / "run.h5").string());
  EXPECT_TRUE(trace.complete);
  const auto ticks_in = [&](Phase phase) {
    return std::count_if(trace.rows.begin(), trace.rows.end(),
                         [phase](const TickRecord& row) { return row.phase == phase; });
  };
  EXPECT_GT(ticks_in(Phase::stick), 50);
  EXPECT_GT(ticks_in(Phase::slip), 50) << "of some hundreds; a busy machine moves the pointer in jumps";
  ASSERT_EQ(trace.info.changes.size(), 1u);
  EXPECT_EQ(trace.info.changes[0].key, "part.0.mu_static");
  EXPECT_EQ(trace.info.changes[0].value, "0.35");

  const Pixels live = read_png(folder / "ring-view-001.png");
  ASSERT_EQ(live.width, width);
  ASSERT_EQ(live.height, height);
  EXPECT_GT(test::share_drawn(live, layout.scene), 0.2) << "the part";
  EXPECT_GT(test::share_drawn(live, layout.charts), 0.03) << "curves";
  EXPECT_GT(test::share_of(live, panel, colours::white), 0.5) << "the panel's paper";
  EXPECT_GT(test::share_of(live, panel, colours::pale_grey), 0.02) << "its buttons";

  // Its trace, scrubbed by the time line.
  const Layout with_line = layout_for(width, height, true, true);
  const Box slider = time_slider(with_line);
  const auto shares = [&](double share) {
    return at(slider.left + share * slider.width, slider.centre().y());
  };
  const auto viewed = test::shell(
      hands(*screen) +
          "$P view run.h5 --size 900x600 --camera top >view.log 2>&1 &\np=$!\nwindow || exit 9\n" +
          shares(0.1) + "xdotool mousedown 1\n" + shares(0.4) + "sleep 0.1\n" + shares(0.8) +
          "sleep 0.1\nxdotool mouseup 1\nsleep 0.1\nxdotool key s\nwait_for run-view-001.png || exit 8\n"
          "xdotool getwindowname $w\nxdotool key q\nwait $p\n",
      folder);
  ASSERT_EQ(viewed.exit_code, 0) << viewed.err << test::bytes_of(folder / "view.log");
  EXPECT_THAT(viewed.out,
              testing::StartsWith("run.h5: torus.stl, finger-pad, mu 0.3/0.2, proxy smooth - fingerpad"));
  const Pixels scrubbed = read_png(folder / "run-view-001.png");
  const double y_line = slider.centre().y();
  const auto blue_between = [&](double from, double to) {
    const Box line{slider.left + from * slider.width, y_line - 1, (to - from) * slider.width, 2};
    return test::share_of(scrubbed, line, colours::blue);
  };
  EXPECT_GT(blue_between(0.05, 0.75), 0.95);
  EXPECT_LT(blue_between(0.85, 0.98), 0.05);

  // The picture of the same moment, made without a window: another way to the same pixels, edges apart, which
  // a slow window does not smooth.
  const double share = (std::floor(slider.left + 0.8 * slider.width) - slider.left) / slider.width;
  const double t_s = share * trace.rows.back().t_s;
  const auto pictured = test::fingerpad(
      "view run.h5 --png same.png --size 900x600 --camera top --at " + std::to_string(t_s), folder);
  ASSERT_EQ(pictured.exit_code, 0) << pictured.err;
  const auto earlier =
      test::fingerpad("view run.h5 --png other.png --size 900x600 --camera top --at 0.2", folder);
  ASSERT_EQ(earlier.exit_code, 0) << earlier.err;
  const Pixels same = read_png(folder / "same.png"), other = read_png(folder / "other.png");
  ASSERT_EQ(same.rgb.size(), scrubbed.rgb.size());
  double most_of_another = 0;
  for (const Box& box : {with_line.scene, with_line.charts, with_line.timeline}) {
    EXPECT_LT(test::share_that_differs(scrubbed, same, box), 0.01);
    most_of_another = std::max(most_of_another, test::share_that_differs(scrubbed, other, box));
  }
  EXPECT_GT(most_of_another, 0.05) << "another moment is told apart: its time line at least";
}

TEST(RealWindow, ShowsAFileThatIsDroppedOntoItAndSaysWhyItCannotShowAnother) {
  std::string why;
  const auto screen = screen_or_why(why);
  if (!screen) GTEST_SKIP() << "no X server can be started: " << why;
  const fs::path folder = workshop();
  test::write_file(folder, "notes.stl", "no mesh");
  const auto opened = test::shell(
      hands(*screen) + "$P view ring.toml --size 600x400 >view.log 2>&1 &\nwindow || exit 9\necho $w\n",
      folder);
  ASSERT_EQ(opened.exit_code, 0) << test::bytes_of(folder / "view.log");
  const unsigned long window = std::stoul(opened.out);
  EXPECT_EQ(test::drop_file(screen->display(), window, (folder / "notes.stl").string()), "");
  EXPECT_EQ(test::drop_file(screen->display(), window, (folder / "torus.stl").string()), "");
  const auto shown =
      test::shell(hands(*screen) +
                      "for i in $(seq 200); do n=$(xdotool search --name '^torus.stl' getwindowname "
                      "2>/dev/null) && break; sleep 0.05; done\necho \"$n\"\nwindow\n" +
                      "xdotool mousemove --window $w 100 100 key q\n",
                  folder);
  EXPECT_THAT(shown.out, testing::StartsWith("torus.stl - fingerpad"));
}

/// Between two frames as well as when one is due.
TEST(RealWindow, EndsWithItsTraceWholeWhereItsFrameIsClosed) {
  std::string why;
  const auto screen = screen_or_why(why);
  if (!screen) GTEST_SKIP() << "no X server can be started: " << why;
  const fs::path folder = workshop();
  for (int time = 0; time < 4; ++time) {
    const std::string trace = "run" + std::to_string(time) + ".csv";
    const auto opened = test::shell(hands(*screen) + "$P touch ring.toml --size 600x400 --record " + trace +
                                        " >touch.log 2>&1 &\necho $!\nwindow || exit 9\necho $w\n"
                                        "xdotool mousemove --window $w 300 250 mousedown 1\nsleep 0.3\n",
                                    folder);
    ASSERT_EQ(opened.exit_code, 0) << test::bytes_of(folder / "touch.log");
    std::istringstream told(opened.out);
    unsigned long process = 0, window = 0;
    ASSERT_TRUE(told >> process >> window) << opened.out;
    ASSERT_EQ(test::ask_to_close(screen->display(), window), "");
    const std::string status = "/proc/" + std::to_string(process) + "/status";
    const auto ended = test::shell(hands(*screen) + "for i in $(seq 200); do grep -q '^State:.*[RSDT] ' " +
                                       status + " 2>/dev/null || break; sleep 0.05; done\n" +
                                       "grep -q '^State:.*[RSDT] ' " + status + " 2>/dev/null && { kill -9 " +
                                       std::to_string(process) + "; exit 1; }\nxdotool mouseup 1\n" +
                                       "for i in $(seq 200); do xdotool search --name ' - fingerpad' "
                                       ">/dev/null 2>&1 || exit 0; sleep 0.05; done\nexit 2\n",
                                   folder);
    ASSERT_EQ(ended.exit_code, 0) << "at closing " << time << ": 1, it went on; 2, a window stayed";
    EXPECT_GT(read_trace((folder / trace).string()).rows.size(), 100u);
  }
}

/// For scripts: how far the servo's thread of the process $p stands back, and the one that draws its window.
constexpr const char* nice_words = R"(
nice_words() {
  for t in /proc/$p/task/*; do
    read -r name <$t/comm
    rest=$(sed 's/.*) //' $t/stat)
    set -- $rest
    [ "$name" = fingerpad-servo ] && echo "servo ${17}"
    [ "${t##*/}" = $p ] && echo "window ${17}"
  done
}
)";

TEST(RealWindow, TheServoDoesNotStandBackWithTheWindowAfterADrop) {
  std::string why;
  const auto screen = screen_or_why(why);
  if (!screen) GTEST_SKIP() << "no X server can be started: " << why;
  const fs::path folder = workshop();
  const auto opened = test::shell(hands(*screen) +
                                      "$P touch ring.toml --size 600x400 >touch.log 2>&1 &\necho $!\n"
                                      "window || exit 9\necho $w\nawk '{ print $19 }' /proc/self/stat\n",
                                  folder);
  ASSERT_EQ(opened.exit_code, 0) << test::bytes_of(folder / "touch.log");
  std::istringstream told(opened.out);
  unsigned long process = 0, window = 0;
  int usual_nice = 0;
  ASSERT_TRUE(told >> process >> window >> usual_nice) << opened.out;
  ASSERT_EQ(test::drop_file(screen->display(), window, (folder / "torus.stl").string()), "");
  const auto after =
      test::shell(hands(*screen) + nice_words + "p=" + std::to_string(process) +
                      "\nfor i in $(seq 200); do xdotool search --name '^torus.stl' >/dev/null 2>&1 && "
                      "break; sleep 0.05; "
                      "done\nnice_words\nwindow\nxdotool mousemove --window $w 100 100 key q\n",
                  folder);
  const std::string servo = "servo " + std::to_string(usual_nice) + "\n";
  const std::string drawing = "window " + std::to_string(std::min(19, std::max(usual_nice, 10))) + "\n";
  EXPECT_THAT(after.out, testing::HasSubstr(servo));
  EXPECT_THAT(after.out, testing::HasSubstr(drawing));
}

TEST(RealWindow, GoesOnWithAMeshThatIsDroppedOntoALiveTouchUnlessThatIsRecorded) {
  std::string why;
  const auto screen = screen_or_why(why);
  if (!screen) GTEST_SKIP() << "no X server can be started: " << why;
  const fs::path folder = workshop();
  test::write_file(folder, "notes.stl", "no mesh");
  test::write_file(folder, "cube.stl", test::binary_stl(test::box_soup({20, 20, 20})));
  for (const bool recorded : {false, true}) {
    const auto opened = test::shell(hands(*screen) + "$P touch ring.toml --size 600x400 " +
                                        (recorded ? "--record run.h5 " : "") +
                                        ">touch.log 2>&1 &\nwindow || exit 9\necho $w\n",
                                    folder);
    ASSERT_EQ(opened.exit_code, 0) << test::bytes_of(folder / "touch.log");
    const unsigned long window = std::stoul(opened.out);
    EXPECT_EQ(test::drop_file(screen->display(), window, (folder / "notes.stl").string()), "");
    EXPECT_EQ(test::drop_file(screen->display(), window, (folder / "cube.stl").string()), "");
    const std::string wanted = recorded ? "ring" : "cube.stl";
    const auto shown =
        test::shell(hands(*screen) + "for i in $(seq 200); do n=$(xdotool search --name '^" + wanted +
                        "' getwindowname 2>/dev/null) && break; sleep 0.05; done\necho \"$n\"\nwindow\n" +
                        "xdotool mousemove --window $w 100 100 key q\n"
                        "for i in $(seq 400); do grep -q longest touch.log && ! xdotool search --name ' - "
                        "fingerpad' && break; "
                        "sleep 0.05; done >/dev/null 2>&1\n",
                    folder);
    EXPECT_THAT(shown.out, testing::StartsWith(wanted));
    const std::string log = test::bytes_of(folder / "touch.log");
    const bool twice = log.find("longest") != log.rfind("longest");
    EXPECT_EQ(twice, !recorded) << log;
  }
}

TEST(RealWindow, GoesOnWithAMeshThatIsDroppedOntoATouchThatIsRecordedNoLonger) {
  std::string why;
  const auto screen = screen_or_why(why);
  if (!screen) GTEST_SKIP() << "no X server can be started: " << why;
  const fs::path folder = workshop();
  test::write_file(folder, "cube.stl", test::binary_stl(test::box_soup({20, 20, 20})));
  const auto opened =
      test::shell(hands(*screen) +
                      "mkdir r; { $P touch ring.toml --size 600x400 --record r/run.h5; echo ended $?; } "
                      ">touch.log 2>&1 &\nwindow || exit 9\nrm -r r\nfor i in $(seq 200); do "
                      "grep -q 'recorded no longer' touch.log && break; sleep 0.05; done\necho $w\n",
                  folder);
  ASSERT_EQ(opened.exit_code, 0) << test::bytes_of(folder / "touch.log");
  EXPECT_EQ(test::drop_file(screen->display(), std::stoul(opened.out), (folder / "cube.stl").string()), "");
  const auto shown =
      test::shell(hands(*screen) +
                      "for i in $(seq 200); do n=$(xdotool search --name '^cube.stl' "
                      "getwindowname 2>/dev/null) && break; sleep 0.05; done\necho \"$n\"\nwindow\n"
                      "xdotool mousemove --window $w 100 100 key q\n"
                      "for i in $(seq 400); do grep -q ended touch.log && break; sleep 0.05; done\n",
                  folder);
  EXPECT_THAT(shown.out, testing::StartsWith("cube.stl"));
  EXPECT_THAT(test::bytes_of(folder / "touch.log"), testing::EndsWith("ended 1\n")) << "for what was lost";
}

// Destroyed by another program, and with all of its connection to the server: X ended the program in the
// midst of the touch, and there was no trace.
TEST(RealWindow, ATouchWhoseWindowIsTakenAwayKeepsItsTraceWhole) {
  std::string why;
  const auto screen = screen_or_why(why);
  if (!screen) GTEST_SKIP() << "no X server can be started: " << why;
  const fs::path folder = workshop();
  for (const std::string how : {"windowclose", "windowkill"}) {
    const auto touched = test::shell(hands(*screen) +
                                         "rm -f run.h5\n$P touch ring.toml --size 900x600 --record run.h5 "
                                         ">touch.log 2>&1 &\np=$!\nwindow || exit 9\nsleep 0.3\nxdotool " +
                                         how + " $w\nwait $p\n",
                                     folder);
    EXPECT_EQ(touched.exit_code, 0) << how << touched.err << test::bytes_of(folder / "touch.log");
    ASSERT_TRUE(fs::exists(folder / "run.h5")) << how;
    const Trace trace = read_trace((folder / "run.h5").string());
    EXPECT_TRUE(trace.complete) << how;
    EXPECT_GT(trace.rows.size(), 100u) << how;
  }
}

}  // namespace
}  // namespace fingerpad::real_window_test
