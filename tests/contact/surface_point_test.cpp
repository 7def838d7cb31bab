#include "contact/surface_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <vector>

#include "base/random_stream.hpp"
#include "contact/triangle_tree.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

namespace fingerpad::surface_point_test {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double crease_rad = 30 * M_PI / 180;
/// A few roundings of numbers near 1.
constexpr double rounding = 4e-15;

TriangleTree tree_of(const TriangleSoup& soup) {
  return TriangleTree(std::make_shared<const Part>(make_part(soup, crease_rad)));
}

Vec3 random_point(RandomStream& random, double scale) {
  return Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * (2 * scale);
}

SurfacePoint at(const TriangleTree& tree, const Vec3& p_P, Normals normals = Normals::facet,
                double reach_m = unbounded) {
  return nearest_surface_point(tree, p_P, normals, -1, reach_m);
}

TEST(NearestSurfacePoint, ABoxIsMeasuredFromOutsideAndInside) {
  const TriangleTree tree = tree_of(test::box_soup({2, 2, 2}));
  const Vec3 x = Vec3::UnitX(), corner = Vec3::Ones().normalized();
  const struct {
    Vec3 p, point, normal;
    double signed_distance_m;
  } cases[] = {
      {{3, 0.2, 0.3}, {1, 0.2, 0.3}, x, 2},
      {{0.75, 0.2, 0.3}, {1, 0.2, 0.3}, x, -0.25},
      {{1.3, 1.4, 0.5}, {1, 1, 0.5}, Vec3(0.6, 0.8, 0), 0.5},
      {{2, 2, 2}, {1, 1, 1}, corner, std::sqrt(3)},
  };
  for (const auto& c : cases) {
    for (const Normals normals : {Normals::facet, Normals::smooth}) {
      const SurfacePoint s = at(tree, c.p, normals);
      EXPECT_NEAR(s.signed_distance_m, c.signed_distance_m, rounding);
      EXPECT_LE((s.point_P - c.point).norm(), rounding);
      EXPECT_LE((s.normal_P - c.normal).norm(), rounding) << s.normal_P.transpose();
      EXPECT_GE(s.triangle, 0);
    }
  }
  EXPECT_LE((at(tree, {1.3, 1.4, 0.5}).pseudonormal_P - Vec3(1, 1, 0).normalized()).norm(), rounding);
  EXPECT_LE((at(tree, {2, 3, 4}).pseudonormal_P - corner).norm(), rounding);
}

TEST(NearestSurfacePoint, SignsAgreeWithTheWindingNumber) {
  const TriangleSoup hollow =
      test::joined(test::sphere_soup(1, 3), test::reversed(test::sphere_soup(0.7, 2)));
  for (const TriangleSoup& soup : {test::box_soup({1, 2, 3}), test::torus_soup(1, 0.4, 24, 12), hollow,
                                   test::box_soup({1, 1, 1e-4}), test::torus_soup(1, 0.99, 6, 4)}) {
    const TriangleTree tree = tree_of(soup);
    RandomStream random(1);
    int inside = 0;
    for (int i = 0; i < test::samples(2000); ++i) {
      const Vec3 p = random_point(random, 1.6).cwiseProduct(tree.part().half_extent);
      const SurfacePoint s = at(tree, p + tree.part().centre_P);
      const bool truly_inside = test::winding_number(tree.part(), p) > 0.5;
      inside += truly_inside ? 1 : 0;
      ASSERT_EQ(s.signed_distance_m < 0, truly_inside) << p.transpose() << " " << s.signed_distance_m;
    }
    ASSERT_GT(inside, test::samples(50));
  }
}

TEST(NearestSurfacePoint, MovingThePartMovesTheAnswerOnly) {
  const TriangleSoup soup = test::torus_soup(1, 0.4, 40, 20);
  const Vec3 offset = Vec3(1e4, -2e4, 3e4);
  const TriangleTree here = tree_of(soup), there = tree_of(test::moved(soup, offset));
  // The file's own coordinates carry rounding of their size there.
  const double tolerance = 1e-12 * (here.part().size_m() + offset.norm());
  RandomStream random(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random_point(random, 2);
    const SurfacePoint a = at(here, p), b = at(there, p + offset);
    ASSERT_NEAR(a.signed_distance_m, b.signed_distance_m, tolerance);
    ASSERT_LE((a.point_P + offset - b.point_P).norm(), tolerance);
  }
}

TEST(NearestSurfacePoint, NoSeedChangesABit) {
  const TriangleTree tree = tree_of(test::torus_soup(1, 0.4, 40, 20));
  RandomStream random(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random_point(random, 2);
    const int seed = static_cast<int>(random.uniform() * tree.part().triangle_count());
    const SurfacePoint a = nearest_surface_point(tree, p, Normals::smooth, -1, unbounded);
    const SurfacePoint b = nearest_surface_point(tree, p, Normals::smooth, seed, unbounded);
    ASSERT_EQ(a.triangle, b.triangle);
    ASSERT_EQ(a.signed_distance_m, b.signed_distance_m);
    ASSERT_EQ(a.normal_P, b.normal_P);
  }
}

TEST(NearestSurfacePoint, ReachHidesWhatIsFarOutsideButNeverTheInside) {
  const TriangleTree tree = tree_of(test::box_soup({2, 2, 2}));
  EXPECT_GE(at(tree, {1.5, 0, 0}, Normals::facet, 0.5).triangle, 0);
  EXPECT_EQ(at(tree, {1.5, 0, 0}, Normals::facet, 0.499).triangle, -1);
  EXPECT_EQ(at(tree, {1.5, 0, 0}, Normals::facet, 0.499).signed_distance_m, unbounded);
  EXPECT_EQ(at(tree, {0.1, 0, 0}, Normals::facet, 0).signed_distance_m, -0.9);
  EXPECT_EQ(at(tree, {1e300, 0, 0}, Normals::facet, 1).triangle, -1);
  EXPECT_NEAR(at(tree, {1e300, 0, 0}).signed_distance_m / 1e300, 1, rounding);
  EXPECT_LE((at(tree, {1e300, 0, 0}).normal_P - Vec3::UnitX()).norm(), rounding);
}

TEST(NearestSurfacePoint, SmoothNormalsOfASphereAreItsOwn) {
  // With corner normals along the radius, weights times normals are weights times corners: exact on a sphere.
  // (The angle-weighted normals that make_part finds are not quite along it where unlike triangles meet.)
  Part part = make_part(test::sphere_soup(1, 5), crease_rad);
  for (int t = 0; t < part.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      part.corner_normals.col(3 * t + k) = part.vertices.col(part.triangles(k, t)).normalized();
      part.vertex_pseudonormals.col(part.welded(k, t)) = part.corner_normals.col(3 * t + k);
    }
  }
  const TriangleTree tree(std::make_shared<const Part>(part));
  RandomStream random(4);
  double facet_error = 0;
  for (int i = 0; i < 2000; ++i) {
    const SurfacePoint smooth = at(tree, random_point(random, 1.5), Normals::smooth);
    const Vec3 truth = smooth.point_P.normalized();
    ASSERT_LE((smooth.normal_P - truth).norm(),
              1e-13);  // weights are distances over heights of 0.03: 1e-16 / 0.03
    facet_error = std::max(facet_error, (part.facet_normals.col(smooth.triangle) - truth).norm());
  }
  EXPECT_GT(facet_error, 0.015);  // half a facet: what a facet normal would be wrong by
}

