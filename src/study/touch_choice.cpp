#include "study/touch_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "contact/contact_method_table.hpp"
#include "friction/law_table.hpp"
#include "scene/scene.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

bool has_events(const Scene& scene) {
  const LawEntry* law = find_law(scene.friction.law);
  return law != nullptr &&
         std::find(law->choices.begin(), law->choices.end(), "events") != law->choices.end();
}

}  // namespace

std::string TouchChoice::name() const {
  return fmt::format("{}, {}, {} Hz, events {}", method, normals->name, number_text(rate_hz),
                     events_word(events));
}

std::string_view events_word(Events events) noexcept {
  return events == Events::exact ? "exact" : "tick";
}

std::vector<TouchChoice> touch_choices(const Scene& scene, const World& world) {
  const bool one_is_as_all = needs_no_method(world);
  std::vector<TouchChoice> choices;
  for (const ContactMethodEntry& method : contact_method_table()) {
    for (const Normals normals : normals_table()) {
      for (const double rate_hz : choice_rates_hz) {
        choices.push_back({std::string(method.name), normals, rate_hz, Events::exact});
        if (has_events(scene)) choices.push_back({std::string(method.name), normals, rate_hz, Events::tick});
      }
      if (one_is_as_all) return choices;
    }
  }
  return choices;
}

TouchChoice model_choice() {
  return {std::string(contact_method_table().back().name), normals_table().back(), model_rate_hz,
          Events::exact};
}

Scene touched_by(Scene scene, const TouchChoice& choice) {
  scene.contact.method = choice.method;
  scene.contact.normals = choice.normals;
  scene.contact.automatic_normals = false;
  scene.motion.rate_hz = choice.rate_hz;
  scene.motion.rate_given = true;
  scene.motion.automatic_rate = false;
  scene.friction.settings.events = choice.events;
  scene.friction.vibration.reset();
  return scene;
}

void prepare_normals(const World& world) {
  for (const Normals normals : normals_table()) {
    if (normals->prepare == nullptr) continue;
    for (const Surface& surface : world.surfaces) {
      if (surface.tree) normals->prepare(*surface.tree);
    }
  }
}

}  // namespace fingerpad
