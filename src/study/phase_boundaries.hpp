#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "study/stick_segments.hpp"

namespace fingerpad {

/// Why a phase ends and the next begins.
enum class BoundaryReason : unsigned char {
  touchdown,     ///< contact begins, or samples were missing
  rupture,       ///< the force ratio drops at once
  spring_gives,  ///< it stops to follow the displacement: local stiffness falls below the border
  spring_holds,  ///< it begins to follow the displacement: local stiffness rises above the border
  hardly_moves,  ///< too little motion to tell a stiffness, or friction that is not against the motion
  moves_again,   ///< the motion tells a stiffness again
};
/// In words, for a chart's legend.
std::string_view reason_text(BoundaryReason reason) noexcept;
std::string_view phase_text(PadPhase phase) noexcept;

/// Where one phase ends and the next begins.
struct PhaseBoundary {
  std::size_t sample = 0;  ///< the first of `after`
  PadPhase before = PadPhase::unknown, after = PadPhase::unknown;
  BoundaryReason reason = BoundaryReason::touchdown;
};

/// Every boundary between phases of a trial, in order, with its reason.
std::vector<PhaseBoundary> phase_boundaries(const MeasuredTrial& trial, const StickSegments& segments);

}  // namespace fingerpad
