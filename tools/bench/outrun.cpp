// How well a proxy keeps up where facets are much smaller than the ball and it passes many in a tick: over
// random fine sheets of five kinds, its push against that of the same proxy with neither memory nor bound on
// its work. Prints the README's table. usage: bench_outrun [SCENES [FIRST_SEED]]
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numbers>
#include <tuple>
#include <utility>

#include "base/random_stream.hpp"
#include "contact/fast_proxy.hpp"
#include "support/shapes.hpp"

namespace fingerpad {
namespace {

constexpr int cells = 240;           // a side of a sheet has so many
constexpr double off_share = 0.03;   // a tick is off by more than this share of the true push ...
constexpr double least_share = 0.1;  // ... or, where that is small, of so much of the depth
constexpr int landing_ticks = 20, resting_ticks = 100, most_ticks = 150;

/// A height over x and y [m].
using Height = std::function<double(double x_m, double y_m)>;

/// A ball's way over a sheet: it lands, goes straight on, following a roof's or a valley's walls, and rests.
struct Trial {
  double radius_m, facet_m, depth_m, step_m, dt_s, heading_rad;
  Normals normals = Normals::facet;
  Height height, follow;
  Eigen::AngleAxisd turned{0, Vec3::UnitX()};
};

double log_between(RandomStream& random, double least, double most) {
  return least * std::pow(most / least, random.uniform());
}

Trial any_trial(std::size_t kind, RandomStream& random) {
  Trial trial;
  trial.radius_m = log_between(random, 0.001, 0.02);
  trial.facet_m = log_between(random, 5e-5, 3e-4);
  trial.depth_m = (0.1 + 0.5 * random.uniform()) * std::min(trial.radius_m, 0.003);
  trial.step_m = trial.facet_m * log_between(random, 0.2, 4);
  trial.dt_s = random.uniform() < 0.5 ? 0.001 : 0.004;
  trial.heading_rad = 2 * std::numbers::pi * random.uniform();
  trial.normals = random.uniform() < 0.5 ? Normals::facet : Normals::smooth;
  trial.turned = Eigen::AngleAxisd(3 * random.uniform(),
                                   Vec3(random.normal(), random.normal(), random.normal()).normalized());
  const double wave_m = log_between(random, 10, 240) * trial.facet_m,
               high_m = log_between(random, 1, 40) * trial.facet_m, slope = 0.3 + random.uniform(),
               bore_m = trial.radius_m * (1.05 + random.uniform());
  const Height level = [](double, double) { return 0.0; };
  const Height valley = [slope](double, double y_m) { return slope * std::abs(y_m); };
  const Height ridge = [slope](double, double y_m) { return -slope * std::abs(y_m); };
  const Height waves = [=](double x_m, double y_m) {
    constexpr double turn = 2 * std::numbers::pi;
    return high_m * std::sin(turn * x_m / wave_m) * std::cos(turn * y_m / wave_m);
  };
  const Height groove = [bore_m](double, double y_m) {
    const double within_m = std::min(std::abs(y_m), 0.85 * bore_m);
    return bore_m - std::sqrt(bore_m * bore_m - within_m * within_m) + 1.5 * (std::abs(y_m) - within_m);
  };
  const std::array<std::pair<Height, Height>, 5> kinds = {
      {{level, level}, {waves, level}, {valley, valley}, {groove, level}, {ridge, ridge}}};
  std::tie(trial.height, trial.follow) = kinds[kind];
  return trial;
}

/// Its corners are floats, as files have them.
TriangleSoup sheet_of(const Trial& trial) {
  const double side_m = cells * trial.facet_m;
  return test::sheet_soup(cells, cells, [&](double u, double v) {
    const double x_m = (u - 0.5) * side_m, y_m = (v - 0.5) * side_m;
    const Vec3 corner = trial.turned * Vec3(x_m, y_m, trial.height(x_m, y_m));
    return Vec3(corner.cast<float>().cast<double>());
  });
}

Vec3 push_of(const ProxyContact& contact) {
  return contact.touching() ? Vec3(contact.depth_m * contact.normal_W) : Vec3::Zero();
}

/// Where the ball first touches on its way down, in steps of a fifth of a facet or a hundredth of its radius.
double touching_height_m(const PlacedSurface& surface, const Trial& trial, double x_m, double y_m) {
  Proxy proxy({surface}, trial.radius_m, trial.normals);
  const double step_m = std::max(0.2 * trial.facet_m, 0.01 * trial.radius_m);
  double z_m = 1.5 * trial.radius_m + cells * trial.facet_m;
  for (int k = 0; k < 10000; ++k, z_m -= step_m) {
    if (proxy.move(trial.turned * Vec3(x_m, y_m, z_m), trial.dt_s).touching()) break;
  }
  return z_m;
}

struct Tally {
  long trials = 0, ticks = 0, off = 0, off_untold = 0, unsettled = 0;
  double worst = 0;
};

void tally_trial(const Trial& trial, Tally& tally) {
  PlacedSurface surface;
  surface.tree =
      std::make_shared<const TriangleTree>(std::make_shared<const Part>(make_part(sheet_of(trial), 0.5)));
  const double side_m = cells * trial.facet_m;
  const Vec3 heading(std::cos(trial.heading_rad), std::sin(trial.heading_rad), 0);
  const Vec3 start = -0.3 * side_m * heading;
  const double touching_m = touching_height_m(surface, trial, start.x(), start.y());
  Proxy fast = fast_proxy({surface}, trial.radius_m, trial.normals);
  Proxy plain({surface}, trial.radius_m, trial.normals);
  const auto move = [&](double way_m, double deep_m, bool is_judged) {
    Vec3 finger = start + way_m * heading;
    finger.z() =
        touching_m - deep_m + trial.follow(finger.x(), finger.y()) - trial.follow(start.x(), start.y());
    finger = trial.turned * finger;
    const Vec3 truth = push_of(plain.move(finger, trial.dt_s));
    const ProxyContact& seen = fast.move(finger, trial.dt_s);
    if (!is_judged) return;
    const double off = (push_of(seen) - truth).norm() / std::max(truth.norm(), least_share * trial.depth_m);
    ++tally.ticks;
    tally.unsettled += seen.behind ? 1 : 0;
    tally.worst = std::max(tally.worst, off);
    if (off <= off_share) return;
    ++tally.off;
    tally.off_untold += seen.behind ? 0 : 1;
  };
  for (int k = 0; k <= landing_ticks; ++k) move(0, trial.depth_m * k / landing_ticks, false);
  const int ticks = std::min(most_ticks, static_cast<int>(0.6 * side_m / trial.step_m));
  for (int k = 1; k <= ticks + resting_ticks; ++k)
    move(trial.step_m * std::min(k, ticks), trial.depth_m, true);
  ++tally.trials;
}

int run(int trials, int first_seed) {
  constexpr std::array names = {"plates", "waves", "valleys", "grooves", "ridges"};
  fmt::print(
      "| sheets | trials | ticks | off by over 3 % | off and not told | told | worst |\n"
      "|---|---|---|---|---|---|---|\n");
  for (std::size_t kind = 0; kind < names.size(); ++kind) {
    Tally tally;
    for (int k = 0; k < trials; ++k) {
      RandomStream random(static_cast<std::uint64_t>(first_seed + k) * names.size() + kind);
      tally_trial(any_trial(kind, random), tally);
    }
    const auto percent = [&](long ticks) {
      return 100.0 * static_cast<double>(ticks) / static_cast<double>(tally.ticks);
    };
    fmt::print("| {} | {} | {} | {:.1f} % | {:.1f} % | {:.1f} % | {:.2f} |\n", names[kind], tally.trials,
               tally.ticks, percent(tally.off), percent(tally.off_untold), percent(tally.unsettled),
               tally.worst);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace fingerpad

int main(int argc, char** argv) {
  return fingerpad::run(argc > 1 ? std::atoi(argv[1]) : 60, argc > 2 ? std::atoi(argv[2]) : 1);
}
