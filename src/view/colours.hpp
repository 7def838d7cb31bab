#pragma once

#include "base/colour.hpp"
#include "friction/law.hpp"

namespace fingerpad {

/// One colour a phase, in every picture and chart.
constexpr Colour phase_colour(Phase phase) {
  switch (phase) {
    case Phase::stick:
      return colours::bluish_green;
    case Phase::slip:
      return colours::orange;
    case Phase::free:
      break;
  }
  return {150, 156, 164};
}

}  // namespace fingerpad
