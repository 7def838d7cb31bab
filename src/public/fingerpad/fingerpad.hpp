#pragma once

/// @mainpage fingerpad
/// All of fingerpad's public face. A program links the components whose functions it calls:
///   - `fingerpad::touch`: PartSurface and ClosestPointPath (part_surface.hpp), TouchWorld (touch_world.hpp),
///     Finger (finger.hpp)
///   - `fingerpad::trace`: TraceRecorder and read_trace_file (trace_file.hpp)
///   - `fingerpad::view`: draw_trace, plot_trace and show_trace (view.hpp), where it was built
///
/// Everything is in SI units and in double; forces are those on the finger. W is the world's frame, P a
/// part's; Q is the finger's point: `p_WQ` is the finger's place in the world.
///
/// Touching a mesh:
/// @include touch_mesh.cpp
/// Asking for closest points:
/// @include closest_points.cpp

#include "fingerpad/error.hpp"
#include "fingerpad/finger.hpp"
#include "fingerpad/finger_sample.hpp"
#include "fingerpad/part_surface.hpp"
#include "fingerpad/phase.hpp"
#include "fingerpad/surface_properties.hpp"
#include "fingerpad/tick_record.hpp"
#include "fingerpad/touch_world.hpp"
#include "fingerpad/trace_file.hpp"
#include "fingerpad/types.hpp"
#if __has_include("fingerpad/view.hpp")
#include "fingerpad/view.hpp"
#endif
