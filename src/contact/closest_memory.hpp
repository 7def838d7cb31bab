#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "contact/packet_list.hpp"

namespace fingerpad {

/// What a caller keeps from one query for the closest triangle to the next, along a path: the last answer,
/// and now and then the packets around it, so that while the path stays near no tree is searched. It changes
/// what a query costs and never its answer, whatever it holds: also that of another tree, or of a path that
/// jumps. (But that of a BriefSearch which is broken off, and is nearer then.) Five kilobytes; for one thread
/// at a time.
///
/// It lists the packets along a piece of the way ahead (PacketList), as far as the path is likely to go, and
/// keeps the last such list for a path that turns back, and for others that follow it. How much room a list
/// has beside its way, for what the path bends and the surface comes nearer, it learns from the path.
class ClosestMemory {
 public:
  /// Forgets everything.
  void forget() noexcept {
    tree_ = 0;
    slot_ = no_slot;
    is_new_ = false;
    soon_ = 0;
    pause_ = 0;
    room_ = first_room;
    share_ = 1;
    for (PacketList& list : lists_) list.clear();
  }

  /// How many packets are kept; 0 where every query searches the tree.
  int packet_count() const noexcept { return list().count; }

 private:
  friend class TriangleTree;

  /// How far beside the way packets are listed, in its lengths.
  static constexpr double first_room = 1.0 / 16, least_room = 1.0 / 64, greatest_room = 1;

  static constexpr std::uint32_t no_slot = std::numeric_limits<std::uint32_t>::max();

  const PacketList& list() const noexcept { return lists_[newest_]; }
  PacketList& list() noexcept { return lists_[newest_]; }
  /// The oldest, to be made anew.
  void take_next_list() noexcept {
    if (list().is_list()) newest_ = 1 - newest_;
    list().clear();
  }
  /// A list that answers for q where the closest triangle is at most so far away; null if there is none.
  const PacketList* covering(const Vec3& q, double within_m) const noexcept {
    if (list().covers(q, within_m)) return &list();
    const PacketList& last = lists_[1 - newest_];
    return last.covers(q, within_m) ? &last : nullptr;
  }
  void learn_room(const Vec3& q) noexcept;
  PathPiece way_ahead(const Vec3& q, const Vec3& heading, double way_m) noexcept;

  std::uint64_t tree_ = 0;        ///< the number of the tree that all this is about
  std::uint32_t slot_ = no_slot;  ///< the last answer's, in the packets
  bool is_new_ = false;           ///< the answer before was another triangle, and its neighbours may be next
  std::uint64_t soon_ = 0;        ///< of the newest list: packets whose corners will be read, a bit each
  Vec3 last_ = Vec3::Constant(std::numeric_limits<double>::infinity());  ///< last point asked for
  Vec3 from_ = last_, heading_ = Vec3::Zero();  ///< where a list was made last, and where the path went there

  std::array<PacketList, 2> lists_;
  std::size_t newest_ = 0;
  double room_ = first_room;
  double share_ = 1;  ///< of the longest way that a list is made for
  int served_ = 0;    ///< queries since the list was made
  int pause_ = 0;     ///< queries until a list may be made again: the last was not worth it
};

}  // namespace fingerpad
