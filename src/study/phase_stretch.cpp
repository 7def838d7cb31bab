#include "study/phase_stretch.hpp"

#include <algorithm>

namespace fingerpad {

std::vector<PhaseStretch> phase_stretches(const StickSegments& segments, PadPhase phase) {
  std::vector<PhaseStretch> found;
  const std::size_t samples = segments.phase.size();
  for (std::size_t i = 0; i < samples;) {
    if (segments.phase[i] != phase) {
      ++i;
      continue;
    }
    PhaseStretch stretch{i, i + 1};
    while (stretch.to < samples && segments.phase[stretch.to] == phase && !segments.begins_run[stretch.to])
      ++stretch.to;
    i = stretch.to;
    found.push_back(stretch);
  }
  return found;
}

PhaseStretch inner_stretch(PhaseStretch stretch, const StickSegments& segments) {
  const auto reach =
      static_cast<std::size_t>(segments.half_window) + static_cast<std::size_t>(segments.half_window + 1) / 2;
  const std::size_t samples = segments.phase.size();
  const std::size_t begin = stretch.from;
  if (!segments.begins_run[begin]) stretch.from += reach;
  const bool ends_run = stretch.to >= samples || segments.begins_run[stretch.to];
  if (segments.drop_tail > 0 && segments.is_rupture[begin]) stretch.from += segments.drop_tail;
  if (segments.drop_tail > 0 && stretch.to < samples && segments.is_rupture[stretch.to]) --stretch.to;
  if (!ends_run) stretch.to = stretch.to > reach ? stretch.to - reach : 0;
  stretch.to = std::max(stretch.to, stretch.from);
  return stretch;
}

}  // namespace fingerpad
