#include "scene/scene_change.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "base/csv_cells.hpp"
#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "contact/contact_method_table.hpp"
#include "friction/law_table.hpp"
#include "scene/scene_key.hpp"

namespace fingerpad {
namespace {

constexpr std::string_view changes_header = "t_s,key,value";
constexpr std::string_view part_prefix = "part.";

Error unknown(const SceneChange& change) {
  return refused("", fmt::format("'{} = {}' is no change of a scene that is touched",
                                 printable(change.key, 60), printable(change.value, 60)));
}

struct Property {
  std::string_view name;
  double SurfaceProperties::*member;
};
constexpr Property properties[] = {{"stiffness_n_per_m", &SurfaceProperties::stiffness_n_per_m},
                                   {"damping_n_s_per_m", &SurfaceProperties::damping_n_s_per_m},
                                   {"mu_static", &SurfaceProperties::mu_static},
                                   {"mu_dynamic", &SurfaceProperties::mu_dynamic}};

/// "part.K.NAME" -> K and NAME; -1 where it is none.
int surface_of_key(std::string_view key, std::string_view& name) {
  key.remove_prefix(part_prefix.size());
  const std::size_t dot = key.find('.');
  if (dot == std::string_view::npos) return -1;
  int surface = -1;
  const auto [end, fault] = std::from_chars(key.data(), key.data() + dot, surface);
  if (fault != std::errc() || end != key.data() + dot) return -1;
  name = key.substr(dot + 1);
  return surface;
}

void apply_to_surface(const SceneChange& change, Scene& scene) {
  std::string_view name;
  const int surface = surface_of_key(change.key, name);
  if (surface < 0 || static_cast<std::size_t>(surface) >= scene.parts.size() + scene.planes.size())
    throw unknown(change);
  const auto value = parse_number(change.value);
  for (const Property& property : properties) {
    if (property.name != name) continue;
    const NumberRange& range = find_scene_key(scene_table("part"), name)->range;
    SurfaceProperties changed = surface_properties(scene, surface);
    if (!value || !(*value >= range.min && *value <= range.max)) throw unknown(change);
    changed.*property.member = *value;
    if (changed.mu_dynamic > changed.mu_static) throw unknown(change);
    surface_properties(scene, surface) = changed;
    return;
  }
  throw unknown(change);
}

}  // namespace

SurfaceProperties& surface_properties(Scene& scene, int surface) {
  const auto index = static_cast<std::size_t>(surface);
  const std::size_t parts = scene.parts.size();
  return index < parts ? scene.parts[index].surface : scene.planes[index - parts].surface;
}

const SurfaceProperties& surface_properties(const Scene& scene, int surface) {
  return surface_properties(const_cast<Scene&>(scene), surface);  // which it does not change
}

std::string surface_key(int surface, std::string_view name) {
  return fmt::format("{}{}.{}", part_prefix, surface, name);
}

void apply(const SceneChange& change, Scene& scene) {
  if (change.key.starts_with(part_prefix)) return apply_to_surface(change, scene);
  if (change.key == "friction.law" && find_law(change.value) != nullptr) {
    scene.friction.law = change.value;
  } else if (change.key == "contact.method" && find_contact_method(change.value) != nullptr) {
    scene.contact.method = change.value;
  } else if (change.key == "contact.normals" && find_normals(change.value) != nullptr) {
    scene.contact.normals = *find_normals(change.value);
    scene.contact.automatic_normals = false;
  } else {
    throw unknown(change);
  }
}

std::string scene_changes_text(std::span<const SceneChange> changes) {
  std::string text = std::string(changes_header) + "\n";
  for (const SceneChange& change : changes)
    text += fmt::format("{},{},{}\n", number_text(change.t_s), change.key, change.value);
  return text;
}

std::vector<SceneChange> read_scene_changes(const std::string& text, const std::string& place) {
  std::vector<SceneChange> changes;
  std::size_t line_number = 0;
  for (std::size_t from = 0; from < text.size(); ++line_number) {
    // A line without its end was under way when the recording was cut short.
    const std::size_t end = text.find('\n', from);
    if (end == std::string::npos) break;
    const std::string line = text.substr(from, end - from);
    from = end + 1;
    const auto refuse = [&](const std::string& why) {
      return refused(place, fmt::format("line {} of its changes: {}", line_number + 1, why));
    };
    if (line_number == 0) {
      if (line != changes_header) throw refuse(fmt::format("is not '{}'", changes_header));
      continue;
    }
    const auto cells = csv_cells(line, ',');
    const auto t_s = cells.size() == 3 ? parse_number(cells[0]) : std::nullopt;
    if (!t_s || !std::isfinite(*t_s)) throw refuse("is no time, key and value");
    if (!changes.empty() && *t_s < changes.back().t_s) throw refuse("its time goes back");
    if (changes.size() == most_scene_changes)
      throw refuse(fmt::format("more than {} changes", most_scene_changes));
    changes.push_back({*t_s, std::string(cells[1]), std::string(cells[2])});
  }
  return changes;
}

}  // namespace fingerpad
