// Frames a second of the window's stage on a screen that nobody sees, drawn by the processor: a part is
// touched while the view is still and while it turns, in a live touch and in a trace that plays. usage:
// bench_frames [--live] [--seconds S] [--size WxH] [--unit U] MESH...

#include <fmt/format.h>
#include <sys/resource.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "base/unit.hpp"
#include "part/part.hpp"
#include "scene/scene_file.hpp"
#include "touch/world.hpp"
#include "view/drawing_threads.hpp"
#include "view/screen.hpp"
#include "view/stage_vtk.hpp"
#include "view/touch_chart.hpp"

namespace fingerpad::bench {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Settings {
  double seconds = 3;
  int width = 1280, height = 800;
  double metres_per_unit = 1e-3;
  bool live_alone = false;  ///< a live touch as it is, and nothing to compare it with
  std::vector<std::string> meshes;
};

ViewInput mesh_input(const std::string& path, double metres_per_unit) {
  ViewInput input;
  input.title = std::filesystem::path(path).filename().string();
  input.scene = scene_of_mesh(path, metres_per_unit);
  input.scene->contact.method = "closest-point";
  input.world = load_world(*input.scene, {});
  return input;
}

/// A finger that goes round on what is seen of the part, a turn in four seconds, with 1000 ticks each: 0.1 s
/// of stick, 0.1 s of slip.
std::vector<TickRecord> rows_on_what_is_seen(const ViewInput& input, int width, int height) {
  Stage stage(input, width, height, true, false);
  const Box& scene = stage.layout().scene;
  std::vector<TickRecord> rows;
  for (int i = 0; i < 4000; ++i) {
    const double turn = 2 * 3.14159265358979 * i / 4000;
    const auto [near, far] = stage.line_of_sight(scene.centre().x() + 0.15 * scene.width * std::cos(turn),
                                                 scene.centre().y() + 0.15 * scene.height * std::sin(turn));
    const auto hit = stage.world().first_hit(near, far);
    if (!hit) continue;
    TickRecord row;
    row.t_s = 1e-3 * static_cast<double>(rows.size());
    row.phase = i / 100 % 2 == 0 ? Phase::stick : Phase::slip;
    row.contact_W = hit->point_W;
    row.normal_W = hit->normal_W;
    row.p_WQ = hit->point_W - 1e-4 * hit->normal_W;
    row.depth_m = 1e-4;
    row.normal_force_n = 1 + 0.2 * std::sin(7 * turn);
    const Vec3 along = hit->normal_W.unitOrthogonal();
    row.friction_W_n = 0.2 * along * std::sin(40 * turn);
    row.force_W_n = row.normal_force_n * row.normal_W + row.friction_W_n;
    row.mu = row.friction_W_n.norm() / row.normal_force_n;
    row.inclination_rad = 0.8;
    row.surface = hit->surface;
    if (row.phase == Phase::stick) row.stick_centre_W = row.contact_W - 1e-4 * along;
    rows.push_back(row);
  }
  return rows;
}

/// What a frame costs: by the clock, and of all the processor's cores together.
struct Pace {
  double frames_per_s = 0, processor_ms = 0;
};

double processor_s() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

template <typename Frame>
Pace pace(double seconds, Frame frame) {
  // What a window makes of its first frames is not asked for.
  for (const auto start = Clock::now(); since(start) < 1.5;) frame(since(start));
  const auto start = Clock::now();
  const double processor_before_s = processor_s();
  int frames = 0;
  for (; since(start) < seconds || frames < 3; ++frames) frame(since(start));
  return {frames / since(start), 1e3 * (processor_s() - processor_before_s) / frames};
}

/// A window's stage, and what its window does with it for each frame.
class Window {
 public:
  Window(const ViewInput& input, const std::vector<TickRecord>& rows, bool live, const Settings& settings,
         bool keep)
      : rows_(rows),
        live_(live),
        levels_(touch_levels(input)),
        stage_(input, settings.width, settings.height, true, !live) {
    stage_.set_keeping(keep);
    stage_.set_pace(keep ? Stage::Pace::smooth : Stage::Pace::smooth_edges_only);
    if (!live) stage_.show_chart(touch_chart(rows, Vec3::UnitX(), levels_));
  }

  vtkCamera* camera() { return stage_.scene()->GetActiveCamera(); }

