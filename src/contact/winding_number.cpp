#include "contact/winding_number.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace fingerpad {
namespace {

/// Clusters in one of the next level.
constexpr std::size_t branching = 4;
/// A cluster farther away than this many of its radii counts as a dipole.
constexpr double far_away = 4;
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

/// @param q  [m]
double WindingNumber::half_angles(const PackedPart& packed, std::size_t level, std::size_t index,
                                  const Vec3& q) const noexcept {
  const Cluster& cluster = clusters_[level_start_[level] + index];
  const Vec3 way = cluster.centre.cast<double>() - packed.scale * q;
  const double distance2 = way.squaredNorm(), near = far_away * static_cast<double>(cluster.radius);
  if (distance2 > near * near)
    return 0.5 * cluster.moment.cast<double>().dot(way) / (distance2 * std::sqrt(distance2));
  if (level == 0) return half_angles_of(packed, index, q);
  const std::size_t count = level_start_[level] - level_start_[level - 1];
  double sum = 0;
  for (std::size_t i = index * branching; i < std::min((index + 1) * branching, count); ++i)
    sum += half_angles(packed, level - 1, i, q);
  return sum;
}

double WindingNumber::about(const PackedPart& packed, const Vec3& q) const noexcept {
  return clusters_.empty() ? 0 : half_angles(packed, level_start_.size() - 2, 0, q) / (2 * std::numbers::pi);
}

bool WindingNumber::encloses(const PackedPart& packed, const Vec3& q) const noexcept {
  double number = std::abs(about(packed, q));
  if (std::abs(number - 0.5) < unclear) {
    double sum = 0;
    for (std::size_t i = 0; i < packed.packets.size(); ++i) sum += half_angles_of(packed, i, q);
    number = std::abs(sum) / (2 * std::numbers::pi);
  }
  return number > 0.5;
}

}  // namespace fingerpad
