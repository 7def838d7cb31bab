#include "touch/contact_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "contact/contact_method_table.hpp"
#include "contact/part_measures.hpp"
#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

/// What one part needs, a row of a table by its number, and why.
struct Need {
  std::size_t what = 0;
  std::string why;
};

/// What a scene asks of contact with one part. The greatest press is told as "10 N at 1000 N/m presses 10 mm
/// deep".
ContactDemand demand_of(const Scene& scene, std::span<const Surface> surfaces, const Surface& surface,
                        const PartMeasures& part) {
  const double force_n = scene.contact.greatest_force_n, radius_m = scene.finger.radius_m;
  const double stiffness_n_per_m = surface.properties.stiffness_n_per_m,
               depth_m = force_n / stiffness_n_per_m;
  const WorldBox box = world_box(surface);
  ContactDemand demand{part};
  demand.finger_radius_m = radius_m;
  demand.force_tolerance = scene.contact.force_tolerance;
  demand.centre_depth_m = depth_m - radius_m + choice_speed_m_per_s / scene.motion.rate_hz;
  demand.press =
      fmt::format("{:.3g} N at {:.4g} N/m presses {}{:.3g} mm deep", force_n, stiffness_n_per_m,
                  radius_m > 0 ? fmt::format("a {:.3g} mm finger ", 1e3 * radius_m) : "", 1e3 * depth_m);
  demand.has_neighbour = std::any_of(surfaces.begin(), surfaces.end(), [&](const Surface& other) {
    return &other != &surface && comes_within(other, box, 2 * radius_m);
  });
  return demand;
}

/// What it asks of the normals there. Tilt and sag may not cost more than the tolerances of force and mu.
NormalsDemand demand_of(const Scene& scene, const Surface& surface, const PartMeasures& part,
                        const ContactMethodEntry& method) {
  const ContactSettings& contact = scene.contact;
  const double mu = surface.properties.mu_dynamic;
  NormalsDemand demand{part};
  demand.tilt_rad = contact.force_tolerance;
  if (mu > 0) demand.tilt_rad = std::min(demand.tilt_rad, contact.mu_tolerance * mu);
  demand.sag_m = contact.force_tolerance * (contact.greatest_force_n / surface.properties.stiffness_n_per_m);
  demand.touches_own_surface = method.touches_own_surface;
  return demand;
}

/// The last row of a table that says it is needed; the first where none does.
/// @param needed_of  (row): its rule, or null
template <typename Row, typename NeededOf, typename Demand>
Need last_needed(std::span<const Row> table, NeededOf needed_of, const Demand& demand) {
  Need last;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto needed = needed_of(table[i]);
    std::string why = needed != nullptr ? needed(demand) : std::string();
    if (!why.empty()) last = {i, std::move(why)};
  }
  return last;
}

std::string file_of(const Surface& surface) {
  return std::filesystem::path(surface.mesh).filename().string();
}

/// What all parts get, because one of them needs the most.
struct Shared {
  std::size_t what = 0, needed_by = 0;

  explicit Shared(const std::vector<Need>& needs) : what(needs.front().what) {
    for (std::size_t i = 1; i < needs.size(); ++i) {
      if (needs[i].what <= what) continue;
      what = needs[i].what;
      needed_by = i;
    }
  }
  std::string why(const std::vector<Need>& needs, std::size_t i, std::span<const Surface> surfaces) const {
    return needs[i].what == what ? needs[i].why : file_of(surfaces[needed_by]) + " needs it";
  }
};

}  // namespace

bool leaves_a_choice(const ContactSettings& contact) noexcept {
  return contact.method == automatic_method || contact.automatic_normals;
}

ContactChoice choose_contact(const Scene& scene, std::span<const Surface> surfaces,
                             std::span<const PartMeasures> measures) {
  const ContactSettings& asked = scene.contact;
  const bool method_open = asked.method == automatic_method;
  ContactChoice choice;
  choice.normals = asked.normals;
  if (!method_open) choice.method = asked.method;
  if (!leaves_a_choice(asked) || measures.empty()) return choice;

  const auto methods = contact_method_table();
  std::vector<Need> method_needs, normals_needs;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    method_needs.push_back(last_needed(
        methods, [](const ContactMethodEntry& method) { return method.needed; },
        demand_of(scene, surfaces, surfaces[i], measures[i])));
  }
  const Shared method(method_needs);
  if (method_open) choice.method = methods[method.what].name;
  const ContactMethodEntry* chosen = find_contact_method(choice.method);
  if (chosen == nullptr) return choice;  // that no table has: Touch refuses it
  for (std::size_t i = 0; i < measures.size(); ++i) {
    normals_needs.push_back(last_needed(
        normals_table(), [](Normals normals) { return normals->needed; },
        demand_of(scene, surfaces[i], measures[i], *chosen)));
  }
  const Shared normals(normals_needs);
  if (asked.automatic_normals) choice.normals = normals_table()[normals.what];
  for (std::size_t i = 0; i < measures.size(); ++i) {
    std::string line = file_of(surfaces[i]) + ": ";
    if (method_open)
      line += fmt::format("{}, because {}", choice.method, method.why(method_needs, i, surfaces));
    if (method_open && asked.automatic_normals) line += "; ";
    if (asked.automatic_normals) {
      line += fmt::format("{} normals, because {}", choice.normals->name,
                          normals.why(normals_needs, i, surfaces));
    }
    choice.reasons.push_back(line + " (auto)");
  }
  return choice;
}

ContactChoice settled_contact(const Scene& scene, const World& world) {
  ContactChoice settled;
  if (world.contact) settled = *world.contact;
  if (scene.contact.method != automatic_method) settled.method = scene.contact.method;
  if (!scene.contact.automatic_normals) settled.normals = scene.contact.normals;
  return settled;
}

std::string_view method_in(const World& world, std::string_view method) noexcept {
  const bool planes_only = std::all_of(world.surfaces.begin(), world.surfaces.end(),
                                       [](const Surface& surface) { return surface.is_plane(); });
  return planes_only ? "plane" : method;
}

}  // namespace fingerpad
