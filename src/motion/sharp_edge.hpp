#pragma once

#include <vector>

#include "motion/surface_walk.hpp"

namespace fingerpad {

/// Whether a walker inside of a part has turned a convex edge by this step, so sharp that the finger has to
/// be taken round it. The points at one distance inside have a fold there. Who turns in it draws away from
/// the first face while a proxy still stands on that face, and presses it 1/cos(turn) times as deep; beyond a
/// right angle without end.
bool turns_sharp_edge(const SurfaceWalker& before, const SurfaceWalker& after);

/// The way of a finger's centre round a sharp convex edge: out to the edge between both faces, round it on
/// the outside, and in again, all the while nearest to the face on which it presses. So the depth falls
/// evenly to where the centre is on the surface, and grows again beyond the edge.
/// @param before, after  inside, on either side of the fold
/// @param step_m       at most between two points of the way, > 0
/// @param clearance_m  of the centre from the edge, > 0
/// @returns  the centre's places between the two walkers; none where the edge is too thin a blade for them
std::vector<Vec3> way_round_edge(const SurfaceWalker& before, const SurfaceWalker& after, double step_m,
                                 double clearance_m);

}  // namespace fingerpad
