#include "contact/curved_patch.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/facet_rule.hpp"

namespace fingerpad {
namespace {

/// A patch that strays from its triangle by no more than this fraction of its length is that triangle.
constexpr double flatness = 1e-9;
/// Sine of the largest turn of an edge's tangent off its chord.
constexpr double largest_turn = 0.5;

/// How an edge's curve leaves its chord at one end: from the point a third of the chord along to the control
/// point there. Of no use where the tangent turns too far.
struct Bulge {
  Vec3 offset;
  bool usable;
};

/// Along a tangent, the chord's part in its direction: as far as a cubic of a circle's arc has its control
/// point, 2 chord / (3 (1 + cos)) for an angle between chord and tangent.
Bulge along(const Vec3& tangent, const Vec3& chord) noexcept {
  const double cos2 = tangent.squaredNorm() / chord.squaredNorm();
  if (!(cos2 >= 1 - largest_turn * largest_turn)) return {Vec3::Zero(), false};
  const double cosine = std::sqrt(cos2);
  return {2 / (3 * cosine * (1 + cosine)) * tangent - chord / 3, true};
}

/// @param chord   from there to the edge's other end
/// @param normal  the surface's
Bulge in_plane(const Vec3& chord, const Vec3& normal) noexcept {
  return along(chord - chord.dot(normal) * normal, chord);
}

/// As above where two smooth surfaces meet in a crease: along the line that is in both tangent planes. At a
/// crease's end, where it runs out into a smooth surface, both planes are one.
Bulge in_both_planes(const Vec3& chord, const Vec3& normal, const Vec3& beyond) noexcept {
  const Vec3 line = normal.cross(beyond);
  const double sine2 = line.squaredNorm();
  if (sine2 < 1e-12 && normal.dot(beyond) > 0) return in_plane(chord, normal);
  // Planes that meet at a few degrees say little about where: 1 degree of error in one turns the line by ten.
  if (sine2 < 0.01) return {Vec3::Zero(), true};
  return along(chord.dot(line) / sine2 * line, chord);
}

/// An edge bulges at one end at most twice as much as at the other, and not at all where they disagree which
/// way. On a smooth surface both bulges are of order h^2 and differ by h^3 alone, so this costs no order; it
/// keeps the edges of a flat face straight that a fillet tilts at one end.
void reconcile(Vec3& a, Vec3& b) noexcept {
  const double a2 = a.squaredNorm(), b2 = b.squaredNorm();
  if (!(a.dot(b) > 0)) {
    a.setZero();
    b.setZero();
  } else if (a2 > 4 * b2) {
    a *= 2 * std::sqrt(b2 / a2);
  } else if (b2 > 4 * a2) {
    b *= 2 * std::sqrt(a2 / b2);
  }
}

/// A triangle's height over its longest edge [m].
double height_m(const Part& part, int t) noexcept {
  const Vec3 p = part.vertices.col(part.triangles(0, t));
  const Vec3 a = part.vertices.col(part.triangles(1, t)) - p, b = part.vertices.col(part.triangles(2, t)) - p;
  const double longest2 = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
  return longest2 > 0 ? std::sqrt(a.cross(b).squaredNorm() / longest2) : 0;
}

/// How far a bulge over the edge from p_P along `chord` may go before it folds triangle t, of which `third`
/// is the corner beside the edge [m]. One that leads out of it, as a bend of a flat face's rim does, never
/// folds it.
double most_bulge_m(const Part& part, int t, int third, const Vec3& p_P, const Vec3& chord,
                    const Vec3& bulge) noexcept {
  Vec3 inward = part.vertices.col(part.triangles(third, t)) - p_P;
  inward -= inward.dot(chord) / chord.squaredNorm() * chord;
  const double lead = bulge.dot(inward);
  constexpr double cos2_aside = 0.8;  // to within 27 degrees of the plane
  const bool leads_out = lead < 0 && lead * lead > cos2_aside * bulge.squaredNorm() * inward.squaredNorm();
  return leads_out ? std::numeric_limits<double>::infinity() : height_m(part, t) / 2;
}

/// The normals beyond edge k at its ends; false where no neighbour answers for both.
bool normals_beyond(const CornerNormals& normals, int t, int k, Vec3& first, Vec3& second) noexcept {
  const Part& part = normals.part;
  const int other = part.neighbours(k, t);
  if (other < 0) return false;
  int found = 0;
  for (int c = 0; c < 3; ++c) {
    const int vertex = part.welded(c, other);
    if (vertex == part.welded(k, t)) {
      first = normals(other, c);
      found |= 1;
    } else if (vertex == part.welded((k + 1) % 3, t)) {
      second = normals(other, c);
      found |= 2;
    }
  }
  return found == 3;
}

/// How the curve of edge k leaves its chord at both ends; the same, up to rounding, from both sides.
std::array<Vec3, 2> bulges(const CornerNormals& normals, int t, int k, const CurvedPatch& patch) noexcept {
  const Part& part = normals.part;
  const auto i = static_cast<std::size_t>(k), j = static_cast<std::size_t>((k + 1) % 3);
  const Vec3 chord = patch.control[j] - patch.control[i];
  const Vec3 &n_i = patch.corner_normal[i], &n_j = patch.corner_normal[j];
  Bulge at_i = in_plane(chord, n_i), at_j = in_plane(-chord, n_j);
  const int other = part.neighbours(k, t);
  const bool is_crease = has_crease(part, t, k);
  if (is_crease && other >= 0) {
    Vec3 beyond_i, beyond_j;
    if (!normals_beyond(normals, t, k, beyond_i, beyond_j)) return {Vec3::Zero(), Vec3::Zero()};
    at_i = in_both_planes(chord, n_i, beyond_i);
    at_j = in_both_planes(-chord, n_j, beyond_j);
  }
  if (!at_i.usable || !at_j.usable) return {Vec3::Zero(), Vec3::Zero()};
  reconcile(at_i.offset, at_j.offset);
  const double larger = std::sqrt(std::max(at_i.offset.squaredNorm(), at_j.offset.squaredNorm()));
  if (larger > flatness * patch.length_m) {
    // A sliver must not fold, and a long one in a flat face says little about how the surface curves.
    const Vec3 bulge = at_i.offset + at_j.offset;
    double most = most_bulge_m(part, t, (k + 2) % 3, patch.control[i], chord, bulge);
    if (other >= 0)
      most = std::min(
          most, most_bulge_m(part, other, corner_beyond(part, t, k, other), patch.control[i], chord, bulge));
    const double share = std::min(1.0, most / larger);
    at_i.offset *= share;
    at_j.offset *= share;
  }
  return {at_i.offset, at_j.offset};
}

void place_edge(const CornerNormals& normals, int t, int k, CurvedPatch& patch) noexcept {
  const auto i = static_cast<std::size_t>(k), j = static_cast<std::size_t>((k + 1) % 3);
  const Vec3 chord = patch.control[j] - patch.control[i];
  const std::array<Vec3, 2> bulge = bulges(normals, t, k, patch);
  patch.control[3 + 2 * i] = patch.control[i] + chord / 3 + bulge[0];
  patch.control[4 + 2 * i] = patch.control[j] - chord / 3 + bulge[1];

  // Half way the normal is the ends' mean, turned so that it is perpendicular to the curve.
  const Vec3 mean = patch.corner_normal[i] + patch.corner_normal[j];
  const Vec3 tangent = 4.0 / 3 * chord + bulge[1] - bulge[0];
  const double tangent2 = tangent.squaredNorm();
  const Vec3 middle = tangent2 > 0 ? Vec3(mean - mean.dot(tangent) / tangent2 * tangent) : mean;
  const double length = middle.norm();
  patch.edge_normal[i] = length > 0.5 ? Vec3(middle / length) : patch.corner_normal[i];
}

/// How far the control points stand from where the flat triangle has them.
double deviation(const CurvedPatch& patch) noexcept {
  const auto& c = patch.control;
  double worst2 = (c[9] - (c[0] + c[1] + c[2]) / 3).squaredNorm();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = c[k], &b = c[(k + 1) % 3];
    worst2 = std::max({worst2, (c[3 + 2 * k] - (2 * a + b) / 3).squaredNorm(),
                       (c[4 + 2 * k] - (a + 2 * b) / 3).squaredNorm()});
  }
  return std::sqrt(worst2);
}

}  // namespace

