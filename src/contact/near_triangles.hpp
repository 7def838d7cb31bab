#pragma once

#include <span>
#include <vector>

#include "contact/looks.hpp"
#include "contact/packet_tangents.hpp"
#include "contact/worst_wall.hpp"

namespace fingerpad {

/// A packet in a proxy's view. Of its triangles half spaces are known, in float, each made by a look from
/// some place: most are told by them to be out of the way of a step, eight at once. What they leave is told
/// exactly, so that they are speed alone.
struct NearPacket {
  PacketTangents tangents = no_tangents();
  alignas(32) TrianglePacket::Lanes ends{};  ///< of those left by bring_first, see SweepFilter
  std::array<float, 3> seen_from{};          ///< relative to the packet's origin, scaled
  bool is_seen = false;                      ///< so far
  PacketLanes of;                            ///< the triangles within reach
  /// How triangles stand before the place that they were last told exactly from, a bit each: a ball that fits
  /// tightly is held by nearly all of them, pass by pass.
  unsigned told = 0;
  Vec3 told_from_P = Vec3::Zero();
  std::array<TriangleApproach, packet_width> approaches;
  unsigned left = 0;  ///< those that may be in the way, by bring_first
};

class RoughWay;

/// The triangles that the last search of the trees found within reach of a place, and what is known of each.
/// They are looked at from this place, or from another one near it. Allocates nothing once it is made.
class NearTriangles {
 public:
  explicit NearTriangles(const ProxyWorld& world);

  int count() const noexcept { return count_; }
  void clear() noexcept {
    near_.clear();
    count_ = 0;
  }

  /// Lists all that the clearance and `reach_m` beyond it reach. False where these are more than `most`.
  bool search(const ProxyWorld& world, const Vec3& place_O, double reach_m, int most, Looks& looks) noexcept;
  /// Looks at those that are listed from another place.
  void look_from(const ProxyWorld& world, const Vec3& place_O) noexcept;

  /// Offers a part's packets, from `next` on, as walls to the way by `z` from the place looked from;
  /// triangles behind the given walls are passed over. False where the looks were spent before the last.
  bool offer(const ProxyWorld& world, int surface, const Vec3& z, std::span<const ProxyWall> walls,
             std::size_t& next, WorstWall& worst, Looks& looks) noexcept;
  /// How far the nearest of them is from a ball about `centre_O`, triangles behind the given walls aside, and
  /// at most `most_m` [m]. None, or negative, where the looks were spent.
  /// @param walls  seen from the place looked from
  double room_m(const ProxyWorld& world, std::span<const ProxyWall> walls, const Vec3& centre_O,
                double most_m, Looks& looks) noexcept;

 private:
  struct PartView {
    Vec3 at_P = Vec3::Zero();  ///< the place looked from
    bool within_reach = false;
    std::size_t first = 0, end = 0;  ///< its packets in near_
    /// Where those end that were compared, and of these, brought to the front, those that may be in the way.
    std::size_t compared = 0, left = 0;
  };

  bool search_part(const ProxyWorld& world, int surface, double distance_m, int most, Looks& looks) noexcept;

  unsigned lanes_left(const RoughWay& way, const PartWalls& before, double slack_m, NearPacket& near,
                      Looks& looks) const noexcept;
  unsigned lanes_in_front(const RoughWay& way, const PartWalls& walls, const TrianglePacket& packet,
                          unsigned lanes, Looks& looks) const noexcept;
  unsigned lanes_swept(const WayPastPacket& past, const TrianglePacket& packet, unsigned lanes,
                       NearPacket& near, Looks& looks) const noexcept;
  void bring_first(const RoughWay& way, const PartWalls& before, double slack_m, PartView& view,
                   Looks& looks) noexcept;

  TangentMaker make_tangents_ = fastest_tangent_maker();
  WayFilter may_block_ = fastest_way_filter();
  SweepFilter may_block_swept_ = fastest_sweep_filter();
  ReachFilter reach_within_ = fastest_reach_filter();
  int count_ = 0;  // triangles
  std::vector<NearPacket> near_;
  std::vector<PacketLanes> found_;  // by the last search of a part
  std::vector<PartView> views_;
};

}  // namespace fingerpad
