#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/segment_crossing.hpp"
#include "contact/tree_parts.hpp"

namespace fingerpad {
namespace {

/// A ray to where it leaves the part.
struct ExitQuery : RayQuery {
  const Part* part;
  int start;  ///< triangle that the ray starts on
  Vec3 origin, direction;
  double scale;
  RayExit exit;
};

bool share_vertex(const Part& part, int a, int b) noexcept {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (part.welded(i, a) == part.welded(j, b)) return true;
    }
  }
  return false;
}

/// Distance along the ray to triangle t where it passes outwards [m], infinite elsewhere
/// (Moeller & Trumbore 1997, in double).
double exit_distance_m(const ExitQuery& search, int t) noexcept {
  constexpr double none = std::numeric_limits<double>::infinity();
  const auto corner = [&](int k) -> Vec3 { return search.part->vertices.col(search.part->triangles(k, t)); };
  const Vec3 a = corner(0), ab = corner(1) - a, ac = corner(2) - a;
  const Vec3 p = search.direction.cross(ac);
  const double determinant = p.dot(ab);  // minus the ray's component along the facet's normal
  if (!(determinant < 0)) return none;
  const Vec3 from_a = search.origin - a;
  const Vec3 r = from_a.cross(ab);
  const double u = from_a.dot(p) / determinant, v = search.direction.dot(r) / determinant;
  constexpr double tolerance = 1e-12;  // a ray through an edge must not slip between both triangles
  if (u < -tolerance || v < -tolerance || u + v > 1 + tolerance) return none;
  const double distance_m = ac.dot(r) / determinant;
  return distance_m >= 0 ? std::abs(distance_m) : none;  // abs: a zero without sign
}

void look_at_exit(RayQuery& query, const TrianglePacket& packet, float& far) {
  ExitQuery& search = static_cast<ExitQuery&>(query);
  RayExit& exit = search.exit;
  for (int lane = 0; lane < packet_width && (packet.used >> lane & 1) != 0; ++lane) {
    const int t = packet.exact[static_cast<std::size_t>(lane)].triangle;
    if (t == search.start) continue;
    const double distance_m = exit_distance_m(search, t);
    if (distance_m > exit.distance_m || (distance_m == exit.distance_m && t >= exit.triangle)) continue;
    if (share_vertex(*search.part, t, search.start)) continue;
    exit = {t, distance_m};
    far = static_cast<float>(distance_m * search.scale * (1 + relative_slack) + ray_slack);
  }
}

/// A segment to where it enters the part.
struct CrossingQuery : RayQuery {
  const Part* part;
  SegmentCrossing crossing;
  double start_m, length_m;  ///< where Embree's ray begins along the segment; the segment's length
  double scale;
  SegmentHit hit;
};

void look_at_crossing(RayQuery& query, const TrianglePacket& packet, float& far) {
  CrossingQuery& search = static_cast<CrossingQuery&>(query);
  SegmentHit& hit = search.hit;
  for (int lane = 0; lane < packet_width && (packet.used >> lane & 1) != 0; ++lane) {
    const int t = packet.exact[static_cast<std::size_t>(lane)].triangle;
    const auto corner = [&](int k) -> Vec3 {
      return search.part->vertices.col(search.part->triangles(k, t));
    };
    const double along = search.crossing.entry(corner(0), corner(1), corner(2));
    if (along > hit.along || (along == hit.along && t >= hit.triangle)) continue;
    hit = {t, along};
    far = static_cast<float>((along * search.length_m - search.start_m) * search.scale + ray_slack);
  }
}

/// Ends of a segment farther away than so many half extents are brought nearer: Embree's floats, and the
/// differences between corners and an end, would hold nothing of the part.
constexpr double segment_range = 1e8;

/// The piece [begin, end] of a segment (0 .. 1) that lies in the box of +- half; empty where begin > end.
struct Piece {
  double begin = 0, end = 1;
};

