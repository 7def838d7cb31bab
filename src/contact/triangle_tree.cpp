#include "contact/triangle_tree.hpp"

#include <embree3/rtcore.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "contact/segment_crossing.hpp"
#include "contact/triangle_frame.hpp"

namespace fingerpad {
namespace {

// Embree sees the part scaled by a power of two so that its box lies within [-1, 1]. There, in its float
// arithmetic: a box corner moves by 3e-8 when rounded; a ray of length 4 strays by 3e-7; a squared distance
// is off by about 1e-6 of itself at most. The paddings below are above these, so that nothing which could win
// or tie is passed over.
constexpr float box_padding = 5e-7f;
constexpr double relative_slack = 2e-6;
constexpr double absolute_slack = 1e-8;
/// Added to a ray's end, scaled: above a float's rounding of lengths up to 4.
constexpr double ray_slack = 1e-6;
/// Beyond so many half extents float boxes no longer tell triangles apart: every triangle is looked at.
constexpr double tree_range = 1e4;
/// Beyond so many half extents only the direction of a point matters.
constexpr double direction_range = 1 << 20;

/// What Embree's callbacks see of a tree.
struct Frames {
  std::vector<TriangleFrame> of;
  double scale = 1;  ///< Embree's coordinate of one metre, a power of two
};

}  // namespace

struct TriangleTree::Impl {
  std::shared_ptr<const Part> part;
  Frames frames;
  double extent_m = 0;  ///< longest half side of the part's box
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
  void build();
  /// Whether a point is surely farther away than reach_m, or this is no number; `farthest_m` is the point's
  /// largest coordinate. Leaves room for rounding.
  bool out_of_reach(double farthest_m, double reach_m) const noexcept {
    return !(farthest_m - extent_m <= reach_m + 1e-14 * (farthest_m + extent_m));
  }
  ClosestTriangle far_closest(const Vec3& q, double reach_m) const noexcept;
};

namespace {

struct Winner {
  int triangle = std::numeric_limits<int>::max();
  FramePoint at;

  /// Takes triangle t if it is closer, or as close and lower. True if it is closer.
  bool offer(int t, const FramePoint& p) noexcept {
    const bool closer = p.distance2_m2 < at.distance2_m2;
    if (closer || (p.distance2_m2 == at.distance2_m2 && t < triangle)) {
      triangle = t;
      at = p;
    }
    return closer;
  }
};

struct Search {
  const TriangleFrame* frames;
  Vec3 q;
  double tie_m;
  double scale;
  double rounding;  ///< how far Embree's query point lies from q, scaled
  Winner winner;

  float radius(double distance_m) const noexcept {
    return static_cast<float>((distance_m * scale + rounding) * (1 + relative_slack) + absolute_slack);
  }
};

bool visit(RTCPointQueryFunctionArguments* args) {
  Search& search = *static_cast<Search*>(args->userPtr);
  const int t = static_cast<int>(args->primID);
  if (!search.winner.offer(t, closest_in(search.frames[t], search.q, search.tie_m))) return false;
  args->query->radius = search.radius(std::sqrt(search.winner.at.distance2_m2));
  return true;
}

/// A search for all triangles within a fixed reach.
struct WithinSearch {
  const TriangleFrame* frames;
  Vec3 q;
  double tie_m;
  double reach_m;
  void (*found)(void* context, int triangle);
  void* context;

