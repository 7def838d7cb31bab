#pragma once

#include <string>
#include <vector>

namespace fingerpad {

/// What the residual may owe to the measurement: a force on the plate or in another unit, a sensor that was
/// not tared, a recorder that is late. (A pad that is softer than the model's looks late too.) A sentence
/// each; none where no force was measured, and where nothing of the kind is seen.
/// @param figures  Figures::values()
std::vector<std::string> residual_warnings(const std::vector<double>& figures);

/// The same in a few words each: "measured force off by 0.2 N without contact", "measured force fits
/// 12 ms later: late, or a softer spring".
std::vector<std::string> residual_doubts(const std::vector<double>& figures);

}  // namespace fingerpad
