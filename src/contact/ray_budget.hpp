#pragma once

#include "part/part.hpp"

namespace fingerpad {

/// How many rays may be sent straight in from a part's facets, so that all together take a second or so.
///
/// A ray looks at the triangles whose boxes it passes: some dozens on a part of whatever size, for which this
/// is far more than anyone sends. Where thousands of needles fan out from one point every box covers a share
/// of all others, and as many rays as facets would take a time that grows with the square of their number.
/// Depends on the part alone.
/// @returns  at least 1
int affordable_rays(const Part& part);

}  // namespace fingerpad
