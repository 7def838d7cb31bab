#pragma once

#include <optional>
#include <string>
#include <vector>

#include "view/contact_glyphs.hpp"
#include "view/overlay.hpp"
#include "view/view_input.hpp"

namespace fingerpad {

/// What a window says beside its picture: lines that others give it, shown as they stand.
struct StageWords {
  std::string hint;               ///< in the title line
  std::vector<std::string> help;  ///< the help page, a line an entry
  std::string alarm;              ///< in red below the title; empty: none
  std::string invitation;         ///< how to begin, until it was done once
  std::string message;            ///< what has just been done
  std::vector<Reading> readings;  ///< beside those of the moment
  TickBars tick_bars;             ///< how often ticks took how long
};

/// The facts of an overlay, but for what depends on the view.
/// @param now     the scene and the surfaces as they are at the moment shown
/// @param moment  none: nothing moves
OverlayFacts facts_to_tell(const ViewInput& input, const ViewInput& now, const StageWords& words,
                           const std::optional<ContactMoment>& moment);

}  // namespace fingerpad
