#pragma once

#include <atomic>
#include <string>

#include "contact/packed_part.hpp"

struct RTCDeviceTy;  // Embree's
struct RTCSceneTy;

namespace fingerpad {

// Embree sees the part scaled so that its box lies within [-1, 1]. There, in its float arithmetic: a box
// corner moves by 3e-8 when rounded; a ray of length 4 strays by 3e-7; a squared distance is off by about
// 1e-6 of itself at most. The paddings below are above these, so that nothing which could win or tie is
// passed over.
inline constexpr float box_padding = 5e-7f;
inline constexpr double relative_slack = 2e-6;
inline constexpr double absolute_slack = 1e-8;
/// Added to a ray's end, scaled: above a float's rounding of lengths up to 4.
inline constexpr double ray_slack = 1e-6;

/// A search along an Embree ray; the base of what knows more.
struct RayQuery {
  /// Looks at a packet's triangles; may shorten the ray.
  void (*look_at)(RayQuery& query, const TrianglePacket& packet, float& far);
};

/// Embree's tree over padded float boxes of packets. Immutable after construction; not moved, since Embree
/// keeps its address.
class PacketScene {
 public:
  /// Builds on all threads. Throws Error (fault) if Embree cannot.
  explicit PacketScene(const PackedPart& packed);
  ~PacketScene();
  PacketScene(const PacketScene&) = delete;
  PacketScene& operator=(const PacketScene&) = delete;

  /// Looks at a packet; returns the radius to go on with, at most the one given.
  using Visit = float (*)(void* search, unsigned packet, float radius) noexcept;

  /// Calls visit(search, packet, radius) for packets whose box comes within the radius of a point.
  /// @param point, radius  scaled
  void each_near(const float* point, float radius, Visit visit, void* search) const noexcept;

  /// Sends a ray with a unit direction through the tree.
  /// @param from, length  scaled; the length may be infinite
  void cast(RayQuery& query, const Vec3& from, const Vec3& direction, double length) const noexcept;

  std::size_t memory_bytes() const noexcept { return static_cast<std::size_t>(memory_.load()); }

 private:
  const PackedPart* packed_;
  std::atomic<std::ptrdiff_t> memory_{0};  ///< what Embree holds
  RTCDeviceTy* device_ = nullptr;
  RTCSceneTy* scene_ = nullptr;
};

/// Of Embree as it is loaded, as "3.13.5"; empty where it cannot start.
std::string embree_version();

}  // namespace fingerpad
