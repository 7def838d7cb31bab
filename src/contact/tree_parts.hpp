#pragma once

#include <atomic>
#include <mutex>

#include "contact/packet_filter.hpp"
#include "contact/packet_scene.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {

/// What a TriangleTree is made of.
struct TriangleTree::Impl {
  PackedPart packed;
  PacketFilter filter;
  PacketScene scene;
  std::once_flag curved_once;
  Points curved_table;
  std::atomic<const Points*> curved_normals = nullptr;  ///< the table, once it is whole

  explicit Impl(std::shared_ptr<const Part> part)
      : packed(pack(std::move(part))), filter(fastest_packet_filter()), scene(packed) {}

  /// Whether a point is surely farther away than reach_m, or this is no number; `farthest_m` is the point's
  /// largest coordinate. Leaves room for rounding.
  bool out_of_reach(double farthest_m, double reach_m) const noexcept {
    return !(farthest_m - packed.extent_m <= reach_m + 1e-14 * (farthest_m + packed.extent_m));
  }
  ClosestTriangle far_closest(const Vec3& q, double reach_m) const noexcept;
};

}  // namespace fingerpad
