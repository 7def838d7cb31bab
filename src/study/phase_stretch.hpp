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

/// Without the samples at its ends whose windows reach into another phase.
PhaseStretch inner_stretch(PhaseStretch stretch, const StickSegments& segments);

}  // namespace fingerpad
