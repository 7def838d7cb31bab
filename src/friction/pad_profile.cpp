#include "friction/pad_profile_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string_view>

#include <toml++/toml.h>

#include "base/error.hpp"

namespace fingerpad {
namespace {

double axis_at(double axis45_m, double slope_per_deg, double inclination_deg) noexcept {
  return axis45_m * (1 - slope_per_deg * (inclination_deg - 45));
}

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

std::string place(const std::string& path, const toml::source_region& source) {
  return fmt::format("{}:{}:{}", path, source.begin.line, source.begin.column);
}

toml::table parse(const std::string& text, const std::string& path) {
  try {
    return toml::parse(text, std::string_view(path));
  } catch (const toml::parse_error& error) {
    throw refused(place(path, error.source()), std::string(error.description()));
  }
}

double number_of(const std::string& path, const NumberKey& key, const toml::node& node) {
  const auto where = place(path, node.source());
  if (!node.is_number()) throw refused(where, fmt::format("{} must be a number", key.key));
  const double value = *node.value<double>();
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

void read_entry(const std::string& path, const toml::key& key, const toml::node& node, PadProfile& profile) {
  for (const NumberKey& number : number_keys) {
    if (key.str() != number.key) continue;
    profile.*number.member = number_of(path, number, node);
    return;
  }
  for (const std::string_view fitted : fitted_sizes) {
    if (key.str() == fitted) return void(number_of(path, {fitted, nullptr, true, false}, node));
  }
  for (const std::string_view fitted : fitted_numbers) {
    if (key.str() == fitted) return void(number_of(path, {fitted, nullptr, false, false}, node));
  }
  for (const std::string_view fitted : fitted_tables) {
    if (key.str() != fitted) continue;
    if (!node.is_table())
      throw refused(place(path, node.source()), fmt::format("{} must be a table", fitted));
    return;
  }
  if (key.str() != "source") {
    std::string known = "source";
    for (const NumberKey& number : number_keys) known += fmt::format(", {}", number.key);
    for (const std::string_view fitted : fitted_sizes) known += fmt::format(", {}", fitted);
    for (const std::string_view fitted : fitted_numbers) known += fmt::format(", {}", fitted);
    for (const std::string_view fitted : fitted_tables) known += fmt::format(", [{}]", fitted);
    throw refused(place(path, key.source()),
                  fmt::format("unknown key '{}'; a profile knows {}", key.str(), known));
  }
  if (!node.is_string()) throw refused(place(path, node.source()), "source must be a text");
  profile.source = **node.as_string();
}

/// An axis is linear in the angle, so it is positive everywhere if it is at both ends.
void refuse_vanishing_axis(const std::string& path, const toml::table& table, const char* axis,
                           const char* slope, double axis45_m, double slope_per_deg) {
  for (const double deg : {0.0, 90.0}) {
    const double there = axis_at(axis45_m, slope_per_deg, deg);
    if (there > 0 && std::isfinite(there)) continue;
    const toml::node* node = table.get(slope);
    throw refused(place(path, (node != nullptr ? node : table.get(axis))->source()),
                  fmt::format("{} = {} makes {} vanish before {} deg; keep it within +-1/45 per degree",
                              slope, slope_per_deg, axis, deg));
  }
}

}  // namespace

double PadProfile::lateral_axis_at(double inclination_rad) const noexcept {
  return axis_at(lateral_axis_m, lateral_slope_per_deg, inclination_rad * 180 / std::numbers::pi);
}

double PadProfile::longitudinal_axis_at(double inclination_rad) const noexcept {
  return axis_at(longitudinal_axis_m, longitudinal_slope_per_deg, inclination_rad * 180 / std::numbers::pi);
}

PadProfile assumed_profile(double mu_static, double stick_stiffness_per_m) {
  PadProfile profile;
  profile.mu_static = mu_static;
  profile.lateral_axis_m = mu_static / stick_stiffness_per_m;
  profile.longitudinal_axis_m = 0.8 * profile.lateral_axis_m;
  profile.source = "assumption: b = 0.8 a, slopes 0.01 per degree; the paper's figures give no numbers";
  return profile;
}

PadProfile read_profile(const std::string& path) {
  return read_profile_text(read_whole_file(path, profile_file), path);
}

PadProfile read_profile_text(const std::string& text, const std::string& path) {
  const toml::table table = parse(text, path);
  PadProfile profile;
  for (const auto& [key, node] : table) read_entry(path, key, node, profile);
  for (const NumberKey& key : number_keys) {
    if (key.required && table.get(key.key) == nullptr) {
      const auto why = table["refused"][key.key].value<std::string>();
      throw refused(path + ":1:1", fmt::format("{} is missing{}", key.key,
                                               why ? fmt::format(": its fit says '{}'", *why) : ""));
    }
  }
  refuse_vanishing_axis(path, table, "lateral_axis_m", "lateral_slope_per_deg", profile.lateral_axis_m,
                        profile.lateral_slope_per_deg);
  refuse_vanishing_axis(path, table, "longitudinal_axis_m", "longitudinal_slope_per_deg",
                        profile.longitudinal_axis_m, profile.longitudinal_slope_per_deg);
  return profile;
}

}  // namespace fingerpad
