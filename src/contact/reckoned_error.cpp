#include "contact/reckoned_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/contact_method_table.hpp"
#include "contact/surface_places.hpp"

namespace fingerpad {
namespace {

constexpr int force_steps = 6;  ///< from the least to the greatest force
constexpr double no_rounding_left = 0.5, whole_force = 2;
/// Of all places: a region of fewer is not judged.
constexpr double least_region_share = 1.0 / 2000;
/// Of a facet's sag, from one to the next.
constexpr double sags_differ_by = 0.25;

/// By how much of a facet's turn the normal at the foot on it is off that at the foot on the surface.
double foot_turn(double u) noexcept {
  return u >= 0 ? u / (1 + u) : std::min(1.0, -u);
}

double facet_turn(double u, bool is_inside, bool lags) noexcept {
  if (u >= 0) return 1 / (1 + u);
  if (!lags || !is_inside) return 1;
  return u > -no_rounding_left ? 1 / (1 + u) : whole_force / 1e-6;
}

/// The way to touch, as reckoning sees it.
struct Way {
  bool touches_patches, shows_facets, lags;
  double (*off_rad)(const SurfacePlace& place) noexcept;
};

/// By how much more a place's tilts turn the force on a ball in a hollow that it nearly fits.
double hollow_factor(double curvature_per_m, double radius_m) noexcept {
  const double room = 1 + radius_m * std::min(0.0, curvature_per_m);
  return room > 0 ? std::max(1.0, std::sqrt(sags_differ_by / room)) : 1;
}

/// Across the force [rad].
double tilt_rad(const Way& way, const SurfacePlace& place, double height_m, double radius_m) noexcept {
  const double u = height_m * place.curvature_per_m;
  double off = 0;
  if (way.touches_patches)
    off = place.patch_rad;
  else if (way.shows_facets)
    off = place.facet_rad * facet_turn(u, height_m < 0, way.lags);
  else
    off = way.off_rad(place) + place.facet_rad * foot_turn(u);
  return std::min(off * hollow_factor(place.curvature_per_m, radius_m), whole_force);
}

/// How much way the finger's centre has over a place at this height, of the place's area.
double way_there(const SurfacePlace& place, double height_m, double radius_m) noexcept {
  const bool is_reached = 1 + radius_m * place.curvature_per_m > 0;
  return is_reached ? std::max(0.0, 1 + height_m * place.curvature_per_m) : 0;
}

/// Along it, as a length [m].
double sag_m(const Way& way, const SurfacePlace& place) noexcept {
  return way.touches_patches ? place.patch_rad * place.width_m : place.sag_m;
}

/// An error, and how much of the finger's way it is met on.
struct Weighed {
  double share = 0, weight = 0;
};

/// The least share that all but a hundredth of the weight is not above. Orders them.
double quantile_99(std::span<Weighed> shares, double weight) {
  std::sort(shares.begin(), shares.end(),
            [](const Weighed& a, const Weighed& b) { return a.share > b.share; });
  double sum = 0;
  for (const Weighed& one : shares) {
    sum += one.weight;
    if (sum > 0.01 * weight) return one.share;
  }
  return 0;
}

/// A region's error under one force, over the places that a finger gets to.
ReckonedError error_in(std::span<const SurfacePlace> region, const Press& press, const Way& way,
                       double force_n, std::vector<Weighed>& shares) {
  const double height_m = press.finger_radius_m - force_n / press.stiffness_n_per_m;
  double tilts = 0, weights = 0;
  shares.clear();
  for (const SurfacePlace& place : region) {
    const double weight = way_there(place, height_m, press.finger_radius_m);
    if (!(weight > 0)) continue;
    const double tilt = tilt_rad(way, place, height_m, press.finger_radius_m);
    shares.push_back({std::hypot(press.stiffness_n_per_m * sag_m(way, place) / force_n, tilt), weight});
    tilts += weight * tilt;
    weights += weight;
  }
  if (!(weights > 0)) return {};
  return {quantile_99(shares, weights), tilts / weights};
}

}  // namespace

ReckonedError reckoned_error(std::span<const SurfacePlace> places, const Press& press,
                             const ContactMethodEntry& method, Normals normals) {
  ReckonedError error;
  const Way way{method.touches_own_surface && normals->own_surface != nullptr, normals->shade == nullptr,
                method.lags_on_facets, normals->off_rad};
  const auto fewest = static_cast<std::ptrdiff_t>(least_region_share * static_cast<double>(places.size()));
  std::vector<Weighed> shares;
  for (auto first = places.begin(), end = first; first != places.end(); first = end) {
    end = std::find_if(first, places.end(),
                       [&](const SurfacePlace& place) { return place.region != first->region; });
    if (end - first < fewest) continue;
    for (int step = 0; step <= force_steps; ++step) {
      const double force_n = press.least_force_n() * std::pow(10.0, static_cast<double>(step) / force_steps);
      const ReckonedError here = error_in({first, end}, press, way, force_n, shares);
      error.force_share = std::max(error.force_share, here.force_share);
      if (step == force_steps) error.mean_tilt_rad = std::max(error.mean_tilt_rad, here.mean_tilt_rad);
    }
  }
  return error;
}

}  // namespace fingerpad
