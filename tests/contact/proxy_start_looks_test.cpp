#include <gtest/gtest.h>

#include "base/random_stream.hpp"
#include "contact/limited_proxies.hpp"
#include "support/brute_force.hpp"

// A proxy's start, where a tick's looks are limited.

namespace fingerpad::proxy_start_looks_test {
namespace {

using test::limited_proxy;
using test::looks_trials;
using test::LooksTrial;
using test::most_beyond;

TEST(ProxyLooks, AStartInPiecesFindsThePlaceThatOneAtOnceFinds) {
  int pieces = 0;
  for (const LooksTrial& trial : looks_trials()) {
    const PlacedSurface surface = surface_of(trial.soup);
    RandomStream random(31);
    int placed = 0;
    for (int k = 0; k < 60; ++k) {
      const Vec3 goal = 0.01 * Vec3(random.normal(), random.normal(), random.normal());
      Proxy whole = plain_proxy({surface}, trial.radius_m, Normals::facet);
      whole.move(goal, 1e-12);  // so short a tick moves it no farther
      Proxy limited = limited_proxy(true, surface, trial.radius_m, Normals::facet, k % 2 == 0 ? 1 : 40);
      for (int tick = 0; tick < 20000 && !limited.state().placed; ++tick, ++pieces) {
        if (!limited.move(goal, 1e-12).broken_off) break;
      }
      ASSERT_EQ(limited.state().placed, whole.state().placed) << trial.name << " " << k;
      if (!whole.state().placed) continue;
      ++placed;
      const Vec3 q = limited.ball_W() - surface.tree->part().centre_P;
      ASSERT_GE(test::brute_closest(surface.tree->part(), q).distance_m,
                limited.clearance_m() - 1e-9 * surface.tree->part().size_m())
          << trial.name << " " << k;
    }
    EXPECT_GT(placed, 20) << trial.name;
  }
  EXPECT_GT(pieces, 200);
}

TEST(ProxyLooks, AStartInTheMiddleOfASphereIsFoundInAFewTicks) {
  const PlacedSurface sphere = surface_of(test::reversed(test::sphere_soup(0.01, 6)));
  Proxy limited = fast_proxy({sphere}, 0.003, Normals::smooth);
  const Vec3 middle = sphere.tree->part().centre_P;
  int ticks = 0;
  do {
    ++ticks;
    ASSERT_LT(ticks, 20);
    limited.move(middle, 1e-3);
    ASSERT_LE(limited.looks().spent(), ServoLooks::most + most_beyond);
    ASSERT_NE(limited.state().placed, limited.state().contact.broken_off && !limited.state().placed);
  } while (!limited.state().placed);
  EXPECT_GT(ticks, 1) << "32,768 triangles are as near as each other";
}

TEST(ProxyLooks, AFreeFingerIsPlacedAtOnceHoweverManyTrianglesAreAsNear) {
  const PlacedSurface ring = surface_of(test::torus_soup(0.06, 0.025, 400, 200));
  for (const Vec3& off : {Vec3(0, 0, 0), Vec3(1e-3, 2e-3, -1e-3), Vec3(0.01, 0, 5e-3)}) {
    Proxy proxy = fast_proxy({ring}, 0.001, Normals::smooth);
    proxy.move(ring.tree->part().centre_P + off, 1e-3);
    EXPECT_TRUE(proxy.state().placed) << off.transpose();
    EXPECT_FALSE(proxy.state().contact.behind);
  }
}

TEST(ProxyLooks, ABallThatFitsNowhereTakesLittleOfATickUntilItIsOut) {
  const TriangleSoup plate = test::box_soup(Vec3(0.04, 0.04, 0.002));
  const PlacedSurface slot =
      surface_of(test::joined(test::moved(plate, Vec3(0, 0, 0.002)), test::moved(plate, Vec3(0, 0, -0.002))));
  constexpr long looks = 2000;
  Proxy proxy = limited_proxy(true, slot, 0.002, Normals::smooth, looks);
  int tries = 0;
  do {
    ASSERT_LT(++tries, 100);
    proxy.move(Vec3(0.001, 0, 0), 1e-3);
  } while (proxy.state().contact.broken_off);
  ASSERT_FALSE(proxy.state().placed);
  long most = 0;
  for (int k = 0; k < 50; ++k) {
    proxy.move(Vec3(0.001 + 1e-5 * k, 0, 0), 1e-3);
    ASSERT_FALSE(proxy.state().placed);
    most = std::max(most, proxy.looks().spent());
  }
  // A search may be ended by the look that spends what is left: a packet, or the angles of eight triangles.
  EXPECT_LE(most, looks / ProxyLimits::less_after_no_place + LookCosts::angle * 8 + LookCosts::closest);
  proxy.move(Vec3(0.001, 0, 0.03), 1e-3);
  EXPECT_TRUE(proxy.state().placed) << "it waits for no start from where it was";
}

TEST(ProxyLooks, AStartThatTakesLongTakesLittleOfATick) {
  const PlacedSurface ball = surface_of(test::sphere_soup(0.02, 4));
  constexpr long looks = 80;
  Proxy proxy = limited_proxy(true, ball, 0.002, Normals::smooth, looks);
  int ticks = 0;
  for (long spent = 0; !proxy.state().placed; ++ticks) {
    ASSERT_LT(ticks, 10000);
    proxy.move(Vec3(0.001, 0, 0), 1e-3);
    spent = proxy.looks().spent();
    // The last look may be at a packet, or at the angles of eight triangles.
    const long most = ticks < ProxyLimits::patient_ticks ? looks : looks / ProxyLimits::less_after_no_place;
    if (!proxy.state().placed) {
      EXPECT_LE(spent, most + LookCosts::angle * 8 + LookCosts::closest) << ticks;
    }
  }
  EXPECT_GT(ticks, 2 * ProxyLimits::patient_ticks);
}

}  // namespace
}  // namespace fingerpad::proxy_start_looks_test
