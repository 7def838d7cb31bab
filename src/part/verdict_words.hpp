#pragma once

#include "part/build_part.hpp"
#include "part/fan.hpp"
#include "part/raw_mesh.hpp"
#include "part/verdict.hpp"

namespace fingerpad {

/// Adds a warning for every damage that the verdict's numbers show: what it is, how much of it, what it means
/// for touch.
/// @pre the verdict's numbers are filled.
void add_warnings(const RawMesh& mesh, const Fan& fan, const BuiltPart& built, Verdict& verdict);

}  // namespace fingerpad
