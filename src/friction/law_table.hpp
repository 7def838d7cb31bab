#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "friction/law.hpp"
#include "friction/pad_profile.hpp"

namespace fingerpad {

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
  Remedy remedy = Remedy::none;  ///< of laws whose spring scales with the load
  std::optional<PadProfile> profile;

  /// The given number, or the default of `parameter`.
  double number(const LawParameter& parameter) const;
};

/// One row of the table of laws.
struct LawEntry {
  std::string_view name;
  std::string_view summary;  ///< who, year, in a line
  std::span<const LawParameter> parameters;
  std::unique_ptr<FrictionLaw> (*make)(const LawSettings&);
  std::span<const std::string_view> choices{};  ///< keys of `[friction]` with words that it reads: "restick"
};

/// All laws, in the order of the documentation.
std::span<const LawEntry> law_table() noexcept;
/// The row of a name; nullptr if there is none.
const LawEntry* find_law(std::string_view name) noexcept;

}  // namespace fingerpad
