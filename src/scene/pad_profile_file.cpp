#include "scene/pad_profile_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "scene/scene_key.hpp"
#include "scene/toml_tree.hpp"

namespace fingerpad {
namespace {

struct NumberKey {
  std::string_view key;
  double PadProfile::*member;
  bool positive;  ///< else any finite number
  bool required;
};
constexpr NumberKey number_keys[] = {
    {"lateral_axis_m", &PadProfile::lateral_axis_m, true, true},
    {"longitudinal_axis_m", &PadProfile::longitudinal_axis_m, true, true},
    {"lateral_slope_per_deg", &PadProfile::lateral_slope_per_deg, false, false},
    {"longitudinal_slope_per_deg", &PadProfile::longitudinal_slope_per_deg, false, false},
    {"mu_static", &PadProfile::mu_static, true, false},
    {"v_min_m_per_s", &PadProfile::v_min_m_per_s, true, false},
    {"vibration_hz", &PadProfile::vibration_hz, true, false},
};

/// What a fitted profile says besides: of the surface that was touched, which a scene names itself, of the
/// spring's shape and of the pad along the normal. Those in the second row may have any sign.
constexpr std::string_view fitted_sizes[] = {"mu_dynamic",
                                             "mu_load_n",
                                             "stick_stiffness_per_m",
                                             "longitudinal_stiffness_per_m",
                                             "vibration_bandwidth_hz",
                                             "normal_stiffness_n_per_m",
                                             "normal_exponent"};
constexpr std::string_view fitted_numbers[] = {"mu_load_exponent",
                                               "lateral_linearity",
                                               "longitudinal_linearity",
                                               "lateral_cubic_share",
                                               "longitudinal_cubic_share",
                                               "lateral_hysteresis_area_m",
                                               "longitudinal_hysteresis_area_m"};
constexpr std::string_view fitted_tables[] = {"interval", "samples", "refused"};

/// All that a profile knows, as it is told: "source", ..., "[interval]".
std::vector<std::string> profile_keys() {
  std::vector<std::string> keys = {"source"};
  for (const NumberKey& number : number_keys) keys.emplace_back(number.key);
  for (const std::string_view fitted : fitted_sizes) keys.emplace_back(fitted);
  for (const std::string_view fitted : fitted_numbers) keys.emplace_back(fitted);
  for (const std::string_view fitted : fitted_tables) keys.push_back(fmt::format("[{}]", fitted));
  return keys;
}

bool has_profile_key(const TomlNode& file) {
  const std::vector<std::string> keys = profile_keys();
  return std::ranges::any_of(file.entries, [&](const TomlEntry& entry) {
    return std::ranges::count(keys, entry.key) + std::ranges::count(keys, '[' + entry.key + ']') > 0;
  });
}

bool has_scene_table(const TomlNode& file) {
  return std::ranges::any_of(file.entries, [](const TomlEntry& entry) {
    return entry.key == "set" || std::ranges::any_of(scene_tables(), [&](const SceneTable& table) {
             return !table.name.empty() && table.name == entry.key;
           });
  });
}

double number_of(const std::string& path, const NumberKey& key, const TomlNode& node) {
  const auto where = place_text(path, node.place);
  if (!node.is(TomlNode::Type::number) && !node.is(TomlNode::Type::integer))
    throw refused(where, fmt::format("{} must be a number", key.key));
  const double value = node.number;
  if (!std::isfinite(value)) throw refused(where, fmt::format("{} must be finite", key.key));
  if (key.positive && !(value > 0)) throw refused(where, fmt::format("{} must be larger than 0", key.key));
  // Wide for any finger, and narrow enough that products of a few such numbers stay numbers.
  constexpr double least = 1e-12, most = 1e12;
  if (std::abs(value) > most || (key.positive && value < least)) {
    throw refused(where, fmt::format("{} is {}; it must be at least {} and at most {}", key.key, value,
                                     key.positive ? least : -most, most));
  }
  return value;
}

void read_entry(const std::string& path, const TomlEntry& entry, PadProfile& profile) {
  const TomlNode& node = entry.value;
  for (const NumberKey& number : number_keys) {
    if (entry.key != number.key) continue;
    profile.*number.member = number_of(path, number, node);
    return;
  }
  for (const std::string_view fitted : fitted_sizes) {
    if (entry.key == fitted) return void(number_of(path, {fitted, nullptr, true, false}, node));
  }
  for (const std::string_view fitted : fitted_numbers) {
    if (entry.key == fitted) return void(number_of(path, {fitted, nullptr, false, false}, node));
  }
  for (const std::string_view fitted : fitted_tables) {
    if (entry.key != fitted) continue;
    if (!node.is(TomlNode::Type::table))
      throw refused(place_text(path, node.place), fmt::format("{} must be a table", fitted));
    return;
  }
  if (entry.key != "source") {
    throw refused(place_text(path, entry.place), fmt::format("unknown key '{}'; a profile knows {}",
                                                             entry.key, fmt::join(profile_keys(), ", ")));
  }
  if (!node.is(TomlNode::Type::text)) throw refused(place_text(path, node.place), "source must be a text");
  profile.source = node.text;
}

/// What a fit says of a number that it could not give; empty where it says nothing.
std::string refusal_in(const TomlNode& file, std::string_view key) {
  const TomlEntry* const refusals = find_entry(file, "refused");
  const TomlEntry* const why = refusals != nullptr ? find_entry(refusals->value, key) : nullptr;
  return why != nullptr ? why->value.text : "";
}

void refuse_missing(const std::string& path, const TomlNode& file) {
  for (const NumberKey& key : number_keys) {
    if (!key.required || find_entry(file, key.key) != nullptr) continue;
    const std::string why = refusal_in(file, key.key);
    throw refused(path + ":1:1", fmt::format("{} is missing{}", key.key,
                                             why.empty() ? "" : fmt::format(": its fit says '{}'", why)));
  }
}

/// An axis is linear in the angle, so it is positive everywhere if it is at both ends.
void refuse_vanishing_axis(const std::string& path, const TomlNode& file, const char* axis, const char* slope,
                           double axis45_m, double slope_per_deg) {
  for (const double deg : {0.0, 90.0}) {
    const double there_m = pad_axis_at(axis45_m, slope_per_deg, deg);
    if (there_m > 0 && std::isfinite(there_m)) continue;
    const TomlEntry* const entry = find_entry(file, slope);
    throw refused(place_text(path, (entry != nullptr ? entry : find_entry(file, axis))->value.place),
                  fmt::format("{} = {} makes {} vanish before {} deg; keep it within +-1/45 per degree",
                              slope, slope_per_deg, axis, deg));
  }
}

}  // namespace

PadProfile read_profile(const std::string& path) {
  return read_profile_text(read_whole_file(path, profile_file), path);
}

PadProfile read_profile_text(const std::string& text, const std::string& path) {
  const TomlNode file = parse_toml(text, path);
  if (has_scene_table(file) && !has_profile_key(file))
    throw refused(path,
                  "is a scene, not the profile of a finger pad: that is a file of the pad's own numbers "
                  "(lateral_axis_m, longitudinal_axis_m and so on), as `fingerpad fit` writes one and "
                  "scenes/profiles/default.toml is; without `profile` the built-in pad serves");
  PadProfile profile;
  for (const TomlEntry& entry : file.entries) read_entry(path, entry, profile);
  refuse_missing(path, file);
  refuse_vanishing_axis(path, file, "lateral_axis_m", "lateral_slope_per_deg", profile.lateral_axis_m,
                        profile.lateral_slope_per_deg);
  refuse_vanishing_axis(path, file, "longitudinal_axis_m", "longitudinal_slope_per_deg",
                        profile.longitudinal_axis_m, profile.longitudinal_slope_per_deg);
  return profile;
}

bool is_profile(const TomlNode& file) {
  return has_profile_key(file) && !has_scene_table(file);
}

}  // namespace fingerpad
