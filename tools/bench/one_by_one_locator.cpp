#include <embree3/rtcore.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "contact/closest_point.hpp"
#include "locator.hpp"

// What fingerpad did before it had packets, kept to measure against: each triangle is a primitive of its own,
// and its frame is prepared in double with everything that a closest point asks for.
namespace fingerpad::bench {
namespace {

/// One triangle prepared for closest-point queries, in the frame of Part::vertices.
///
/// Corners are sorted by welded vertex, so that an edge runs from the lower vertex to the higher in both of
/// its triangles and gives both the same bits. Edge 0 joins corners 0 and 1, edge 1 corners 1 and 2, edge 2
/// corners 0 and 2.
struct TriangleFrame {
  std::array<Vec3, 3> corner;  ///< [m]
  std::array<Vec3, 3>
      inward;  ///< unit, in the plane, from edge k into the triangle; zero where no plane is determined
  std::array<double, 3> inverse_length2;    ///< of edge k [1/m^2]; 0 for an edge without length
  std::array<std::uint8_t, 3> part_corner;  ///< corner k of the frame is this corner of the part's triangle
};

/// Where on a frame a closest point lies. `site`: 0 face, 1 + k edge k, 4 + k corner k.
struct FramePoint {
  Vec3 point = Vec3::Zero();
  double distance2_m2 = 0;
  double along = 0;  ///< on an edge: 0 at its first corner, 1 at its second
  int site = 0;
};

constexpr int first_corner[3] = {0, 1, 0};
constexpr int second_corner[3] = {1, 2, 2};

FramePoint on_edge(const TriangleFrame& f, int k, const Vec3& q, double tie_m) noexcept {
  const int i = first_corner[k], j = second_corner[k];
  const Vec3 edge = f.corner[j] - f.corner[i];
  const double along = (q - f.corner[i]).dot(edge) * f.inverse_length2[k];
  FramePoint p;
  const double tie2 = tie_m * tie_m * f.inverse_length2[k];
  if (along <= 0 || along * along <= tie2) {
    p.point = f.corner[i];
    p.site = 4 + i;
  } else if (along >= 1 || (1 - along) * (1 - along) <= tie2) {
    p.point = f.corner[j];
    p.site = 4 + j;
  } else {
    p.point = f.corner[i] + along * edge;
    p.site = 1 + k;
    p.along = along;
  }
  p.distance2_m2 = (q - p.point).squaredNorm();
  return p;
}

/// Distances of q's projection from the three edges' lines, positive inside [m].
Vec3 inside_m(const TriangleFrame& f, const Vec3& q) noexcept {
  const Vec3 from0 = q - f.corner[0], from1 = q - f.corner[1];
  return {from0.dot(f.inward[0]), from1.dot(f.inward[1]), from0.dot(f.inward[2])};
}

/// How near to an edge or a corner rounding cannot tell a point from one on it [m]: a few units in the last
/// place. Points that near are taken to lie on it, so that all triangles there give the same bits and the
/// lowest wins.
double tie_distance_m(const Part& part, const Vec3& q) noexcept {
  return 5e-16 * (part.half_extent.maxCoeff() + q.cwiseAbs().maxCoeff());
}

/// The point of a frame's triangle that lies closest to q; `tie_m` is tie_distance_m(part, q).
///
/// The projection lies inside where it is inside of all three edges; it is then built from the foot on the
/// nearest edge, so that a sliver's badly known normal is multiplied by its small width and costs no more
/// than rounding. Elsewhere the closest point lies on an edge that q is outside of; without a plane that is
/// every edge.
FramePoint closest_in(const TriangleFrame& f, const Vec3& q, double tie_m) noexcept {
  const Vec3 s = inside_m(f, q);
  if (s[0] > tie_m && s[1] > tie_m && s[2] > tie_m) {
    const int k = s[0] <= s[1] ? (s[0] <= s[2] ? 0 : 2) : (s[1] <= s[2] ? 1 : 2);
    FramePoint p = on_edge(f, k, q, tie_m);
    p.point += s[k] * f.inward[k];
    p.site = 0;
    p.distance2_m2 = (q - p.point).squaredNorm();
    return p;
  }
  FramePoint best;
  bool found = false;
  for (int k = 0; k < 3; ++k) {
    if (s[k] > tie_m) continue;
    const FramePoint p = on_edge(f, k, q, tie_m);
    if (!found || p.distance2_m2 < best.distance2_m2) best = p;
    found = true;
  }
  return best;
}

/// A normal, not unit: the cross product of the two shorter edges, where rounding costs least. Zero where
/// rounding alone could have made it.
Vec3 plane_normal(const TriangleFrame& f) noexcept {
  const Vec3 edge[3] = {f.corner[1] - f.corner[0], f.corner[2] - f.corner[1], f.corner[2] - f.corner[0]};
  const double length[3] = {edge[0].norm(), edge[1].norm(), edge[2].norm()};
  const int longest = static_cast<int>(std::max_element(length, length + 3) - length);
  const int a = (longest + 1) % 3, b = (longest + 2) % 3;
  const auto normal = edge[a].cast<long double>().cross(edge[b].cast<long double>()).eval();
  const long double size = normal.norm();
  constexpr double rounding = 1e-15;
  if (!(size > rounding * length[a] * length[b])) return Vec3::Zero();
  // As (corner 1 - corner 0) x (corner 2 - corner 0): with edge 2 = edge 0 + edge 1 the other two pairs are
  // turned round.
  return (normal / (longest == 2 ? size : -size)).cast<double>();
}

/// The unit vector in the plane that points from edge k into the triangle; zero without a plane. Which way
/// that is follows from the order of the corners; a sliver's opposite corner is too near to ask.
Vec3 inward_of(const TriangleFrame& f, int k, const Vec3& unit_normal) noexcept {
  const Vec3 edge = f.corner[second_corner[k]] - f.corner[first_corner[k]];
  const Vec3 across = unit_normal.cross(edge).stableNormalized();
  return k == 2 ? Vec3(-across) : across;
}

TriangleFrame triangle_frame(const Part& part, int t) noexcept {
  TriangleFrame f;
  int order[3] = {0, 1, 2};
  const auto welded = part.welded.col(t);
  std::sort(order, order + 3,
            [&](int a, int b) { return std::make_pair(welded[a], a) < std::make_pair(welded[b], b); });
  for (int k = 0; k < 3; ++k) {
    f.part_corner[k] = static_cast<std::uint8_t>(order[k]);
    f.corner[k] = part.vertices.col(part.triangles(order[k], t));
  }
  const Vec3 unit_normal = plane_normal(f);
  for (int k = 0; k < 3; ++k) {
    const double length2 = (f.corner[second_corner[k]] - f.corner[first_corner[k]]).squaredNorm();
    f.inverse_length2[k] = length2 > 0 && std::isfinite(1 / length2) ? 1 / length2 : 0;
    f.inward[k] = inward_of(f, k, unit_normal);
  }
  return f;
}

struct Frames {
  std::vector<TriangleFrame> of;
  double scale = 1;
};

struct Winner {
  int triangle = std::numeric_limits<int>::max();
  FramePoint at;

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
  double rounding;
  Winner winner;

