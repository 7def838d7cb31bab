#include "study/pulled_block.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/bench_scene.hpp"

namespace fingerpad {
namespace {

constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();
constexpr double stick_stiffness_per_m = 500;
/// A bristle creeps before it yields; only one this stiff does so over a way that the block does not notice.
constexpr double bristle_n_per_m = 5e5;

/// What the coefficients are given as for all laws to have the same limits under the block's load.
double mu_raise(const LawEntry& law) {
  return law.mu_raise != nullptr ? law.mu_raise(PulledBlock{}.normal_n) : 1;
}

bool is_damped_bristle(const LawEntry& law) {
  return std::any_of(law.parameters.begin(), law.parameters.end(), [](const LawParameter& parameter) {
    return parameter.key == "bristle_damping_n_s_per_m";
  });
}

}  // namespace

bool has_static_limit(const std::string& law) {
  return find_law(law)->has_static_limit;
}

StickSlipCycle rigid_cycle(const PulledBlock& block) {
  // The pull u = k (V t - x) obeys u'' + (b/m) u' + (k/m) (u - F_d - b V) = 0, u' = k (V - x').
  const double decay = block.damping_n_s_per_m / (2 * block.mass_kg);
  const double natural_square = block.spring_n_per_m / block.mass_kg;
  const double omega = std::sqrt(natural_square - decay * decay);
  const double level = block.dynamic_n() + block.damping_n_s_per_m * block.speed_m_per_s;
  const double rate = block.spring_n_per_m * block.speed_m_per_s;  // u' at rest
  const double start = block.static_n() - level;
  const double sine = (rate + decay * start) / omega;
  const auto slope = [&](double t) {
    return std::exp(-decay * t) * ((omega * sine - decay * start) * std::cos(omega * t) -
                                   (omega * start + decay * sine) * std::sin(omega * t));
  };
  // The block stands where the slope is that of rest again: within the second half turn.
  double moving = 1e-6 / omega, stopped = 2 * 3.141592653589793 / omega;
  while (slope(moving) > rate) moving *= 2;
  double probe = 3.141592653589793 / omega / 2;
  moving = std::max(moving, probe);
  for (int i = 0; i < 200; ++i) {
    probe = (moving + stopped) / 2;
    (slope(probe) < rate ? moving : stopped) = probe;
  }
  const double least =
      level + std::exp(-decay * probe) * (start * std::cos(omega * probe) + sine * std::sin(omega * probe));
  return {probe + (block.static_n() - least) / rate, block.static_n(), least, 1};
}

StickSlipCycle reference_cycle(const PulledBlock& block, const std::string& law) {
  const LawSettings settings = block_settings(law);
  const auto slip_damping = settings.numbers.find("slip_damping_n_s_per_m");
  if (slip_damping == settings.numbers.end()) return rigid_cycle(block);
  PulledBlock viscous = block;
  viscous.mu_dynamic = 0;
  viscous.damping_n_s_per_m += slip_damping->second;
  return rigid_cycle(viscous);
}

LawSettings block_settings(const std::string& name) {
  const LawEntry& law = *find_law(name);
  const std::pair<const char*, double> wanted[] = {
      {"v_min_m_per_s", 0.002},
      {"stick_stiffness_per_m", mu_raise(law) * stick_stiffness_per_m},
      {"stick_stiffness_n_per_m", stick_stiffness_per_m * PulledBlock{}.normal_n},
      {"slip_damping_n_s_per_m", 2},
  };
  const std::pair<const char*, double> bristle[] = {
      {"stick_stiffness_n_per_m", bristle_n_per_m},
      {"bristle_damping_n_s_per_m", 1.4 * std::sqrt(bristle_n_per_m * PulledBlock{}.mass_kg)},
      {"stribeck_speed_m_per_s", 0.001},
  };
  LawSettings settings;
  for (const LawParameter& parameter : law.parameters) {
    for (const auto& [key, value] : wanted) {
      if (parameter.key == key) settings.numbers[key] = value;
    }
    if (!is_damped_bristle(law)) continue;
    for (const auto& [key, value] : bristle) {
      if (parameter.key == key) settings.numbers[key] = value;
    }
  }
  return settings;
}

PulledBlock block_for(const PulledBlock& block, const std::string& law) {
  PulledBlock given = block;
  given.mu_static *= mu_raise(*find_law(law));
  given.mu_dynamic *= mu_raise(*find_law(law));
  return given;
}

std::vector<double> pull_of_block(const PulledBlock& block, const std::string& law,
                                  const LawSettings& settings, double rate_hz, double seconds) {
  BenchScene bench(rate_hz, law);
  bench.scene().friction.settings = settings;
  const double surface_n_per_m = stick_stiffness_per_m * block.normal_n;  // friction-cone sticks with this
  bench.surface() = {surface_n_per_m, 0, block.mu_static, block.mu_dynamic};
  HandSettings& hand = bench.hold({.mass_kg = block.mass_kg,
                                   .damping_n_s_per_m = block.damping_n_s_per_m,
                                   .stiffness_n_per_m = block.spring_n_per_m,
                                   .encoder_m = 0});
  hand.free_axis[1] = hand.free_axis[2] = false;
  const double z_m = -block.normal_n / surface_n_per_m;
  ClosedLoop loop = bench.loop(seconds, [&](double t_s) { return Vec3(block.speed_m_per_s * t_s, 0, z_m); });
  std::vector<double> pull(static_cast<std::size_t>(loop.tick_count()));
  for (double& p : pull) {
    const TickRecord record = loop.next();
    p = block.spring_n_per_m * (block.speed_m_per_s * record.t_s - record.p_WQ.x());
  }
  return pull;
}

StickSlipCycle cycle_of(const std::vector<double>& pull_n, double rate_hz, double tooth_n) {
  std::vector<double> peak_s, peaks, troughs;
  double extreme = pull_n.empty() ? 0 : pull_n.front();
  double at_s = 0;
  bool rising = true;
  for (std::size_t k = 0; k < pull_n.size(); ++k) {
    const double now = pull_n[k];
    if (rising ? now >= extreme : now <= extreme) {
      extreme = now;
      at_s = static_cast<double>(k) / rate_hz;
      continue;
    }
    if (std::abs(now - extreme) < tooth_n / 2) continue;
    if (rising) {
      peak_s.push_back(at_s);
      peaks.push_back(extreme);
    } else if (!peaks.empty()) {
      troughs.push_back(extreme);
    }
    rising = !rising;
    extreme = now;
    at_s = static_cast<double>(k) / rate_hz;
  }
  if (peak_s.size() < 3) return {unmeasured, unmeasured, unmeasured, 0};
  const auto mean_after_first = [](const std::vector<double>& values, std::size_t end) {
    double sum = 0;
    for (std::size_t i = 1; i < end; ++i) sum += values[i];
    return sum / static_cast<double>(end - 1);
  };
  const auto cycles = static_cast<int>(peak_s.size()) - 2;
  return {(peak_s.back() - peak_s[1]) / cycles, mean_after_first(peaks, peaks.size()),
          mean_after_first(troughs, std::min(troughs.size(), peaks.size() - 1)), cycles};
}

}  // namespace fingerpad