  void frame(double t_s) {
    const auto k = static_cast<std::size_t>(1e3 * t_s) % rows_.size();
    stage_.show(rows_[k], 0.1);
    stage_.words().hint = fmt::format("press {:.2f} N (pressing)   h help", rows_[k].normal_force_n);
    if (live_ && std::abs(t_s - chart_at_s_) > live_chart_period_s) show_last_seconds(t_s, k);
    stage_.render();
  }

 private:
  void show_last_seconds(double t_s, std::size_t k) {
    chart_at_s_ = t_s;
    std::vector<TickRecord> last(rows_.begin() + static_cast<long>(k), rows_.end());
    last.insert(last.end(), rows_.begin(), rows_.begin() + static_cast<long>(k));
    for (std::size_t i = 0; i < last.size(); ++i) last[i].t_s = t_s - 4 + 1e-3 * static_cast<double>(i);
    stage_.show_chart(live_chart(last, levels_));
    stage_.words().readings = {{"median tick", "8.3 us"}, {"late ticks", fmt::format("{}", k)}};
    stage_.words().tick_bars = {{0.1, 1, 0.4}, "0.5 us", "30 us"};
  }

  const std::vector<TickRecord>& rows_;
  bool live_;
  TouchLevels levels_;
  Stage stage_;
  double chart_at_s_ = -1;
};

void measure(const ViewInput& input, const std::vector<TickRecord>& rows, bool live, bool keep,
             const Settings& settings) {
  const auto start = Clock::now();
  const DrawingThreads drawing;
  Window window(input, rows, live, settings, keep);
  window.frame(0);
  if (live) drawing.stand_back();  // as a touch's do, for ever: hence a thread of its own
  const double first_s = since(start);
  const Pace still = pace(settings.seconds, [&](double t_s) { window.frame(t_s); });
  const Pace turning = pace(settings.seconds, [&](double t_s) {
    window.camera()->Azimuth(2);
    window.frame(t_s);
  });
  fmt::print("| {} | {} | {} | {:.2f} | {:.1f} ({:.0f}) | {:.1f} ({:.0f}) |\n",
             input.world->surfaces[0].part->triangle_count(), live ? "touch" : "trace",
             keep ? "as it is" : "all anew", first_s, still.frames_per_s, still.processor_ms,
             turning.frames_per_s, turning.processor_ms);
  std::fflush(stdout);
}

void measure_mesh(const std::string& path, const Settings& settings) {
  const auto start = Clock::now();
  ViewInput input = mesh_input(path, settings.metres_per_unit);
  fmt::print(stderr, "{}: loaded in {:.2f} s\n", input.title, since(start));
  const std::vector<TickRecord> rows = rows_on_what_is_seen(input, settings.width, settings.height);
  for (const bool live : {true, false}) {
    input.rows = live ? std::vector<TickRecord>{} : rows;
    for (const bool keep : {false, true}) {
      if ((keep && live) || !settings.live_alone)
        std::thread([&] { measure(input, rows, live, keep, settings); }).join();
    }
  }
}

Settings read_settings(int argc, char** argv) {
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const auto next = [&] { return i + 1 < argc ? argv[++i] : ""; };
    if (std::strcmp(argv[i], "--seconds") == 0) {
      settings.seconds = std::atof(next());
    } else if (std::strcmp(argv[i], "--size") == 0) {
      std::sscanf(next(), "%5dx%5d", &settings.width, &settings.height);
    } else if (std::strcmp(argv[i], "--live") == 0) {
      settings.live_alone = true;
    } else if (std::strcmp(argv[i], "--unit") == 0) {
      settings.metres_per_unit = metres_per_unit(next()).value();
    } else {
      settings.meshes.emplace_back(argv[i]);
    }
  }
  return settings;
}

}  // namespace
}  // namespace fingerpad::bench

int main(int argc, char** argv) {
  using namespace fingerpad;
  try {
    const bench::Settings settings = bench::read_settings(argc, argv);
    const VirtualScreen screen;
    fmt::print(
        "| triangles | window | drawn | first frame, s | frames a second, still (ms of processor) | turning "
        "|\n");
    fmt::print("|---|---|---|---|---|---|\n");
    for (const std::string& mesh : settings.meshes) bench::measure_mesh(mesh, settings);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_frames: error: {}\n", error.what());
    return 1;
  }
}
