#include "scene/scene_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "scene/motion_values.hpp"
#include "scene/scene_key.hpp"
#include "scene/scene_values.hpp"
#include "scene/toml_table.hpp"

namespace fingerpad {
namespace {

/// A table named `key` at the top of the file; nullptr if there is none.
const TomlNode* find_table(const TomlNode& root, std::string_view key, const std::string& path) {
  const TomlEntry* entry = find_entry(root, key);
  if (entry == nullptr) return nullptr;
  if (!entry->value.is(TomlNode::Type::table)) {
    throw refused(place_text(path, entry->place),
                  fmt::format("'{}' must be a table, [{}], not {}", key, key, type_text(entry->value.type)));
  }
  return &entry->value;
}

/// The tables of an array of tables at the top of the file.
std::vector<const TomlNode*> find_tables(const TomlNode& root, std::string_view key,
                                         const std::string& path) {
  std::vector<const TomlNode*> tables;
  const TomlEntry* entry = find_entry(root, key);
  if (entry == nullptr) return tables;
  const auto refuse = [&](const TomlNode& value) {
    return refused(place_text(path, entry->place),
                   fmt::format("'{}' is {}; there may be several, so write it as [[{}]]", key,
                               type_text(value.type), key));
  };
  if (!entry->value.is(TomlNode::Type::array)) throw refuse(entry->value);
  for (const TomlNode& item : entry->value.items) {
    if (!item.is(TomlNode::Type::table)) throw refuse(item);
    tables.push_back(&item);
  }
  return tables;
}

void refuse_mu_dynamic_above(const SurfaceProperties& surface, const TomlTable& table) {
  if (surface.mu_dynamic <= surface.mu_static) return;
  const char* key = table.has("mu_dynamic") ? "mu_dynamic" : "mu_static";
  throw table.error(key, fmt::format("mu_dynamic {} is above mu_static {}{}", number_text(surface.mu_dynamic),
                                     number_text(surface.mu_static),
                                     table.has("mu_dynamic") && table.has("mu_static")
                                         ? ""
                                         : " (one of them is the default; give both)"));
}

void read_part(const TomlNode& node, Missing missing, Scene& scene) {
  const SceneTable& rows = scene_table("part");
  const TomlTable table = open_table(node, scene.path, rows);
  scene.parts.emplace_back();
  if (missing != Missing::mesh) table.require("mesh");
  read_keys(rows, table, scene);
  refuse_mu_dynamic_above(scene.parts.back().surface, table);
}

void read_plane(const TomlNode& node, Scene& scene) {
  const SceneTable& rows = scene_table("plane");
  const TomlTable table = open_table(node, scene.path, rows);
  scene.planes.emplace_back();
  read_keys(rows, table, scene);
  refuse_mu_dynamic_above(scene.planes.back().surface, table);
}

/// Reads one of the tables that may stand once, if it does.
void read_table(const TomlNode& root, std::string_view name, Scene& scene) {
  const TomlNode* node = find_table(root, name, scene.path);
  if (node == nullptr) return;
  const SceneTable& rows = scene_table(name);
  read_keys(rows, open_table(*node, scene.path, rows), scene);
}

/// For what is known only once the parts are loaded.
void note_radius_place(const TomlNode& root, Scene& scene) {
  const TomlNode* const finger = find_table(root, "finger", scene.path);
  const TomlEntry* const radius = finger != nullptr ? find_entry(*finger, "radius_m") : nullptr;
  if (radius != nullptr) scene.finger.radius_place = place_text(scene.path, radius->value.place);
}

/// A motion that is laid on the first part, or placed in its frame, needs one.
void refuse_no_part(const TomlNode& motion_node, const Scene& scene) {
  if (!scene.parts.empty() || (!scene.motion.laid && !scene.motion.placement.in_part)) return;
  const TomlTable motion = open_table(motion_node, scene.path, scene_table("motion"));
  const char* key = scene.motion.laid ? "kind" : "frame";
  throw motion.error(key, motion.name(key) + " is of the first [[part]], and the scene has none");
}

void read_hand(const TomlNode& root, Scene& scene) {
  const TomlNode* node = find_table(root, "hand", scene.path);
  if (node == nullptr) return;
  scene.hand.emplace();
  read_table(root, "hand", scene);
  if (!scene.motion.is_rate_open())  // which is not known yet: load_motion asks then
    refuse_hand_too_quick(*scene.hand, scene.motion.rate_hz, place_text(scene.path, node->place));
}

/// What a recording says of the finger itself, where a hand moves it otherwise.
void refuse_measured_in_a_hand(const TomlNode& motion_node, const Scene& scene) {
  if (!scene.hand) return;
  const TomlTable motion = open_table(motion_node, scene.path, scene_table("motion"));
  if (scene.motion.format.reads_normal_force) {
    throw motion.error("normal_force", motion.name("normal_force") +
                                           " cannot be \"measured\" in a scene with a [hand], whose finger "
                                           "goes and presses as the hand lets it");
  }
  if (scene.motion.encoder_m > 0) {
    throw motion.error("encoder_m", motion.name("encoder_m") +
                                        " is of a finger that follows its motion exactly: in a scene with a "
                                        "[hand] say encoder_m there");
  }
}

}  // namespace

void refuse_hand_too_quick(const HandSettings& hand, double rate_hz, const std::string& place) {
  constexpr double most = 1e9;
  const double quickness = std::max(hand.stiffness_n_per_m, hand.damping_n_s_per_m) / hand.mass_kg / rate_hz;
  if (quickness <= most) return;
  throw refused(place,
                fmt::format("a [hand] of {} kg with {} N/m and {} N s/m moves too quickly for ticks at {} "
                            "Hz: stiffness_n_per_m and damping_n_s_per_m may be at most 1e9 times mass_kg "
                            "times rate_hz",
                            number_text(hand.mass_kg), number_text(hand.stiffness_n_per_m),
                            number_text(hand.damping_n_s_per_m), number_text(rate_hz)));
}

Scene read_scene(const TomlNode& root, const std::string& path, Missing missing) {
  const SceneTable& rows = scene_table("");
  const TomlTable top = open_table(root, path, rows);
  Scene scene;
  scene.path = path;
  scene.name = name_of_file(path);
  read_keys(rows, top, scene);
  for (const TomlNode* node : find_tables(root, "part", path)) {
    // A set's mesh goes to the first part.
    read_part(*node, scene.parts.empty() ? missing : Missing::nothing, scene);
  }
  for (const TomlNode* node : find_tables(root, "plane", path)) read_plane(*node, scene);
  if (scene.parts.empty() && scene.planes.empty() && missing == Missing::nothing) {
    throw refused(path,
                  "the scene has nothing to touch: it needs a [[part]] with 'mesh', or a [[plane]] with "
                  "'point_m' and 'normal'");
  }
  for (const char* name : {"contact", "friction", "finger", "device"}) read_table(root, name, scene);
  note_radius_place(root, scene);
  if (const TomlNode* node = find_table(root, "motion", path)) {
    read_motion_settings(*node, scene);
    if (missing == Missing::nothing) refuse_no_part(*node, scene);
  }
  read_hand(root, scene);
  if (const TomlNode* node = find_table(root, "motion", path)) refuse_measured_in_a_hand(*node, scene);
  return scene;
}

}  // namespace fingerpad
