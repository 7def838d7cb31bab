#pragma once

#include <string>
#include <vector>

#include "view/compared_run.hpp"

namespace fingerpad {

/// Along what a chart's friction is told, and what its sign means: one for all runs that it compares, or
/// their difference would mean nothing.
struct FrictionSense {
  std::string along;     ///< "x", "u", "sliding"
  std::string sign;      ///< "+ pushes towards +x", "- against it"
  std::string sentence;  ///< the same for people who read no chart
};

/// Tells the friction of all runs along one line of the world where all rub straight along it over flat
/// places; elsewhere that of all along their own sliding.
/// @pre the friction of each is along its sliding, as read_compared_run gives it
FrictionSense share_friction_sense(std::vector<ComparedRun>& runs);

}  // namespace fingerpad
