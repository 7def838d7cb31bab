#include "support/brute_force.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fingerpad::test {
namespace {

template <class Real>
struct Vector {
  Real x, y, z;
  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(const Real& s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Real dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
};

template <class Real>
Vector<Real> in(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

struct Nearest {
  Vec3 point = Vec3::Zero();
  long double distance2 = std::numeric_limits<long double>::infinity();

  template <class Real>
  void offer(const Vector<Real>& candidate, const Vector<Real>& q) {
    const Vector<Real> r = candidate - q;
    const auto d2 = static_cast<long double>(dot(r, r));
    if (d2 >= distance2) return;
    distance2 = d2;
    point = {static_cast<double>(candidate.x), static_cast<double>(candidate.y),
             static_cast<double>(candidate.z)};
  }
};

template <class Real>
void offer_segment(const Vector<Real>& a, const Vector<Real>& b, const Vector<Real>& q, Nearest& nearest) {
  const Vector<Real> along = b - a;
  const Real length2 = dot(along, along);
  Real t = length2 > 0 ? dot(along, q - a) / length2 : Real(0);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  nearest.offer(a + t * along, q);
}

template <class Real>
bool offer_sides(const Vector<Real>& a, const Vector<Real>& b, const Vector<Real>& c, const Vector<Real>& q,
                 Nearest& nearest) {
  offer_segment(a, b, q, nearest);
  offer_segment(b, c, q, nearest);
  offer_segment(c, a, q, nearest);
  return true;
}

/// False where rounding of this kind of number spoils the least squares: nothing is offered then.
template <class Real>
bool offer_triangle(const Vec3& corner_a, const Vec3& corner_b, const Vec3& corner_c, const Vec3& to,
                    double least_area_ratio2, Nearest& nearest) {
  const auto a = in<Real>(corner_a), b = in<Real>(corner_b), c = in<Real>(corner_c), q = in<Real>(to);
  const auto e = b - a, f = c - a, r = q - a;
  const Real ee = dot(e, e), ff = dot(f, f);
  if (!(ee > 0) || !(ff > 0)) return offer_sides(a, b, c, q, nearest);
  const auto g = f - (dot(e, f) / ee) * e;  // of f, what stands upright on e
  const Real gg = dot(g, g);
  if (gg < Real(least_area_ratio2) * ff) return false;
  offer_sides(a, b, c, q, nearest);
  if (!(gg > 0)) return true;
  const Real v = dot(r, g) / gg, u = (dot(e, r) - v * dot(e, f)) / ee;
  if (u >= 0 && v >= 0 && u + v <= 1) nearest.offer(a + (dot(e, r) / ee) * e + v * g, q);
  return true;
}

/// Long double where it serves, quadruple precision for slivers.
void offer_exactly(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& q, Nearest& nearest) {
  if (offer_triangle<long double>(a, b, c, q, 1e-8, nearest)) return;
  offer_triangle<__float128>(a, b, c, q, 0, nearest);
}

}  // namespace

Vec3 brute_closest_on(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& q, double* distance_m) {
  Nearest nearest;
  offer_exactly(a, b, c, q, nearest);
  *distance_m = static_cast<double>(std::sqrt(nearest.distance2));
  return nearest.point;
}

BruteClosest brute_closest(const Part& part, const Vec3& q) {
  Nearest nearest;
  int lowest = -1;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const auto corner = [&](int k) -> Vec3 { return part.vertices.col(part.triangles(k, t)); };
    const Vec3 a = corner(0), b = corner(1), c = corner(2);
    // A triangle whose box is farther than the best so far (by more than rounding) cannot win.
    const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    const double box_distance2 = (low - q).cwiseMax(q - high).cwiseMax(0.0).squaredNorm();
    if (static_cast<long double>(box_distance2) > nearest.distance2 * 1.000001L) continue;
    const long double before = nearest.distance2;
    offer_exactly(a, b, c, q, nearest);
    if (nearest.distance2 < before) lowest = t;
  }
  return {static_cast<double>(std::sqrt(nearest.distance2)), nearest.point, lowest};
}

double winding_number(const Part& part, const Vec3& q) {
  double solid_angle = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const Vec3 a = part.vertices.col(part.triangles(0, t)) - q;
    const Vec3 b = part.vertices.col(part.triangles(1, t)) - q;
    const Vec3 c = part.vertices.col(part.triangles(2, t)) - q;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double volume = a.dot(b.cross(c));
    const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    solid_angle += 2 * std::atan2(volume, below);
  }
  return solid_angle / (4 * std::numbers::pi);
}

}  // namespace fingerpad::test