/// The greatest error of the normal over a torus of n x n/2 quads, at points near the surface.
double torus_error(int n, Normals normals) {
  const TriangleTree tree = tree_of(test::torus_soup(1, 0.4, n, n / 2));
  RandomStream random(5);
  double worst = 0;
  for (int i = 0; i < 4000; ++i) {
    const double u = 2 * M_PI * random.uniform(), v = 2 * M_PI * random.uniform();
    const Vec3 outward(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
    const Vec3 ring(std::cos(u), std::sin(u), 0);
    const SurfacePoint s = at(tree, ring + 0.38 * outward, normals);
    const Vec3 around = Vec3(s.point_P.x(), s.point_P.y(), 0).normalized();
    worst = std::max(worst, (s.normal_P - (s.point_P - around).normalized()).norm());
  }
  return worst;
}

TEST(NearestSurfacePoint, OnATorusTheFacetErrorFallsWithHAndTheSmoothErrorWithItsSquare) {
  const double facet = std::log2(torus_error(64, Normals::facet) / torus_error(128, Normals::facet));
  const double smooth = std::log2(torus_error(64, Normals::smooth) / torus_error(128, Normals::smooth));
  // A finite h adds terms of the next order, and 4000 samples miss the worst place by a little.
  EXPECT_NEAR(facet, 1, 0.15);
  EXPECT_NEAR(smooth, 2, 0.25);
}

TEST(NearestSurfacePoint, NothingIsFeltAtTheInternalEdgesOfAFlatFace) {
  const TriangleTree tree = tree_of(test::square_soup(1, 7));
  for (const Normals normals : {Normals::facet, Normals::smooth}) {
    for (const double height : {1e-3, 1e-7, 1e-11, -1e-11, -1e-3}) {
      for (int i = 0; i < 400; ++i) {
        const double along = (i - 200) * 0.0024;
        const SurfacePoint s = at(tree, {along, 0.5 * along, height}, normals);
        ASSERT_LE((s.normal_P - Vec3::UnitZ()).norm(), 1e-15);  // one rounding
        ASSERT_NEAR(s.signed_distance_m, height, 1e-16);
      }
    }
  }
}

TEST(NearestSurfacePoint, OverASharpRidgeTheNormalTurnsWithTheFinger) {
  const double turn = 80 * M_PI / 180;
  const TriangleTree tree = tree_of(test::roof_soup(1, turn));
  const Vec3 ridge = at(tree, {0, 0, 1}).point_P;
  for (const Normals normals : {Normals::facet, Normals::smooth}) {
    for (double angle = -0.49 * turn; angle <= 0.49 * turn; angle += turn / 40) {
      const Vec3 towards(std::sin(angle), 0, std::cos(angle));
      const SurfacePoint s = at(tree, ridge + 0.01 * towards, normals);
      EXPECT_LE((s.normal_P - towards).norm(), 1e-13);  // rounding of 1e-16 seen over 0.01
      EXPECT_LE((s.point_P - ridge).norm(), rounding);
    }
  }
}

TEST(NearestSurfacePoint, AGentleRidgeIsSmoothedAndASharpOneIsNot) {
  const double gentle = 10 * M_PI / 180;
  const TriangleTree tree = tree_of(test::roof_soup(1, gentle));
  const Vec3 ridge = at(tree, {0, 0, 1}).point_P;
  const Vec3 right(std::sin(gentle / 2), 0, std::cos(gentle / 2));
  // From the one facet's normal beyond the edge, through the mean at the edge: no step on the way.
  EXPECT_LE((at(tree, ridge + 0.01 * right, Normals::smooth).normal_P - Vec3::UnitZ()).norm(), 1e-12);
  Vec3 before = at(tree, ridge + Vec3(-1e-4, 0, -1e-3), Normals::smooth).normal_P;
  for (int i = -99; i <= 100; ++i) {
    const Vec3 normal = at(tree, ridge + Vec3(i * 1e-6, 0, -1e-3), Normals::smooth).normal_P;
    // Below the ridge the nearest point changes sides: 1.7e-4 m along facets whose normal turns by 0.09
    // rad/m.
    EXPECT_LE((normal - before).norm(), 2e-5);
    before = normal;
  }
}

TEST(NearestSurfacePoint, ATriangleWithoutAreaInAClosedPartHarmsNoSign) {
  // A box one of whose edges is split by a vertex that only one of its two faces knows: the gap is closed by
  // a triangle without area, as CAD exporters write them.
  TriangleSoup soup = test::box_soup({1, 1, 1});
  const int a = soup.triangles(0, 0), b = soup.triangles(1, 0), c = soup.triangles(2, 0);
  const Vec3 middle = (soup.vertices_P.col(a) + soup.vertices_P.col(b)) / 2;
  const auto vertices = soup.vertices_P.cols(), triangles = soup.triangles.cols();
  soup.vertices_P.conservativeResize(3, vertices + 1);
  soup.vertices_P.col(vertices) = middle;
  const int m = static_cast<int>(vertices);
  soup.triangles.conservativeResize(3, triangles + 2);
  soup.triangles.col(0) << a, m, c;
  soup.triangles.col(triangles) << m, b, c;
  soup.triangles.col(triangles + 1) << a, b, m;
  const TriangleTree tree = tree_of(soup);
  RandomStream random(6);
  for (int i = 0; i < 4000; ++i) {
    // All round the split edge, close and far.
    const Vec3 p = middle + random_point(random, i % 2 == 0 ? 0.3 : 1e-6);
    const double inside_m = (Vec3::Constant(0.5) - p.cwiseAbs()).minCoeff();
    if (std::abs(inside_m) < 1e-9) continue;  // within rounding of the surface
    const SurfacePoint s = at(tree, p);
    ASSERT_EQ(s.signed_distance_m<0, inside_m> 0) << p.transpose();
    ASSERT_NEAR(s.normal_P.norm(), 1, rounding);
  }
}

bool are_in_one_plane(const Part& part, int t, int u) {
  return u >= 0 && part.facet_normals.col(t).dot(part.facet_normals.col(u)) > 1 - 1e-15;
}

/// All of `some`, and what lies in one plane with a triangle of it that it meets at an edge, and so on.
std::set<int> with_their_planes(const Part& part, std::set<int> some) {
  std::vector<int> open(some.begin(), some.end());
  while (!open.empty()) {
    const int t = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k) {
      const int next = part.neighbours(k, t);
      if (are_in_one_plane(part, t, next) && some.insert(next).second) open.push_back(next);
    }
  }
  return some;
}

