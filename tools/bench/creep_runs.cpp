#include "creep_runs.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>

namespace fingerpad::bench {
namespace {

constexpr double settle_s = 1, rise_s = 1, hold_s = 10, last_s = 2;
constexpr double beyond = 1.2, beyond_s = 0.5, slid_m = 0.01;
/// What a position may tremble by where nothing but its last bits moves.
constexpr double roundings = 16 * std::numeric_limits<double>::epsilon();
/// Beside the push, in every program: it takes the ringing out of a block on a spring, to the last bit before
/// the last 2 s. It holds no block: at 1 mm/s it takes 0.01 N.
constexpr double damping_n_s_per_m = 10;

/// The push rises softly, so that no program is started by a jolt.
double risen(double t_s) {
  return t_s < rise_s ? 0.5 - 0.5 * std::cos(std::numbers::pi * t_s / rise_s) : 1;
}

void push(Block& block, double force_n, double damper_n_s_per_m) {
  block.step(force_n - damper_n_s_per_m * block.speed_m_per_s());
}

long steps(double seconds, double rate_hz) {
  return std::lround(seconds * rate_hz);
}

std::unique_ptr<Block> settled(const Program& program, const BlockSetup& setup) {
  std::unique_ptr<Block> block = program.make(setup);
  for (long k = 0; k < steps(settle_s, setup.rate_hz); ++k) block->step(0);
  return block;
}

/// Time that this thread has run.
double thread_ns() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

}  // namespace

HeldPush hold(const Program& program, double share) {
  const BlockSetup setup;
  const auto block = settled(program, setup);
  const double start_m = block->x_m(), full_n = share * setup.limit_n();
  HeldPush held;
  held.share = share;
  const long rise = steps(rise_s, setup.rate_hz), end = rise + steps(hold_s, setup.rate_hz);
  double last_start_m = 0;
  for (long k = 0; k < end; ++k) {
    const double t_s = static_cast<double>(k) / setup.rate_hz;
    if (k == end - steps(last_s, setup.rate_hz)) last_start_m = block->x_m();
    if (k % 50 == 0) {
      held.t_s.push_back(t_s - rise_s);
      held.travelled_m.push_back(block->x_m() - start_m);
    }
    push(*block, full_n * risen(t_s), damping_n_s_per_m);
  }
  const double end_m = block->x_m();
  const double moved_m = end_m - last_start_m;
  held.creep_m_per_s = std::abs(moved_m) > roundings * std::abs(end_m) ? moved_m / last_s : 0;
  for (long k = 0; k < steps(beyond_s, setup.rate_hz); ++k)
    push(*block, beyond * setup.limit_n(), damping_n_s_per_m);
  held.gives_way = block->x_m() - end_m > slid_m;
  return held;
}

StickSlipCycle pull(const Program& program, const PulledBlock& pulled, double rate_hz) {
  const BlockSetup setup{.rate_hz = rate_hz,
                         .mass_kg = pulled.mass_kg,
                         .gravity_m_per_s2 = pulled.normal_n / pulled.mass_kg,
                         .mu_static = pulled.mu_static,
                         .mu_dynamic = pulled.mu_dynamic,
                         .v_min_m_per_s = 0.002,
                         .zero_band_m_per_s = 1e-4,
                         .stick_stiffness_per_m = 500};
  const auto block = settled(program, setup);
  const double start_m = block->x_m();
  std::vector<double> pull_n(static_cast<std::size_t>(steps(30, rate_hz)));
  for (std::size_t k = 0; k < pull_n.size(); ++k) {
    const double far_end_m = pulled.speed_m_per_s * static_cast<double>(k) / rate_hz;
    pull_n[k] = pulled.spring_n_per_m * (far_end_m - (block->x_m() - start_m));
    push(*block, pull_n[k], pulled.damping_n_s_per_m);
  }
  // A tooth of stick-slip falls by more than F_s - F_d; what slides all the time swings by less.
  return cycle_of(pull_n, rate_hz, 2 * (pulled.static_n() - pulled.dynamic_n()));
}

std::vector<double> step_times_ns(const std::vector<Program>& programs) {
  constexpr int rounds = 201, steps_a_round = 200;
  const BlockSetup setup;
  std::vector<std::unique_ptr<Block>> blocks;
  for (const Program& program : programs) blocks.push_back(settled(program, setup));
  std::vector<std::vector<double>> times_ns(blocks.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const double start = thread_ns();
      for (int k = 0; k < steps_a_round; ++k) push(*blocks[i], 0.9 * setup.limit_n(), damping_n_s_per_m);
      times_ns[i].push_back((thread_ns() - start) / steps_a_round);
    }
  }
  std::vector<double> median_ns;
  for (std::vector<double>& times : times_ns) {
    std::nth_element(times.begin(), times.begin() + rounds / 2, times.end());
    median_ns.push_back(times[rounds / 2]);
  }
  return median_ns;
}

}  // namespace fingerpad::bench
