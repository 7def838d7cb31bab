#include "touch/contact_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>

#include "base/number_text.hpp"
#include "contact/contact_cost.hpp"
#include "part/part.hpp"
#include "scene/scene.hpp"
#include "touch/contact_choice.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

/// The greatest press is told as "10 N at 1000 N/m presses 10 mm deep", and the way in a tick where that is
/// more.
ContactDemand demand_of(const Scene& scene, const Surface& surface, const PartMeasures& part,
                        const Nearby& nearby) {
  const double force_n = scene.contact.greatest_force_n, radius_m = scene.finger.radius_m;
  const double stiffness_n_per_m = surface.properties.stiffness_n_per_m,
               depth_m = force_n / stiffness_n_per_m, tick_m = choice_speed_m_per_s / scene.motion.rate_hz;
  ContactDemand demand{part};
  demand.finger_radius_m = radius_m;
  demand.force_tolerance = scene.contact.force_tolerance;
  demand.centre_depth_m = depth_m - radius_m + tick_m;
  demand.press = fmt::format(
      "{} N at {} N/m presses {}{} mm deep", rounded_text(force_n, 3), rounded_text(stiffness_n_per_m, 4),
      radius_m > 0 ? fmt::format("a {} mm finger ", rounded_text(1e3 * radius_m, 3)) : "",
      rounded_text(1e3 * depth_m, 3));
  if (tick_m > depth_m)
    demand.press += fmt::format(", and a tick at {} Hz takes a finger of {} m/s {} mm farther",
                                rounded_text(scene.motion.rate_hz, 3), rounded_text(choice_speed_m_per_s, 3),
                                rounded_text(1e3 * tick_m, 3));
  demand.crowded = nearby.crowded;
  demand.has_neighbour = nearby.has_neighbour;
  return demand;
}

/// The tilt of the normals is an error of the coefficient of friction that is felt; what a choice must keep
/// of that is its mean.
double allowed_mean_tilt_rad(const ContactSettings& contact, double mu) {
  return mu > 0 ? contact.mu_tolerance * mu : std::numeric_limits<double>::infinity();
}

bool is_open(const Scene& scene, const ContactMethodEntry& method) {
  return scene.contact.method == automatic_method ? method.fails != nullptr
                                                  : scene.contact.method == method.name;
}

bool is_open(const Scene& scene, Normals normals) {
  return scene.contact.automatic_normals ? normals->off_rad != nullptr : scene.contact.normals == normals;
}

}  // namespace

double across_m(const Part& part) noexcept {
  const Vec3 half = part.half_extent;
  return 2 * std::max(std::min(half.x(), half.y()), std::min(std::max(half.x(), half.y()), half.z()));
}

bool has_neighbour(std::span<const Surface> surfaces, const Surface& surface, double finger_radius_m) {
  const WorldBox box = world_box(surface);
  return std::any_of(surfaces.begin(), surfaces.end(), [&](const Surface& other) {
    return &other != &surface && comes_within(other, box, 2 * finger_radius_m);
  });
}

ContactCase contact_case(const Scene& scene, const Surface& surface, const PartMeasures& measures,
                         const Nearby& nearby) {
  return {std::filesystem::path(surface.mesh).filename().string(),
          demand_of(scene, surface, measures, nearby),
          {surface.properties.stiffness_n_per_m, scene.finger.radius_m, scene.contact.greatest_force_n},
          across_m(*surface.part),
          scene.contact.mu_tolerance,
          allowed_mean_tilt_rad(scene.contact, surface.properties.mu_dynamic)};
}

std::vector<ContactCase> contact_cases(const Scene& scene, std::span<const Surface> surfaces,
                                       std::span<const PartMeasures> measures) {
  std::vector<ContactCase> cases;
  cases.reserve(measures.size());
  const double radius_m = scene.finger.radius_m;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const Surface& surface = surfaces[i];
    cases.push_back(contact_case(scene, surface, measures[i],
                                 {most_crowded_hollow(*surface.tree, measures[i].places, radius_m),
                                  has_neighbour(surfaces, surface, radius_m)}));
  }
  return cases;
}

bool ContactPair::holds() const {
  return std::all_of(fails.begin(), fails.end(), [](const std::string& why) { return why.empty(); });
}

bool ContactPair::gets_round(std::span<const ContactCase> cases) const {
  if (!normals->shows_facets()) return true;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (errors[i].behind_share > cases[i].contact.force_tolerance) return false;
  return true;
}

double ContactPair::tolerances(std::span<const ContactCase> cases, std::size_t i) const {
  return std::max(errors[i].force_share / cases[i].contact.force_tolerance,
                  errors[i].mean_tilt_rad / cases[i].mean_tilt_rad);
}

double ContactPair::tolerances(std::span<const ContactCase> cases) const {
  double most = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) most = std::max(most, tolerances(cases, i));
  return most;
}

namespace {

/// @param most_force, most_mu  errors count as no more than that
double misses_of(const ContactPair& pair, std::span<const ContactCase> cases, double most_force,
                 double most_mu) {
  double most = 1;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    double product = 1;
    for (std::size_t k = 0; k < ReckonedError::forces; ++k)
      product *= std::max(
          {1.0, std::min(most_force, pair.errors[i].force_shares[k]) / cases[i].contact.force_tolerance,
           std::min(most_mu / cases[i].mu_tolerance,
                    pair.errors[i].mean_tilts_rad[k] / cases[i].mean_tilt_rad)});
    most = std::max(most, std::pow(product, 1.0 / static_cast<double>(ReckonedError::forces)));
  }
  return most;
}

}  // namespace

double ContactPair::misses(std::span<const ContactCase> cases) const {
  constexpr double any = std::numeric_limits<double>::infinity();
  return misses_of(*this, cases, any, any);
}

double ContactPair::told_misses(std::span<const ContactCase> cases) const {
  return misses_of(*this, cases, most_force_kept, most_mu_kept);
}

std::vector<ContactPair> contact_pairs(const Scene& scene, std::span<const Surface> surfaces,
                                       std::span<const ContactCase> cases, ErrorMemory& errors) {
  std::vector<ContactPair> pairs;
  for (const ContactMethodEntry& method : contact_method_table()) {
    for (const Normals normals : normals_table()) {
      if (!is_open(scene, method) || !is_open(scene, normals)) continue;
      // What no table of costs knows is taken for dearer than all that it does.
      const auto cost =
          contact_cost(method.name, normals->name, triangles_of(surfaces), scene.finger.radius_m > 0);
      ContactPair pair{&method, normals, cost.value_or(std::numeric_limits<double>::infinity())};
      for (const ContactCase& one : cases) {
        pair.errors.push_back(normals->off_rad == nullptr ? ReckonedError()
                                                          : errors.error(one, method, normals));
        pair.fails.push_back(method.fails == nullptr ? "" : method.fails(one.contact));
        const ReckonedError& error = pair.errors.back();
        if (pair.fails.back().empty() && error.behind_share > one.contact.force_tolerance)
          pair.fails.back() = fmt::format("{}, and falls behind where it goes round a rounding of {} mm",
                                          one.contact.press, rounded_text(1e3 * error.behind_m, 2));
      }
      pairs.push_back(std::move(pair));
    }
  }
  return pairs;
}

}  // namespace fingerpad
