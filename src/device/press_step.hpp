#pragma once

#include "fingerpad/surface_properties.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

/// What a tick's step into a surface may add to the normal force, as a share of the force that is asked for.
inline constexpr double press_step_share = 0.1;
/// From so many times the force that is asked for on, a finger gives way and does nothing else.
inline constexpr double press_too_hard = 1.3;

/// How much deeper a pressed finger goes in a tick, or less deep, so that the normal force becomes the one
/// asked for [m]. Along the normal, away from the place on the surface, all walls' shares grow and shrink as
/// the depth does, whatever their angles.
/// @param touched   what the last tick felt, touching
/// @param surface   that it touched
/// @param wanted_n  > 0
/// @param motion_left  from 1 to 0, under a pointer that rests: then it goes slowly
/// @param tolerated    so far the force may be off, as a share of what is asked for
/// noexcept, allocates nothing.
double deeper_m(const TickRecord& touched, double wanted_n, const SurfaceProperties& surface,
                double motion_left, double tolerated, double dt_s) noexcept;

}  // namespace fingerpad
