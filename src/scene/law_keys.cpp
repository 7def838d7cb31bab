#include "scene/law_keys.hpp"

#include <algorithm>
#include <array>

#include "friction/law_table.hpp"
#include "scene/scene_key_makers.hpp"
#include "scene/scene_values.hpp"

namespace fingerpad {
namespace {

/// For numbers of laws, which have many units: below and above these only powers of them lose meaning.
constexpr double least_of_a_law = 1e-12, most_of_a_law = 1e12;

NumberRange law_range(const LawParameter& parameter) {
  const bool above_min = !parameter.min_allowed;
  const bool from_nothing = above_min && parameter.min == 0;
  return {from_nothing ? least_of_a_law : parameter.min, std::min(parameter.max, most_of_a_law),
          above_min && !from_nothing};
}

const LawParameter* find_parameter(const LawEntry& law, std::string_view key) {
  const auto found = std::find_if(law.parameters.begin(), law.parameters.end(),
                                  [key](const LawParameter& parameter) { return parameter.key == key; });
  return found == law.parameters.end() ? nullptr : &*found;
}

bool chooses(const LawEntry& law, std::string_view key) {
  return std::find(law.choices.begin(), law.choices.end(), key) != law.choices.end();
}

std::vector<std::string_view> laws_that_read(std::string_view key) {
  std::vector<std::string_view> laws;
  for (const LawEntry& law : law_table()) {
    if (find_parameter(law, key) != nullptr || chooses(law, key)) laws.push_back(law.name);
  }
  return laws;
}

void read_law_number(const SceneKey& row, const TomlTable& table, Scene& scene) {
  const LawParameter* own = find_parameter(*find_law(scene.friction.law), row.key);
  const NumberRange range = own != nullptr ? law_range(*own) : row.range;
  scene.friction.settings.numbers[std::string(row.key)] = table.number(row.key, 0, range);
}

SceneKey number_row(const LawParameter& parameter) {
  SceneKey row{parameter.key, KeyType::number, parameter.meaning};
  if (find_parameter(*find_law(FrictionSettings().law), parameter.key) != nullptr)
    row.shown = number_text(parameter.default_value);
  row.range = law_range(parameter);
  row.only_with = laws_that_read(parameter.key);
  row.read = read_law_number;
  return row;
}

void take_law(Scene& scene, std::string_view word) {
  scene.friction.law = word;
}

void take_restick(Scene& scene, std::size_t word) {
  scene.friction.settings.restick = std::array{Restick::level, Restick::crossing}[word];
}

void take_remedy(Scene& scene, std::size_t word) {
  scene.friction.settings.remedy =
      std::array{Remedy::none, Remedy::damping, Remedy::implicit, Remedy::cap}[word];
}

void take_events(Scene& scene, std::size_t word) {
  scene.friction.settings.events = std::array{Events::exact, Events::tick}[word];
}

SceneKey law_key() {
  std::vector<std::string> names;
  for (const LawEntry& law : law_table()) names.emplace_back(law.name);
  return choice_key<take_law>("law", names, FrictionSettings().law, "or one of the table of laws");
}

}  // namespace

std::vector<SceneKey> friction_keys() {
  std::vector<SceneKey> keys{law_key()};
  for (const LawEntry& law : law_table()) {
    for (const LawParameter& parameter : law.parameters) {
      const auto is_same = [&](const SceneKey& row) { return row.key == parameter.key; };
      if (std::none_of(keys.begin(), keys.end(), is_same)) keys.push_back(number_row(parameter));
    }
  }
  keys.push_back(only_with(laws_that_read("restick"),
                           choice_key<take_restick>("restick", {"level", "crossing"}, "level",
                                                    "it sticks only when the speed falls through v_min")));
  keys.push_back(
      only_with(laws_that_read("remedy"),
                choice_key<take_remedy>("remedy", {"none", "damping", "implicit", "cap"}, "none",
                                        "for a stick spring too stiff for the loop, told when it acts")));
  keys.push_back(only_with(laws_that_read("events"),
                           choice_key<take_events>("events", {"exact", "tick"}, "exact",
                                                   "where rupture and restick are looked for: within the "
                                                   "tick, or at ticks only, as a comparison")));
  keys.push_back(table_key("vibration", "false", read_vibration));
  return keys;
}

}  // namespace fingerpad
