#include "contact/curved_closest.hpp"

#include <algorithm>
#include <cmath>

#include "contact/facet_rule.hpp"

namespace fingerpad {
namespace {

constexpr int most_steps = 24;
constexpr int most_hops = 12;
/// Steps shorter than this fraction of the patch are taken without asking whether they come nearer: rounding
/// hides that, while Newton's method is certain there.
constexpr double surely_converging = 1e-6;
/// A step so short is the last: of Newton's method, whose error squares; and of Gauss-Newton, whose error
/// falls by a share.
constexpr double last_newton = 1e-7, last_gauss_newton = 1e-13;

/// Newton is taken where the squared distance's curvature is more than this share of what it is far from the
/// surface. It falls to 0 at the middle of a rounding, where Gauss-Newton takes more steps than there are.
constexpr double least_convexity = 0.001;

/// A place on one patch.
struct Foot {
  int triangle = -1;
  Vec3 barycentric = Vec3::Zero();
  Vec3 point = Vec3::Zero();
  double distance2_m2 = 0;
  bool good = false;
};

/// The squared distance's (half) slope and curvature by barycentric coordinates 1 and 2.
struct Slope {
  double g1, g2;
  double h11, h12, h22;  ///< positive definite
  bool newton = true;    ///< the true curvature, not Gauss-Newton's
  bool usable = false;
};

Slope slope_at(const PatchPoint& p, const Vec3& q) noexcept {
  const Vec3 r = p.x - q;
  Slope s{r.dot(p.x1), r.dot(p.x2), 0, 0, 0};
  const double e = p.x1.squaredNorm(), f = p.x1.dot(p.x2), g = p.x2.squaredNorm();
  s.h11 = e + r.dot(p.x11);
  s.h12 = f + r.dot(p.x12);
  s.h22 = g + r.dot(p.x22);
  // Newton where the distance is convex, and well so; else Gauss-Newton, which always goes downhill.
  constexpr double least = least_convexity, least2 = least * least;
  if (!(s.h11 > least * e && s.h22 > least * g && s.h11 * s.h22 - s.h12 * s.h12 > least2 * (e * g - f * f))) {
    s.h11 = e;
    s.h12 = f;
    s.h22 = g;
    s.newton = false;
  }
  s.usable = s.h11 * s.h22 - s.h12 * s.h12 > 1e-14 * s.h11 * s.h22;
  return s;
}

bool is_allowed(const Vec3& barycentric, const Vec3& step) noexcept {
  for (int k = 0; k < 3; ++k) {
    if (barycentric[k] <= 0 && step[k] < 0) return false;
  }
  return true;
}

/// The step to the least of the model that stays in the triangle at least for a moment; zero at a corner, or
/// on an edge, that is least itself.
Vec3 allowed_step(const Slope& s, const Vec3& barycentric) noexcept {
  const double det = s.h11 * s.h22 - s.h12 * s.h12;
  const double d1 = (s.h12 * s.g2 - s.h22 * s.g1) / det, d2 = (s.h12 * s.g1 - s.h11 * s.g2) / det;
  Vec3 newton(-d1 - d2, d1, d2);
  if (is_allowed(barycentric, newton)) return newton;
  Vec3 best = Vec3::Zero();
  double best_gain = 0;
  for (int k = 0; k < 3; ++k) {
    if (barycentric[k] > 0) continue;
    Vec3 along = Vec3::Zero();
    along[(k + 1) % 3] = -1;
    along[(k + 2) % 3] = 1;
    const double slope = s.g1 * along[1] + s.g2 * along[2];
    const double curvature =
        along[1] * along[1] * s.h11 + 2 * along[1] * along[2] * s.h12 + along[2] * along[2] * s.h22;
    const Vec3 step = -slope / curvature * along;
    if (slope * slope / curvature > best_gain && is_allowed(barycentric, step)) {
      best = step;
      best_gain = slope * slope / curvature;
    }
  }
  return best;
}

/// From a place of the triangle along a step, as far as its border, which is then met exactly.
Vec3 stepped(const Vec3& barycentric, const Vec3& step) noexcept {
  double share = 1;
  int border = -1;
  for (int k = 0; k < 3; ++k) {
    if (barycentric[k] + step[k] >= 0 || !(step[k] < 0)) continue;
    const double to_border = barycentric[k] / -step[k];
    if (to_border < share) {
      share = to_border;
      border = k;
    }
  }
  Vec3 result = (barycentric + share * step).cwiseMax(0.0);
  if (border >= 0) result[border] = 0;
  return result / result.sum();
}

/// The closest place of one patch, downhill from a place of it.
Foot descend(const CurvedPatch& patch, int t, const Vec3& q, const Vec3& start) noexcept {
  Foot foot{t, start, {}, 0, false};
  PatchPoint at = evaluate(patch, start);
  foot.distance2_m2 = (at.x - q).squaredNorm();
  foot.point = at.x;
  for (int i = 0; i < most_steps; ++i) {
    const Slope slope = slope_at(at, q);
    if (!slope.usable || !std::isfinite(foot.distance2_m2)) return foot;
    const double last_m = (slope.newton ? last_newton : last_gauss_newton) * patch.length_m;
    Vec3 step = allowed_step(slope, foot.barycentric);
    for (int halvings = 0;; ++halvings) {
      const Vec3 next = stepped(foot.barycentric, step);
      const Vec3 moved = next - foot.barycentric;
      const double length_m = (moved[1] * at.x1 + moved[2] * at.x2).norm();
      const PatchPoint there = evaluate(patch, next);
      const double distance2_m2 = (there.x - q).squaredNorm();
      const bool sure = length_m <= surely_converging * patch.length_m;
      if (sure || distance2_m2 < foot.distance2_m2) {
        foot = {t, next, there.x, distance2_m2, length_m <= last_m};
        at = there;
        break;
      }
      if (halvings == 8) return foot;
      step /= 4;
    }
    if (foot.good) return foot;
  }
  return foot;
}

/// As above; of a flat patch the facet's own answer, bit for bit.
Foot closest_on(const Part& part, const CurvedPatch& patch, int t, const Vec3& q,
                const Vec3& start) noexcept {
  if (!patch.flat) return descend(patch, t, q, start);
  const TrianglePoint at = closest_on_triangle(part, t, q);
  return {t, at.barycentric, at.point, at.distance2_m2, true};
}

Feature feature_at(const Vec3& barycentric) noexcept {
  int zeros = 0, zero = 0, other = 0;
  for (int k = 0; k < 3; ++k) {
    if (barycentric[k] > 0) {
      other = k;
    } else {
      ++zeros;
      zero = k;
    }
  }
  if (zeros == 0) return Feature::face;
  // The edge opposite corner k is edge k + 1.
  if (zeros == 1) return static_cast<Feature>(static_cast<int>(Feature::edge0) + (zero + 1) % 3);
  return static_cast<Feature>(static_cast<int>(Feature::vertex0) + other);
}

/// Looks for a closer place, from patch to patch.
struct Walk {
  const CornerNormals& normals;
  const Part& part;
  const Vec3& q;
  Foot best;
  CurvedPatch patch;  ///< best's
  double deviation_m = 0;

