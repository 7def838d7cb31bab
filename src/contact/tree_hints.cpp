#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/nearest_packets.hpp"
#include "contact/tree_parts.hpp"

// Hints: what is likely the closest, or met first. They cost little and need not be right.

namespace fingerpad {
namespace {

/// Four clusters that are gone into, each, for what is about the closest: of all that are about as near, as
/// from the middle of a ball, any will do.
constexpr long most_opened = 256;
/// Packets that are looked at for what a way meets first. One that comes by more goes along a fine surface
/// rather than through it, or through long slivers, and is told to meet nothing: packets come in the part's
/// order, so that what was found so far need not be the first.
constexpr int most_on_way = 256;

/// Where a way goes through a packet's triangles first, by their rough frames in floats.
struct AboutMet {
  static constexpr float none = std::numeric_limits<float>::infinity();
  int lane = -1;
  float along = none;  ///< 0 at the way's start, 1 at its end
};

/// @param start, way  scaled; the start relative to the packet's origin
AboutMet about_met(const TrianglePacket& packet, const Eigen::Vector3f& start,
                   const Eigen::Vector3f& way) noexcept {
  // So much of the size beyond an edge counts as within it: no way slips between neighbours.
  constexpr float wider = 1e-5F;
  const float beyond = wider * (packet.radius + start.norm());
  TrianglePacket::Lanes along;
  for (std::size_t k = 0; k < packet_width; ++k) {
    const auto in_frame = [&](const std::array<TrianglePacket::Lanes, 3>& axis, float x, float y, float z) {
      return axis[0][k] * x + axis[1][k] * y + axis[2][k] * z;
    };
    const float x = start[0] - packet.foot[0][k], y = start[1] - packet.foot[1][k],
                z = start[2] - packet.foot[2][k];
    const float height = in_frame(packet.z_axis, x, y, z),
                sinks = -in_frame(packet.z_axis, way[0], way[1], way[2]);
    const float t = height / sinks;
    const float u = in_frame(packet.x_axis, x, y, z) + t * in_frame(packet.x_axis, way[0], way[1], way[2]),
                v = in_frame(packet.y_axis, x, y, z) + t * in_frame(packet.y_axis, way[0], way[1], way[2]);
    const auto past_hypotenuse = [&](const TrianglePacket::Half& half) {
      return half.normal_x[k] * (std::abs(u) - half.width[k]) + half.normal_y[k] * v;
    };
    const float past = u >= 0 ? past_hypotenuse(packet.half[0]) : past_hypotenuse(packet.half[1]);
    const bool is_met = t >= 0 && t <= 1 && v >= -beyond && past <= beyond;
    along[k] = is_met ? t : AboutMet::none;
  }
  AboutMet met;
  const unsigned rough = packet.used & ~unsigned{packet.always_exact};
  for (int k = 0; k < packet_width; ++k) {
    const float t = along[static_cast<std::size_t>(k)];
    if ((rough >> k & 1) != 0 && t < met.along) met = {k, t};
  }
  return met;
}

}  // namespace

ClosestTriangle TriangleTree::about_closest(const Vec3& q, int seed, double reach_m, int most_packets,
                                            Looks& looks) const noexcept {
  const Impl& impl = *impl_;
  const PackedPart& packed = impl.packed;
  if (!impl.is_searched(q, reach_m)) return {};
  ClosestSearch search(packed, impl.filter, q, reach_m);
  if (seed >= 0) {
    search.look_at_seed(seed);
    looks.spend(LookCosts::closest);
  }
  const TrianglePacket* const seen = search.looked_at;
  WindingNumber::NearestPackets nearest(impl.winding, search.scaled);
  std::size_t index = 0;
  long paid = 0;
  for (int k = 0; k < most_packets && nearest.tests() < most_opened && !looks.are_spent();) {
    const double radius = std::sqrt(search.winner.at.distance2_m2) * packed.scale;
    const bool is_found = nearest.next(index, radius);
    looks.spend(LookCosts::opened * (nearest.tests() - std::exchange(paid, nearest.tests())));
    if (!is_found) break;
    const TrianglePacket& packet = packed.packets[index];
    looks.spend(LookCosts::passed_over);
    if (&packet == seen || search.passes_over(packed.discs[index])) continue;
    search.look_at(packet);
    looks.spend(LookCosts::closest);
    ++k;
  }
  return search.answer();
}

TriangleMet TriangleTree::about_first_met(const Vec3& q, const Vec3& way, Looks& looks) const noexcept {
  const Impl& impl = *impl_;
  const PackedPart& packed = impl.packed;
  const Vec3 middle = q + 0.5 * way;
  if (!impl.is_searched(middle, 0.5 * way.norm())) return {};
  const Vec3 half = 0.5 * packed.scale * way, scaled = packed.scale * middle, start = packed.scale * q;
  WindingNumber::NearPackets near(impl.winding, scaled, ray_slack, half,
                                  WindingNumber::NearPackets::About::way);
  TriangleMet first;
  std::size_t index = 0;
  long paid = 0;
  for (int k = 0; !looks.are_spent(); ++k) {
    const bool is_found = near.next(index);
    looks.spend(LookCosts::beside * (near.tests() - std::exchange(paid, near.tests())));
    if (!is_found) break;
    if (k == most_on_way) return {};
    const TrianglePacket& packet = packed.packets[index];
    looks.spend(impl.packet_price());
    const AboutMet met =
        about_met(packet, (start - packet.origin).cast<float>(), (packed.scale * way).cast<float>());
    if (met.lane < 0 || !(met.along < first.along)) continue;
    first = {packet.exact[static_cast<std::size_t>(met.lane)].triangle, met.along};
  }
  return first;
}

}  // namespace fingerpad
