#include "touch/contact_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "contact/contact_method_table.hpp"
#include "scene/scene.hpp"
#include "touch/contact_case.hpp"
#include "touch/contact_mend.hpp"
#include "touch/contact_reasons.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

/// What mends each part that is not kept. It is looked for on the first part of each kind, and told of all
/// that it mends alike.
std::vector<std::string> mends_of(const Scene& scene, ContactReckoning& reckoning,
                                  const ContactVerdict& verdict) {
  std::vector<std::string> mends(verdict.cases.size());
  std::vector<std::size_t> looked_at;
  for (std::size_t i = 0; i < mends.size(); ++i) {
    const Unkept unkept = verdict.unkept_on(i);
    if (unkept == Unkept::nothing) continue;
    const auto alike = std::find_if(looked_at.begin(), looked_at.end(),
                                    [&](std::size_t j) { return is_mended_alike(verdict, i, j); });
    const auto of_kind = std::find_if(looked_at.begin(), looked_at.end(),
                                      [&](std::size_t j) { return verdict.unkept_on(j) == unkept; });
    if (alike != looked_at.end()) {
      mends[i] = mends[*alike];
    } else if (of_kind != looked_at.end()) {
      mends[i] = fmt::format("what would is only looked for on {}", verdict.cases[*of_kind].file);
    } else {
      mends[i] = mend_of(scene, reckoning, verdict, i);
      looked_at.push_back(i);
    }
  }
  return mends;
}

/// Of a rub that presses less hard than `greatest_force_n`, for which the choice is made: which number to
/// give. Empty for any other motion.
std::string lighter_press_words(const Scene& scene) {
  const double asked_n = scene.motion.laid ? scene.motion.laid->normal_force_n : 0;
  if (!(asked_n > 0) || !(asked_n < scene.contact.greatest_force_n)) return "";
  return fmt::format(
      "; reckoned for contact.greatest_force_n = {0}, though the motion asks for {1} N: with "
      "greatest_force_n = {1} less has to be kept",
      rounded_text(scene.contact.greatest_force_n, 3), rounded_text(asked_n, 3));
}

/// Planes alone keep any tolerance, but that of two which meet the nearest alone would hold.
void choose_among_planes(std::span<const Surface> planes, ContactChoice& choice) {
  const auto rows = contact_method_table();
  const auto holds_corners = std::ranges::find_if(
      rows, [](const ContactMethodEntry& row) { return row.holds_several && row.fails != nullptr; });
  if (holds_corners == rows.end() || !any_planes_meet(planes)) return;
  choice.method = holds_corners->name;
  choice.reasons.push_back(fmt::format(
      "planes: {}, because two of them meet, and both hold a finger there (auto)", choice.method));
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
  if (!leaves_a_choice(asked)) return choice;
  if (measures.empty()) {
    if (asked.method == automatic_method) choose_among_planes(surfaces, choice);
    return choice;
  }

  ContactReckoning reckoning(surfaces, measures);
  const ContactVerdict verdict = reckoning.on_all(scene);
  if (verdict.all.empty()) return choice;  // a method that no table has: Touch refuses it
  choice.method = verdict.chosen().method->name;
  choice.normals = verdict.chosen().normals;
  const std::vector<std::string> mends = mends_of(scene, reckoning, verdict);
  for (std::size_t i = 0; i < verdict.cases.size(); ++i) {
    choice.limits.push_back(limit_of(verdict, i, mends[i]));
    if (!choice.limits[i].said.empty()) choice.limits[i].said += lighter_press_words(scene);
    choice.reasons.push_back(reason_of(verdict, i, choice.limits[i].kept_tolerance));
  }
  for (std::size_t i = 0; i < verdict.cases.size(); ++i) {
    if (!choice.limits[i].said.empty())
      choice.reasons.push_back(fmt::format("{}: {} (auto)", verdict.cases[i].file, choice.limits[i].said));
  }
  choice.reckoned = reckoning.reckoned();
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
  return needs_no_method(world) ? plane_kind.name : method;
}

}  // namespace fingerpad
