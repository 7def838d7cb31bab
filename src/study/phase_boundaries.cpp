#include "study/phase_boundaries.hpp"

namespace fingerpad {

std::string_view reason_text(BoundaryReason reason) noexcept {
  switch (reason) {
    case BoundaryReason::touchdown:
      return "contact";
    case BoundaryReason::rupture:
      return "ratio drops";
    case BoundaryReason::spring_gives:
      return "spring gives";
    case BoundaryReason::spring_holds:
      return "spring holds";
    case BoundaryReason::hardly_moves:
      return "hardly moves";
    case BoundaryReason::moves_again:
      return "moves again";
  }
  return "";
}

std::string_view phase_text(PadPhase phase) noexcept {
  switch (phase) {
    case PadPhase::unknown:
      return "not told";
    case PadPhase::stick:
      return "stick";
    case PadPhase::slip:
      return "slip";
  }
  return "";
}

std::vector<PhaseBoundary> phase_boundaries(const MeasuredTrial& trial, const StickSegments& segments) {
  const auto reason = [&](std::size_t i, PadPhase before, PadPhase after) {
    if (trial.starts_anew[i]) return BoundaryReason::touchdown;
    if (segments.is_rupture[i]) return BoundaryReason::rupture;
    if (after == PadPhase::unknown) return BoundaryReason::hardly_moves;
    if (before == PadPhase::unknown) return BoundaryReason::moves_again;
    return after == PadPhase::slip ? BoundaryReason::spring_gives : BoundaryReason::spring_holds;
  };
  std::vector<PhaseBoundary> found;
  for (std::size_t i = 0; i < segments.phase.size(); ++i) {
    const PadPhase before = i > 0 ? segments.phase[i - 1] : PadPhase::unknown, after = segments.phase[i];
    if (before == after && !segments.is_rupture[i] && !trial.starts_anew[i]) continue;
    found.push_back({i, before, after, reason(i, before, after)});
  }
  return found;
}

}  // namespace fingerpad
