#pragma once

#include "touch/tick_record.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// Whether a record shows the finger behind the part's surface that it touches: on a first tick, that it
/// started inside, and that its first force is towards the nearest place outside.
bool is_inside_part(const TickRecord& record, const World& world) noexcept;

}  // namespace fingerpad
