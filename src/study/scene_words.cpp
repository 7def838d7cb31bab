// What a study of a scene comes to, in words and as lines of a scene file.
#include <fmt/format.h>

#include "base/number_text.hpp"
#include "scene/scene.hpp"
#include "study/scene_study.hpp"

namespace fingerpad {
namespace {

/// A choice as far as the scene has one: a plane needs no method, a law without ruptures has no events.
std::string words_of(const SceneStudy& study, const TouchChoice& choice) {
  return fmt::format("{}{} Hz{}",
                     study.has_meshes ? fmt::format("{}, {}, ", choice.method, choice.normals->name) : "",
                     number_text(choice.rate_hz),
                     study.has_events ? fmt::format(", events {}", events_word(choice.events)) : "");
}

std::string cost_of(const ChoicePrice& price) {
  return fmt::format("{:.0f} ns a tick, {} % of a core", price.tick_ns, rounded_text(100 * price.load(), 2));
}

std::string tolerances_of(const Scene& scene) {
  return fmt::format("the force within {} % on 99 % of the ticks and friction within {} %",
                     rounded_text(100 * scene.contact.force_tolerance, 3),
                     rounded_text(100 * scene.contact.mu_tolerance, 3));
}

std::string why(const SceneStudyInput& input, const SceneStudy& study, const ChoicePrice& chosen) {
  if (!chosen.keeps()) {
    return fmt::format("none of {} choices keeps {}; this one is nearest ({}), but {}", study.prices.size(),
                       tolerances_of(input.scene), cost_of(chosen), fmt::join(chosen.broken, "; "));
  }
  return fmt::format(
      "of {} choices the cheapest that keeps {} over {} s of this motion, and of those within a tenth of "
      "its "
      "cost the truest: {}",
      study.prices.size(), tolerances_of(input.scene), rounded_text(study.compared_s, 4), cost_of(chosen));
}

/// What the next cheaper choice would have lost; empty where the chosen one keeps nothing itself.
std::string what_next_loses(const SceneStudy& study, const ChoicePrice& chosen) {
  if (!chosen.keeps()) return {};
  const ChoicePrice* next = next_cheaper(study.prices, chosen);
  if (next == nullptr) return "no choice is cheaper by more than a tenth";
  return fmt::format("the next one that is cheaper by more than a tenth ({}: {}) would have lost: {}",
                     words_of(study, next->choice), cost_of(*next), fmt::join(next->broken, "; "));
}

/// Lines of comment of at most 100 columns, the first letter large.
std::string commented(std::string text) {
  constexpr std::size_t widest = 98;
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  std::string lines;
  while (!text.empty()) {
    std::size_t end = text.size() > widest ? text.rfind(' ', widest) : text.size();
    if (end == std::string::npos || end == 0) end = text.size();
    lines += "# " + text.substr(0, end) + "\n";
    text.erase(0, end + 1);
  }
  return lines;
}

}  // namespace

std::string scene_lines(const SceneStudyInput& input, const SceneStudy& study) {
  const ChoicePrice& chosen = cheapest(study.prices);
  std::string lines = commented(fmt::format("For {}: {}.", input.scene.name, why(input, study, chosen)));
  const std::string lost = what_next_loses(study, chosen);
  if (!lost.empty()) lines += commented(lost + ".");
  lines += "# Put each line into the scene's own table of that name.\n";
  if (study.has_meshes) {
    lines += fmt::format("[contact]\nmethod = \"{}\"\nnormals = \"{}\"\n\n", chosen.choice.method,
                         chosen.choice.normals->name);
  }
  if (study.has_events)
    lines += fmt::format("[friction]\nevents = \"{}\"\n\n", events_word(chosen.choice.events));
  return lines + fmt::format("[motion]\nrate_hz = {}\n", number_text(chosen.choice.rate_hz));
}

std::string scene_verdict(const SceneStudyInput& input, const SceneStudy& study) {
  const ChoicePrice& chosen = cheapest(study.prices);
  const std::string lost = what_next_loses(study, chosen);
  return fmt::format("{}: {}: {}{}", input.scene.name, words_of(study, chosen.choice),
                     why(input, study, chosen), lost.empty() ? "" : "; " + lost);
}

}  // namespace fingerpad
