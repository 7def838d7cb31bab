#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/random_stream.hpp"
#include "contact/proxies.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

namespace fingerpad::proxy_test {
namespace {

constexpr double dt_s = 1e-3;
const int walk_ticks = test::sanitized() ? 400 : 4000;

/// Moves in even steps and returns the last contact.
ProxyContact drag(Proxy& proxy, const Vec3& from, const Vec3& to, int ticks) {
  for (int k = 0; k < ticks; ++k) proxy.move(from + (to - from) * (static_cast<double>(k) / ticks), dt_s);
  return proxy.move(to, dt_s);
}

/// A cone with its tip at the origin, opening downwards.
TriangleSoup cone_soup(double radius_m, double height_m, int around) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, around + 2);
  soup.vertices_P.col(0) = Vec3::Zero();
  soup.vertices_P.col(1) = Vec3(0, 0, -height_m);
  soup.triangles.resize(3, 2 * around);
  for (int k = 0; k < around; ++k) {
    const double angle = 2 * std::numbers::pi * k / around;
    soup.vertices_P.col(k + 2) = Vec3(radius_m * std::cos(angle), radius_m * std::sin(angle), -height_m);
    const int a = k + 2, b = (k + 1) % around + 2;
    soup.triangles.col(2 * k) << 0, a, b;
    soup.triangles.col(2 * k + 1) << 1, b, a;
  }
  return soup;
}

/// A wedge along y with its edge at z = 0 and half the given angle.
TriangleSoup knife_soup(double half_angle_rad) {
  const double h = 0.03, w = h * std::tan(half_angle_rad), l = 0.04;
  TriangleSoup soup;
  soup.vertices_P.resize(3, 6);
  soup.vertices_P << 0, 0, -w, -w, w, w, -l, l, -l, l, -l, l, 0, 0, -h, -h, -h, -h;
  soup.triangles.resize(3, 8);
  soup.triangles << 0, 0, 0, 0, 2, 2, 0, 1, 1, 3, 4, 5, 3, 5, 2, 3, 3, 2, 5, 1, 5, 4, 4, 5;
  return soup;
}

class ProxyOfEitherKind : public EitherProxy {};
INSTANTIATE_TEST_SUITE_P(Kinds, ProxyOfEitherKind, testing::ValuesIn(proxy_kinds), kind_name);

TEST_P(ProxyOfEitherKind, LiesInAConcaveCornerOfThreePlanes) {
  for (const double radius_m : {0.0, 0.004}) {
    Proxy proxy = make_proxy({plane_of(Vec3::Zero(), Vec3::UnitX()), plane_of(Vec3::Zero(), Vec3::UnitY()),
                              plane_of(Vec3::Zero(), Vec3::UnitZ())},
                             radius_m, Normals::facet);
    const Vec3 corner = Vec3::Constant(radius_m);
    const Vec3 goal(-0.001, -0.002, -0.003);
    const ProxyContact c = drag(proxy, Vec3(0.02, 0.03, 0.01), goal, 37);
    EXPECT_EQ(c.hold_count, 3);
    EXPECT_LT((shown_place_W(c, goal) - corner).norm(), 1e-15);  // rounding of 1e-2
    EXPECT_NEAR(c.depth_m, (corner - goal).norm(), 1e-15);
    EXPECT_EQ(c.holds[0].surface, 2) << "the one that pushes most comes first";
  }
}

TEST_P(ProxyOfEitherKind, LiesInAConcaveCornerOfAMesh) {
  for (const double radius_m : {0.0, 0.003}) {
    // A valley of two half planes at 90 degrees along y.
    Proxy proxy =
        make_proxy({surface_of(test::roof_soup(0.05, -std::numbers::pi / 2))}, radius_m, Normals::smooth);
    const Vec3 goal(0.0004, 0.0011, -0.002);
    const ProxyContact c = drag(proxy, Vec3(0.001, 0, 0.03), goal, 40);
    const double s = std::numbers::sqrt2;
    EXPECT_TRUE(c.settled);
    EXPECT_EQ(c.hold_count, 2);
    // Where both faces are a radius away; skin of 5e-10 m does not show, rounding of 1e-1 does.
    EXPECT_LT((shown_place_W(c, goal) - Vec3(0, 0.0011, s * radius_m)).norm(), 1e-14) << radius_m;
  }
}

