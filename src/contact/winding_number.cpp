#include "contact/winding_number.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/large_pages.hpp"
#include "contact/four_floats.hpp"

namespace fingerpad {
namespace {

/// A cluster farther away than this many of its radii counts as a dipole.
constexpr double far_away = 4;
/// Whether a point is enclosed is asked in rounds, each more exact than the one before: a number that is
/// farther from one half than `unclear` tells, with room for what the dipoles' error may make of it (up to
/// 0.12 in the first round and 0.03 in the second, over ten real parts).
struct Round {
  double far_away, unclear;
};
constexpr Round rounds[] = {{1.5, 0.3}, {far_away, 0.1}, {10, 0}};
constexpr int last_round = 2;
/// Up to so many it is known best by summing up all triangles; of more that would take many ticks.
constexpr std::size_t few_packets = 4096 / packet_width;

/// Adds up angles between -pi and pi (both ends apart), each given as a complex number of that argument:
/// their product's argument, and how often it went round, are told at the end by a single arc tangent.
/// @pre the products fit a double; of one that is rounded to 0 no round is counted
class Turns {
 public:
  void add(double x, double y) noexcept {
    if (x == 0 && y == 0) return;
    const double turned_x = x_ * x - y_ * y, turned_y = x_ * y + y_ * x;
    if (y_ >= 0 && y >= 0 && turned_y < 0) ++rounds_;
    const bool is_beyond = turned_y > 0 || (turned_y == 0 && turned_x < 0);
    if (y_ < 0 && y < 0 && is_beyond) --rounds_;
    x_ = turned_x;
    y_ = turned_y + 0.0;  // no -0, of which the arc tangent makes -pi: the round that was taken off above
  }
  double sum() const noexcept { return 2 * std::numbers::pi * rounds_ + std::atan2(y_, x_); }

