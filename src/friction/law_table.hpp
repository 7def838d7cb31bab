#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "friction/law.hpp"
#include "friction/law_settings.hpp"

namespace fingerpad {

/// How far the contact point may be from the stick centre before it slips: half axes of an ellipse [m].
struct StickAxes {
  double lateral_m = 0;       ///< across the finger
  double longitudinal_m = 0;  ///< along the finger
};

/// One row of the table of laws.
struct LawEntry {
  std::string_view name;
  std::string_view summary;  ///< who, year, in a line
  std::span<const LawParameter> parameters{};
  std::unique_ptr<FrictionLaw> (*make)(const LawSettings&);
  std::span<const std::string_view> choices{};  ///< keys of `[friction]` with words that it reads: "restick"
  /// It holds the finger back; else it gives no force at all, and there is none to be shown or measured.
  bool rubs = true;
  /// It holds up to mu_static and slides at less: a pulled block sticks and slips.
  bool has_static_limit = false;
  /// The region within which it sticks, on a surface of this mu_static, at a finger's inclination; null: it
  /// has none of this kind.
  StickAxes (*stick_axes)(const LawSettings&, double mu_static, double inclination_rad) = nullptr;
  /// By how much the coefficient of friction rises a metre in stick, where that is most; null: by the stick
  /// stiffness that it reads.
  double (*rise_per_m)(const LawSettings&) = nullptr;
  /// What a surface's coefficients are to be multiplied by for them to hold under a load (without adhesion);
  /// null: they hold under any.
  double (*mu_raise)(double load_n) = nullptr;
};

/// All laws, in the order of the documentation.
std::span<const LawEntry> law_table() noexcept;
/// The row of a name; nullptr if there is none.
const LawEntry* find_law(std::string_view name) noexcept;

}  // namespace fingerpad