TEST_P(ProxyOfEitherKind, NeverEntersKnivesTipsOrThinShellsHoweverFastTheyAreStruck) {
  const std::vector<TriangleSoup> soups{cone_soup(0.01, 0.03, 12), cone_soup(0.0005, 0.03, 300),
                                        knife_soup(0.01), knife_soup(0.3),
                                        test::box_soup(Vec3(0.05, 0.05, 0.0002))};
  for (std::size_t s = 0; s < soups.size(); ++s) {
    for (const double radius_m : {0.0, 0.002}) {
      const PlacedSurface surface = surface_of(soups[s]);
      const Part& part = surface.tree->part();
      Proxy proxy = make_proxy({surface}, radius_m, Normals::smooth);
      RandomStream random(11 + s);
      Vec3 p(0.001, 0.002, 0.01), v(0, 0, -5);
      for (int k = 0; k < walk_ticks; ++k) {
        // Shot from one side to the other at up to 5 m/s, 5 mm a tick.
        if (k % 10 == 0)
          v = 5 * random.uniform() *
              (Vec3(random.normal(), random.normal(), random.normal()) * 0.3 - p.normalized()).normalized();
        p += v * dt_s;
        const ProxyContact& c = proxy.move(p, dt_s);
        ASSERT_TRUE(c.placed && std::isfinite(c.depth_m) && c.normal_W.allFinite() && c.point_W.allFinite());
        if (k % 40 != 0) continue;  // brute force is slow
        const Vec3 q = proxy.ball_W() - part.centre_P;
        // The skin's sixty-fourth is the tolerance; coordinates round far below.
        ASSERT_GE(test::brute_closest(part, q).distance_m, proxy.clearance_m() - 1e-10 * part.size_m())
            << s << " " << k;
        ASSERT_LT(std::abs(test::winding_number(part, q)), 0.5) << s << " " << k;
      }
    }
  }
}

TEST_P(ProxyOfEitherKind, KeepsItsDistanceFromEveryTriangleOfARandomSoup) {
  constexpr int ticks = 4000;  // it comes from outside and takes a while to get there
  for (int trial = 0; trial < 6; ++trial) {
    RandomStream random(100 + static_cast<std::uint64_t>(trial));
    TriangleSoup soup;
    const int count = 60;
    soup.vertices_P.resize(3, 3 * count);
    soup.triangles.resize(3, count);
    for (int t = 0; t < count; ++t) {
      const Vec3 at = 0.02 * Vec3(random.normal(), random.normal(), random.normal());
      for (int k = 0; k < 3; ++k) {
        // Some slivers, some that share corners, some of no area.
        const double size = t % 5 == 0 ? 1e-9 : 0.01;
        soup.vertices_P.col(3 * t + k) =
            at + 0.01 * k * Vec3::UnitX() + size * Vec3(random.normal(), random.normal(), random.normal());
        soup.triangles(k, t) = t % 7 == 3 && k > 0 ? 3 * (t - 1) + k : 3 * t + k;
      }
    }
    const PlacedSurface surface = surface_of(soup);
    const Part& part = surface.tree->part();
    const double radius_m = trial % 2 == 0 ? 0 : 0.001;
    Proxy proxy =
        make_proxy({surface, plane_of(Vec3(0, 0, -0.03), Vec3::UnitZ())}, radius_m, Normals::smooth);
    Vec3 p(0.1, 0, 0);
    int touched = 0;
    for (int k = 0; k < ticks; ++k) {
      p = 0.995 * p + (k % 50 == 0 ? 0.01 : 3e-4) * Vec3(random.normal(), random.normal(), random.normal());
      const ProxyContact& c = proxy.move(p, dt_s);
      ASSERT_TRUE(c.placed && std::isfinite(c.depth_m) && c.normal_W.allFinite() && c.point_W.allFinite());
      touched += c.touching() ? 1 : 0;
      ASSERT_GE(test::brute_closest(part, proxy.ball_W() - part.centre_P).distance_m,
                proxy.clearance_m() - 1e-10 * part.size_m())
          << trial << " " << k;
      ASSERT_GE(proxy.ball_W().z(), -0.03 + radius_m - 1e-15);
    }
    EXPECT_GT(touched, ticks / 10);
  }
}

TEST_P(ProxyOfEitherKind, StaysOnTheSideOfAnOpenSheetWhereItCameFrom) {
  const PlacedSurface sheet = surface_of(test::square_soup(0.1, 5));
  for (const double side : {1.0, -1.0}) {
    Proxy proxy = make_proxy({sheet}, 0, Normals::smooth);
    const ProxyContact c =
        drag(proxy, Vec3(0.0123, 0.004, 0.02 * side), Vec3(0.011, 0.0071, -0.003 * side), 9);
    EXPECT_TRUE(c.touching());
    EXPECT_NEAR(c.depth_m, 0.003, 1e-15);
    EXPECT_LT((c.normal_W - Vec3(0, 0, side)).norm(), 1e-12) << "the normal shows to the finger's side";
  }
}

