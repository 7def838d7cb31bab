#include "contact/reckoned_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "contact/contact_method_table.hpp"
#include "contact/proxy_limits.hpp"
#include "contact/surface_places.hpp"

namespace fingerpad {
namespace {

/// Of how far a patch's own normal is off the shown one: the shown normal's error, and the height over the
/// patch's width. So much on the surfaces that study contact knows exactly, at most, and of errors that
/// count, where the patch itself is touched.
constexpr double shown_per_patch = 1.25, height_per_patch = 0.5;
constexpr double last_force = ReckonedError::forces - 1;
constexpr double whole_force = 2;
constexpr double keeps_up = ProxyLimits::rounds_per_finger;
/// Of a facet's sag, from one to the next: of the one that is nearest, and of several that hold a proxy.
constexpr double sags_differ_by = 0.5, sags_held_differ_by = 0.25;

/// How the finger's centre stands to the surface.
struct Centre {
  double radius_m, depth_m;
  double height_m() const noexcept { return radius_m - depth_m; }
};

/// By how much of a turn a foot that nothing holds is aside of where it were without that turn. 1 + u > 0
double free_foot_turn(double u) noexcept {
  return std::abs(u) / (1 + u);
}

/// By how much of a facet's turn the normal at the foot on it is off that at the foot on the surface.
/// @param held  how far edges of facets hold the foot inside a rounding, 0 .. 1
double foot_turn(double u, double held) noexcept {
  return u >= 0 ? free_foot_turn(u) : held * std::min(1.0, -u) + (1 - held) * free_foot_turn(u);
}

double facet_turn(double u, bool is_inside, bool lags) noexcept {
  return u >= 0 || (lags && is_inside) ? 1 / (1 + u) : 1;
}

/// The way to touch, as reckoning sees it.
struct Way {
  bool touches_patches, shows_facets, lags;
  double (*off_rad)(const SurfacePlace& place) noexcept;
};

/// How many times as far as the finger's centre a proxy has to go round a rounding of this curvature.
double times_as_far(double curvature_per_m, const Centre& centre) noexcept {
  return (1 + centre.radius_m * curvature_per_m) / (1 + centre.height_m() * curvature_per_m);
}

/// Whether that is farther than it may.
bool falls_behind(const Way& way, double curvature_per_m, const Centre& centre) noexcept {
  return way.lags && curvature_per_m > 0 && times_as_far(curvature_per_m, centre) > keeps_up;
}

/// The error that this makes over a quarter turn, of the force: the proxy stands behind on its circle.
double behind_share(double times_as_far) noexcept {
  const double behind_rad = std::numbers::pi / 2 * (1 - keeps_up / times_as_far);
  return times_as_far / (times_as_far - 1) * 2 * std::sin(behind_rad / 2);
}

/// By how much more a place's tilts turn the force on a ball in a hollow that it nearly fits.
double hollow_factor(const Way& way, double curvature_per_m, const Centre& centre) noexcept {
  if (!(curvature_per_m < 0) || centre.radius_m == 0) return 1;
  const double room = 1 + centre.height_m() * curvature_per_m;  // from the hollow's middle
  const double differ_by = way.lags ? sags_held_differ_by : sags_differ_by;
  return room > 0 ? std::max(1.0, std::sqrt(differ_by / room)) : 1;
}

/// Inside a rounding edges of facets hold a proxy's foot that run along it: on a fillet, not on a ball.
double held_foot(const Way& way, const SurfacePlace& place, const Centre& centre) noexcept {
  constexpr double ball_from = 0.5;  // of the curvature along: that across
  if (!way.lags || centre.height_m() >= 0 || !(place.curvature_per_m > 0)) return 1;
  return 1 - std::clamp(place.across_per_m / place.curvature_per_m / ball_from, 0.0, 1.0);
}

/// Across the force [rad].
double tilt_rad(const Way& way, const SurfacePlace& place, const Centre& centre) noexcept {
  const double u = centre.height_m() * place.curvature_per_m;
  // On plain facets it does not get round at all.
  if (way.shows_facets && falls_behind(way, place.curvature_per_m, centre)) return whole_force;
  double off = 0;
  if (way.touches_patches)
    off = shown_per_patch * place.patch_rad * (u >= 0 ? 1 : 1 / (1 + u));
  else if (way.shows_facets)
    off = way.off_rad(place) * facet_turn(u, centre.height_m() < 0, way.lags);
  else
    off = way.off_rad(place) + place.facet_rad * foot_turn(u, held_foot(way, place, centre));
  return std::min(off * hollow_factor(way, place.curvature_per_m, centre), whole_force);
}

/// How much way the finger's centre has over a place at this height, of the place's area: none where a ball
/// has no room between the facets.
double way_there(const SurfacePlace& place, const Centre& centre) noexcept {
  const double needs_m = centre.radius_m > 0 ? centre.radius_m + place.sag_m : 0;
  return 1 + needs_m * place.curvature_per_m > 0
             ? std::max(0.0, 1 + centre.height_m() * place.curvature_per_m)
             : 0;
}

/// Along it, as a length [m].
double sag_m(const Way& way, const SurfacePlace& place) noexcept {
  return way.touches_patches ? height_per_patch * place.patch_rad * place.width_m : place.sag_m;
}

/// An error, and how much of the finger's way it is met on.
struct Weighed {
  double share = 0, weight = 0;
};

/// The least share that all but a hundredth of the weight is not above.
/// @param largest  scratch: the largest met so far, as few as outweigh that hundredth; a heap, the least
/// first
double quantile_99(std::span<const Weighed> shares, double weight, std::vector<Weighed>& largest) {
  const auto is_more = [](const Weighed& a, const Weighed& b) { return a.share > b.share; };
  const double beyond = 0.01 * weight;
  largest.clear();
  double sum = 0;
  for (const Weighed& one : shares) {
    if (sum > beyond && !(one.share > largest.front().share)) continue;
    largest.push_back(one);
    std::push_heap(largest.begin(), largest.end(), is_more);
    sum += one.weight;
    while (sum - largest.front().weight > beyond) {
      sum -= largest.front().weight;
      std::pop_heap(largest.begin(), largest.end(), is_more);
      largest.pop_back();
    }
  }
  return sum > beyond ? largest.front().share : 0;
}

/// How many times the least force the k-th is.
double times_least(std::size_t k) noexcept {
  return std::pow(10.0, static_cast<double>(k) / last_force);
}

/// Kept from region to region, for its memory.
struct Scratch {
  std::vector<Weighed> shares, behind, largest;
};

/// A region's error under one force, over the places that a finger gets to.
ReckonedError error_in(std::span<const SurfacePlace> region, const Press& press, const Way& way,
                       double force_n, Scratch& scratch) {
  const Centre centre{press.finger_radius_m, force_n / press.stiffness_n_per_m};
  double tilts = 0, weights = 0;
  std::vector<Weighed>&shares = scratch.shares, &behind = scratch.behind;
  shares.clear();
  behind.clear();
  for (const SurfacePlace& place : region) {
    const double weight = way_there(place, centre);
    if (!(weight > 0)) continue;
    const double tilt = tilt_rad(way, place, centre);
    const double along = sag_m(way, place) / centre.depth_m;
    shares.push_back({std::sqrt(along * along + tilt * tilt), weight});
    tilts += weight * tilt;
    weights += weight;
    if (falls_behind(way, place.curvature_per_m, centre)) behind.push_back({place.curvature_per_m, weight});
  }
  if (!(weights > 0)) return {};
  const double tightest_per_m = quantile_99(behind, weights, scratch.largest);
  ReckonedError error{quantile_99(shares, weights, scratch.largest), tilts / weights};
  if (!(tightest_per_m > 0)) return error;
  error.behind_m = 1 / tightest_per_m;
  error.behind_share = behind_share(times_as_far(tightest_per_m, centre));
  return error;
}

void take_worse(ReckonedError& worst, const ReckonedError& other) noexcept {
  worst.force_share = std::max(worst.force_share, other.force_share);
  worst.mean_tilt_rad = std::max(worst.mean_tilt_rad, other.mean_tilt_rad);
  for (std::size_t k = 0; k < ReckonedError::forces; ++k) {
    worst.force_shares[k] = std::max(worst.force_shares[k], other.force_shares[k]);
    worst.mean_tilts_rad[k] = std::max(worst.mean_tilts_rad[k], other.mean_tilts_rad[k]);
  }
  if (!(other.behind_share > worst.behind_share)) return;
  worst.behind_share = other.behind_share;
  worst.behind_m = other.behind_m;
}

}  // namespace

std::vector<RegionError> region_errors(std::span<const SurfacePlace> places, const Press& press,
                                       const ContactMethodEntry& method, Normals normals) {
  std::vector<RegionError> errors;
  const Way way{method.touches_own_surface && normals->own_surface != nullptr, normals->shows_facets(),
                method.lags_on_facets, normals->off_rad};
  Scratch scratch;
  each_region(places, [&](std::span<const SurfacePlace> region) {
    if (is_too_small(region, places)) return;
    RegionError worst{region.front().region, {}};
    for (std::size_t k = 0; k < ReckonedError::forces; ++k) {
      const double force_n = press.least_force_n() * times_least(k);
      ReckonedError here = error_in(region, press, way, force_n, scratch);
      here.force_shares[k] = here.force_share;
      here.mean_tilts_rad[k] = here.mean_tilt_rad;
      if (k + 1 < ReckonedError::forces) here.mean_tilt_rad = 0;
      take_worse(worst.error, here);
    }
    errors.push_back(worst);
  });
  return errors;
}

ReckonedError reckoned_error(std::span<const SurfacePlace> places, const Press& press,
                             const ContactMethodEntry& method, Normals normals) {
  ReckonedError worst;
  for (const RegionError& one : region_errors(places, press, method, normals)) take_worse(worst, one.error);
  return worst;
}

double rounding_share(const Press& press, double rounding_m) noexcept {
  constexpr double felt = 0.01;
  const double share = press.stiffness_n_per_m * rounding_m / press.least_force_n();
  return share > felt ? share : 0;
}

void add_rounding(ReckonedError& error, const Press& press, double rounding_m) noexcept {
  const double share = rounding_share(press, rounding_m);
  error.force_share += share;
  for (std::size_t k = 0; k < ReckonedError::forces; ++k) error.force_shares[k] += share / times_least(k);
}

}  // namespace fingerpad
