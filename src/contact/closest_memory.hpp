#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "contact/packet_filter.hpp"

namespace fingerpad {

/// What a caller keeps from one query for the closest triangle to the next, along a path: the last answer,
/// and now and then the packets around it, so that while the path stays near no tree is searched. It changes
/// what a query costs and never its answer, whatever it holds: also that of another tree, or of a path that
/// jumps. (But that of a BriefSearch which is broken off, and is nearer then.) Two and a half kilobytes; for
/// one thread at a time.
///
/// The packets listed are all that come within a ball. A query is answered by them as long as its own ball,
/// which reaches from q as far as the closest triangle, lies in that one. So the listed ball does not stand
/// about q, but farther off the surface where there is room (`lift`): it is flatter there, has fewer packets
/// in it, and holds the balls of a longer way along the surface. And it stands ahead, as the path goes on as
/// it came.
class ClosestMemory {
 public:
  /// Forgets everything.
  void forget() noexcept {
    tree_ = 0;
    triangle_ = -1;
    pause_ = 0;
    lift_ = greatest_lift;
    forget_packets();
  }

  /// How many packets are kept; 0 where every query searches the tree.
  int packet_count() const noexcept { return count_; }

 private:
  friend class TriangleTree;
  friend struct PacketGathering;

  static constexpr int groups = 8, most = groups * packet_width;
  /// How far the listed ball is moved off the surface, in lengths of the way that it is to serve.
  static constexpr double greatest_lift = 6;

  bool covers(const Vec3& q, double distance_m, double rounding_m) const noexcept;
  void forget_packets() noexcept {
    count_ = 0;
    clear_m_ = -1;
  }

  std::uint64_t tree_ = 0;  ///< the number of the tree that all this is about
  int triangle_ = -1;       ///< the last answer; -1 if there is none
  Vec3 last_ = Vec3::Constant(std::numeric_limits<double>::infinity());  ///< last point asked for

  int count_ = 0;               ///< packets listed
  Vec3 about_ = Vec3::Zero();   ///< the middle of the listed ball [m]
  double clear_m_ = -1;         ///< no triangle of a packet that is not listed is nearer to it
  Vec3 anchor_ = Vec3::Zero();  ///< scaled: what the discs' places are relative to
  float spread_ = 0;            ///< no disc reaches farther from there, by the sum of coordinates and radius
  double lift_ = greatest_lift;
  int served_ = 0;  ///< queries since the list was made
  int pause_ = 0;   ///< queries until a list may be made again: the last was not worth it
  std::array<std::uint32_t, most> packet_{};
  std::array<PacketDiscs, groups> discs_{};  // ordinary numbers too where nothing is listed
};

}  // namespace fingerpad
