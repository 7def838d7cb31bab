#pragma once

#include "contact/proxy_state.hpp"
#include "contact/proxy_world.hpp"

namespace fingerpad {

/// How far a step has to go on along its walls because they bend away.
///
/// A ball on a corner or an edge of facets is held by a wall that turns as it goes. Steps that know only the
/// walls' planes then come to rest slowly: with the share s of a corner's wall and the clearance R each
/// leaves s/R of the way. What is left can be told from the planes' turning: over a corner a wall bends with
/// the radius R in all directions, over an edge across it, over a face it does not bend. The way along all
/// walls where the finger is closest, to the second order, is Newton's step (sequential quadratic
/// programming): steps then come to rest quadratically. It stays in the walls' planes, so that it is as free
/// of them as the step is; whether it is free of everything else has to be looked at.
/// @returns what is to be added to the step; nothing where the walls do not bend, or so much that the finger
/// is not closest there
Vec3 way_along_bend(const ProxyWorld& world, const ProxyStep& step) noexcept;

}  // namespace fingerpad
