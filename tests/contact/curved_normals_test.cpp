#include "contact/curved_normals.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/random_stream.hpp"
#include "contact/profiles.hpp"
#include "support/shapes.hpp"

namespace fingerpad::curved_normals_test {
namespace {

constexpr double crease_rad = 30 * M_PI / 180;

Vec3 place_of(const Part& part, int t, int k) {
  return part.vertices.col(part.triangles(k, t)) + part.centre_P;
}

/// A sphere of radius 1 whose vertices are moved aside by up to a third of an edge.
TriangleSoup uneven_sphere() {
  TriangleSoup soup = test::sphere_soup(1, 3);
  RandomStream random(4);
  for (auto p : soup.vertices_P.colwise()) {
    const Vec3 aside(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    p = (p + 0.1 * aside).normalized();
  }
  return soup;
}

TEST(CurvedNormals, OfASphereAreExactWhateverItsTriangles) {
  const Part part = make_part(uneven_sphere(), crease_rad);
  for (int t = 0; t < part.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k)
      ASSERT_LE((curved_corner_normal(part, t, k) - place_of(part, t, k).normalized()).norm(), 1e-12);
  }
}

TEST(CurvedNormals, OfUnevenStripsPointAwayFromTheAxis) {
  // Strips of 24 and 6 degrees in turn. Weighted by area the normals lean 9 degrees towards the wide ones'.
  for (const TriangleSoup& soup : {test::uneven_drum(), test::rounded_drum(24, 4, 0.8)}) {
    const Part part = make_part(soup, crease_rad);
    int on_wall = 0;
    for (int t = 0; t < part.triangle_count(); ++t) {
      if (std::abs(part.facet_normals(2, t)) > 1e-9) continue;
      ++on_wall;
      for (int k = 0; k < 3; ++k) {
        Vec3 away = place_of(part, t, k);
        away.z() = 0;
        EXPECT_LE((curved_corner_normal(part, t, k) - away.normalized()).norm(), 1e-9);
      }
    }
    EXPECT_EQ(on_wall, 48);
  }
}

TEST(CurvedNormals, ASliverOfAFlatFaceBesideAFilletIsOfThatFace) {
  // Of a tenth of the first facet's width: alone it is no face that the facet could be held against.
  const Part part = make_part(test::filleted_bar(8, 3, 0.02), crease_rad);
  int on_face = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    if (std::abs(part.facet_normals(2, t) - 1) > 1e-9) continue;
    ++on_face;
    for (int k = 0; k < 3; ++k) EXPECT_LE((curved_corner_normal(part, t, k) - Vec3::UnitZ()).norm(), 1e-9);
  }
  EXPECT_EQ(on_face, 12);
}

TEST(CurvedNormals, WhereAFilletTurnsFasterThanItsWallStayWithTheWall) {
  // A fillet's facets are 2.5 times as curved as the strips of the wall beside it, and turn by as much.
  const Part part = make_part(test::rounded_drum(24, 6), crease_rad);
  for (int t = 0; t < part.triangle_count(); ++t) {
    if (std::abs(part.facet_normals(2, t)) > 1e-9) continue;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(curved_corner_normal(part, t, k).z(), 0, 1e-9);
  }
}

/// A cap of a sphere of radius 1, down to so far off its pole, on a flat floor.
TriangleSoup cap(double edge_rad, int rings, int around) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, 2 + rings * around);
  soup.triangles.resize(3, 2 * rings * around);
  const double floor = std::cos(edge_rad);
  soup.vertices_P.col(0) << 0, 0, 1;
  soup.vertices_P.col(1) << 0, 0, floor;
  const auto at = [&](int ring, int i) { return 2 + ring * around + i % around; };
  int t = 0;
  for (int ring = 0; ring < rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      const double down = edge_rad * (ring + 1) / rings, angle = 2 * M_PI * i / around;
      soup.vertices_P.col(at(ring, i)) << std::sin(down) * std::cos(angle), std::sin(down) * std::sin(angle),
          std::cos(down);
      if (ring == 0) {
        soup.triangles.col(t++) << 0, at(0, i), at(0, i + 1);
      } else {
        soup.triangles.col(t++) << at(ring - 1, i), at(ring, i), at(ring, i + 1);
        soup.triangles.col(t++) << at(ring - 1, i), at(ring, i + 1), at(ring - 1, i + 1);
      }
      if (ring + 1 == rings) soup.triangles.col(t++) << 1, at(ring, i + 1), at(ring, i);
    }
  }
  EXPECT_EQ(t, soup.triangles.cols());
  return soup;
}

// To what the normals further in are told alike by wide and by round ones.
TEST(CurvedNormals, AtARimAreNearlyThoseOfTheSurfaceThatEndsThere) {
  const Part part = make_part(cap(1, 6, 24), crease_rad);
  double own_off = 0;
  for (int t = 0; t < part.triangle_count(); ++t) {
    const bool on_floor = part.facet_normals(2, t) < -0.99;
    for (int k = 0; k < 3; ++k) {
      const Vec3 exact = on_floor ? Vec3(-Vec3::UnitZ()) : place_of(part, t, k);
      EXPECT_LE((curved_corner_normal(part, t, k) - exact).norm(), 0.012) << t;
      own_off = std::max(own_off, (part.corner_normals.col(3 * t + k) - exact).norm());
    }
  }
  EXPECT_GT(own_off, 0.08) << "its facets, all on one side, turn the parts' own normals there";
}