// The inside of a ring is hollow to both sides of each column of its vertices and rounded along it: held by
// two facets, the ball comes over their edges from behind the planes of the next.
TEST_P(ProxyOfEitherKind, GoesRoundTheInsideOfARingAlongAColumnOfItsVertices) {
  constexpr double tube_m = 0.005, deep_m = 0.001;
  Proxy proxy = make_proxy({surface_of(test::torus_soup(0.02, tube_m, 192, 96))}, 0, Normals::smooth);
  for (int k = 0; k < walk_ticks; ++k) {
    const double inwards_m = tube_m - deep_m, angle = std::numbers::pi / 2 + 5e-6 * k / inwards_m;
    const ProxyContact& contact =
        proxy.move(Vec3(0.02 + inwards_m * std::cos(angle), 0, inwards_m * std::sin(angle)), dt_s);
    ASSERT_TRUE(contact.touching()) << "tick " << k;
    ASSERT_NEAR(contact.depth_m, deep_m, 0.01 * deep_m) << "tick " << k;
    for (int h = 0; h < contact.hold_count; ++h)
      ASSERT_GT(contact.holds[static_cast<std::size_t>(h)].normal_W.dot(contact.normal_W), 0.9)
          << "tick " << k;
  }
}

// Near to a rounding's axis the proxy has to go several times as far as the finger.
TEST_P(ProxyOfEitherKind, GoesRoundATubeWithAFingerThatIsAlmostThreeQuartersDeep) {
  constexpr double tube_m = 0.005, pace_m = 1e-4;
  const PlacedSurface ring = surface_of(test::torus_soup(0.02, tube_m, 192, 96));
  for (const double radius_m : {0.0, 0.002}) {
    for (const Normals normals : {Normals::facet, Normals::smooth}) {
      SCOPED_TRACE(testing::Message() << radius_m << " " << normals->name);
      const double deep_m = 0.7 * (tube_m + radius_m), from_axis_m = tube_m + radius_m - deep_m;
      const Vec3 across(std::cos(0.01), std::sin(0.01), 0);  // a fifth of a facet beside its vertices
      const auto way_out = [&across](double angle) -> Vec3 {
        return std::cos(angle) * across + std::sin(angle) * Vec3::UnitZ();
      };
      Proxy proxy = make_proxy({ring}, radius_m, normals);
      for (int k = 0; k <= 200; ++k)
        proxy.move(0.02 * across + (from_axis_m + 0.01 - 0.01 * k / 200) * way_out(0), dt_s);
      Vec3 last_push = deep_m * way_out(0);
      for (double angle = 0; angle < 2; angle += pace_m / from_axis_m) {
        const ProxyContact& contact = proxy.move(0.02 * across + from_axis_m * way_out(angle), dt_s);
        ASSERT_NEAR(contact.depth_m, deep_m, 0.03 * deep_m) << angle;
        ASSERT_GT(contact.normal_W.dot(way_out(angle)), std::cos(0.2)) << angle;
        const Vec3 push = contact.depth_m * contact.normal_W;
        if (normals == Normals::facet) {
          ASSERT_LE((push - last_push).norm(), 3 * pace_m + 1e-9) << angle;
        }
        last_push = push;
      }
    }
  }
}

TEST_P(ProxyOfEitherKind, StartsAtTheNearestPlaceOutside) {
  Proxy proxy = make_proxy({surface_of(test::box_soup(Vec3(0.1, 0.1, 0.02)))}, 0.001, Normals::smooth);
  const Vec3 inside(0.01, 0.02, 0.004);
  const ProxyContact& c = proxy.move(inside, dt_s);
  EXPECT_TRUE(c.started && c.placed && c.touching());
  EXPECT_LT((shown_place_W(c, inside) - Vec3(0.01, 0.02, 0.011)).norm(), 1e-15);
  EXPECT_FALSE(proxy.move(inside, dt_s).started);
}

