#include "touch/contact_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "scene/scene.hpp"
#include "touch/contact_case.hpp"
#include "touch/contact_reasons.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

/// Where nothing keeps the tolerance, what costs less may be off by so much more than the best.
constexpr double nearly_best = 1.2;

/// The cheapest pair that holds and keeps the tolerances; else the cheapest of those that are nearly as good
/// as can be.
/// @param pairs  the most complete method's last
const ContactPair& best_of(const std::vector<ContactPair>& pairs, std::span<const ContactCase> cases) {
  const bool any_holds =
      std::any_of(pairs.begin(), pairs.end(), [](const ContactPair& pair) { return pair.holds(); });
  // Where none can do, the most complete lets no finger through.
  const auto may_be_taken = [&](const ContactPair& pair) {
    return any_holds ? pair.holds() : pair.method == pairs.back().method;
  };
  double least = std::numeric_limits<double>::infinity();
  for (const ContactPair& pair : pairs) {
    if (may_be_taken(pair)) least = std::min(least, pair.tolerances(cases));
  }
  const double allowed = least <= 1 ? 1 : nearly_best * least;
  const ContactPair* best = nullptr;
  for (const ContactPair& pair : pairs) {
    if (!may_be_taken(pair) || pair.tolerances(cases) > allowed) continue;
    if (best == nullptr || pair.cost < best->cost) best = &pair;
  }
  return *best;
}

}  // namespace

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

  const std::vector<ContactCase> cases = contact_cases(scene, surfaces, measures);
  const std::vector<ContactPair> pairs = contact_pairs(scene, surfaces, cases);
  if (pairs.empty()) return choice;  // a method that no table has: Touch refuses it
  const ContactPair& best = best_of(pairs, cases);
  const ContactVerdict verdict{best, pairs, asked.method == automatic_method, asked.automatic_normals};
  choice.method = best.method->name;
  choice.normals = best.normals;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    choice.reasons.push_back(reason_of(verdict, cases, i));
    choice.limits.push_back(limit_of(verdict, cases, i));
  }
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!choice.limits[i].said.empty())
      choice.reasons.push_back(fmt::format("{}: {} (auto)", cases[i].file, choice.limits[i].said));
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
