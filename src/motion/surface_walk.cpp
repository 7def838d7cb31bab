#include "motion/surface_walk.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "base/tangent_frame.hpp"
#include "contact/surface_point.hpp"

namespace fingerpad {
namespace {

/// Where a point stands, and which way its distance grows.
struct Standing {
  SurfacePoint nearest;
  Vec3 away_P = Vec3::UnitZ();
};

Standing standing_at(const TriangleTree& tree, const Vec3& p_P, double tolerance_m, ClosestMemory& memory) {
  Standing standing{
      nearest_surface_point(tree, p_P, Normals::facet, memory, std::numeric_limits<double>::infinity())};
  const SurfacePoint& nearest = standing.nearest;
  // On the surface itself the way to it says nothing.
  standing.away_P = std::abs(nearest.signed_distance_m) > tolerance_m
                        ? Vec3((p_P - nearest.point_P) / nearest.signed_distance_m)
                        : nearest.pseudonormal_P;
  return standing;
}

/// Whether the point of the surface nearest to p_P is one of an open rim, or of an edge of three triangles.
bool is_on_rim(const Part& part, int t, const Vec3& p_P) {
  const TrianglePoint at = closest_on_triangle(part, t, p_P - part.centre_P);
  const auto is_open = [&](int edge) { return part.neighbours(edge % 3, t) < 0; };
  switch (at.feature) {
    case Feature::face:
      return false;
    case Feature::edge0:
    case Feature::edge1:
    case Feature::edge2:
      return is_open(static_cast<int>(at.feature) - static_cast<int>(Feature::edge0));
    case Feature::vertex0:
    case Feature::vertex1:
    case Feature::vertex2: {
      const int corner = static_cast<int>(at.feature) - static_cast<int>(Feature::vertex0);
      return is_open(corner) || is_open(corner + 2);
    }
  }
  return false;
}

Vec3 turned(const Vec3& heading, const Vec3& normal, double angle_rad) {
  return std::cos(angle_rad) * heading + std::sin(angle_rad) * normal.cross(heading);
}

/// The heading where the normal has become another: turned as little as that asks for.
Vec3 carried(const Vec3& heading, const Vec3& normal, const Vec3& to_normal) {
  Mat3 frame;
  frame << heading.cross(normal), heading, normal;  // columns: across, along, out
  return transported(frame, to_normal).col(1);
}

}  // namespace

SurfaceWalk::SurfaceWalk(const TriangleTree& tree, double distance_m, double tolerance_m)
    : tree_(tree), distance_m_(distance_m), tolerance_m_(tolerance_m) {}

double SurfaceWalk::distance_at(const Vec3& p_P) {
  return nearest_surface_point(tree_, p_P, Normals::facet, memory_, std::numeric_limits<double>::infinity())
      .signed_distance_m;
}

/// Brings the walker to its distance; in a corner by turns away from both walls.
bool SurfaceWalk::settle(SurfaceWalker& walker) {
  constexpr int most_rounds = 20;
  for (int round = 0; round < most_rounds; ++round) {
    const Standing standing = standing_at(tree_, walker.p_P, tolerance_m_, memory_);
    if (standing.nearest.triangle < 0) return false;
    const double off_m = standing.nearest.signed_distance_m - distance_m_;
    if (std::abs(off_m) <= tolerance_m_) {
      walker.foot_P = standing.nearest.point_P;
      return !is_on_rim(tree_.part(), standing.nearest.triangle, walker.p_P);
    }
    walker.p_P -= off_m * standing.away_P;
  }
  return false;
}

bool SurfaceWalk::start(int t, const Vec3& surface_P, double heading_rad, SurfaceWalker& walker) {
  const Vec3 normal = tree_.part().facet_normals.col(t);
  walker.normal_P = normal;
  walker.heading_P = turned(tangent_frame(normal, Vec3::UnitX()).col(1), normal, heading_rad);
  walker.p_P = surface_P + distance_m_ * normal;
  halts_ = 0;
  constexpr double close_enough = 0.05;
  const double off_m = std::abs(distance_at(walker.p_P) - distance_m_);
  return off_m <= close_enough * std::abs(distance_m_) + tolerance_m_ && settle(walker);
}

bool SurfaceWalk::step(double step_m, double turn_rad, SurfaceWalker& walker) {
  const Vec3 from = walker.p_P;
  const Vec3 heading = turned(walker.heading_P, walker.normal_P, turn_rad / 2);
  walker.p_P += step_m * heading;
  // The wall that is met counts, not the one that is left.
  const Vec3 normal = standing_at(tree_, walker.p_P, tolerance_m_, memory_).away_P;
  walker.heading_P = turned(carried(heading, walker.normal_P, normal), normal, turn_rad / 2);
  walker.normal_P = normal;
  if (!settle(walker)) return false;
  constexpr double leap = 2, halt = 0.2;  // of a step
  constexpr int most_halts = 4;
  const double gone_m = (walker.p_P - from).norm();
  halts_ = gone_m < halt * step_m ? halts_ + 1 : 0;
  return gone_m <= leap * step_m && halts_ <= most_halts;
}

}  // namespace fingerpad
