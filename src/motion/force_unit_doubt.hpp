#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace fingerpad {

/// Why a measured force has hardly the unit that it was taken to have: no finger rubs so.
struct ForceUnitDoubt {
  double press_n = 0;
  bool is_hard = false;        ///< else it is too light
  bool asks_for_unit = false;  ///< nobody has said it: newtons were taken

  /// "taken as newtons, its normal force is 1200 N where it presses, harder than a finger rubs: say ...".
  /// @param force  what it is: "normal force"
  /// @param said   how a unit is said: "--force-unit mN"
  std::string words(std::string_view force, const std::function<std::string(std::string_view)>& said) const;
};

/// Doubts a force of more than 40 N, or of less than 10 mN (but of 0), where it presses.
/// @param says_unit  the user has said its unit, or the file
std::optional<ForceUnitDoubt> force_unit_doubt(double press_n, bool says_unit);

}  // namespace fingerpad
