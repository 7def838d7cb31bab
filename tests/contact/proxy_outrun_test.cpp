#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "contact/fine_sheets.hpp"

// A finger that goes over many facets in a tick, against closed forms: the proxy keeps up within its looks.

namespace fingerpad::proxy_outrun_test {
namespace {

constexpr double radius_m = 0.003, dt_s = 0.004;

using test::push_of;
using test::sheet_soup;
using test::Worst;

template <class Push>
Worst worst_along(const TriangleSoup& soup, const std::vector<Vec3>& path, double depth_m, Push push) {
  return test::worst_along(soup, radius_m, dt_s, path, depth_m, push);
}

TEST(ProxyOutrun, OnAFinePlateItKeepsUp) {
  // Facets of .15 mm, of which it passes eight in a tick.
  const TriangleSoup plate =
      sheet_soup(120, 120, [](double u, double v) { return Vec3(0.018 * u - 0.009, 0.018 * v - 0.009, 0); });
  constexpr double depth_m = 0.001;
  std::vector<Vec3> path = {Vec3(-0.004, -0.001, radius_m + 5e-4), Vec3(-0.004, -0.001, radius_m)};
  for (int k = 0; k < 60; ++k) {
    const double x_m = 0.004 * 2 / std::numbers::pi * std::asin(std::sin(0.4712 * k - 1.57));  // to and fro
    path.emplace_back(x_m, 0.3 * x_m, radius_m - depth_m);
  }
  const Worst worst =
      worst_along(plate, path, depth_m, [](const Vec3& p) { return Vec3(0, 0, radius_m - p.z()); });
  EXPECT_LT(worst.push, 1e-3);
  EXPECT_EQ(worst.unsettled, 0);
  EXPECT_LE(worst.most_looks, ServoLooks::most + 2000);
}

/// Two walls of facets of .1 mm that meet in an inner edge along x, and a ball that lies on both.
TEST(ProxyOutrun, AlongAnInnerEdgeOfFineFacetsItKeepsUp) {
  constexpr double depth_m = 0.001;
  for (const double lean_rad : {1.0, 1.5708, 2.2}) {
    const Vec3 floor = Vec3::UnitZ(), wall(0, std::sin(lean_rad), -std::cos(lean_rad));
    const TriangleSoup soup = sheet_soup(160, 200, [&](double u, double v) {
      const double up_m = 0.01 - 0.02 * v;
      const Vec3 across =
          up_m < 0 ? Vec3(0, -up_m, 0) : Vec3(0, std::cos(lean_rad), std::sin(lean_rad)) * up_m;
      return Vec3(Vec3(0.016 * u - 0.008, 0, 0) + across);
    });
    const auto place = [&](double x_m, double from_walls_m) {
      return Vec3(Vec3(x_m, 0, 0) + from_walls_m / (1 + floor.dot(wall)) * (floor + wall));
    };
    for (const double tick_m : {1e-4, 3e-4}) {
      std::vector<Vec3> path = {place(-0.004, radius_m + 5e-4), place(-0.004, radius_m)};
      for (double x_m = -0.004; x_m < 0.004; x_m += tick_m) path.push_back(place(x_m, radius_m - depth_m));
      const Worst worst =
          worst_along(soup, path, depth_m, [&](const Vec3& p) { return Vec3(place(p.x(), radius_m) - p); });
      EXPECT_LT(worst.push, 1e-3) << lean_rad << ", " << tick_m;
      EXPECT_EQ(worst.unsettled, 0) << lean_rad << ", " << tick_m;
      EXPECT_LE(worst.most_looks, ServoLooks::most + 2000) << lean_rad << ", " << tick_m;
    }
  }
}

/// Deep enough that the finger is nearest to facets from whose planes the ball slides off. With few looks a
/// tick steps are broken off, and gone on with while the finger waits.
TEST(ProxyOutrun, OverAFinePlatesRimItIsHeldAsByThePlainProxy) {
  const TriangleSoup plate =
      sheet_soup(120, 120, [](double u, double v) { return Vec3(0.018 * u - 0.009, 0.018 * v - 0.009, 0); });
  constexpr double depth_m = 0.0025;
  const auto hold_against_plain = [&](double way_m, long looks, int ticks) {
    Proxy fast = fast_proxy({surface_of(plate)}, radius_m, Normals::facet, Looks(looks));
    Proxy plain = plain_proxy({surface_of(plate)}, radius_m, Normals::facet);
    int compared = 0;
    const auto move = [&](const Vec3& finger) {
      for (int k = 0; k < ticks; ++k) {
        const ProxyContact &seen = fast.move(finger, dt_s), &truth = plain.move(finger, dt_s);
        if (!seen.settled || !truth.settled) continue;
        ++compared;
        // Where both are right: steps end within what counts as touching, and each by its own ways.
        EXPECT_LT((push_of(seen) - push_of(truth)).norm(), 0.02 * depth_m)
            << "at x = " << finger.x() << " m, " << way_m << " m and " << looks << " looks a tick";
      }
    };
    move({-0.006, -0.001, radius_m + 5e-4});
    for (double x_m = -0.006; x_m < 0.0165; x_m += way_m) move({x_m, -0.001, radius_m - depth_m});
    EXPECT_GT(compared, 0.009 / way_m);
  };
  hold_against_plain(0.0012, ServoLooks::most, 1);
  hold_against_plain(0.002, ServoLooks::most, 1);
  for (const long looks : {1000L, 2000L, 4000L}) hold_against_plain(0.002, looks, 20);
}

TEST(ProxyOutrun, InABoreOfFineFacetsItKeepsUp) {
  constexpr double bore_m = 0.004, depth_m = 6e-4;
  const TriangleSoup bore = sheet_soup(1000, 1, [](double u, double v) {
    const double angle = -2 * std::numbers::pi * u;
    return Vec3(bore_m * std::cos(angle), bore_m * std::sin(angle), 0.03 * v - 0.015);
  });
  std::vector<Vec3> path = {Vec3(5e-4, 0, 0), Vec3(bore_m - radius_m, 0, 0)};
  for (int k = 0; k < 60; ++k) {
    const double angle = 0.25 * k, r_m = bore_m - radius_m + depth_m;
    path.emplace_back(r_m * std::cos(angle), r_m * std::sin(angle), 0);
  }
  const Worst worst =
      worst_along(bore, path, depth_m, [&](const Vec3& p) { return Vec3(-depth_m * p.normalized()); });
  EXPECT_LT(worst.push, 0.01);
  EXPECT_EQ(worst.unsettled, 0);
  EXPECT_LE(worst.most_looks, ServoLooks::most + 2000);
}

TEST(ProxyOutrun, RoundABallOfFineFacetsItKeepsUp) {
  constexpr double ball_m = 0.005, depth_m = 0.001;
  const TriangleSoup ball = test::sphere_soup(ball_m, 6);
  std::vector<Vec3> path;
  for (int k = 0; k < 60; ++k) {
    const double angle = 0.17 * k, r_m = ball_m + radius_m - (k < 2 ? 0 : depth_m);
    path.push_back(r_m * (std::cos(angle) * Vec3(0.6, 0.8, 0) + std::sin(angle) * Vec3(0, 0, 1)));
  }
  const Worst worst =
      worst_along(ball, path, depth_m, [&](const Vec3& p) { return Vec3(depth_m * p.normalized()); });
  EXPECT_LT(worst.push, 0.02);
  EXPECT_EQ(worst.unsettled, 0);
  EXPECT_LE(worst.most_looks, ServoLooks::most + 2000);
}

}  // namespace
}  // namespace fingerpad::proxy_outrun_test
