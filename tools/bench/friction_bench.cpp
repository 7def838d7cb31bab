// What a tick of each friction law costs, through the interface that Touch uses.
//   build/bin/bench_friction --benchmark_repetitions=10 --benchmark_out=friction.json
//   --benchmark_out_format=json
// A finger rubs to and fro at 1 kHz in a plane, up to 0.25 m/s: slip, stick at each turn, load and tilt
// changing; the law's state is carried from tick to tick. `none` is the cost of the loop itself; on a shared
// machine the least of the repetitions is the figure to read.

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "friction/law_table.hpp"
#include "friction/slip_vibration.hpp"

namespace fingerpad::bench {
namespace {

constexpr double rate_hz = 1000;

/// What changes from tick to tick.
struct Rub {
  Vec2 step_m;
  double load_n, inclination_rad;
};

std::vector<Rub> rub_of_seconds(double seconds) {
  constexpr double turn = 2 * std::numbers::pi;
  std::vector<Rub> rub(static_cast<std::size_t>(seconds * rate_hz));
  Vec2 last = Vec2::Zero();
  for (std::size_t k = 0; k < rub.size(); ++k) {
    const double t = static_cast<double>(k) / rate_hz;
    const Vec2 at(0.012 * std::sin(turn * 3 * t) + 0.0004 * std::sin(turn * 17.3 * t),
                  0.003 * std::sin(turn * 2.1 * t));
    rub[k] = {at - last, 1.5 + std::sin(turn * 0.7 * t), 0.8 + 0.5 * std::sin(turn * 0.31 * t)};
    last = at;
  }
  return rub;
}

/// Plays the part of Touch on a plane: multiplies the slip force by the vibration.
void run(benchmark::State& state, const FrictionLaw& law, SlipVibration* vibration) {
  const std::vector<Rub> rub = rub_of_seconds(16);
  TangentialMotion motion;
  motion.dt_s = 1 / rate_hz;
  FrictionState memory;
  std::size_t k = 0, stuck = 0, slipped = 0;
  for (auto _ : state) {
    const Rub& now = rub[k];
    motion.step_m = now.step_m;
    motion.velocity_m_per_s = now.step_m * rate_hz;
    motion.normal_force_n = now.load_n;
    motion.inclination_rad = now.inclination_rad;
    Friction answer = law.tick(motion, memory);
    if (answer.phase == Phase::stick) {
      ++stuck;
      if (vibration != nullptr) vibration->rest();
    } else {
      ++slipped;
      if (vibration != nullptr) {
        memory.slip_force_scale = vibration_force_scale(0.05, vibration->next());
        answer.force_n *= memory.slip_force_scale;
      }
    }
    benchmark::DoNotOptimize(answer);
    k = k + 1 < rub.size() ? k + 1 : 0;
  }
  state.counters["slip_share"] = static_cast<double>(slipped) / static_cast<double>(stuck + slipped);
}

void add(const std::string& name, std::string_view law, const LawSettings& settings, bool vibration = false) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    const auto made = find_law(law)->make(settings);
    SlipVibration signal(89, 20, 1 / rate_hz, RandomStream(1));
    run(state, *made, vibration ? &signal : nullptr);
  });
}

void vibration_alone(benchmark::State& state) {
  SlipVibration signal(89, 20, 1 / rate_hz, RandomStream(1));
  for (auto _ : state) {
    double scale = vibration_force_scale(0.05, signal.next());
    benchmark::DoNotOptimize(scale);
  }
}

/// What one call into libm costs here, since a law with an exponential cannot be cheaper.
void libm_exp(benchmark::State& state) {
  double x = 0.1, sum = 0;
  for (auto _ : state) {
    sum += std::exp(-x);
    x = x < 20 ? x + 0.01 : 0.1;
    benchmark::DoNotOptimize(sum);
  }
}

void add_all() {
  for (const LawEntry& law : law_table()) add(std::string(law.name), law.name, {});
  LawSettings settings;
  settings.profile = assumed_profile(0.3, 1000);
  add("finger-pad/profile", "finger-pad", settings);
  settings.numbers["mu_rises_below_n"] = 2;
  add("finger-pad/profile+load", "finger-pad", settings);
  settings.numbers = {{"cubic_share", 0.5}};
  add("finger-pad/profile+cubic", "finger-pad", settings);
  settings.numbers["mu_rises_below_n"] = 2;
  add("finger-pad/profile+load+cubic", "finger-pad", settings);
  settings.numbers.clear();
  settings.remedy = Remedy::implicit;
  add("finger-pad/profile+implicit", "finger-pad", settings);
  settings.remedy = Remedy::none;
  add("finger-pad/profile+vibration", "finger-pad", settings, true);
  settings = {};
  settings.numbers["adhesion_j_per_m2"] = 0.05;
  add("contact-area/adhesion", "contact-area", settings);
  settings.numbers = {{"stick_displacement_m", 1.5e-4}};
  add("max-displacement/smooth", "max-displacement", settings);
  benchmark::RegisterBenchmark("vibration", vibration_alone);
  benchmark::RegisterBenchmark("libm_exp", libm_exp);
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
