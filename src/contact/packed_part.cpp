#include "contact/packed_part.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/large_pages.hpp"
#include "contact/packet_grouping.hpp"

namespace fingerpad {

std::size_t PackedPart::memory_bytes() const noexcept {
  return packets.capacity() * sizeof(TrianglePacket) + discs.capacity() * sizeof(PacketDisc) +
         slot_of.capacity() * sizeof(std::uint32_t);
}

PackedPart pack(std::shared_ptr<const Part> part) {
  PackedPart packed;
  packed.part = std::move(part);
  packed.extent_m = packed.part->half_extent.maxCoeff();
  constexpr int largest_power = 1000;  // of two: of parts whose size is not even an ordinary double
  if (packed.extent_m > 0)
    packed.scale = std::ldexp(1.0, std::min(-std::ilogb(packed.extent_m) - 1, largest_power));
  const std::vector<std::int32_t> order = packet_order(*packed.part);
  packed.packets.reserve((order.size() + packet_width - 1) / packet_width);
  prefer_large_pages(packed.packets.data(), packed.packets.capacity() * sizeof(TrianglePacket));
  packed.packets.resize((order.size() + packet_width - 1) / packet_width);
  packed.discs.resize(packed.packets.size());
  packed.slot_of.resize(order.size());
  tbb::parallel_for(std::size_t{0}, packed.packets.size(), [&](std::size_t i) {
    const std::size_t first = i * packet_width,
                      count = std::min<std::size_t>(packet_width, order.size() - first);
    const auto triangles = std::span(order).subspan(first, count);
    packed.packets[i] = make_packet(*packed.part, triangles, packed.scale);
    packed.discs[i] = disc_around(*packed.part, packed.packets[i], packed.scale);
    for (std::size_t lane = 0; lane < count; ++lane) {
      packed.slot_of[static_cast<std::size_t>(triangles[lane])] = static_cast<std::uint32_t>(first + lane);
    }
  });
  return packed;
}

}  // namespace fingerpad
