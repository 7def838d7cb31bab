#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "friction/law.hpp"
#include "friction/law_settings.hpp"

namespace fingerpad {

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