  void look_at(int t) const noexcept {
    const FramePoint p = closest_in(frames[t], q, tie_m);
    const bool within = std::isfinite(p.distance2_m2) ? p.distance2_m2 <= reach_m * reach_m
                                                      : (q - p.point).stableNorm() <= reach_m;
    if (within) found(context, t);
  }
};

bool visit_within(RTCPointQueryFunctionArguments* args) {
  static_cast<const WithinSearch*>(args->userPtr)->look_at(static_cast<int>(args->primID));
  return false;
}

/// An Embree ray with the exact search behind it.
struct AnyRay {
  RTCIntersectContext context;  // first, so that Embree's pointer to it is a pointer to this
  void (*look_at)(AnyRay& search, int t, float& far);  ///< may shorten the ray
};

struct CrossingSearch : AnyRay {
  const Part* part;
  SegmentCrossing crossing;
  double start_m, length_m;  ///< where Embree's ray begins along the segment; the segment's length
  double scale;
  SegmentHit hit;
};

void look_at_crossing(AnyRay& any, int t, float& far) {
  CrossingSearch& search = static_cast<CrossingSearch&>(any);
  const auto corner = [&](int k) -> Vec3 { return search.part->vertices.col(search.part->triangles(k, t)); };
  const double along = search.crossing.entry(corner(0), corner(1), corner(2));
  SegmentHit& hit = search.hit;
  if (along > hit.along || (along == hit.along && t >= hit.triangle)) return;
  hit = {t, along};
  far = static_cast<float>((along * search.length_m - search.start_m) * search.scale + ray_slack);
}

/// An Embree ray with the exact one behind it.
struct RaySearch : AnyRay {
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
double exit_distance_m(const RaySearch& search, int t) noexcept {
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

void look_at_exit(AnyRay& any, int t, float& far) {
  RaySearch& search = static_cast<RaySearch&>(any);
  if (t == search.start) return;
  const double distance_m = exit_distance_m(search, t);
  RayExit& exit = search.exit;
  if (distance_m > exit.distance_m || (distance_m == exit.distance_m && t >= exit.triangle)) return;
  if (share_vertex(*search.part, t, search.start)) return;
  exit = {t, distance_m};
  far = static_cast<float>(distance_m * search.scale * (1 + relative_slack) + ray_slack);
}

void intersect(const RTCIntersectFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  AnyRay& search = *reinterpret_cast<AnyRay*>(args->context);
  RTCRayHit& ray = *reinterpret_cast<RTCRayHit*>(args->rayhit);
  const float far = ray.ray.tfar;
  search.look_at(search, static_cast<int>(args->primID), ray.ray.tfar);
  if (ray.ray.tfar >= far) return;
  ray.hit.primID = args->primID;
  ray.hit.geomID = args->geomID;
}

/// Sends a ray with a unit direction through the scene; `from` and `length` scaled.
void cast(RTCScene scene, AnyRay& search, const Vec3& from, const Vec3& direction, double length) noexcept {
  rtcInitIntersectContext(&search.context);
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(from.x());
  ray.ray.org_y = static_cast<float>(from.y());
  ray.ray.org_z = static_cast<float>(from.z());
  ray.ray.dir_x = static_cast<float>(direction.x());
  ray.ray.dir_y = static_cast<float>(direction.y());
  ray.ray.dir_z = static_cast<float>(direction.z());
  ray.ray.tnear = 0;
  ray.ray.tfar = static_cast<float>(length);
  ray.ray.mask = ~0u;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &search.context, &ray);
}

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

void bounds(const RTCBoundsFunctionArguments* args) {
  const auto& frames = *static_cast<const Frames*>(args->geometryUserPtr);
  const TriangleFrame& f = frames.of[args->primID];
  const Vec3 low = f.corner[0].cwiseMin(f.corner[1]).cwiseMin(f.corner[2]) * frames.scale;
  const Vec3 high = f.corner[0].cwiseMax(f.corner[1]).cwiseMax(f.corner[2]) * frames.scale;
  RTCBounds& box = *args->bounds_o;
  box.lower_x = static_cast<float>(low.x()) - box_padding;
  box.lower_y = static_cast<float>(low.y()) - box_padding;
  box.lower_z = static_cast<float>(low.z()) - box_padding;
  box.upper_x = static_cast<float>(high.x()) + box_padding;
  box.upper_y = static_cast<float>(high.y()) + box_padding;
  box.upper_z = static_cast<float>(high.z()) + box_padding;
}

/// Every triangle in turn: for points so far away that a tree of float boxes sees no difference between them.
Winner look_at_all(const std::vector<TriangleFrame>& frames, const Vec3& q, double tie_m) noexcept {
  Winner winner;
  winner.at.distance2_m2 = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < frames.size(); ++t)
    winner.offer(static_cast<int>(t), closest_in(frames[t], q, tie_m));
  return winner;
}

}  // namespace

void TriangleTree::Impl::build() {
  // The widest instruction set is not the fastest: 8-wide boxes were 8-13 % faster than 16-wide ones.
  device = rtcNewDevice(__builtin_cpu_supports("avx2") ? "isa=avx2" : nullptr);
  if (device == nullptr) throw Error(ErrorKind::fault, "", "Embree cannot start");
  scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(frames.of.size()));
  rtcSetGeometryUserData(geometry, &frames);
  rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE) {
    throw Error(ErrorKind::fault, "",
                "Embree cannot build a tree of " + std::to_string(frames.of.size()) +
                    " triangles (its error " + std::to_string(error) + ")");
  }
}

TriangleTree::TriangleTree(std::shared_ptr<const Part> part) : impl_(std::make_unique<Impl>()) {
  Impl& impl = *impl_;
  impl.part = std::move(part);
  impl.extent_m = impl.part->half_extent.maxCoeff();
  if (impl.extent_m > 0) impl.frames.scale = std::ldexp(1.0, -std::ilogb(impl.extent_m) - 1);
  const int count = impl.part->triangle_count();
  impl.frames.of.resize(static_cast<std::size_t>(count));
  tbb::parallel_for(0, count, [&](int t) { impl.frames.of[t] = triangle_frame(*impl.part, t); });
  impl.build();
}

TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;

const Part& TriangleTree::part() const noexcept {
  return *impl_->part;
}

