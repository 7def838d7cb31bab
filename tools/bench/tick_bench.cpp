// The whole tick, sample to force: contact, friction, frames and stick centre.
//   build/bin/bench_tick --benchmark_out=tick.json --benchmark_out_format=json
// A finger of 7 mm radius, half a millimetre deep, rubs around a sphere of 1 m diameter at 0.5 m/s and 1 kHz
// (coherent), or is put at random places of it (random). Time is the mean of a tick.

#include <benchmark/benchmark.h>

#include <numbers>

#include "base/random_stream.hpp"
#include "meshes.hpp"
#include "touch/touch.hpp"

namespace fingerpad::bench {
namespace {

constexpr double radius_m = 0.5, finger_m = 0.007, depth_m = 0.0005;

std::shared_ptr<const World> sphere_world(int subdivisions) {
  auto world = std::make_shared<World>();
  Surface surface;
  surface.part =
      std::make_shared<const Part>(make_part(icosphere(subdivisions), 30 * std::numbers::pi / 180));
  surface.tree = std::make_shared<const TriangleTree>(surface.part);
  surface.tree->prepare_curved();
  world->surfaces.push_back(std::move(surface));
  return world;
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
  benchmark::Initialize(&argc, argv);
  fingerpad::bench::add_all();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
