// Frames a second of the window's stage on a screen that nobody sees, drawn by the processor: a part is
// touched while the view is still and while it turns, in a live touch and in a trace that plays. usage:
// bench_frames [--seconds S] [--size WxH] [--unit U] MESH...

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "base/unit.hpp"
#include "part/part.hpp"
#include "scene/scene_file.hpp"
#include "touch/world.hpp"
#include "view/screen.hpp"
#include "view/stage_vtk.hpp"
#include "view/touch_window.hpp"
#include "view/window.hpp"

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

/// As many turns as it takes.
std::vector<TickRecord> repeated(const std::vector<TickRecord>& rows, double seconds) {
  std::vector<TickRecord> all;
  for (std::size_t i = 0; static_cast<double>(i) < 1e3 * seconds; ++i) {
    all.push_back(rows[i % rows.size()]);
    all.back().t_s = 1e-3 * static_cast<double>(i);
  }
  return all;
}

struct Paces {
  double first_s = 0, still_hz = 0, turning_hz = 0;
};

constexpr double settle_s = 1.5;  // what a window makes of its first frames is not asked for

/// What a window is told: nothing for a while, then a drag beside the part, to and fro, which turns the view.
std::vector<WindowEvent> to_and_fro(const Settings& settings) {
  using Kind = WindowEvent::Kind;
  const double begin_s = settle_s + settings.seconds, end_s = begin_s + settle_s + settings.seconds;
  const int y = settings.height / 10;
  std::vector<WindowEvent> events = {{begin_s, Kind::press, "", 20, y}};
  for (double at_s = begin_s; at_s < end_s; at_s += 0.016) {
    const double turn = 3 * (at_s - begin_s);
    events.push_back({at_s, Kind::move, "", static_cast<int>(120 - 100 * std::cos(turn)), y});
  }
  events.push_back({end_s, Kind::release, "", 20, y});
  events.push_back({end_s, Kind::key, "q"});
  return events;
}

/// Frames between two moments.
struct Count {
  double from_s, to_s;
  long first = -1, last = -1;
  double first_s = 0, last_s = 0;
  void see(const WindowReport& report) {
    if (report.since_open_s < from_s || report.since_open_s > to_s) return;
    if (first < 0) first = report.frames, first_s = report.since_open_s;
    last = report.frames, last_s = report.since_open_s;
  }
  double hz() const { return last_s > first_s ? static_cast<double>(last - first) / (last_s - first_s) : 0; }
};

template <typename Run>
Paces measure(const Settings& settings, std::vector<WindowEvent> events, Run run) {
  Paces paces;
  WindowOptions options;
  options.width = settings.width;
  options.height = settings.height;
  options.events = std::move(events);
  Count still{settle_s, settle_s + settings.seconds}, turning = still;
  turning.from_s = still.to_s + settle_s;
  turning.to_s = turning.from_s + settings.seconds;
  const auto start = Clock::now();
  options.on_frame = [&](const WindowReport& report) {
    if (paces.first_s == 0) paces.first_s = since(start);
    still.see(report);
    turning.see(report);
  };
  run(options);
  paces.still_hz = still.hz();
  paces.turning_hz = turning.hz();
  return paces;
}

Paces measure_live(const ViewInput& input, const std::vector<TickRecord>& rows, const Settings& settings) {
  const auto start = Clock::now();
  const auto row_now = [&](double t_s) {
    TickRecord row = rows[static_cast<std::size_t>(1e3 * t_s) % rows.size()];
    row.t_s = t_s;
    return row;
  };
  TouchWindowInput touch;
  touch.view = input;
  touch.set_target = [](const FingerSample&) {};
  touch.latest = [&] { return row_now(4 + since(start)); };
  touch.recent = [&](double seconds) {
    std::vector<TickRecord> last;
    const double now_s = 4 + since(start);
    for (double t_s = now_s - seconds; t_s <= now_s; t_s += 1e-3) last.push_back(row_now(t_s));
    return last;
  };
  touch.timing = [] { return ServoTiming{}; };
  return measure(settings, to_and_fro(settings),
                 [&](const WindowOptions& options) { run_touch_window(touch, options); });
}

Paces measure_trace(const ViewInput& input, const Settings& settings) {
  std::vector<WindowEvent> events = to_and_fro(settings);
  events.insert(events.begin(), {0, WindowEvent::Kind::key, "space"});
  return measure(settings, std::move(events),
                 [&](const WindowOptions& options) { run_view_window(input, options); });
}

void measure_mesh(const std::string& path, const Settings& settings) {
  const auto start = Clock::now();
  ViewInput input = mesh_input(path, settings.metres_per_unit);
  const double load_s = since(start);
  const std::vector<TickRecord> rows = rows_on_what_is_seen(input, settings.width, settings.height);
  const int triangles = input.world->surfaces[0].part->triangle_count();
  fmt::print("{}: {} triangles, loaded in {:.2f} s\n", input.title, triangles, load_s);
  for (const bool live : {true, false}) {
    if (!live) input.rows = repeated(rows, 4 * (settle_s + settings.seconds));
    const Paces paces = live ? measure_live(input, rows, settings) : measure_trace(input, settings);
    fmt::print("| {} | first frame {:.2f} s | still {:.1f} /s | turning {:.1f} /s |\n",
               live ? "live" : "trace", paces.first_s, paces.still_hz, paces.turning_hz);
    std::fflush(stdout);
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
    for (const std::string& mesh : settings.meshes) bench::measure_mesh(mesh, settings);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_frames: error: {}\n", error.what());
    return 1;
  }
}
