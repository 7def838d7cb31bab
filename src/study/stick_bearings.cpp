#include "study/stick_bearings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fingerpad {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t bearing_bins = 24;

std::size_t bin_of(const Vec2& displacement_m) {
  const double turn = std::atan2(displacement_m.y(), displacement_m.x()) / (2 * pi) + 1;
  return static_cast<std::size_t>(std::lround(turn * bearing_bins)) % bearing_bins;
}

using Bins = std::array<std::vector<Vec2>, bearing_bins>;

/// The mean of the farthest tenth; not a number of few samples.
Vec2 farthest_tenth(std::vector<Vec2> of) {
  constexpr std::size_t fewest = 10;
  if (of.size() < fewest) return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  std::stable_sort(of.begin(), of.end(), [](const Vec2& a, const Vec2& b) { return a.norm() < b.norm(); });
  const std::size_t from = of.size() - of.size() / 10;
  Vec2 mean(0, 0);
  for (std::size_t i = from; i < of.size(); ++i) mean += of[i] / static_cast<double>(of.size() - from);
  return mean;
}

/// What of stick was pushed, by its bearing: what stays near the centre is noise beside other bearings, and a
/// few samples are a stray.
Bins pushed_bins(const std::vector<const StickPath*>& paths) {
  constexpr double least_reach = 0.3, least_samples = 0.01;
  Bins bins;
  for (const StickPath* path : paths)
    for (const Vec2& d : path->displacement_m) bins[bin_of(d)].push_back(d);
  double most_m = 0, pushed = 0;
  for (const auto& bin : bins)
    if (const double here_m = farthest_tenth(bin).norm(); here_m > most_m) most_m = here_m;
  for (auto& bin : bins) {
    std::erase_if(bin, [&](const Vec2& d) { return !(d.norm() > least_reach * most_m); });
    pushed += static_cast<double>(bin.size());
  }
  for (auto& bin : bins)
    if (!(static_cast<double>(bin.size()) > least_samples * pushed)) bin.clear();
  return bins;
}

}  // namespace

std::vector<Vec2> farthest_by_bearing_m(const std::vector<const StickPath*>& paths) {
  std::vector<Vec2> farthest_m;
  for (auto& bin : pushed_bins(paths))
    if (const Vec2 here_m = farthest_tenth(std::move(bin)); here_m.allFinite()) farthest_m.push_back(here_m);
  return farthest_m;
}

PushedLines pushed_lines(const std::vector<const StickPath*>& paths) {
  const Bins bins = pushed_bins(paths);
  constexpr std::size_t lines = bearing_bins / 2;
  PushedLines found;
  for (std::size_t k = 0; k < lines; ++k) {
    Vec2 doubled(0, 0);  // of unit vectors at twice the bearing: either way is the same line
    for (const auto* bin : {&bins[k], &bins[k + lines]}) {
      if (!farthest_tenth(*bin).allFinite()) continue;
      for (const Vec2& d : *bin) {
        const double twice = 2 * std::atan2(d.y(), d.x());
        doubled += Vec2(std::cos(twice), std::sin(twice));
      }
    }
    if (doubled.norm() == 0) continue;
    const double bearing_deg = std::atan2(doubled.y(), doubled.x()) * 90 / pi;
    found.bearing_deg.push_back(std::lround(bearing_deg) < 0 ? bearing_deg + 180 : bearing_deg);
  }
  std::sort(found.bearing_deg.begin(), found.bearing_deg.end());
  return found;
}

bool PushedLines::tell_ellipse() const {
  constexpr double least_apart = 0.2;
  double least = 1, most = 0;
  for (const double deg : bearing_deg) {
    const double lateral_share = std::pow(std::cos(deg * pi / 180), 2);
    least = std::min(least, lateral_share);
    most = std::max(most, lateral_share);
  }
  return most - least > least_apart;
}

std::string PushedLines::words() const {
  constexpr std::size_t most_named = 8;
  if (bearing_deg.size() > most_named) return "all ways round";
  std::string named;
  for (std::size_t k = 0; k < bearing_deg.size(); ++k)
    named += fmt::format("{}{:.0f}",
                         k == 0                        ? ""
                         : k + 1 == bearing_deg.size() ? " and "
                                                       : ", ",
                         std::abs(bearing_deg[k]));
  return "at " + named + " deg";
}

}  // namespace fingerpad