/// Two facets of a cylinder of radius 1 along its axis, of 12 and of 24 degrees, with no cylinder beside
/// them.
TriangleSoup strip(const Mat3& turned) {
  constexpr double degree = M_PI / 180;
  TriangleSoup soup = test::sheet_soup(2, 8, [](double across, double along) -> Vec3 {
    const double angle = across < 0.25 ? 0 : across < 0.75 ? 12 * degree : 36 * degree;
    return {std::sin(angle), along, std::cos(angle)};
  });
  soup.vertices_P = turned * soup.vertices_P;
  return soup;
}

TEST(CurvedNormals, OfAStripBetweenTwoRimsTurnWithIt) {
  const Part as_is = make_part(strip(Mat3::Identity()), crease_rad);
  for (int i = 1; i < 8; ++i) {
    const Mat3 turned = Eigen::AngleAxisd(0.7 * i, Vec3(1, 0.3 * i, -2).normalized()).toRotationMatrix();
    const Part part = make_part(strip(turned), crease_rad);
    ASSERT_EQ(part.triangle_count(), as_is.triangle_count());
    for (int t = 0; t < part.triangle_count(); ++t)
      for (int k = 0; k < 3; ++k)
        ASSERT_LE((curved_corner_normal(part, t, k) - turned * curved_corner_normal(as_is, t, k)).norm(),
                  1e-5)
            << i;
  }
}

// The normals between it and the fillet lean half into that; a flat strip keeps its own at its other end.
TEST(CurvedNormals, AtTheRimOfAFlatStripBesideAFilletAreThoseOfTheStrip) {
  constexpr int segments = 6;
  for (const double land : {0.5, 1.0, 1.5}) {  // of a fillet's facet
    const double facet = 2 * std::sin(M_PI / 4 / segments);
    const Part part = make_part(test::sheet_soup(segments + 1, 10,
                                                 [&](double across, double along) -> Vec3 {
                                                   const long i = std::lround(across * (segments + 1));
                                                   if (i == 0) return {1, -along, -land * facet};
                                                   const double angle = M_PI / 2 * (i - 1) / segments;
                                                   return {std::cos(angle), -along, std::sin(angle)};
                                                 }),
                                crease_rad);
    for (int t = 0; t < part.triangle_count(); ++t) {
      for (int k = 0; k < 3; ++k) {
        if (place_of(part, t, k).z() > -1e-9) continue;
        // Half a facet's turn would be 0.13.
        EXPECT_LE((curved_corner_normal(part, t, k) - Vec3::UnitX()).norm(), land < 1 ? 0.04 : 1e-9) << land;
      }
    }
  }
}

/// A cone's mantle of so many facets, whose tip is not in its middle, so that they are unlike.
TriangleSoup leaning_cone(int facets) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, facets + 1);
  soup.triangles.resize(3, facets);
  soup.vertices_P.col(facets) << 0.3, 0, 0.2;
  for (int i = 0; i < facets; ++i) {
    const double angle = 2 * M_PI * i / facets;
    soup.vertices_P.col(i) << std::cos(angle), std::sin(angle), 0;
    soup.triangles.col(i) << i, (i + 1) % facets, facets;
  }
  return soup;
}

TEST(CurvedNormals, OfTooManyFacetsAreThePartsOwn) {
  for (const auto& [facets, is_own] : {std::pair(64, false), std::pair(65, true)}) {
    const Part part = make_part(leaning_cone(facets), crease_rad);
    const Points table = curved_corner_normals(part);
    for (int t = 0; t < facets; ++t) {
      const Vec3 n = curved_corner_normal(part, t, 2), own = part.corner_normals.col(3 * t + 2);
      ASSERT_EQ(n == own, is_own) << facets;
      ASSERT_EQ(Vec3(table.col(3 * t + 2)), n);
    }
  }
}

TEST(CurvedNormals, AreOneInAFanAndTheSameBitsInATable) {
  for (const TriangleSoup& soup :
       {test::torus_soup(1, 0.4, 24, 16), uneven_sphere(), test::uneven_drum(),
        test::filleted_bar(8, 3, 0.02), test::rounded_drum(24, 4, 0.8), cap(1, 6, 24)}) {
    const Part part = make_part(soup, crease_rad);
    const Points table = curved_corner_normals(part);
    ASSERT_EQ(table.cols(), 3 * part.triangle_count());
    for (int t = 0; t < part.triangle_count(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const Vec3 n = curved_corner_normal(part, t, k);
        ASSERT_NEAR(n.norm(), 1, 1e-15);
        ASSERT_EQ(Vec3(table.col(Eigen::Index{3} * t + k)), n);
        const int other = part.neighbours(k, t);
        if (other < 0 || (part.creases[static_cast<std::size_t>(t)] >> k & 1) != 0) continue;
        for (int c = 0; c < 3; ++c) {
          if (part.welded(c, other) != part.welded(k, t)) continue;
          ASSERT_EQ(curved_corner_normal(part, other, c), n);
        }
      }
    }
  }
}

}  // namespace
}  // namespace fingerpad::curved_normals_test