ClosestTriangle TriangleTree::closest(const Vec3& q, int seed, double reach_m) const noexcept {
  const Impl& impl = *impl_;
  const double farthest = q.cwiseAbs().maxCoeff();
  if (impl.frames.of.empty() || !q.allFinite()) return {};
  if (impl.out_of_reach(farthest, reach_m)) return {};
  if (farthest > tree_range * impl.extent_m) return impl.far_closest(q, reach_m);

  Search search{impl.frames.of.data(), q, tie_distance_m(*impl.part, q), impl.frames.scale, 0, {}};
  Winner& winner = search.winner;
  winner.at.distance2_m2 = reach_m * reach_m;
  const int count = static_cast<int>(impl.frames.of.size());
  if (seed >= 0 && seed < count) winner.offer(seed, closest_in(impl.frames.of[seed], q, search.tie_m));

  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  RTCPointQuery query;
  const Vec3 scaled = q * impl.frames.scale;
  query.x = static_cast<float>(scaled.x());
  query.y = static_cast<float>(scaled.y());
  query.z = static_cast<float>(scaled.z());
  query.time = 0;
  search.rounding = (scaled - Vec3(query.x, query.y, query.z)).cwiseAbs().sum();
  const double to_far_corner_m = q.norm() + 2 * impl.extent_m;
  query.radius = search.radius(std::min(std::sqrt(winner.at.distance2_m2), to_far_corner_m));
  rtcPointQuery(impl.scene, &query, &context, visit, &search);

  if (winner.triangle >= count) return {};
  return {winner.triangle, in_part_corners(impl.frames.of[winner.triangle], winner.at, q)};
}

ClosestTriangle TriangleTree::Impl::far_closest(const Vec3& q, double reach_m) const noexcept {
  const double farthest = q.cwiseAbs().maxCoeff();
  const double limit = direction_range * extent_m;
  const Vec3 nearer = farthest > limit ? Vec3(q / farthest * limit) : q;
  const Winner winner = look_at_all(frames.of, nearer, tie_distance_m(*part, nearer));
  ClosestTriangle result{winner.triangle, in_part_corners(frames.of[winner.triangle], winner.at, nearer)};
  const double distance_m = (q - result.at.point).stableNorm();
  if (farthest > limit) result.at.distance2_m2 = distance_m * distance_m;
  if (!(distance_m <= reach_m)) return {};
  return result;
}

void TriangleTree::each_within(const Vec3& q, double reach_m, void (*visit)(void* context, int triangle),
                               void* context) const noexcept {
  const Impl& impl = *impl_;
  const double farthest = q.cwiseAbs().maxCoeff();
  if (impl.frames.of.empty() || !q.allFinite() || !(reach_m >= 0)) return;
  if (impl.out_of_reach(farthest, reach_m)) return;
  const WithinSearch search{impl.frames.of.data(), q, tie_distance_m(*impl.part, q), reach_m, visit, context};
  if (farthest > tree_range * impl.extent_m) {
    for (int t = 0; t < static_cast<int>(impl.frames.of.size()); ++t) search.look_at(t);
    return;
  }
  RTCPointQueryContext query_context;
  rtcInitPointQueryContext(&query_context);
  RTCPointQuery query;
  const Vec3 scaled = q * impl.frames.scale;
  query.x = static_cast<float>(scaled.x());
  query.y = static_cast<float>(scaled.y());
  query.z = static_cast<float>(scaled.z());
  query.time = 0;
  const double rounding = (scaled - Vec3(query.x, query.y, query.z)).cwiseAbs().sum();
  const double bound = std::min(reach_m, q.norm() + 2 * impl.extent_m) * impl.frames.scale + rounding;
  query.radius = static_cast<float>(bound * (1 + relative_slack) + absolute_slack);
  rtcPointQuery(impl.scene, &query, &query_context, visit_within, const_cast<WithinSearch*>(&search));
}

SegmentHit TriangleTree::first_crossing(const Vec3& from, const Vec3& to) const noexcept {
  const Impl& impl = *impl_;
  const Vec3 way = to - from;
  const double length_m = way.stableNorm();
  if (impl.frames.of.empty() || !(length_m > 0) || !std::isfinite(length_m) || !from.allFinite()) return {};
  // Embree gets the piece within the part's box, with room for rounding of the ends.
  const Vec3 half = impl.part->half_extent.array() + 1e-6 * impl.extent_m + tie_distance_m(*impl.part, from);
  const Piece piece = piece_in_box(from, way, half);
  if (!(piece.begin <= piece.end)) return {};
  CrossingSearch search{{{}, look_at_crossing},
                        impl.part.get(),
                        SegmentCrossing(from, to),
                        piece.begin * length_m,
                        length_m,
                        impl.frames.scale,
                        {}};
  const double reach_m = (piece.end - piece.begin) * length_m;
  cast(impl.scene, search, (from + piece.begin * way) * impl.frames.scale, way / length_m,
       reach_m * impl.frames.scale + ray_slack);
  return search.hit;
}

RayExit TriangleTree::first_exit(int start, const Vec3& origin, const Vec3& direction) const noexcept {
  RaySearch search{{{}, look_at_exit}, impl_->part.get(), start, origin, direction, impl_->frames.scale, {}};
  cast(impl_->scene, search, origin * impl_->frames.scale, direction,
       std::numeric_limits<double>::infinity());
  return search.exit;
}

}  // namespace fingerpad
