#include "contact/winding_number.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace fingerpad {
namespace {

/// Clusters in one of the next level.
constexpr unsigned branching_bits = 2;
constexpr std::size_t branching = 1U << branching_bits;
/// A cluster farther away than this many of its radii counts as a dipole; than the second, where it has to be
/// known better.
constexpr double far_away = 4, very_far_away = 10;
/// Up to so many it is known best by summing up all triangles; of more that would take many ticks.
constexpr std::size_t few_packets = 4096 / packet_width;
/// What rounding to float may take off a cluster's radius, as a share of it and of the part's box.
constexpr double radius_rounding = 1e-5, box_rounding = 1e-6;
/// What the dipoles' error may make of a winding number, with room to spare.
constexpr double unclear = 0.1;

/// Half the solid angle of a triangle (Van Oosterom & Strackee 1983).
double half_angle(const Part& part, int t, const Vec3& q) noexcept {
  const Vec3 a = part.vertices.col(part.triangles(0, t)) - q, b = part.vertices.col(part.triangles(1, t)) - q,
             c = part.vertices.col(part.triangles(2, t)) - q;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double half_angles_of(const PackedPart& packed, std::size_t index, const Vec3& q) noexcept {
  const TrianglePacket& packet = packed.packets[index];
  double sum = 0;
  for (std::size_t lane = 0; lane < packet_width && (packet.used >> lane & 1) != 0; ++lane)
    sum += half_angle(*packed.part, packet.exact[lane].triangle, q);
  return sum;
}

/// Of the largest cluster that begins at a packet.
std::size_t widest_level(std::size_t packet, std::size_t top) {
  return packet == 0
             ? top
             : std::min<std::size_t>(top, static_cast<unsigned>(std::countr_zero(packet)) / branching_bits);
}

}  // namespace

WindingNumber::Cluster WindingNumber::cluster_of(const PackedPart& packed, std::size_t index) {
  const Part& part = *packed.part;
  const TrianglePacket& packet = packed.packets[index];
  Vec3 moment = Vec3::Zero(), weighted = Vec3::Zero();
  double area = 0;
  for (std::size_t lane = 0; lane < packet_width && (packet.used >> lane & 1) != 0; ++lane) {
    const int t = packet.exact[lane].triangle;
    const auto corner = [&](int k) { return Vec3(packed.scale * part.vertices.col(part.triangles(k, t))); };
    const Vec3 a = corner(0), b = corner(1), c = corner(2), moment_here = 0.5 * (b - a).cross(c - a);
    moment += moment_here;
    area += moment_here.norm();
    weighted += moment_here.norm() / 3 * (a + b + c);
  }
  const Vec3 centre = area > 0 ? Vec3(weighted / area) : packet.origin;
  Cluster cluster;
  cluster.moment = moment.cast<float>();
  cluster.centre = centre.cast<float>();
  cluster.radius = packet.radius + static_cast<float>((centre - packet.origin).norm());
  cluster.area = static_cast<float>(area);
  return cluster;
}

WindingNumber::Cluster WindingNumber::joined(std::size_t first, std::size_t end) const {
  Cluster cluster;
  Eigen::Vector3f weighted = Eigen::Vector3f::Zero();
  for (std::size_t i = first; i < end; ++i) {
    cluster.moment += clusters_[i].moment;
    cluster.area += clusters_[i].area;
    weighted += clusters_[i].area * clusters_[i].centre;
  }
  cluster.centre = cluster.area > 0 ? Eigen::Vector3f(weighted / cluster.area) : clusters_[first].centre;
  for (std::size_t i = first; i < end; ++i)
    cluster.radius =
        std::max(cluster.radius, (clusters_[i].centre - cluster.centre).norm() + clusters_[i].radius);
  return cluster;
}

WindingNumber::WindingNumber(const PackedPart& packed) {
  std::size_t count = packed.packets.size();
  clusters_.reserve(count + count / (branching - 1) + 64);
  clusters_.resize(count);
  level_start_ = {0, count};
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { clusters_[i] = cluster_of(packed, i); });
  while (count > 1) {
    const std::size_t below = level_start_[level_start_.size() - 2], below_end = level_start_.back();
    count = (count + branching - 1) / branching;
    for (std::size_t i = 0; i < count; ++i)
      clusters_.push_back(joined(below + i * branching, std::min(below + (i + 1) * branching, below_end)));
    level_start_.push_back(clusters_.size());
  }
}