/// The fewest bent edges on a way from triangle t to u; 3: more than two.
int bends_between(const Part& part, int t, int u) {
  std::set<int> reached = with_their_planes(part, {t});
  int bends = 0;
  for (; bends < 3 && !reached.contains(u); ++bends) {
    std::set<int> wider = reached;
    for (const int from : reached) {
      for (int k = 0; k < 3; ++k)
        if (part.neighbours(k, from) >= 0) wider.insert(part.neighbours(k, from));
    }
    reached = with_their_planes(part, std::move(wider));
  }
  return bends;
}

TEST(FootOnFacet, IsTheFootOnTheTriangleOrAcrossTheEdge) {
  const TriangleTree tree = tree_of(test::torus_soup(1, 0.4, 24, 16));
  const Part& part = tree.part();
  RandomStream random(9);
  int own = 0, next = 0, none = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    for (int k = 0; k < 10; ++k) {
      const Vec3 corner = part.vertices.col(part.triangles(k % 3, t));
      const Vec3 q = corner + random_point(random, 0.2);
      const FacetFoot s = foot_on_facet(part, t, part.centre_P + q);
      const TrianglePoint here = closest_on_triangle(part, t, q);
      const bool is_beyond_edge = here.feature >= Feature::edge0 && here.feature <= Feature::edge2;
      const int across =
          is_beyond_edge
              ? part.neighbours(static_cast<int>(here.feature) - static_cast<int>(Feature::edge0), t)
              : -1;
      const int expected = here.feature == Feature::face ? t
                           : across >= 0 && closest_on_triangle(part, across, q).feature == Feature::face
                               ? across
                               : -1;
      if (expected < 0 && s.triangle >= 0) {  // a flat piece has two triangles, and a corner is smooth
        ASSERT_EQ(closest_on_triangle(part, s.triangle, q).feature, Feature::face);
        ASSERT_LE(bends_between(part, t, s.triangle), 2);
        continue;
      }
      ASSERT_EQ(s.triangle, expected);
      ++(expected == t ? own : expected >= 0 ? next : none);
      if (expected < 0) continue;
      const TrianglePoint foot = closest_on_triangle(part, expected, q);
      ASSERT_LE((s.point_P - part.centre_P - foot.point).norm(), rounding);
    }
  }
  EXPECT_GT(std::min({own, next, none}), 300);
}

