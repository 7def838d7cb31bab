#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "study/measurement.hpp"

namespace fingerpad {

/// What the pad was doing at a sample; unknown where it moved too little to tell.
enum class PadPhase : unsigned char { unknown, stick, slip };

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

/// Where one phase ends and the next begins.
struct PhaseBoundary {
  std::size_t sample = 0;  ///< the first of `after`
  PadPhase before = PadPhase::unknown, after = PadPhase::unknown;
  BoundaryReason reason = BoundaryReason::touchdown;
};

/// A trial told apart into stick and slip.
struct StickSegments {
  std::vector<PadPhase> phase;         ///< per sample
  std::vector<bool> is_rupture;        ///< per sample: the first after the force ratio has dropped
  std::vector<bool> begins_run;        ///< rupture or starts_anew: no window goes across
  std::vector<Vec2> velocity_m_per_s;  ///< slope of the window's positions
  double position_noise_m = 0;         ///< standard deviation of one component
  double ratio_noise = 0;              ///< likewise, of q
  double border_per_m = 0;             ///< local stiffness that parts slip (below) from stick
  int half_window = 0;                 ///< samples
};

/// Tells stick from slip by the local stiffness k = -sum dq.dx / sum |dx|^2 over windows of 13 ms (up to 100
/// ms where the pad moves slowly) that do not go across a rupture: in slip the force ratio q stays as the
/// finger moves, in stick it follows. The border is half the mean of the stiffer group (two means); slip must
/// also be against the motion, q.v < 0. A window whose spread is under four times the noise of positions
/// tells nothing.
///
/// A rupture is a step in which |q| falls by a twelfth, and more than in the steps around it by four and a
/// half standard deviations and by their size (medians). So a sensor must pass the drop within one sample.
/// Noise is told from second differences (sample_noise), so that ruptures do not count.
StickSegments stick_segments(const MeasuredTrial& trial);

/// Every boundary between phases of a trial, in order, with its reason.
std::vector<PhaseBoundary> phase_boundaries(const MeasuredTrial& trial, const StickSegments& segments);

}  // namespace fingerpad
