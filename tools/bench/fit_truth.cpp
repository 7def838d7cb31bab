// How far `fit` is off where the pad is known: a hundred seeded measurements by
// tests/support/pad_measurement, and for each number how often its 95 % interval holds the truth, its mean
// error and its intervals' mean width, as the README has it. usage: bench_fit_truth [SETS [FIRST_SEED]]
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <utility>
#include <vector>

#include "support/pad_measurement.hpp"

namespace fingerpad {
namespace {

constexpr std::size_t numbers = pad_number_keys.size();

/// What the sets say of one number; errors and widths of those that do not refuse it.
struct Tally {
  int held = 0, given = 0;
  double error = 0, width = 0;

  double mean_error() const { return error / given; }
  double mean_width() const { return width / given; }
};

struct Tallies {
  std::array<Tally, numbers> of{};
  int sets = 0, misfits = 0, delays_held = 0;
};

/// What a set is measured with, and told of it.
struct Watched {
  test::KnownSensors sensors;
  bool normal_force_alone = false;
  CleaningSettings settings;
};

/// What one set's fit says, as a tally of one.
Tallies tally_one(int seed, const test::KnownFinger& finger, const Watched& watched) {
  Tallies tallies;
  RecordedMeasurement recorded = test::known_measurement(test::known_trials(), finger, watched.sensors,
                                                         static_cast<std::uint64_t>(seed));
  if (watched.normal_force_alone) recorded = test::of_normal_force_alone(std::move(recorded));
  const Measurement measurement = clean(std::move(recorded), watched.settings);
  const ProfileFit fit = fit_profile(measurement, {});
  const auto truth = test::known_numbers(finger, fit.mu_load_n);
  tallies.sets = 1;
  tallies.misfits = fit.residual.misfit.empty() ? 0 : 1;
  const double delay_s = watched.sensors.delay_s;
  for (const FileDelay& delay : measurement.delays) {
    const auto& interval_s = delay.estimate.interval_s;
    tallies.delays_held +=
        interval_s && interval_s->first <= delay_s && delay_s <= interval_s->second ? 1 : 0;
  }
  for (std::size_t k = 0; k < numbers; ++k) {
    if (!fit.interval[k]) continue;
    const auto [low, high] = *fit.interval[k];
    tallies.of[k] = {low <= truth[k] && truth[k] <= high ? 1 : 0, 1, fit.values[k].value - truth[k],
                     high - low};
  }
  return tallies;
}

/// The sets are shared by the processors, and added in their order.
Tallies tally(int sets, int first_seed, const test::KnownFinger& finger, const Watched& watched) {
  std::vector<Tallies> each(static_cast<std::size_t>(sets));
  std::atomic<int> next{0};
  {
    std::vector<std::jthread> workers;
    for (unsigned k = 0; k < std::max(1U, std::thread::hardware_concurrency()); ++k)
      workers.emplace_back([&] {
        for (int set = next++; set < sets; set = next++)
          each[static_cast<std::size_t>(set)] = tally_one(first_seed + set, finger, watched);
      });
  }
  Tallies sum;
  for (const Tallies& one : each) {
    sum.sets += one.sets;
    sum.misfits += one.misfits;
    sum.delays_held += one.delays_held;
    for (std::size_t k = 0; k < numbers; ++k) {
      sum.of[k].held += one.of[k].held;
      sum.of[k].given += one.of[k].given;
      sum.of[k].error += one.of[k].error;
      sum.of[k].width += one.of[k].width;
    }
  }
  return sum;
}

/// A share of the truth in percent; as it is where the truth is 0.
std::string share_text(double value, double truth) {
  return truth == 0 ? fmt::format("{:.1e}", value) : fmt::format("{:.2f} %", 100 * value / std::abs(truth));
}

const Tally& of_number(const Tallies& tallies, PadNumber number) {
  return tallies.of[static_cast<std::size_t>(number)];
}

/// What a bent spring comes to: both axes' cubic shares, as a mean, and what it moves else.
std::string bent_text(int sets, int first_seed, test::KnownFinger finger, double share) {
  finger.cubic_share = share;
  const Tallies bent = tally(sets, first_seed, finger, {test::bad_sensors(), false, {}});
  const double found = share + (of_number(bent, PadNumber::lateral_cubic_share).mean_error() +
                                of_number(bent, PadNumber::longitudinal_cubic_share).mean_error()) /
                                   2;
  return fmt::format(
      "a cubic share of {} as {:.3f}, with `v_min_m_per_s` {:+.1f} % and `mu_dynamic` {:+.1f} % off", share,
      found, 100 * of_number(bent, PadNumber::v_min).mean_error() / finger.pad.v_min_m_per_s,
      100 * of_number(bent, PadNumber::mu_dynamic).mean_error() / finger.mu_dynamic);
}

/// What noise of the force sensor comes to beyond that of the table.
std::string noise_text(int sets, int first_seed, const test::KnownFinger& finger, double noise_n) {
  test::KnownSensors sensors = test::bad_sensors();
  sensors.force_noise_n = noise_n;
  const Tallies noisy = tally(sets, first_seed, finger, {sensors, false, {}});
  const auto truth = test::known_numbers(finger, 1);
  std::string text = fmt::format("with {:.0f} mN of noise", 1e3 * noise_n);
  for (const PadNumber number : {PadNumber::mu_static, PadNumber::mu_dynamic, PadNumber::mu_load_exponent}) {
    const auto k = static_cast<std::size_t>(number);
    text += noisy.of[k].given == sets ? fmt::format(" `{}` {:+.2f} %,", pad_number_keys[k],
                                                    100 * noisy.of[k].mean_error() / std::abs(truth[k]))
                                      : fmt::format(" `{}` refused in {} of {},", pad_number_keys[k],
                                                    sets - noisy.of[k].given, sets);
  }
  if (of_number(noisy, PadNumber::mu_dynamic).given == 0) return text.substr(0, text.size() - 1);
  return text + fmt::format(" and the law said not to fit in {}", noisy.misfits);
}

/// What the normal force alone comes to.
std::string normal_text(int sets, int first_seed, const test::KnownFinger& finger) {
  const auto truth = test::known_numbers(finger, 1);
  std::string text = fmt::format("Of {} sets of the normal force alone", sets);
  for (const bool is_given : {true, false}) {
    Watched alone{test::bad_sensors(), true, {}};
    if (is_given) alone.settings.delay_s = alone.sensors.delay_s;
    const Tallies found = tally(sets, first_seed, finger, alone);
    text += is_given ? ", where the delay is given," : "; where it is not,";
    for (const PadNumber number : {PadNumber::normal_stiffness, PadNumber::normal_exponent}) {
      const auto k = static_cast<std::size_t>(number);
      const Tally& of = found.of[k];
      text += fmt::format("\n{}the interval of `{}` holds the truth in {}",
                          number == PadNumber::normal_stiffness ? "" : "and ", pad_number_keys[k], of.held);
      if (of.given < sets) text += fmt::format(" of {} (refused in {})", of.given, sets - of.given);
      if (of.given > 0)
        text += fmt::format(" ({} off, {} wide)", share_text(of.mean_error(), truth[k]),
                            share_text(of.mean_width(), truth[k]));
    }
  }
  return text + ".";
}

/// How many of a table's counts are below ninety in a hundred, and which.
std::string below_text(const Tallies& one, const Tallies& other) {
  std::string below;
  int count = 0;
  for (const Tallies* tallies : {&one, &other}) {
    for (std::size_t k = 0; k < numbers; ++k) {
      if (10 * tallies->of[k].held >= 9 * tallies->sets) continue;
      below += fmt::format("{}`{}` {} ({})", below.empty() ? "" : ", ", pad_number_keys[k],
                           tallies == &one ? "scattered" : "alike", tallies->of[k].held);
      ++count;
    }
  }
  if (count == 0)
    return fmt::format("All {} intervals hold the truth in at least ninety of a hundred sets.", 2 * numbers);
  return fmt::format("Of the {} intervals {} hold{} the truth in less than ninety of a hundred sets: {}.",
                     2 * numbers, count, count == 1 ? "s" : "", below);
}

void print_tables(int sets, int first_seed) {
  test::KnownFinger alike, scattered;
  alike.rises_with_less_load = scattered.rises_with_less_load = true;
  scattered.scatter = 0.03;
  const Watched bad{test::bad_sensors(), false, {}};
  const Tallies one = tally(sets, first_seed, scattered, bad), other = tally(sets, first_seed, alike, bad);
  const auto truth = test::known_numbers(scattered, 1);
  fmt::print(
      "| number | truth (at 1 N) | held | error | interval's width | held | error | width "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (std::size_t k = 0; k < numbers; ++k) {
    fmt::print("| `{}` | {:.4g} | {} | {} | {} | {} | {} | {} |\n", pad_number_keys[k], truth[k],
               one.of[k].held, share_text(one.of[k].mean_error(), truth[k]),
               share_text(one.of[k].mean_width(), truth[k]), other.of[k].held,
               share_text(other.of[k].mean_error(), truth[k]),
               share_text(other.of[k].mean_width(), truth[k]));
  }
  test::KnownFinger lugre = alike;
  lugre.law = "lugre";
  const int few = std::max(1, sets / 10);
  fmt::print(
      "\n{}\nOf {} sets each, from seed {} on, the delay's interval holds 7.3 ms in {} and {}; the pad's law "
      "is said "
      "not to\nfit in {} and {}, and in {} of {} whose forces come from LuGre's law. Of {} sets each "
      "(no scatter):\n",
      below_text(one, other), sets, first_seed, one.delays_held, other.delays_held, one.misfits,
      other.misfits, tally(few, first_seed, lugre, bad).misfits, few, few);
  for (const double share : {0.3, 0.5}) fmt::print("{};\n", bent_text(few, first_seed, alike, share));
  fmt::print("{};\n", noise_text(few, first_seed, alike, 0.01));
  fmt::print("{}.\n", noise_text(few, first_seed, alike, 0.03));
  fmt::print("{}\n", normal_text(sets, first_seed, scattered));
}

}  // namespace
}  // namespace fingerpad

int main(int argc, char** argv) {
  // Seeds that no choice was made by.
  fingerpad::print_tables(argc > 1 ? std::max(1, std::atoi(argv[1])) : 100,
                          argc > 2 ? std::atoi(argv[2]) : 9701);
}
