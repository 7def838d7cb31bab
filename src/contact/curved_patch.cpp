#include "contact/curved_patch.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace fingerpad {
namespace {

/// A patch that strays from its triangle by no more than this fraction of its length is that triangle.
constexpr double flatness = 1e-9;
/// Sine of the largest turn of an edge's tangent off its chord.
constexpr double largest_turn = 0.5;

/// From an end of an edge to the control point near it, where `chord` goes to the other end and `normal` is
/// the surface's: a third of the chord, in the tangent plane. Of no use where it turns too far.
struct Tangent {
  Vec3 third;
  bool usable;
};

Tangent in_plane(const Vec3& chord, const Vec3& normal) noexcept {
  const double off = chord.dot(normal);
  return {(chord - off * normal) / 3, off * off <= largest_turn * largest_turn * chord.squaredNorm()};
}

/// As above where two smooth surfaces meet in a crease: along the line that is in both tangent planes. At a
/// crease's end, where it runs out into a smooth surface, both planes are one.
Tangent in_both_planes(const Vec3& chord, const Vec3& normal, const Vec3& beyond) noexcept {
  const Vec3 line = normal.cross(beyond);
  const double sine2 = line.squaredNorm();
  if (sine2 < 1e-12 && normal.dot(beyond) > 0) return in_plane(chord, normal);
  // Planes that meet at a few degrees say little about where: 1 degree of error in one turns the line by ten.
  if (sine2 < 0.01) return {chord / 3, true};
  const double along = chord.dot(line);
  return {along / (3 * sine2) * line,
          along * along >= (1 - largest_turn * largest_turn) * chord.squaredNorm() * sine2};
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

void place_edge(const CornerNormals& normals, int t, int k, CurvedPatch& patch) noexcept {
  const Part& part = normals.part;
  const auto i = static_cast<std::size_t>(k), j = static_cast<std::size_t>((k + 1) % 3);
  const Vec3 chord = patch.control[j] - patch.control[i];
  const Vec3 &n_i = patch.corner_normal[i], &n_j = patch.corner_normal[j];
  Tangent at_i{chord / 3, false}, at_j{-chord / 3, false};
  Vec3 beyond_i, beyond_j;
  const bool is_crease = (part.creases[static_cast<std::size_t>(t)] >> k & 1) != 0;
  if (!is_crease && part.neighbours(k, t) >= 0) {
    at_i = in_plane(chord, n_i);
    at_j = in_plane(-chord, n_j);
  } else if (is_crease && normals_beyond(normals, t, k, beyond_i, beyond_j)) {
    at_i = in_both_planes(chord, n_i, beyond_i);
    at_j = in_both_planes(-chord, n_j, beyond_j);
  }
  const bool curved = at_i.usable && at_j.usable;
  patch.control[3 + 2 * i] = patch.control[i] + (curved ? at_i.third : Vec3(chord / 3));
  patch.control[4 + 2 * i] = patch.control[j] + (curved ? at_j.third : Vec3(-chord / 3));

  // Half way the normal is the ends' mean, turned so that it is perpendicular to the curve.
  const Vec3 mean = n_i + n_j;
  const Vec3 tangent =
      patch.control[j] + patch.control[4 + 2 * i] - patch.control[3 + 2 * i] - patch.control[i];
  const double tangent2 = tangent.squaredNorm();
  Vec3 middle = mean;
  if (curved && tangent2 > 0) middle -= mean.dot(tangent) / tangent2 * tangent;
  const double length = middle.norm();
  patch.edge_normal[i] = length > 0.5 ? Vec3(middle / length) : n_i;
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
  for (int k = 0; k < 3; ++k) place_edge(normals, t, k, patch);
  auto& c = patch.control;
  const Vec3 edges = (c[3] + c[4] + c[5] + c[6] + c[7] + c[8]) / 6;
  c[9] = edges + (edges - (c[0] + c[1] + c[2]) / 3) / 2;
  for (std::size_t k = 0; k < 3; ++k)
    patch.length_m = std::max(patch.length_m, (c[(k + 1) % 3] - c[k]).norm());
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
