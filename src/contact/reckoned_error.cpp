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

/// Across the force [rad].
double tilt_rad(const Way& way, const SurfacePlace& place, double height_m) noexcept {
  const double u = height_m * place.curvature_per_m;
  double off = 0;
  if (way.touches_patches)
    off = place.patch_rad;
  else if (way.shows_facets)
    off = place.facet_rad * facet_turn(u, height_m < 0, way.lags);
  else
    off = way.off_rad(place) + place.facet_rad * foot_turn(u);
  return std::min(off, whole_force);
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

/// The least share that all but so much of the weight is not above.
double quantile(const std::vector<Weighed>& falling, double beyond) {
  double all = 0;
  for (const Weighed& one : falling) all += one.weight;
  double sum = 0;
  for (const Weighed& one : falling) {
    sum += one.weight;
    if (sum > beyond * all) return one.share;
  }
  return 0;
}

}  // namespace

ReckonedError reckoned_error(std::span<const SurfacePlace> places, const Press& press,
                             const ContactMethodEntry& method, Normals normals) {
  ReckonedError error;
  if (places.empty()) return error;
  const Way way{method.touches_own_surface && normals->own_surface != nullptr, normals->shade == nullptr,
                method.lags_on_facets, normals->off_rad};
  std::vector<Weighed> shares(places.size());
  for (int step = 0; step <= force_steps; ++step) {
    const double force_n = press.least_force_n() * std::pow(10.0, static_cast<double>(step) / force_steps);
    const double height_m = press.finger_radius_m - force_n / press.stiffness_n_per_m;
    double tilts = 0, weights = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double tilt = tilt_rad(way, places[i], height_m);
      const double weight = way_there(places[i], height_m, press.finger_radius_m);
      shares[i] = {std::hypot(press.stiffness_n_per_m * sag_m(way, places[i]) / force_n, tilt), weight};
      tilts += weight * tilt;
      weights += weight;
    }
    std::sort(shares.begin(), shares.end(),
              [](const Weighed& a, const Weighed& b) { return a.share > b.share; });
    error.force_share = std::max(error.force_share, quantile(shares, 0.01));
    error.largest_share = std::max(error.largest_share, quantile(shares, 0.001));
    error.mean_tilt_rad = weights > 0 ? tilts / weights : 0;
  }
  return error;
}

}  // namespace fingerpad