Piece piece_in_box(const Vec3& from, const Vec3& way, const Vec3& half) noexcept {
  Piece piece;
  for (int i = 0; i < 3; ++i) {
    if (way[i] == 0) {
      if (std::abs(from[i]) > half[i]) return {1, 0};
      continue;
    }
    const double a = (-half[i] - from[i]) / way[i], b = (half[i] - from[i]) / way[i];
    piece.begin = std::max(piece.begin, std::min(a, b));
    piece.end = std::min(piece.end, std::max(a, b));
  }
  return piece;
}

/// Whether a ray can be told to Embree: it starts near the part and its direction is unit, more or less.
bool is_ray_at(const PackedPart& packed, const Vec3& origin, const Vec3& direction) noexcept {
  return !packed.packets.empty() && origin.allFinite() &&
         origin.cwiseAbs().maxCoeff() <= tree_range * packed.extent_m &&
         std::abs(direction.squaredNorm() - 1) < 1e-3;
}

}  // namespace

RayExit TriangleTree::first_exit(int start, const Vec3& origin, const Vec3& direction) const noexcept {
  const PackedPart& packed = impl_->packed;
  if (!is_ray_at(packed, origin, direction)) return {};
  ExitQuery search{{look_at_exit}, packed.part.get(), start, origin, direction, packed.scale, {}};
  impl_->scene.cast(search, origin * packed.scale, direction, std::numeric_limits<double>::infinity());
  return search.exit;
}

SegmentHit TriangleTree::first_crossing(const Vec3& from, const Vec3& to) const noexcept {
  const PackedPart& packed = impl_->packed;
  if (!from.allFinite() || !to.allFinite()) return {};
  const double farthest = std::max(from.cwiseAbs().maxCoeff(), to.cwiseAbs().maxCoeff());
  if (farthest > segment_range * packed.extent_m) return impl_->far_crossing(*this, from, to);
  const Vec3 way = to - from;
  const double length_m = way.stableNorm();
  if (packed.packets.empty() || !(length_m > 0)) return {};
  // Embree gets the piece within the part's box, with room for rounding of the ends.
  const Vec3 half =
      packed.part->half_extent.array() + 1e-6 * packed.extent_m + tie_distance_m(*packed.part, from);
  const Piece piece = piece_in_box(from, way, half);
  if (!(piece.begin <= piece.end)) return {};
  CrossingQuery search{{look_at_crossing},
                       packed.part.get(),
                       SegmentCrossing(from, to),
                       piece.begin * length_m,
                       length_m,
                       packed.scale,
                       {}};
  const double reach_m = (piece.end - piece.begin) * length_m;
  impl_->scene.cast(search, (from + piece.begin * way) * packed.scale, way / length_m,
                    reach_m * packed.scale + ray_slack);
  return search.hit;
}

/// The piece of the segment around the part, with ends that are near enough.
SegmentHit TriangleTree::Impl::far_crossing(const TriangleTree& tree, const Vec3& from,
                                            const Vec3& to) const noexcept {
  const double limit_m = segment_range / 4 * packed.extent_m;
  // In units in which squares are numbers.
  const double unit_m = std::max(from.cwiseAbs().maxCoeff(), to.cwiseAbs().maxCoeff());
  const Vec3 begin = from / unit_m, way = to / unit_m - begin;
  const double length = way.norm();
  if (!(length > 0)) return {};
  const Vec3 direction = way / length;
  const double nearest = std::clamp(-begin.dot(direction), 0.0, length);  // along it, to the part's centre
  const Vec3 middle_m = (begin + nearest * direction) * unit_m;
  if (!(middle_m.cwiseAbs().maxCoeff() <= limit_m)) return {};
  const double before_m = std::min(nearest * unit_m, limit_m),
               after_m = std::min((length - nearest) * unit_m, limit_m);
  SegmentHit hit = tree.first_crossing(middle_m - before_m * direction, middle_m + after_m * direction);
  if (hit.triangle < 0) return {};
  const double past_middle_m = hit.along * (before_m + after_m) - before_m;
  hit.along = std::clamp((nearest + past_middle_m / unit_m) / length, 0.0, 1.0);
  return hit;
}

}  // namespace fingerpad
