#pragma once

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

#include "contact/looks.hpp"
#include "contact/packed_part.hpp"
#include "contact/triangle_tree.hpp"

namespace fingerpad {

/// Tells whether a part encloses a point, by the generalized winding number (Jacobson, Kavan &
/// Sorkine-Hornung 2013, eq. 5), in a time that grows with the logarithm of the part: a cluster of triangles
/// that is far away in its own size counts as one dipole (Barill et al. 2018, the first term).
class WindingNumber {
 public:
  /// On all threads; some nine bytes a triangle.
  explicit WindingNumber(const PackedPart& packed);

  /// The winding number about q, to within 0.05 where the part is closed: 0 outside, 1 or -1 inside.
  /// @param q  relative to the part's centre [m], finite. noexcept, allocates nothing.
  double about(const PackedPart& packed, const Vec3& q) const noexcept;
  /// Whether it is above one half in size: asked roughly at first, which tells most places, and where that is
  /// not clear ever more exactly; in the end a small part is summed up triangle by triangle, a large one with
  /// far fewer dipoles.
  bool encloses(const PackedPart& packed, const Vec3& q) const noexcept;
  /// The same in pieces: nothing where it was broken off.
  std::optional<bool> encloses(const PackedPart& packed, const Vec3& q, WindingWalk& walk,
                               Looks& looks) const noexcept;

  /// The packets that may come near a point or a way, from cluster to cluster, in the part's order.
  class NearPackets;
  /// Them with about the nearest first; where thousands are about as near, not all.
  class NearestPackets;
  /// A packet that is likely near a point. @pre there is one
  std::size_t some_near(const Vec3& at) const noexcept;

  std::size_t memory_bytes() const noexcept {
    return fours_.capacity() * sizeof(Four) + dipoles_.capacity() * sizeof(Dipole);
  }

 private:
  /// Clusters in one of the next level.
  static constexpr unsigned branching_bits = 2;
  static constexpr std::size_t branching = 1U << branching_bits;

  /// A packet, or clusters that follow one another. Lengths scaled, see PackedPart.
  struct Cluster {
    Eigen::Vector3f moment = Eigen::Vector3f::Zero();  ///< sum of area times normal
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();  ///< of gravity
    float radius = 0;                                  ///< no corner is farther from there
    float area = 0;
    Eigen::AlignedBox3f box;  ///< of its packets
  };
  /// What is wanted of a cluster from afar.
  struct Dipole {
    float moment[3], centre[3], radius;
  };
  /// The boxes of the clusters that are one in the next level, side by side, so that they are looked at as
  /// one. Where the last of a level has fewer, those that are not are infinitely far away.
  struct alignas(32) Four {
    float middle[3][4], half[3][4];
    Four() noexcept;
    void set(std::size_t k, const Eigen::AlignedBox3f& box) noexcept;
  };
  /// What rounding to float may take off the distance between a box and a point, or a way: a share of that
  /// distance, and of the part's box and the coordinates of the point, or the way's middle and half. (A place
  /// on the way nearest to a box is off by some ten units in a float's last place of these.)
  static constexpr float radius_rounding = 1e-5F, place_rounding = 2e-6F;
  static float wider_in_floats(double radius) noexcept;

  /// A ball about a point, as clusters are held against it.
  struct Around {
    float at[3], radius2, slack[3];

    /// @param half  the ball is moved about within a box of such half sides
    Around(const Vec3& point, double radius, const Vec3& half = Vec3::Zero()) noexcept;
    void shrink(double radius) noexcept;
    /// Of four clusters those whose boxes come within the ball, a bit each.
    unsigned near(const Four& four) const noexcept;
  };
  /// A ball that moves along a way.
  struct Along {
    float at[3], half[3];  ///< the way's middle, and from there to its end
    float share[3];  ///< half / |half|^2: times what a place is off the middle, how many halves along it is
    float reach;

    Along(const Vec3& middle, double radius, const Vec3& half_way) noexcept;
    /// Of four clusters those of which a ball around comes within reach of the way.
    unsigned near(const Four& four) const noexcept;
  };

  const Four& four(std::size_t level, std::size_t index) const noexcept {
    return fours_[level_start_[level] + index / 4];
  }
  const Dipole& dipole(std::size_t level, std::size_t index) const noexcept {
    return dipoles_[4 * level_start_[level] + index];
  }
  static Cluster cluster_of(const PackedPart& packed, std::size_t packet);
  static Cluster joined(const Cluster* first, const Cluster* end);
  void add_level(const std::vector<Cluster>& clusters);
  std::size_t top() const noexcept { return level_start_.size() - 1; }
  /// Of the largest cluster that begins at a packet.
  std::size_t widest_level(std::size_t packet) const noexcept {
    if (packet == 0) return top();
    return std::min<std::size_t>(top(), static_cast<unsigned>(std::countr_zero(packet)) / branching_bits);
  }
  bool add_half_angles(const PackedPart& packed, const Vec3& q, double far_away, WindingWalk& walk,
                       Looks& looks) const noexcept;

  std::size_t packet_count_ = 0;
  std::vector<Four> fours_;               // level by level, the packets' first
  std::vector<Dipole> dipoles_;           // four of each
  std::vector<std::size_t> level_start_;  // of each level in fours_
};

}  // namespace fingerpad
