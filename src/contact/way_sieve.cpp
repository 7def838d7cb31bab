#include "contact/way_sieve.hpp"

namespace fingerpad {

static_assert(PartWalls::most_walls <= RoughWay::most_walls);

unsigned WaySieve::lanes_left(const TrianglePacket& packet) const noexcept {
  static const WayFilter filter = fastest_way_filter();
  const unsigned lanes = filter(packet, seen_from(packet)) & ~unsigned{packet.always_exact};
  const unsigned slivers = packet.always_exact != 0 && !clears_slivers(packet) ? packet.always_exact : 0;
  return (lanes | slivers) & packet.used;
}

/// With floats as WayFilter takes them.
RoughWay WaySieve::seen_from(const TrianglePacket& packet) const noexcept {
  RoughWay seen;
  const Vec3 start = start_ - packet.origin;
  for (int i = 0; i < 3; ++i) {
    seen.start[static_cast<std::size_t>(i)] = static_cast<float>(start[i]);
    seen.way[static_cast<std::size_t>(i)] = static_cast<float>(way_[i]);
  }
  seen.length = static_cast<float>(length_);
  seen.clearance = static_cast<float>(clearance_);
  seen.worst = static_cast<float>(scale_ * worst_.slack_m);
  const double size = start.norm() + length_ + clearance_ + 2 * static_cast<double>(packet.radius);
  const double margin = static_cast<double>(way_margin) * size + way_margin_tolerances * tolerance_;
  seen.margin = static_cast<float>(margin);
  seen.wall_count = before_.walls().size();
  for (std::size_t k = 0; k < seen.wall_count; ++k) {
    const PartWalls::Wall& wall = before_.walls()[k];
    for (int i = 0; i < 3; ++i)
      seen.walls[k].normal[static_cast<std::size_t>(i)] = static_cast<float>(wall.normal_P[i]);
    seen.walls[k].offset =
        static_cast<float>(scale_ * wall.offset_m - wall.normal_P.dot(packet.origin) - margin);
  }
  return seen;
}

/// Of all a packet's triangles together, as the class says.
bool WaySieve::clears_slivers(const TrianglePacket& packet) const noexcept {
  const Vec3 off = start_ - packet.origin;
  const double distance = off.norm(), radius = static_cast<double>(packet.radius);
  if (distance > radius) {
    const double sine = radius / distance;
    const double slope = off.dot(way_) / distance * std::sqrt(1 - sine * sine) - length_ * sine;
    if (distance - radius - clearance_ + slope > scale_ * worst_.slack_m + tolerance_) return true;
  }
  return std::any_of(before_.walls().begin(), before_.walls().end(), [&](const PartWalls::Wall& wall) {
    return wall.normal_P.dot(packet.origin) + packet.highest(wall.normal_P) <= scale_ * wall.offset_m;
  });
}

}  // namespace fingerpad
