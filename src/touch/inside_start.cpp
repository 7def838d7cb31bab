#include "touch/inside_start.hpp"

namespace fingerpad {

bool is_inside_part(const TickRecord& record, const World& world) noexcept {
  if (record.phase == Phase::free || record.surface < 0) return false;
  return !world.surfaces[static_cast<std::size_t>(record.surface)].is_plane() &&
         (record.p_WQ - record.contact_W).dot(record.normal_W) < 0;
}

}  // namespace fingerpad
