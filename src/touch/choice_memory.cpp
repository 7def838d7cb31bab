#include "touch/choice_memory.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

/// Beyond that all are forgotten: each has sentences for its parts.
constexpr std::size_t most_choices = 4096;

void add_numbers(std::string& key, std::initializer_list<double> numbers) {
  for (const double number : numbers) key += number_text(number) + " ";
}

void add_surface(std::string& key, const Surface& surface) {
  const SurfaceProperties& properties = surface.properties;
  key += fmt::format("\n{} {} ", surface.mesh_hash, surface.mesh);
  add_numbers(key, {properties.stiffness_n_per_m, properties.damping_n_s_per_m, properties.mu_static,
                    properties.mu_dynamic});
  for (const Vec3& vector : {surface.p_WP, surface.plane_point_W, surface.plane_normal_W})
    add_numbers(key, {vector.x(), vector.y(), vector.z()});
  for (const double number : surface.R_WP.reshaped()) add_numbers(key, {number});
}

}  // namespace

std::optional<ContactChoice> ChoiceMemory::find(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = choices_.find(key);
  return found == choices_.end() ? std::nullopt : std::optional(found->second);
}

void ChoiceMemory::keep(const std::string& key, const ContactChoice& choice) {
  const std::lock_guard lock(mutex_);
  if (choices_.size() >= most_choices) choices_.clear();
  choices_.emplace(key, choice);
}

std::string choice_key(const Scene& scene, const World& world) {
  const ContactSettings& asked = scene.contact;
  std::string key = fmt::format("{} {} {} ", asked.method, asked.normals->name, asked.automatic_normals);
  add_numbers(key, {asked.force_tolerance, asked.mu_tolerance, asked.greatest_force_n, scene.finger.radius_m,
                    scene.motion.rate_hz});
  for (const Surface& surface : world.surfaces) add_surface(key, surface);
  for (const PartEntry& part : scene.parts) {  // how the file's triangles become a part
    key += part.repair ? "\nrepaired " : "\n";
    add_numbers(key, {part.metres_per_unit, part.crease_deg});
  }
  return key;
}

}  // namespace fingerpad