/// Adds up the half solid angles of the packets from walk.next on; a cluster that is far away in its own size
/// counts as a dipole. False where the looks were spent before the end.
/// @param q  [m]
bool WindingNumber::add_half_angles(const PackedPart& packed, const Vec3& q, double far, WindingWalk& walk,
                                    Looks& looks) const noexcept {
  const std::size_t count = packed.packets.size(), top = level_start_.size() - 2;
  const Vec3 at = packed.scale * q;
  while (walk.next < count) {
    if (looks.are_spent()) return false;
    // The largest cluster that begins here; where it is near, its first part.
    std::size_t level = widest_level(walk.next, top);
    for (;; --level) {
      looks.spend(1);
      const Cluster& here = cluster(level, walk.next >> (branching_bits * level));
      const Vec3 way = here.centre.cast<double>() - at;
      const double distance2 = way.squaredNorm(), near = far * static_cast<double>(here.radius);
      if (distance2 > near * near) {
        walk.half_angles += 0.5 * here.moment.cast<double>().dot(way) / (distance2 * std::sqrt(distance2));
        break;
      }
      if (level > 0) continue;
      walk.half_angles += half_angles_of(packed, walk.next, q);
      looks.spend(LookCosts::angle * packet_width);
      break;
    }
    walk.next += std::size_t{1} << (branching_bits * level);
  }
  return true;
}

double WindingNumber::about(const PackedPart& packed, const Vec3& q) const noexcept {
  WindingWalk walk;
  Looks looks(Looks::unlimited);
  add_half_angles(packed, q, far_away, walk, looks);
  return walk.half_angles / (2 * std::numbers::pi);
}

std::optional<bool> WindingNumber::encloses(const PackedPart& packed, const Vec3& q, WindingWalk& walk,
                                            Looks& looks) const noexcept {
  const bool is_small = packed.packets.size() <= few_packets;
  const double better = is_small ? std::numeric_limits<double>::infinity() : very_far_away;
  for (;; walk = {0, 0, 1}) {
    if (!add_half_angles(packed, q, walk.round == 0 ? far_away : better, walk, looks)) return std::nullopt;
    const double number = std::abs(walk.half_angles) / (2 * std::numbers::pi);
    if (walk.round > 0 || std::abs(number - 0.5) >= unclear) return number > 0.5;
  }
}

bool WindingNumber::encloses(const PackedPart& packed, const Vec3& q) const noexcept {
  WindingWalk walk;
  Looks looks(Looks::unlimited);
  return encloses(packed, q, walk, looks).value_or(false);
}

std::size_t WindingNumber::next_near(std::size_t packet, const Vec3& at, double radius,
                                     long& tests) const noexcept {
  const auto is_near = [&](const Cluster& c) {
    const double grown = static_cast<double>(c.radius) * (1 + radius_rounding) + box_rounding + radius;
    return (c.centre.cast<double>() - at).squaredNorm() <= grown * grown;
  };
  const std::size_t count = level_start_[1], top = level_start_.size() - 2;
  while (packet < count) {
    // The largest cluster that begins here; it is passed by as a whole, or its first part is looked at.
    std::size_t level = widest_level(packet, top);
    for (;; --level) {
      ++tests;
      if (!is_near(cluster(level, packet >> (branching_bits * level)))) break;
      if (level == 0) return packet;
    }
    packet += std::size_t{1} << (branching_bits * level);
  }
  return count;
}

std::size_t WindingNumber::some_near(const Vec3& at) const noexcept {
  std::size_t index = 0;
  for (std::size_t level = level_start_.size() - 2; level-- > 0;) {
    const std::size_t first = index * branching,
                      end = std::min(first + branching, level_start_[level + 1] - level_start_[level]);
    double least2 = std::numeric_limits<double>::infinity();
    for (std::size_t i = first; i < end; ++i) {
      const double distance2 = (cluster(level, i).centre.cast<double>() - at).squaredNorm();
      if (!(distance2 < least2)) continue;
      least2 = distance2;
      index = i;
    }
    index = std::max(index, first);
  }
  return index;
}

}  // namespace fingerpad