TEST(FootOnFacet, OfAPlaneOfFacetsIsFoundSomeEdgesOn) {
  const Part part = make_part(test::square_soup(1, 8), crease_rad);
  RandomStream random(10);
  int far = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const int t = trial % part.triangle_count();
    const Vec3 corner = part.vertices.col(part.triangles(0, t));
    const Vec3 q = corner + 0.1 * Vec3(random.normal(), random.normal(), 0);  // an edge is 1/8 long
    const FacetFoot foot = foot_on_facet(part, t, part.centre_P + q);
    if ((q.cwiseAbs() - part.half_extent).maxCoeff() > 0) {
      ASSERT_EQ(foot.triangle, -1);
      continue;
    }
    if (foot.triangle < 0) continue;  // too many edges away
    ASSERT_EQ(closest_on_triangle(part, foot.triangle, q).feature, Feature::face);
    ASSERT_LE((foot.point_P - part.centre_P - q).norm(), rounding);
    if (closest_on_triangle(part, t, q).feature < Feature::vertex0) continue;
    ++far;
    const Vec3 above = q + 1e-3 * Vec3::UnitZ();
    ASSERT_LE((foot_on_facet(part, t, part.centre_P + above).point_P - part.centre_P - q).norm(), rounding);
  }
  EXPECT_GT(far, 500);
}

