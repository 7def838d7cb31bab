#pragma once

#include <vector>

#include "study/stick_segments.hpp"

namespace fingerpad {

/// A run of samples of one phase, [from, to).
struct PhaseStretch {
  std::size_t from, to;
};

/// All runs of a phase, in order; a rupture and a gap part them.
std::vector<PhaseStretch> phase_stretches(const StickSegments& segments, PadPhase phase);

/// Without one and a half half windows (StickSegments::half_window) at an end where another phase is next:
/// the windows there reach into it, and it may begin a little sooner than they tell. At a rupture, a gap, or
/// the trial's end nothing is left out, but what a slow sensor makes of a rupture (StickSegments::drop_tail).
/// Empty where the stretch is shorter.
PhaseStretch inner_stretch(PhaseStretch stretch, const StickSegments& segments);

}  // namespace fingerpad