TEST_P(ProxyOfEitherKind, StartsBehindAnOpenSheetAndOutsideAShellWoundInsideOutWithoutBeingPulled) {
  Proxy sheet = make_proxy({surface_of(test::square_soup(0.1, 5))}, 0, Normals::smooth);
  EXPECT_FALSE(sheet.move(Vec3(0, 0.001, -0.004), dt_s).touching());
  Proxy shell =
      make_proxy({surface_of(test::reversed(test::box_soup(Vec3(0.1, 0.1, 0.02))))}, 0, Normals::smooth);
  EXPECT_FALSE(shell.move(Vec3(0, 0.001, 0.014), dt_s).touching());
  const ProxyContact& c = shell.move(Vec3(0, 0.001, 0.008), dt_s);
  EXPECT_TRUE(c.touching());
  EXPECT_LT((c.normal_W - Vec3::UnitZ()).norm(), 1e-12);
}

TEST_P(ProxyOfEitherKind, RestsOnBothEdgesOfASlotNarrowerThanItselfWithoutJitter) {
  // Two blocks 6 mm apart, a ball of 5 mm: its centre rests 4 mm above the edges.
  const auto left = test::moved(test::box_soup(Vec3(0.02, 0.1, 0.02)), Vec3(-0.013, 0, -0.01));
  const auto right = test::moved(test::box_soup(Vec3(0.02, 0.1, 0.02)), Vec3(0.013, 0, -0.01));
  Proxy proxy = make_proxy({surface_of(left), surface_of(right)}, 0.005, Normals::smooth);
  const Vec3 goal(0.0001, 0.001, 0.002);
  const Vec3 rest = shown_place_W(drag(proxy, Vec3(0.0003, 0, 0.03), goal, 50), goal);
  EXPECT_LT((rest - Vec3(0, 0.001, 0.004)).norm(), 1e-10);
  for (int k = 0; k < 100; ++k) {
    const ProxyContact& c = proxy.move(goal, dt_s);
    ASSERT_EQ(c.hold_count, 2);
    ASSERT_LT((shown_place_W(c, goal) - rest).norm(), 1e-10) << k;
  }
}

/// A box and a ring that cut each other, each walked over at random by three proxies at once.
TEST_P(ProxyOfEitherKind, IsTheSameInOtherUnitsAndPlacesOfTheWorld) {
  const TriangleSoup soup =
      test::joined(test::box_soup(Vec3(0.04, 0.03, 0.02)),
                   test::moved(test::torus_soup(0.02, 0.006, 24, 12), Vec3(0, 0, 0.012)));
  PlacedSurface turned = surface_of(soup);
  turned.R_WP = Eigen::AngleAxisd(1.1, Vec3(3, -1, 2).normalized()).toRotationMatrix();
  turned.p_WP = Vec3(1e3, -1e3, 200);
  for (const double scale : {1024.0, 1000.0}) {
    TriangleSoup scaled = soup;
    scaled.vertices_P *= scale;
    for (const double radius_m : {0.0, 0.0015}) {
      Proxy here = make_proxy({surface_of(soup)}, radius_m, Normals::smooth);
      Proxy there = make_proxy({turned}, radius_m, Normals::smooth);
      Proxy larger = make_proxy({surface_of(scaled)}, scale * radius_m, Normals::smooth);
      RandomStream random(8);
      int same_scaled = 0, same_turned = 0;
      Vec3 p(0, 0, 0.04);
      for (int k = 0; k < walk_ticks; ++k) {
        p = 0.998 * p + 2e-4 * Vec3(random.normal(), random.normal(), random.normal());
        const ProxyContact a = here.move(p, dt_s), b = larger.move(scale * p, dt_s);
        const ProxyContact c = there.move(turned.R_WP * p + turned.p_WP, dt_s);
        const Vec3 push = a.touching() ? Vec3(a.depth_m * a.normal_W) : Vec3::Zero();
        const Vec3 push_scaled = b.touching() ? Vec3(b.depth_m / scale * b.normal_W) : Vec3::Zero();
        const Vec3 push_turned = c.touching() ? Vec3(c.depth_m * c.normal_W) : Vec3::Zero();
        // A power of two changes no rounding at all.
        if (scale == 1024) {
          ASSERT_EQ(push, push_scaled) << k;
        }
        // Of a force of 1000 N/m, 1e-9 N; there positions are rounded to 1e-13 m, 1e-10 N.
        same_scaled += (push - push_scaled).norm() < 1e-12 ? 1 : 0;
        same_turned += (turned.R_WP * push - push_turned).norm() < 1e-11 ? 1 : 0;
      }
      // Where two ways are equally short, rounding may choose another, until both come to the same place.
      EXPECT_GE(same_scaled, 0.99 * walk_ticks) << radius_m;
      EXPECT_GE(same_turned, 0.98 * walk_ticks) << radius_m;
    }
  }
}

}  // namespace
}  // namespace fingerpad::proxy_test