  /// Moves on to triangle `to`, which shares the vertices at which `best` stands, if its patch has a closer
  /// place. An equal place counts if it is off the border: the surface goes on there.
  bool move_to(int to, int from) noexcept {
    Vec3 start = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      for (int c = 0; c < 3; ++c) {
        if (part.welded(c, to) == part.welded(k, best.triangle)) start[c] = best.barycentric[k];
      }
    }
    if (!(std::abs(start.sum() - 1) < 1e-9)) return false;
    const CurvedPatch candidate = curved_patch(normals, to);
    const Foot foot = closest_on(part, candidate, to, q, start);
    if (!foot.good || foot.distance2_m2 > best.distance2_m2) return false;
    if (foot.distance2_m2 == best.distance2_m2 && (to == from || (foot.barycentric.array() <= 0).any()))
      return false;
    best = foot;
    patch = candidate;
    deviation_m = std::max(deviation_m, candidate.deviation_m);
    return true;
  }

  /// Around the vertex at which `best` stands, one way and then the other, past creases too.
  bool turn_around(int corner, int from) noexcept {
    constexpr int most_turns = 16;
    const int home = best.triangle, vertex = part.welded(corner, home);
    for (const int first_edge : {corner, (corner + 2) % 3}) {
      VertexTurn at{vertex, home, first_edge};
      for (int turn = 0; turn < most_turns; ++turn) {
        const int next = at.next(part);
        if (next == home) return false;
        if (next < 0) break;
        at.go_on(part);
        if (move_to(next, from)) return true;
      }
    }
    return false;
  }

  bool hop(int from) noexcept {
    const Feature feature = feature_at(best.barycentric);
    if (feature == Feature::face) return false;
    const int number = static_cast<int>(feature);
    if (number >= static_cast<int>(Feature::vertex0))
      return turn_around(number - static_cast<int>(Feature::vertex0), from);
    const int next = part.neighbours(number - static_cast<int>(Feature::edge0), best.triangle);
    return next >= 0 && move_to(next, from);
  }
};

}  // namespace

CurvedPoint closest_on_curved(const CornerNormals& normals, const ClosestTriangle& facets,
                              const Vec3& q) noexcept {
  const Part& part = normals.part;
  const int t = facets.triangle;
  Walk walk{normals, part, q, {}, curved_patch(normals, t), 0};
  walk.deviation_m = walk.patch.deviation_m;
  walk.best = walk.patch.flat ? Foot{t, facets.at.barycentric, facets.at.point, facets.at.distance2_m2, true}
                              : descend(walk.patch, t, q, facets.at.barycentric);
  CurvedPoint result{t, facets.at, Vec3::UnitZ(), walk.deviation_m};
  if (walk.best.good) {
    for (int hops = 0, from = -1; hops < most_hops; ++hops) {
      const int here = walk.best.triangle;
      if (!walk.hop(from)) break;
      from = here;
    }
    const Foot& best = walk.best;
    result.triangle = best.triangle;
    result.at = {best.point, best.distance2_m2, feature_at(best.barycentric), best.barycentric};
    result.deviation_m = walk.deviation_m;
  }
  result.normal_P = shown_normal(walk.patch, result.at.barycentric, part.facet_normals.col(result.triangle));
  return result;
}

}  // namespace fingerpad
