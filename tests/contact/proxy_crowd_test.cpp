#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "contact/fine_sheets.hpp"
#include "support/effort.hpp"

// A ball on facets of a hundredth of its size, more than any view shows, against closed forms.

namespace fingerpad::proxy_crowd_test {
namespace {

constexpr double radius_m = 0.007, facet_m = 5e-5, depth_m = 0.001, dt_s = 0.001;
constexpr int ticks = 80;
constexpr std::size_t landing = 24;

/// @param way_m  that the ball goes in a tick: it is a tick behind at most, to a hundredth of its depth
void expect_kept_up(const test::Worst& worst, double way_m, int most_unsettled) {
  EXPECT_LT(worst.push, 0.01 + way_m / depth_m);
  EXPECT_LE(worst.unsettled, most_unsettled);
  EXPECT_LE(worst.most_looks, ServoLooks::most + 2000);
}

TEST(ProxyCrowd, OnAPlateABigBallKeepsUp) {
  const TriangleSoup plate = test::sheet_soup(
      600, 300, [](double u, double v) { return Vec3(0.03 * u - 0.015, 0.015 * v - 0.0075, 0); });
  for (const double facets_per_tick : test::cases({0.5, 1.0, 2.0})) {
    const auto at = [&](int k, double deep_m) {
      const double x_m = -0.004 + facets_per_tick * facet_m * k;
      return Vec3(x_m, 0.3 * x_m, radius_m - deep_m);
    };
    std::vector<Vec3> path = {at(0, -5e-4)};
    for (int k = 0; k <= 20; ++k) path.push_back(at(0, depth_m * k / 20));
    for (int k = 0; k < ticks; ++k) path.push_back(at(k, depth_m));
    const test::Worst worst = test::worst_along(
        plate, radius_m, dt_s, path, depth_m, [](const Vec3& p) { return Vec3(0, 0, radius_m - p.z()); },
        landing);
    expect_kept_up(worst, facets_per_tick * facet_m * std::hypot(1, 0.3), 5);
  }
}

/// Round the axis of a groove along x, and along it: in a tick now and then it is broken off.
TEST(ProxyCrowd, InAGrooveOfAboutItsSizeItKeepsUp) {
  for (const double groove_m : test::cases({0.008, 0.010})) {
    const int across = static_cast<int>(2 * groove_m / facet_m);
    const TriangleSoup groove = test::sheet_soup(200, across, [&](double u, double v) {
      const double angle = 2 * v - 1;
      return Vec3(0.01 * u - 0.005, groove_m * std::sin(angle), -groove_m * std::cos(angle));
    });
    const auto place = [](double x_m, double angle, double from_axis_m) {
      return Vec3(x_m, from_axis_m * std::sin(angle), -from_axis_m * std::cos(angle));
    };
    const double held_m = groove_m - radius_m;
    const auto push = [&](const Vec3& p) {
      const Vec3 off(0, p.y(), p.z());
      return Vec3(-std::max(0.0, off.norm() - held_m) * off.normalized());
    };
    for (const bool is_along : {true, false}) {
      for (const double facets_per_tick : test::cases({0.5, 1.0, 2.0})) {
        const auto at = [&](int k, double deep_m) {
          const double way_m = facets_per_tick * facet_m * k;
          return is_along ? place(-0.003 + std::min(way_m, 0.006), 0.2, held_m + deep_m)
                          : place(1e-4, -0.6 + way_m / groove_m, held_m + deep_m);
        };
        std::vector<Vec3> path = {at(0, -5e-4)};
        for (int k = 0; k <= 20; ++k) path.push_back(at(0, depth_m * k / 20));
        for (int k = 0; k < ticks; ++k) path.push_back(at(k, depth_m));
        SCOPED_TRACE(testing::Message() << groove_m << " m, along " << is_along << ", " << facets_per_tick);
        const test::Worst worst = test::worst_along(groove, radius_m, dt_s, path, depth_m, push, landing);
        expect_kept_up(worst, facets_per_tick * facet_m, ticks / 5);
      }
    }
  }
}

/// With looks for one step in several ticks: what it pushes while it catches up under a resting finger is no
/// more right than what it pushed before.
TEST(ProxyCrowd, ThatWasOutrunIsBehindUntilItHasComeToRest) {
  const TriangleSoup plate = test::sheet_soup(
      300, 300, [](double u, double v) { return Vec3(0.015 * u - 0.0075, 0.015 * v - 0.0075, 0); });
  Proxy proxy = fast_proxy({surface_of(plate)}, radius_m, Normals::facet, Looks(500));
  for (int k = 0; k < 200; ++k)
    proxy.move(Vec3(-0.004, 0, radius_m - depth_m * std::min(1.0, k / 100.0)), dt_s);
  int off = 0, off_unbroken = 0;
  for (int k = 0; k < 400; ++k) {
    const Vec3 finger(-0.004 + 1e-4 * std::min(k, 60), 0, radius_m - depth_m);
    const ProxyContact& c = proxy.move(finger, dt_s);
    if ((test::push_of(c) - depth_m * Vec3::UnitZ()).norm() <= 0.03 * depth_m) continue;
    ++off;
    off_unbroken += c.broken_off ? 0 : 1;
    EXPECT_TRUE(c.behind) << k;
  }
  EXPECT_GT(off, 60) << "it was outrun";
  EXPECT_GT(off_unbroken, 10) << "and caught up";
  EXPECT_FALSE(proxy.state().contact.behind);
}

}  // namespace
}  // namespace fingerpad::proxy_crowd_test