CurvedPatch curved_patch(const CornerNormals& normals, int t) noexcept {
  const Part& part = normals.part;
  CurvedPatch patch;
  for (int k = 0; k < 3; ++k) {
    patch.control[static_cast<std::size_t>(k)] = part.vertices.col(part.triangles(k, t));
    patch.corner_normal[static_cast<std::size_t>(k)] = normals(t, k);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    patch.length_m = std::max(patch.length_m, (patch.control[(k + 1) % 3] - patch.control[k]).norm());
  }
  for (int k = 0; k < 3; ++k) place_edge(normals, t, k, patch);
  auto& c = patch.control;
  const Vec3 edges = (c[3] + c[4] + c[5] + c[6] + c[7] + c[8]) / 6;
  c[9] = edges + (edges - (c[0] + c[1] + c[2]) / 3) / 2;
  patch.deviation_m = deviation(patch);
  patch.flat = patch.deviation_m <= flatness * patch.length_m;
  return patch;
}

PatchPoint evaluate(const CurvedPatch& patch, const Vec3& b) noexcept {
  const auto& c = patch.control;
  const double b0 = b[0], b1 = b[1], b2 = b[2];
  // de Casteljau, twice: the six points of the quadratic net, then three of the linear one.
  const Vec3 q200 = b0 * c[0] + b1 * c[3] + b2 * c[8], q020 = b0 * c[4] + b1 * c[1] + b2 * c[5];
  const Vec3 q002 = b0 * c[7] + b1 * c[6] + b2 * c[2], q110 = b0 * c[3] + b1 * c[4] + b2 * c[9];
  const Vec3 q011 = b0 * c[9] + b1 * c[5] + b2 * c[6], q101 = b0 * c[8] + b1 * c[9] + b2 * c[7];
  const Vec3 l0 = b0 * q200 + b1 * q110 + b2 * q101, l1 = b0 * q110 + b1 * q020 + b2 * q011;
  const Vec3 l2 = b0 * q101 + b1 * q011 + b2 * q002;
  PatchPoint p;
  p.x = b0 * l0 + b1 * l1 + b2 * l2;
  p.x1 = 3 * (l1 - l0);
  p.x2 = 3 * (l2 - l0);
  p.x11 = 6 * (q020 - 2 * q110 + q200);
  p.x12 = 6 * (q011 - q110 - q101 + q200);
  p.x22 = 6 * (q002 - 2 * q101 + q200);
  return p;
}

Vec3 shown_normal(const CurvedPatch& patch, const Vec3& b, const Vec3& otherwise) noexcept {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k), j = (i + 1) % 3;
    sum += b[i] * (2 * b[i] - 1) * patch.corner_normal[k] + 4 * b[i] * b[j] * patch.edge_normal[k];
  }
  const double length = sum.norm();
  if (!(length > 1e-6) || sum.dot(otherwise) <= 0) return otherwise;
  return sum / length;
}

}  // namespace fingerpad
