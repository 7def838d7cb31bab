#include "scene/key_ranges.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "motion/farthest.hpp"

namespace fingerpad {
namespace {

struct KeyRange {
  std::string_view key;
  double lowest, highest;
};

constexpr KeyRange ranges[] = {
    {"part.crease_deg", 0, 180},
    {"part.rotation.angle_deg", -3600, 3600},
    {"part.stiffness_n_per_m", 1e-6, 1e9},
    {"part.damping_n_s_per_m", 0, 1e9},
    {"part.mu_static", 0, 1000},
    {"part.mu_dynamic", 0, 1000},
    {"contact.force_tolerance", 1e-9, 1},
    {"contact.mu_tolerance", 1e-9, 1},
    {"contact.greatest_force_n", 1e-6, 1e6},
    {"friction.vibration.frequency_hz", 1e-3, 1e6},
    {"friction.vibration.bandwidth_hz", 1e-3, 1e6},
    {"friction.vibration.amplitude", 0, 1},
    {"friction.vibration.normal_amplitude", 0, 1},
    {"finger.radius_m", 0, 1000},
    {"motion.rate_hz", 1, 1e6},
    {"motion.speed_m_per_s", 1e-9, farthest_m},
    {"motion.amplitude_m", 0, farthest_m},
    {"motion.radius_m", 0, farthest_m},
    {"motion.frequency_hz", 0, 1e9},
    {"motion.duration_s", 1e-9, 1e9},
    {"hand.mass_kg", 1e-6, 1e3},
    {"hand.damping_n_s_per_m", 0, 1e9},
    {"hand.stiffness_n_per_m", 0, 1e9},
    {"hand.encoder_m", 0, 1},
    {"hand.coulomb_n", 0, 1e9},
};

/// For numbers of laws, which have many units: below and above these only powers of them lose meaning.
constexpr double least_of_a_law = 1e-12, most_of_a_law = 1e12;

}  // namespace

NumberRange key_range(std::string_view dotted_key) noexcept {
  const auto row = std::find_if(std::begin(ranges), std::end(ranges),
                                [&](const KeyRange& range) { return range.key == dotted_key; });
  if (row == std::end(ranges)) std::abort();  // a key that the reader asks for and nobody gave a range
  return {row->lowest, row->highest, false};
}

NumberRange law_range(double min, bool above_min, double max) noexcept {
  const bool from_nothing = above_min && min == 0;
  return {from_nothing ? least_of_a_law : min, std::min(max, most_of_a_law), above_min && !from_nothing};
}

}  // namespace fingerpad
