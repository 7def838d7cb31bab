#pragma once

#include "part/part.hpp"

namespace fingerpad::test {

/// Slow, plain answers to compare fast ones with. Nothing here is shared with src/contact.

/// What looking at every triangle says, in long double, slivers in quadruple precision.
struct BruteClosest {
  double distance_m = 0;
  Vec3 point = Vec3::Zero();  ///< relative to the part's centre
  int triangle = -1;
};

/// The closest point of one triangle with corners a, b, c to q, in long double: the least-squares solution
/// where it lies inside, else the nearest of three segments.
Vec3 brute_closest_on(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& q, double* distance_m);

/// The closest of all triangles. @param q  relative to the part's centre [m]
BruteClosest brute_closest(const Part& part, const Vec3& q);

/// The generalized winding number of the part's facets about q (Jacobson, Kavan & Sorkine-Hornung 2013, eq.
/// 5; solid angles after Van Oosterom & Strackee 1983): 1 inside a closed part wound outwards, 0 outside.
double winding_number(const Part& part, const Vec3& q);

}  // namespace fingerpad::test
