#include "study/battery.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>

#include "friction/law_table.hpp"

namespace fingerpad {
namespace {

constexpr double depth_m = 1e-3;  // 1 N on 1000 N/m
constexpr double turn = 2 * std::numbers::pi;

constexpr std::array<BatteryCase, 6> cases{{
    {"slow-drag", "drag at 0.01 m/s", 0.5, [](double t) { return Vec3(0.01 * t, 0, -depth_m); }},
    {"sine", "10 mm at 3 Hz", 1, [](double t) { return Vec3(0.01 * std::sin(3 * turn * t), 0, -depth_m); }},
    {"reversal", "to and fro at 0.15 m/s, 5.3 times a second", 1,
     [](double t) {
       const double phase = std::fmod(5.3 * t, 1.0);
       return Vec3(0.15 / 5.3 * (phase < 0.5 ? phase : 1 - phase), 0, -depth_m);
     }},
    {"circle", "radius 10 mm at 3 Hz", 1,
     [](double t) { return Vec3(0.01 * std::cos(3 * turn * t), 0.01 * std::sin(3 * turn * t), -depth_m); }},
    {"varying-load", "drag at 0.15 m/s, 1 + 0.8 sin N at 5 Hz", 1,
     [](double t) { return Vec3(0.15 * t, 0, -depth_m * (1 + 0.8 * std::sin(5 * turn * t))); }},
    {"presliding", "0.15 mm at 5 Hz, never breaking away", 1,
     [](double t) { return Vec3(1.5e-4 * std::sin(5 * turn * t), 0, -depth_m); }},
}};

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// What a law is told on a plane, tick by tick, without a touch around it.
std::vector<TangentialMotion> motions_of(const BatteryCase& c, double rate_hz) {
  std::vector<TangentialMotion> motions;
  Vec3 last = c.position_W(0);
  for (long k = 0; k < static_cast<long>(c.seconds * rate_hz); ++k) {
    const Vec3 now = c.position_W(static_cast<double>(k) / rate_hz);
    TangentialMotion m;
    m.dt_s = 1 / rate_hz;
    m.normal_force_n = -1000 * now.z();
    m.step_m = (now - last).head<2>();
    m.velocity_m_per_s = m.step_m * rate_hz;
    m.inclination_rad = std::numbers::pi / 4;
    motions.push_back(m);
    last = now;
  }
  return motions;
}

}  // namespace

std::span<const BatteryCase> battery() noexcept {
  return cases;
}

long BatteryRun::rupture_count() const noexcept {
  return std::accumulate(ruptures.begin(), ruptures.end(), 0L);
}

BatteryRun run_battery(const BatteryCase& c, const std::string& law, double rate_hz, Events events) {
  BenchScene bench(rate_hz, law);
  bench.scene().friction.settings.events = events;
  ClosedLoop loop = bench.loop(c.seconds, c.position_W);
  BatteryRun run;
  run.friction_W_n.resize(3, loop.tick_count());
  TickRecord last;
  for (Eigen::Index k = 0; k < run.friction_W_n.cols(); ++k) {
    const TickRecord record = loop.next();
    run.friction_W_n.col(k) = record.friction_W_n;
    run.ruptures.push_back(record.ruptures);
    run.mean_load_n += record.normal_force_n / static_cast<double>(loop.tick_count());
    if (k > 0) run.work_j -= (record.friction_W_n + last.friction_W_n).dot(record.p_WQ - last.p_WQ) / 2;
    last = record;
  }
  return run;
}

BatteryError battery_error(const BatteryRun& coarse, const BatteryRun& fine, long every) {
  BatteryError error;
  const Eigen::Index ticks = coarse.friction_W_n.cols();
  double square = 0, worst = 0;
  for (Eigen::Index k = 0; k < ticks; ++k) {
    const Eigen::Index fine_k = std::min<Eigen::Index>(k * every, fine.friction_W_n.cols() - 1);
    const double off = (coarse.friction_W_n.col(k) - fine.friction_W_n.col(fine_k)).norm();
    square += off * off;
    worst = std::max(worst, off);
  }
  const double limit_n = 0.3 * fine.mean_load_n;
  error.rms = std::sqrt(square / static_cast<double>(ticks)) / limit_n;
  error.worst = worst / limit_n;
  // Where a law takes next to nothing the share says nothing: then of the work at the limit over 1 mm.
  error.work = std::abs(coarse.work_j - fine.work_j) / std::max(std::abs(fine.work_j), limit_n * 1e-3);
  return error;
}

TickCost tick_cost(const BatteryCase& c, const std::string& law_name) {
  constexpr double rate_hz = 20000;
  constexpr int runs = 7;
  const std::vector<TangentialMotion> motions = motions_of(c, rate_hz);
  const auto law = find_law(law_name)->make({});
  const BenchScene bench(rate_hz, law_name);
  TickCost cost{HUGE_VAL, HUGE_VAL};
  double sum = 0;  // of forces, so that nothing is left out
  for (int i = 0; i < runs; ++i) {
    FrictionState state;
    const double alone_s = seconds_of([&] {
      for (const TangentialMotion& m : motions) {
        sum += law->tick(m, state).force_n.x();
      }
    });
    ClosedLoop loop = bench.loop(c.seconds, c.position_W);
    const double whole_s = seconds_of([&] {
      for (std::size_t k = 0; k < motions.size(); ++k) sum += loop.next().force_W_n.x();
    });
    cost.law_ns = std::min(cost.law_ns, alone_s * 1e9 / static_cast<double>(motions.size()));
    cost.whole_ns = std::min(cost.whole_ns, whole_s * 1e9 / static_cast<double>(motions.size()));
  }
  return std::isfinite(sum) ? cost : TickCost{};
}

}  // namespace fingerpad
