#pragma once

#include <atomic>
#include <mutex>

#include "contact/closest_memory.hpp"
#include "contact/closest_search.hpp"
#include "contact/near_packets.hpp"
#include "contact/packet_gathering.hpp"
#include "contact/triangle_tree.hpp"
#include "contact/winding_number.hpp"

namespace fingerpad {

/// Beyond so many half extents float boxes no longer tell triangles apart: every triangle is looked at.
inline constexpr double tree_range = 1e4;

/// Of more packets most come from memory: 1.4 MB.
inline constexpr std::size_t cached_packets = 2048;

/// A number that no tree had before.
std::uint64_t new_tree_number() noexcept;

/// What a TriangleTree is made of.
struct TriangleTree::Impl {
  std::uint64_t number = new_tree_number();
  PackedPart packed;
  PacketFilter filter;
  DiscFilter disc_filter = fastest_disc_filter();
  DiscMeasure disc_measure = fastest_disc_measure();
  PacketScene scene;
  WindingNumber winding;
  std::once_flag curved_once;
  Points curved_table;
  std::atomic<const Points*> curved_normals = nullptr;  ///< the table, once it is whole

  explicit Impl(std::shared_ptr<const Part> part)
      : packed(pack(std::move(part))), filter(fastest_packet_filter()), scene(packed), winding(packed) {
    keep_in_large_pages();
  }

  /// Whether what a query reads comes from memory, mostly.
  bool is_cold() const noexcept { return packed.packets.size() > cached_packets; }
  long packet_price() const noexcept { return is_cold() ? LookCosts::packet_cold : LookCosts::packet; }
  /// Whether a point is surely farther away than reach_m, or this is no number; `farthest_m` is the point's
  /// largest coordinate. Leaves room for rounding.
  bool out_of_reach(double farthest_m, double reach_m) const noexcept {
    return !(farthest_m - packed.extent_m <= reach_m + 1e-14 * (farthest_m + packed.extent_m));
  }
  /// Whether packets are looked for: near enough for float boxes, and perhaps within reach.
  bool is_searched(const Vec3& q, double reach_m) const noexcept {
    const double farthest = q.cwiseAbs().maxCoeff();
    return !packed.packets.empty() && q.allFinite() && farthest <= tree_range * packed.extent_m &&
           !out_of_reach(farthest, reach_m);
  }
  /// Looks for a triangle nearer than what the search has, `within_m` away.
  void search_tree(ClosestSearch& search, double within_m) const noexcept;
  /// Looks for it among the packets that a memory lists, and lists them anew where that pays; false where
  /// that does not answer.
  /// @param seed    tried where the memory's own is not within reach; -1 if there is none
  /// @param beside  another memory, asked before packets are listed anew; null if there is none
  bool search_list(ClosestSearch& search, ClosestMemory& memory, int seed,
                   const ClosestMemory* beside) const noexcept;
  void look_through(ClosestSearch& search, const PacketList& list) const noexcept;
  void list_packets(const ClosestSearch& search, const Vec3& step, ClosestMemory& memory) const noexcept;
  /// For speed alone, where they are read from memory.
  std::uint64_t let_packets_come(const PacketList& list, const PacketGathering& gathering,
                                 double near) const noexcept;
  ClosestTriangle far_closest(const Vec3& q, double reach_m) const noexcept;
  void far_each_within(const Vec3& q, double reach_m, void (*visit)(void* context, int triangle),
                       void* context) const noexcept;
  SegmentHit far_crossing(const TriangleTree& tree, const Vec3& from, const Vec3& to) const noexcept;
  void keep_in_large_pages() const noexcept;
};

}  // namespace fingerpad
