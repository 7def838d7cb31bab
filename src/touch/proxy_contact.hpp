#pragma once

#include "contact/proxy.hpp"
#include "touch/tick_record.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// A proxy for a finger of this radius in a whole world: every part in its pose and every plane holds it.
Proxy world_proxy(const World& world, double radius_m, Normals normals);

/// Whether a record shows the finger behind the part's surface that it touches: on a first tick, that it
/// started inside and was put at the nearest place outside, from where its first force comes.
bool is_inside_part(const TickRecord& record, const World& world) noexcept;

}  // namespace fingerpad
