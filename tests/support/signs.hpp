#pragma once

#include <functional>
#include <memory>

#include "contact/surface_point.hpp"
#include "part/part.hpp"

namespace fingerpad::test {

/// Asks for the surface points of `count` places in and around the part (a fifth of its size beyond its box,
/// from a fixed seed): each must be finite with unit normals.
/// @param inside  says whether a place in frame P is inside: then the sign must agree; empty: any sign will
/// do.
///                Places closer to the surface than a millionth of the size are not asked.
/// @returns       how many were inside
int expect_touchable(const std::shared_ptr<const Part>& part, int count,
                     const std::function<bool(const Vec3&)>& inside);

}  // namespace fingerpad::test
