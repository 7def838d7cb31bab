#include "scene/scene_keys.hpp"

#include <algorithm>
#include <array>

#include "friction/law_table.hpp"

namespace fingerpad {
namespace {

/// The tables of a scene file and their keys. [friction] has those of the laws beside its own.
struct SceneTable {
  std::string_view name;
  std::vector<std::string> keys;
};

const std::vector<SceneTable>& scene_tables() {
  static const std::vector<SceneTable> tables = {
      {"", {"name", "seed", "part", "plane", "contact", "friction", "finger", "motion", "hand", "set"}},
      {"part",
       {"mesh", "unit", "position_m", "rotation", "crease_deg", "repair", "stiffness_n_per_m",
        "damping_n_s_per_m", "mu_static", "mu_dynamic"}},
      {"part.rotation", {"axis", "angle_deg"}},
      {"plane", {"point_m", "normal", "stiffness_n_per_m", "damping_n_s_per_m", "mu_static", "mu_dynamic"}},
      {"contact", {"method", "normals", "force_tolerance", "mu_tolerance", "greatest_force_n"}},
      {"friction", {"law", "restick", "remedy", "vibration", "v_min_m_per_s", "stick_stiffness_per_m"}},
      {"friction.vibration", {"frequency_hz", "bandwidth_hz", "amplitude", "normal_amplitude"}},
      {"finger", {"radius_m", "direction", "profile"}},
      {"motion",
       {"file", "rate_hz", "kind", "from_m", "to_m", "speed_m_per_s", "centre_m", "direction", "normal",
        "amplitude_m", "radius_m", "frequency_hz", "duration_s"}},
      {"hand",
       {"mass_kg", "damping_n_s_per_m", "stiffness_n_per_m", "encoder_m", "delay_ticks", "coulomb_n",
        "axes"}},
  };
  return tables;
}

/// Keys of the file itself that are values; `name` is left out of sets, since it names their files.
constexpr std::string_view plain_set_key = "seed";

bool has_key(std::string_view table, std::string_view key) {
  const std::vector<std::string> keys = scene_keys(table);
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace

std::vector<std::string> scene_keys(std::string_view table) {
  std::vector<std::string> keys;
  for (const SceneTable& candidate : scene_tables()) {
    if (candidate.name == table) keys = candidate.keys;
  }
  if (table != "friction") return keys;
  for (const LawEntry& law : law_table()) {
    for (const LawParameter& parameter : law.parameters) {
      if (std::find(keys.begin(), keys.end(), parameter.key) == keys.end()) keys.emplace_back(parameter.key);
    }
  }
  return keys;
}

std::optional<std::string> set_key_target(std::string_view key) {
  if (key == plain_set_key) return std::string(key);
  if (key == "mesh") return "part.mesh";
  if (key == "motion") return "motion.file";
  const std::size_t dot = key.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return std::nullopt;
  if (!has_key(key.substr(0, dot), key.substr(dot + 1))) return std::nullopt;
  return std::string(key);
}

std::vector<std::string> set_keys() {
  std::vector<std::string> keys = {"mesh", "motion", std::string(plain_set_key)};
  for (const SceneTable& table : scene_tables()) {
    if (table.name.empty()) continue;
    for (const std::string& key : scene_keys(table.name)) keys.push_back(std::string(table.name) + "." + key);
  }
  return keys;
}

bool is_vector_key(std::string_view dotted_key) {
  constexpr std::array names = {"position_m", "axis",   "point_m", "normal",
                                "direction",  "from_m", "to_m",    "centre_m"};
  const std::string_view key = dotted_key.substr(dotted_key.rfind('.') + 1);
  return std::find(names.begin(), names.end(), key) != names.end();
}

}  // namespace fingerpad
