// How far `fit` is off where the pad is known: a hundred seeded measurements by
// tests/support/pad_measurement, and for each number how often its 95 % interval holds the truth, its mean
// error and its intervals' mean width, as the README has it. usage: bench_fit_truth [SETS [FIRST_SEED]]
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "support/pad_measurement.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t numbers = pad_number_keys.size();

/// What the sets say of one number.
struct Tally {
  int held = 0;
  double error = 0, width = 0;
};

struct Tallies {
  std::array<Tally, numbers> of{};
  int sets = 0, misfits = 0, delays_held = 0;
};

Tallies tally(int sets, int first_seed, const test::KnownFinger& finger) {
  Tallies tallies;
  const test::KnownSensors sensors = test::bad_sensors();
  for (int seed = first_seed; seed < first_seed + sets; ++seed) {
    const Measurement measurement = clean(
        test::known_measurement(test::known_trials(), finger, sensors, static_cast<std::uint64_t>(seed)), {});
    const ProfileFit fit = fit_profile(measurement, {});
    const auto truth = test::known_numbers(finger, fit.mu_load_n);
    ++tallies.sets;
    tallies.misfits += fit.residual.misfit.empty() ? 0 : 1;
    const auto& delay = measurement.delays.front().estimate.interval_s;
    tallies.delays_held +=
        delay && delay->first <= sensors.delay_s && sensors.delay_s <= delay->second ? 1 : 0;
    for (std::size_t k = 0; k < numbers; ++k) {
      if (!fit.interval[k]) continue;
      const auto [low, high] = *fit.interval[k];
      Tally& number = tallies.of[k];
      number.held += low <= truth[k] && truth[k] <= high ? 1 : 0;
      number.error += (fit.values[k].value - truth[k]) / sets;
      number.width += (high - low) / sets;
    }
  }
  return tallies;
}

/// A share of the truth in percent; as it is where the truth is 0.
std::string share_text(double value, double truth) {
  return truth == 0 ? fmt::format("{:.1e}", value) : fmt::format("{:.2f} %", 100 * value / std::abs(truth));
}

/// Error of both axes' cubic shares of a bent spring, as a mean.
double bent_share(int sets, int first_seed, test::KnownFinger finger, double share) {
  finger.cubic_share = share;
  const Tallies bent = tally(sets, first_seed, finger);
  return share + (bent.of[static_cast<std::size_t>(PadNumber::lateral_cubic_share)].error +
                  bent.of[static_cast<std::size_t>(PadNumber::longitudinal_cubic_share)].error) /
                     2;
}

void print_tables(int sets, int first_seed) {
  test::KnownFinger alike, scattered;
  alike.rises_with_less_load = scattered.rises_with_less_load = true;
  scattered.scatter = 0.03;
  const Tallies one = tally(sets, first_seed, scattered), other = tally(sets, first_seed, alike);
  const auto truth = test::known_numbers(scattered, 1);
  fmt::print(
      "| number | truth (at 1 N) | held | error | interval's width | held | error | width "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (std::size_t k = 0; k < numbers; ++k) {
    fmt::print("| `{}` | {:.4g} | {} | {} | {} | {} | {} | {} |\n", pad_number_keys[k], truth[k],
               one.of[k].held, share_text(one.of[k].error, truth[k]), share_text(one.of[k].width, truth[k]),
               other.of[k].held, share_text(other.of[k].error, truth[k]),
               share_text(other.of[k].width, truth[k]));
  }
  test::KnownFinger lugre = alike;
  lugre.law = "lugre";
  const int few = std::max(1, sets / 10);
  const double bent = 0.3;
  fmt::print(
      "\nOf {} sets each, from seed {} on, the delay's interval holds 7.3 ms in {} and {}; the pad's law is "
      "said "
      "not to\nfit in {} and {}, and in {} of {} whose forces come from LuGre's law. A cubic share of {} is "
      "found as "
      "{:.3f}\n(mean of {} sets).\n",
      sets, first_seed, one.delays_held, other.delays_held, one.misfits, other.misfits,
      tally(few, first_seed, lugre).misfits, few, bent, bent_share(few, first_seed, alike, bent), few);
}

}  // namespace
}  // namespace fingerpad

int main(int argc, char** argv) {
  // Seeds that no choice was made by.
  fingerpad::print_tables(argc > 1 ? std::max(1, std::atoi(argv[1])) : 100,
                          argc > 2 ? std::atoi(argv[2]) : 4001);
}
