#include "touch/contact_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/scene.hpp"
#include "touch/contact_case.hpp"
#include "touch/contact_mend.hpp"
#include "touch/contact_reasons.hpp"
#include "touch/world.hpp"

namespace fingerpad {

bool leaves_a_choice(const ContactSettings& contact) noexcept {
  return contact.method == automatic_method || contact.automatic_normals;
}

ContactChoice choose_contact(const Scene& scene, std::span<const Surface> surfaces,
                             std::span<const PartMeasures> measures) {
  const ContactSettings& asked = scene.contact;
  ContactChoice choice;
  choice.normals = asked.normals;
  if (asked.method != automatic_method) choice.method = asked.method;
  if (!leaves_a_choice(asked) || measures.empty()) return choice;

  const ContactVerdict verdict = reckon_verdict(scene, surfaces, contact_cases(scene, surfaces, measures));
  if (verdict.all.empty()) return choice;  // a method that no table has: Touch refuses it
  choice.method = verdict.chosen().method->name;
  choice.normals = verdict.chosen().normals;
  for (std::size_t i = 0; i < verdict.cases.size(); ++i) {
    const bool is_kept = verdict.unkept_on(i) == Unkept::nothing;
    const std::string mend = is_kept ? "" : mend_of(scene, surfaces, measures, verdict, i);
    choice.limits.push_back(limit_of(verdict, i, mend));
    choice.reasons.push_back(reason_of(verdict, i, choice.limits[i].kept_tolerance));
  }
  for (std::size_t i = 0; i < verdict.cases.size(); ++i) {
    if (!choice.limits[i].said.empty())
      choice.reasons.push_back(fmt::format("{}: {} (auto)", verdict.cases[i].file, choice.limits[i].said));
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