TEST(FootOnFacet, OfASurfaceThatHardlyTurnsIsFoundSomeEdgesOn) {
  const TriangleTree tree = tree_of(test::torus_soup(1, 0.4, 192, 128));
  const Part& part = tree.part();
  RandomStream random(11);
  int far = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const int t = trial * 7 % part.triangle_count();
    const Vec3 normal = part.facet_normals.col(t);
    Vec3 along(random.normal(), random.normal(), random.normal());
    along = 0.05 * (along - along.dot(normal) * normal).normalized();  // an edge is .02 to .05 long
    const Vec3 q = part.vertices.col(part.triangles(0, t)) + along;
    const FacetFoot foot = foot_on_facet(part, t, part.centre_P + q);
    if (foot.triangle < 0 || bends_between(part, t, foot.triangle) <= 2) continue;
    ++far;
    const double distance_m = (foot.point_P - part.centre_P - q).norm();
    // Over hollows a point may have the feet of two facets, and either is found.
    ASSERT_LE(distance_m, std::abs(at(tree, part.centre_P + q).signed_distance_m) + 1e-4) << t;
  }
  EXPECT_GT(far, 500);
}

TEST(FootOnFacet, IsNotSoughtRoundATightRounding) {
  const Part part =
      make_part(test::torus_soup(1, 0.01, 400, 16), crease_rad);  // turns by 22.5 degrees an edge
  RandomStream random(12);
  int found = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const int t = trial * 3 % part.triangle_count();
    const Vec3 q = part.vertices.col(part.triangles(0, t)) + random_point(random, 0.03);
    const FacetFoot foot = foot_on_facet(part, t, part.centre_P + q);
    if (foot.triangle < 0) continue;
    ++found;
    const double turned_cos = part.facet_normals.col(t).dot(part.facet_normals.col(foot.triangle));
    ASSERT_TRUE(turned_cos > 0.93 || bends_between(part, t, foot.triangle) <= 2) << t;
  }
  EXPECT_GT(found, 500);
}

TEST(FootOnFacet, IsNotSoughtOnTheOtherSideOfAGroove) {
  // Two level shelves, and between them a groove whose bends are no creases.
  const auto grooved = [](double u, double v) {
    const double x = 0.06 * (u - 0.5);
    return Vec3(x, 0.04 * (v - 0.5), 1.2 * std::min(0.0, std::abs(x) - 0.01));
  };
  const Part part = make_part(test::sheet_soup(6, 4, grooved), 2.5);
  int tried = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const Vec3 corner = part.vertices.col(part.triangles(0, t));
    if (!(part.facet_normals(2, t) > 0.999) || corner.x() > 0) continue;
    ++tried;
    const Vec3 beyond(0.018, corner.y() + 0.004, corner.z());
    EXPECT_EQ(foot_on_facet(part, t, part.centre_P + beyond).triangle, -1) << t;
  }
  EXPECT_GT(tried, 8);
}

TEST(NearestPlanePoint, IsTheFootOfThePerpendicular) {
  const SurfacePoint s = nearest_plane_point({0, 0, 2}, Vec3::UnitZ(), {5, 6, 1.5});
  EXPECT_EQ(s.signed_distance_m, -0.5);
  EXPECT_EQ(s.point_P, Vec3(5, 6, 2));
  EXPECT_EQ(s.normal_P, Vec3::UnitZ());
  EXPECT_EQ(s.pseudonormal_P, Vec3::UnitZ());
  EXPECT_EQ(s.triangle, -1);
}

}  // namespace
}  // namespace fingerpad::surface_point_test
