#pragma once

#include <span>
#include <vector>

#include "touch/tick_record.hpp"
#include "view/view_input.hpp"

namespace fingerpad {

/// The coefficients of friction of one surface; 0 where they are not known.
struct MuPair {
  double mu_static = 0, mu_dynamic = 0;
};

/// The coefficients of all surfaces, in the order of a trace's column `part`, from a time on.
struct MuFrom {
  double from_s = 0;
  std::vector<MuPair> surfaces;
};

/// What the coefficients were in the course of a touch, in order of time: as its scene has them, and from
/// each change on what that made of them. Empty where they are not known.
std::vector<MuFrom> mu_history(const ViewInput& input);

/// The coefficients at each row: of the surface that it touches; while the finger is free of the one that it
/// touched last, or touches first.
std::vector<MuPair> mu_at_rows(std::span<const TickRecord> rows, std::span<const MuFrom> history);

}  // namespace fingerpad
