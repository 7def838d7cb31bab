// The whole tick, sample to force: contact, friction, frames and stick centre.
//   build/bin/bench_tick --benchmark_out=tick.json --benchmark_out_format=json
// A finger of 7 mm radius, half a millimetre deep, rubs around a sphere of 1 m diameter at 0.5 m/s and 1 kHz
// (coherent), or is put at random places of it (random). Time is the mean of a tick.
//
// MESH/METHOD/NORMALS/FINGER/LAW, at a finger's pace: a point or a ball of 7 mm radius half a millimetre deep
// at 0.1 m/s and 1 kHz, some thousand ticks, in turn with as many bare closest-point queries of the tree
// along the same path; more_ns is the median of what a tick takes longer, in thread time, so that it holds on
// a busy machine too (query_ns and tick_ns: the medians of each).
//   build/bin/bench_tick --benchmark_filter='/(proxy|closest-point)/'

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <numbers>

#include "base/random_stream.hpp"
#include "contact/contact_method_table.hpp"
#include "contact/triangle_tree.hpp"
#include "meshes.hpp"
#include "query_paths.hpp"
#include "scene/scene.hpp"
#include "touch/touch.hpp"

namespace fingerpad::bench {
namespace {

constexpr double radius_m = 0.5, finger_m = 0.007, depth_m = 0.0005;

std::shared_ptr<const World> world_of(const TriangleSoup& soup) {
  auto world = std::make_shared<World>();
  Surface surface;
  surface.part = std::make_shared<const Part>(make_part(soup, 30 * std::numbers::pi / 180));
  surface.tree = std::make_shared<const TriangleTree>(surface.part);
  surface.tree->prepare_curved();
  world->surfaces.push_back(std::move(surface));
  return world;
}

std::shared_ptr<const World> sphere_world(int subdivisions) {
  return world_of(icosphere(subdivisions));
}

std::vector<FingerSample> rub(bool coherent, int count) {
  RandomStream random(4);
  std::vector<FingerSample> samples(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double around = 1e-3 * k, up = 0.5 * std::sin(1e-4 * k);
    const Vec3 towards =
        coherent ? Vec3(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up))
                 : Vec3(random.normal(), random.normal(), random.normal()).normalized();
    samples[static_cast<std::size_t>(k)].t_s = 1e-3 * k;
    samples[static_cast<std::size_t>(k)].p_WQ = (radius_m + finger_m - depth_m) * towards;
  }
  return samples;
}

void tick(benchmark::State& state, const std::shared_ptr<const World>& world, const std::string& law,
          bool coherent, bool vibration, Normals normals) {
  Scene scene;
  scene.contact.normals = normals;
  scene.friction.law = law;
  scene.finger.radius_m = finger_m;
  if (vibration) scene.friction.vibration = VibrationSettings{};
  Touch touch(world, scene);
  const auto samples = rub(coherent, 100000);
  std::size_t k = 0;
  for (auto _ : state) {
    TickRecord record = touch.tick(samples[k]);
    benchmark::DoNotOptimize(record);
    k = k + 1 < samples.size() ? k + 1 : 0;
  }
}

void add(const std::string& name, const std::shared_ptr<const World>& world, const std::string& law,
         bool coherent, bool vibration, Normals normals) {
  benchmark::RegisterBenchmark(
      name.c_str(), [=](benchmark::State& state) { tick(state, world, law, coherent, vibration, normals); });
}

struct Mesh {
  std::string name;
  std::function<std::shared_ptr<const World>()> make;
  std::function<std::vector<Vec3>(int count, double finger_radius_m)> path;
  std::shared_ptr<const World> world{};
};

struct Pairing {
  std::string method;
  Normals normals;
  double finger_radius_m;
  std::string law;
};

/// Time that this thread has run.
double thread_ns() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<Vec3> deep_on_sphere(int count, double finger_radius_m) {
  auto points = coherent_on_sphere(count);
  for (Vec3& p : points) p *= (radius_m + finger_radius_m - depth_m) / p.norm();
  return points;
}

std::vector<Vec3> deep_on_plate(int count, double finger_radius_m) {
  auto points = coherent_on_plate(count);
  for (Vec3& p : points) p.z() = 0.005 + finger_radius_m - depth_m;
  return points;
}

/// Chunks of ticks and of bare queries in turn.
void tick_beside_query(benchmark::State& state, Mesh& mesh, const Pairing& pairing) {
  constexpr int chunk = 1000, count = 100 * chunk;
  if (!mesh.world) mesh.world = mesh.make();
  Scene scene;
  scene.contact.method = pairing.method;
  scene.contact.normals = pairing.normals;
  scene.contact.automatic_normals = false;
  scene.friction.law = pairing.law;
  scene.finger.radius_m = pairing.finger_radius_m;
  Touch touch(mesh.world, scene);
  const Surface& surface = mesh.world->surfaces[0];
  const auto points = mesh.path(count, pairing.finger_radius_m);
  std::vector<double> query, whole, more;
  int at = 0, seed = -1;
  for (auto _ : state) {
    if (at == 0) touch.reset();
    const double before = thread_ns();
    for (int k = at; k < at + chunk; ++k) {
      ClosestTriangle closest =
          surface.tree->closest(points[static_cast<std::size_t>(k)] - surface.part->centre_P, seed,
                                std::numeric_limits<double>::infinity());
      benchmark::DoNotOptimize(closest);
      seed = closest.triangle;
    }
    const double between = thread_ns();
    for (int k = at; k < at + chunk; ++k) {
      FingerSample sample;
      sample.t_s = 1e-3 * k;
      sample.p_WQ = points[static_cast<std::size_t>(k)];
      TickRecord record = touch.tick(sample);
      benchmark::DoNotOptimize(record);
    }
    query.push_back((between - before) / chunk);
    whole.push_back((thread_ns() - between) / chunk);
    more.push_back(whole.back() - query.back());
    at = (at + chunk) % count;
  }
  state.counters["query_ns"] = median(query);
  state.counters["tick_ns"] = median(whole);
  state.counters["more_ns"] = median(more);
}

void add_pairs(Mesh& mesh) {
  for (const ContactMethodEntry& method : contact_method_table()) {
    for (const Normals normals : normals_table()) {
      for (const double finger_radius_m : {0.0, finger_m}) {
        for (const char* law : {"none", "finger-pad"}) {
          const Pairing pairing{std::string(method.name), normals, finger_radius_m, law};
          const std::string name = mesh.name + "/" + pairing.method + "/" + std::string(normals->name) + "/" +
                                   (finger_radius_m > 0 ? "ball" : "point") + "/" + law;
          benchmark::RegisterBenchmark(name.c_str(), [&mesh, pairing](benchmark::State& state) {
            tick_beside_query(state, mesh, pairing);
          })->Iterations(200);
        }
      }
    }
  }
}

void add_all() {
  auto plane = std::make_shared<World>();
  plane->surfaces.emplace_back();
  plane->surfaces[0].plane_normal_W = Vec3::UnitX();
  plane->surfaces[0].plane_point_W =
      Vec3(10, 0, 0);  // all samples are deep inside: the plane's cheapest case
  for (const char* law : {"none", "finger-pad"})
    add(std::string("plane/") + law, plane, law, true, false, Normals::smooth);
  for (const int subdivisions : {5, 7}) {
    const auto world = sphere_world(subdivisions);
    const std::string size = subdivisions == 5 ? "20k" : "328k";
    for (const char* law : {"none", "coulomb", "stick-slip", "finger-pad"}) {
      add("sphere_" + size + "/coherent/" + law, world, law, true, false, Normals::smooth);
    }
    add("sphere_" + size + "/coherent/finger-pad+vibration", world, "finger-pad", true, true,
        Normals::smooth);
    add("sphere_" + size + "/random/finger-pad", world, "finger-pad", false, false, Normals::smooth);
    add("sphere_" + size + "/coherent/none/facet", world, "none", true, false, Normals::facet);
    add("sphere_" + size + "/coherent/none/smooth", world, "none", true, false, Normals::smooth);
    add("sphere_" + size + "/coherent/none/curved", world, "none", true, false, Normals::curved);
    add("sphere_" + size + "/coherent/finger-pad/curved", world, "finger-pad", true, false, Normals::curved);
  }
}

}  // namespace
}  // namespace fingerpad::bench

int main(int argc, char** argv) {
  using namespace fingerpad::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  add_all();
  std::vector<Mesh> meshes = {
      {"sphere_20k", [] { return sphere_world(5); }, deep_on_sphere},
      {"sphere_328k", [] { return sphere_world(7); }, deep_on_sphere},
      {"sphere_1311k", [] { return sphere_world(8); }, deep_on_sphere},
      {"drilled_plate", [] { return world_of(drilled_plate()); }, deep_on_plate},
  };
  for (Mesh& mesh : meshes) add_pairs(mesh);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
