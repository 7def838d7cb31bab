#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "friction/pad_profile.hpp"

namespace fingerpad {

/// When slip gives way to stick (paper eq. 1, two readings). level: whenever |v| <= v_min. crossing: only
/// when |v| falls through v_min, so that a rupture at low speed slips on.
enum class Restick { level, crossing };

/// Where rupture and restick are looked for. exact: within the tick, each at its own place, as many as it
/// holds. tick: at ticks only, at most one on each; for comparison.
enum class Events { exact, tick };

/// Share of 2 b/T that a stick spring may have without a remedy: at the limit itself it would ring for ever.
inline constexpr double stick_remedy_reserve = 0.95;

/// What to do where the stick spring is too stiff for the loop that displays it: a device of damping b holds
/// a spring of up to 2 b/T (SCIENCE 4). Acts only in stick, only beyond 0.95 of that, and says so. Of a
/// spring that hardens the stiffness where it stands counts.
///   damping   a damper beside the spring, 1.5 times what the excess of stiffness asks for
///   implicit  the spring is read where the finger will be a tick later (backward Euler: a damper of K T)
///   cap       the spring is softened to 0.95 of 2 b/T; its limit stays, so the pad gives way later
enum class Remedy { none, damping, implicit, cap };
struct StickRemedy {
  Remedy remedy = Remedy::none;
  double device_damping_n_s_per_m = 0.5;  ///< b, of hand and device
};

/// A number that a law reads from `[friction]`, in SI.
struct LawParameter {
  std::string_view key;  ///< with its unit in the name
  double default_value;
  double min;        ///< smallest allowed value
  bool min_allowed;  ///< false: must be larger than min
  std::string_view meaning;
  double max = std::numeric_limits<double>::infinity();  ///< largest allowed value
};

/// Why `value` cannot be this parameter ("must be larger than 0"); empty where it can.
std::string refusal(const LawParameter& parameter, double value);

/// What a law is made from: a scene's `[friction]`.
struct LawSettings {
  std::map<std::string, double, std::less<>> numbers;  ///< given keys only
  Restick restick = Restick::level;
  Events events = Events::exact;  ///< of laws that rupture
  Remedy remedy = Remedy::none;   ///< of laws whose spring scales with the load
  std::optional<PadProfile> profile;

  /// The given number, or the default of `parameter`.
  double number(const LawParameter& parameter) const;
};

}  // namespace fingerpad