 private:
  double x_ = 1, y_ = 0;
  int rounds_ = 0;
};

/// Adds half the solid angle of a triangle (Van Oosterom & Strackee 1983).
/// @param scale  makes the part's size about 1, so that of eight triangles the lengths' product fits a double
void add_half_angle(const Part& part, int t, const Vec3& q, double scale, Turns& turns) noexcept {
  const auto seen = [&](int k) { return Vec3(scale * (part.vertices.col(part.triangles(k, t)) - q)); };
  const Vec3 a = seen(0), b = seen(1), c = seen(2);
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  turns.add(la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb, a.dot(b.cross(c)));
}

double half_angles_of(const PackedPart& packed, std::size_t index, const Vec3& q) noexcept {
  const TrianglePacket& packet = packed.packets[index];
  Turns turns;
  for (std::size_t lane = 0; lane < packet_width && (packet.used >> lane & 1) != 0; ++lane)
    add_half_angle(*packed.part, packet.exact[lane].triangle, q, packed.scale, turns);
  return turns.sum();
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
  for (const double side : {-1.0, 1.0}) {
    const Vec3 corner =
        packet.origin + side * Vec3(packet.box_half[0], packet.box_half[1], packet.box_half[2]);
    cluster.box.extend(corner.cast<float>());
  }
  return cluster;
}

WindingNumber::Cluster WindingNumber::joined(const Cluster* first, const Cluster* end) {
  Cluster cluster;
  Eigen::Vector3f weighted = Eigen::Vector3f::Zero();
  for (const Cluster* part = first; part != end; ++part) {
    cluster.moment += part->moment;
    cluster.area += part->area;
    weighted += part->area * part->centre;
    cluster.box.extend(part->box);
  }
  cluster.centre = cluster.area > 0 ? Eigen::Vector3f(weighted / cluster.area) : first->centre;
  for (const Cluster* part = first; part != end; ++part)
    cluster.radius = std::max(cluster.radius, (part->centre - cluster.centre).norm() + part->radius);
  return cluster;
}

WindingNumber::Four::Four() noexcept : half{} {
  for (auto& coordinate : middle)
    std::fill(std::begin(coordinate), std::end(coordinate), std::numeric_limits<float>::infinity());
}

void WindingNumber::Four::set(std::size_t k, const Eigen::AlignedBox3f& box) noexcept {
  for (int i = 0; i < 3; ++i) {
    middle[i][k] = box.center()[i];
    half[i][k] = box.sizes()[i] / 2;
  }
}

float WindingNumber::wider_in_floats(double radius) noexcept {
  return static_cast<float>(std::min(radius, static_cast<double>(far_off))) * (1 + radius_rounding);
}

WindingNumber::Along::Along(const Vec3& middle, double radius, const Vec3& half_way) noexcept {
  const double per_length2 = 1 / half_way.squaredNorm();
  double farthest = 1;
  for (int i = 0; i < 3; ++i) {
    at[i] = static_cast<float>(middle[i]);
    half[i] = static_cast<float>(half_way[i]);
    share[i] = static_cast<float>(half_way[i] * per_length2);
    farthest += std::abs(middle[i]) + std::abs(half_way[i]);
  }
  reach = wider_in_floats(radius) + static_cast<float>(farthest) * place_rounding;
}

unsigned WindingNumber::Along::near(const Four& four) const noexcept {
  using namespace four_floats;
  FourFloats off[3], size2 = {}, along = {};
  for (int i = 0; i < 3; ++i) {
    const FourFloats size = load(four.half[i]);
    off[i] = load(four.middle[i]) - at[i];
    size2 += size * size;
    along += off[i] * share[i];
  }
  along = lesser_of(greater_of(along, FourFloats{} - 1.0F), FourFloats{} + 1.0F);
  FourFloats beside2 = {};
  for (int i = 0; i < 3; ++i) {
    const FourFloats beside = off[i] - along * half[i];
    beside2 += beside * beside;
  }
  const FourFloats within = root_of(size2) * (1 + radius_rounding) + reach;
  return to_mask(beside2 <= within * within);
}

WindingNumber::Around::Around(const Vec3& point, double radius, const Vec3& half) noexcept {
  shrink(radius);
  float rounding = 1;
  for (int i = 0; i < 3; ++i) {
    at[i] = static_cast<float>(point[i]);
    rounding += std::abs(at[i]);
  }
  for (int i = 0; i < 3; ++i)
    slack[i] = rounding * place_rounding + static_cast<float>(std::abs(half[i])) * (1 + radius_rounding);
}

void WindingNumber::Around::shrink(double radius) noexcept {
  const float wider = wider_in_floats(radius);
  radius2 = wider * wider;
}

unsigned WindingNumber::Around::near(const Four& four) const noexcept {
  using namespace four_floats;
  FourFloats beyond2 = {};
  for (int i = 0; i < 3; ++i) {
    const FourFloats off = load(four.middle[i]) - at[i];
    const FourFloats beyond = greater_of(greater_of(off, -off) - load(four.half[i]) - slack[i], FourFloats{});
    beyond2 += beyond * beyond;
  }
  return to_mask(beyond2 <= radius2);
}

void WindingNumber::add_level(const std::vector<Cluster>& clusters) {
  level_start_.push_back(fours_.size());
  fours_.resize(fours_.size() + (clusters.size() + branching - 1) / branching);
  dipoles_.resize(branching * fours_.size());
  Four* const fours = fours_.data() + level_start_.back();
  Dipole* dipole = dipoles_.data() + branching * level_start_.back();
  for (std::size_t i = 0; i < clusters.size(); ++i, ++dipole) {
    const Cluster& c = clusters[i];
    fours[i / branching].set(i % branching, c.box);
    *dipole = {{c.moment[0], c.moment[1], c.moment[2]}, {c.centre[0], c.centre[1], c.centre[2]}, c.radius};
  }
}

WindingNumber::WindingNumber(const PackedPart& packed) : packet_count_(packed.packets.size()) {
  std::vector<Cluster> clusters(packet_count_);
  tbb::parallel_for(std::size_t{0}, packet_count_,
                    [&](std::size_t i) { clusters[i] = cluster_of(packed, i); });
  fours_.reserve(packet_count_ / (branching - 1) + 16);  // a level rounds up by one at most
  dipoles_.reserve(branching * fours_.capacity());
  add_level(clusters);
  while (clusters.size() > 1) {
    std::vector<Cluster> next((clusters.size() + branching - 1) / branching);
    for (std::size_t i = 0; i < next.size(); ++i)
      next[i] =
          joined(&clusters[i * branching], clusters.data() + std::min((i + 1) * branching, clusters.size()));
    clusters = std::move(next);
    add_level(clusters);
  }
  keep_in_large_pages(fours_);
  keep_in_large_pages(dipoles_);
}

/// Adds up the half solid angles of the packets from walk.next on; a cluster that is far away in its own size
/// counts as a dipole. False where the looks were spent before the end.
/// @param q  [m]
bool WindingNumber::add_half_angles(const PackedPart& packed, const Vec3& q, double far, WindingWalk& walk,
                                    Looks& looks) const noexcept {
  const Vec3 at = packed.scale * q;
  while (walk.next < packet_count_) {
    if (looks.are_spent()) return false;
    // The largest cluster that begins here; where it is near, its first part.
    std::size_t level = widest_level(walk.next);
    for (;; --level) {
      looks.spend(LookCosts::dipole);
      const Dipole& here = dipole(level, walk.next >> (branching_bits * level));
      const Vec3 way = Vec3(here.centre[0], here.centre[1], here.centre[2]) - at;
      const double distance2 = way.squaredNorm(), near = far * static_cast<double>(here.radius);
      if (distance2 > near * near) {
        const Vec3 moment(here.moment[0], here.moment[1], here.moment[2]);
        walk.half_angles += 0.5 * moment.dot(way) / (distance2 * std::sqrt(distance2));
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
  for (;; walk = {0, 0, walk.round + 1}) {
    const Round& round = rounds[walk.round];
    const bool is_summed_up = is_small && walk.round == last_round;
    const double far = is_summed_up ? std::numeric_limits<double>::infinity() : round.far_away;
    if (!add_half_angles(packed, q, far, walk, looks)) return std::nullopt;
    const double number = std::abs(walk.half_angles) / (2 * std::numbers::pi);
    if (walk.round == last_round || std::abs(number - 0.5) >= round.unclear) return number > 0.5;
  }
}

bool WindingNumber::encloses(const PackedPart& packed, const Vec3& q) const noexcept {
  WindingWalk walk;
  Looks looks(Looks::unlimited);
  return encloses(packed, q, walk, looks).value_or(false);
}

}  // namespace fingerpad