  float radius(double distance_m) const noexcept {
    return static_cast<float>((distance_m * scale + rounding) * (1 + 2e-6) + 1e-8);
  }
};

bool visit(RTCPointQueryFunctionArguments* args) {
  Search& search = *static_cast<Search*>(args->userPtr);
  const int t = static_cast<int>(args->primID);
  if (!search.winner.offer(t, closest_in(search.frames[t], search.q, search.tie_m))) return false;
  args->query->radius = search.radius(std::sqrt(search.winner.at.distance2_m2));
  return true;
}

void bounds(const RTCBoundsFunctionArguments* args) {
  const auto& frames = *static_cast<const Frames*>(args->geometryUserPtr);
  const TriangleFrame& f = frames.of[args->primID];
  const Vec3 low = f.corner[0].cwiseMin(f.corner[1]).cwiseMin(f.corner[2]) * frames.scale;
  const Vec3 high = f.corner[0].cwiseMax(f.corner[1]).cwiseMax(f.corner[2]) * frames.scale;
  constexpr float padding = 5e-7f;
  RTCBounds& box = *args->bounds_o;
  box.lower_x = static_cast<float>(low.x()) - padding;
  box.lower_y = static_cast<float>(low.y()) - padding;
  box.lower_z = static_cast<float>(low.z()) - padding;
  box.upper_x = static_cast<float>(high.x()) + padding;
  box.upper_y = static_cast<float>(high.y()) + padding;
  box.upper_z = static_cast<float>(high.z()) + padding;
}

class OneByOneLocator : public Locator {
 public:
  explicit OneByOneLocator(std::shared_ptr<const Part> part) : part_(std::move(part)) {
    frames_.scale = std::ldexp(1.0, -std::ilogb(part_->half_extent.maxCoeff()) - 1);
    frames_.of.resize(static_cast<std::size_t>(part_->triangle_count()));
    tbb::parallel_for(0, part_->triangle_count(), [&](int t) { frames_.of[t] = triangle_frame(*part_, t); });
    device_ = rtcNewDevice(__builtin_cpu_supports("avx2") ? "isa=avx2" : nullptr);
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(frames_.of.size()));
    rtcSetGeometryUserData(geometry, &frames_);
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryPointQueryFunction(geometry, visit);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~OneByOneLocator() override {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  double distance2_m2(const Vec3& q) override {
    Search search{frames_.of.data(), q, tie_distance_m(*part_, q), frames_.scale, 0, {}};
    Winner& winner = search.winner;
    winner.at.distance2_m2 = std::numeric_limits<double>::infinity();
    if (last_ >= 0) winner.offer(last_, closest_in(frames_.of[last_], q, search.tie_m));
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    RTCPointQuery query;
    const Vec3 scaled = q * frames_.scale;
    query.x = static_cast<float>(scaled.x());
    query.y = static_cast<float>(scaled.y());
    query.z = static_cast<float>(scaled.z());
    query.time = 0;
    search.rounding = (scaled - Vec3(query.x, query.y, query.z)).cwiseAbs().sum();
    const double to_far_corner_m = q.norm() + 2 * part_->half_extent.maxCoeff();
    query.radius = search.radius(std::min(std::sqrt(winner.at.distance2_m2), to_far_corner_m));
    rtcPointQuery(scene_, &query, &context, nullptr, &search);
    last_ = winner.triangle;
    return winner.at.distance2_m2;
  }

 private:
  std::shared_ptr<const Part> part_;
  Frames frames_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  int last_ = -1;
};

}  // namespace

std::unique_ptr<Locator> make_one_by_one_locator(std::shared_ptr<const Part> part) {
  return std::make_unique<OneByOneLocator>(std::move(part));
}

}  // namespace fingerpad::bench
