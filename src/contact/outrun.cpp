#include "contact/outrun.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "contact/proxy_limits.hpp"
#include "contact/proxy_memory_limits.hpp"
#include "contact/reckoned_error.hpp"
#include "contact/surface_places.hpp"
#include "part/part.hpp"

namespace fingerpad {
namespace {

using Limits = ProxyMemoryLimits;

// The fit, see proxy_looks().
constexpr double looks_per_view = 164, views_power = 0.695, triangles_power = 0.597;
/// Of a tick's looks. Of the 197 rubs none that is reckoned below this is off by more than its facets.
constexpr double sure_share = 0.75;
/// Fewer facets than this from tick to tick are no going round.
constexpr double least_facets = 2;
/// Of all places: a region of fewer is not judged (as reckoned_error).
constexpr double least_region_share = 1.0 / 2000;

double area_m2(const Part& part, int triangle) noexcept {
  const Vec3 a = part.vertices.col(part.triangles(0, triangle)),
             b = part.vertices.col(part.triangles(1, triangle)),
             c = part.vertices.col(part.triangles(2, triangle));
  return (b - a).cross(c - a).norm() / 2;
}

/// A view shows what comes within its reach of the ball: of the surface an ellipse, whose half axes are a
/// along the finger's way and b across it, where the surface is taken for straight.
double triangles_in_view(const Part& part, const SurfacePlace& place, double radius_m, double reach_m,
                         int finer) noexcept {
  double a = reach_m, b = reach_m;
  if (radius_m > 0) {
    a = std::sqrt(2 * reach_m / (1 / radius_m + place.curvature_per_m));
    b = std::sqrt(2 * reach_m * radius_m);
  }
  const double area = area_m2(part, place.triangle) / (finer * finer),
               longest = 2 * area * finer / place.width_m;
  return 1 + (std::numbers::pi * a * b + longest * (a + b)) / area;
}

}  // namespace

double proxy_looks(const Part& part, std::span<const SurfacePlace> places, const Press& press, double step_m,
                   int finer) {
  if (!(step_m > 0)) return 0;
  const double radius_m = press.finger_radius_m, height_m = radius_m - press.greatest_depth_m();
  const double reach_m = std::min(Limits::first_view * part.half_extent.norm(),
                                  std::max(Limits::least_ticks * step_m, Limits::least_share * radius_m));
  const auto fewest = static_cast<std::ptrdiff_t>(least_region_share * static_cast<double>(places.size()));
  const auto looks_at = [&](const SurfacePlace& place) {
    const double c = place.curvature_per_m, room = 1 + height_m * c;
    if (!(c > 0 && room > 0 && place.width_m > 0 && place.triangle >= 0)) return 0.0;
    if (step_m * finer < least_facets * room * place.width_m) return 0.0;
    const double way_m = step_m * (1 + radius_m * c) / room;
    return looks_per_view * std::pow(way_m / reach_m, views_power) *
           std::pow(triangles_in_view(part, place, radius_m, reach_m, finer), triangles_power);
  };
  std::vector<double> looks;
  double most = 0;
  for (auto first = places.begin(), end = first; first != places.end(); first = end) {
    end = std::find_if(first, places.end(),
                       [&](const SurfacePlace& place) { return place.region != first->region; });
    if (end - first < fewest) continue;
    looks.resize(static_cast<std::size_t>(end - first));
    std::transform(first, end, looks.begin(), looks_at);
    const auto at = looks.end() - 1 - (end - first) / 100;
    std::nth_element(looks.begin(), at, looks.end());
    most = std::max(most, *at);
  }
  return most;
}

bool outruns_proxy(double looks) noexcept {
  return looks > sure_share * ProxyLimits::most_looks;
}

double step_share_for(double looks) noexcept {
  return std::pow(sure_share * ProxyLimits::most_looks / looks, 1 / views_power);
}

}  // namespace fingerpad
