#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/random_stream.hpp"
#include "contact/limited_proxies.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"
#include "support/shapes.hpp"

// A tick's looks are limited: what a proxy does that is broken off again and again.

namespace fingerpad::proxy_looks_test {
namespace {

using test::limited_proxy;
using test::looks_trials;
using test::LooksTrial;
using test::most_beyond;

const int walk_ticks = test::sanitized() ? 300 : 3000;
/// A resting finger lets the proxy come all the way in one tick of a second.
constexpr double dt_s = 1;
/// Across the part at some millimetres a tick, and between whiles not at all.
class Shots {
 public:
  explicit Shots(std::uint64_t seed) : random_(seed) {}
  Vec3 next() {
    if (k_ % 24 == 0) step_ = 0.004 * random_.uniform() * (0.4 * any() - p_.normalized()).normalized();
    if (k_++ % 24 < 12) p_ += step_;
    return p_;
  }

 private:
  Vec3 any() { return {random_.normal(), random_.normal(), random_.normal()}; }
  RandomStream random_;
  Vec3 p_ = Vec3(0.004, 0.003, 0.05), step_ = Vec3::Zero();
  int k_ = 0;
};

TEST(ProxyLooks, NothingIsCrossedHoweverLittleATickMayLookAt) {
  for (const LooksTrial& trial : looks_trials()) {
    const PlacedSurface surface = surface_of(trial.soup);
    const Part& part = surface.tree->part();
    for (const bool fast : {false, true}) {
      for (const long looks : {1L, 30L, 300L}) {
        SCOPED_TRACE(testing::Message() << trial.name << ", " << looks << (fast ? " fast" : " plain"));
        Proxy proxy = limited_proxy(fast, surface, trial.radius_m, Normals::smooth, looks);
        Shots finger(17);
        int broken_off = 0, touched = 0;
        for (int k = 0; k < walk_ticks; ++k) {
          const ProxyContact& c = proxy.move(finger.next(), 1e-3);
          ASSERT_TRUE(std::isfinite(c.depth_m) && c.normal_W.allFinite() && c.point_W.allFinite());
          ASSERT_LE(proxy.looks().spent(), looks + most_beyond);
          broken_off += c.broken_off ? 1 : 0;
          touched += c.placed && c.touching() ? 1 : 0;
          if (!c.placed || k % 20 != 0) continue;
          const Vec3 q = proxy.ball_W() - part.centre_P;
          ASSERT_GE(test::brute_closest(part, q).distance_m, proxy.clearance_m() - 1e-10 * part.size_m())
              << k;
          ASSERT_LT(std::abs(test::winding_number(part, q)), 0.75) << k;  // of an open valley, one half
        }
        EXPECT_GT(touched, 0);
        if (looks == 1) {
          EXPECT_GT(broken_off, walk_ticks / 20);
        }
      }
    }
  }
}

/// Until it rests.
int ticks_to_rest(Proxy& proxy, const Vec3& goal) {
  for (int k = 1; k < 5000; ++k) {
    const ProxyContact& c = proxy.move(goal, dt_s);
    if (c.placed && c.settled && !c.broken_off) return k;
  }
  return -1;
}

TEST(ProxyLooks, UnderARestingFingerItComesToWhereAnUnlimitedOneComes) {
  for (const LooksTrial& trial : looks_trials()) {
    const PlacedSurface surface = surface_of(trial.soup);
    const double size_m = surface.tree->part().size_m();
    for (const long looks : {1L, 30L, 300L}) {
      SCOPED_TRACE(testing::Message() << trial.name << ", " << looks);
      Proxy limited = limited_proxy(false, surface, trial.radius_m, Normals::facet, looks);
      Proxy fast = limited_proxy(true, surface, trial.radius_m, Normals::facet, looks);
      Proxy whole = plain_proxy({surface}, trial.radius_m, Normals::facet);
      Shots finger(23);
      int rests = 0, longer = 0, same = 0, fast_same = 0;
      for (int k = 0; k < walk_ticks / 3; ++k) {
        const Vec3 goal = finger.next();
        if (k % 8 != 0 || !limited.state().placed) {
          limited.move(goal, 1e-3);
          continue;
        }
        limited.resume(limited.state());  // what is broken off goes another way
        whole.resume(limited.state());
        fast.resume(limited.state());
        const int ticks = ticks_to_rest(limited, goal);
        ASSERT_GT(ticks, 0) << k;
        ASSERT_GT(ticks_to_rest(fast, goal), 0) << k;
        const int whole_ticks = ticks_to_rest(whole, goal);
        ASSERT_GT(whole_ticks, 0) << k;
        ++rests;
        longer += ticks > whole_ticks ? 1 : 0;
        // Two places that are as near to the finger, to within some tolerances (2^-34 of the size), are as
        // good.
        const auto away_m = [&](const Proxy& proxy) { return (proxy.state().place_O - goal).norm(); };
        const double alike_m = 16 * std::ldexp(size_m, -34);
        same += std::abs(away_m(limited) - away_m(whole)) < alike_m ? 1 : 0;
        fast_same += std::abs(away_m(fast) - away_m(whole)) < alike_m ? 1 : 0;
      }
      EXPECT_GT(rests, walk_ticks / 50);
      EXPECT_EQ(same, rests);
      // Its views may end a long step short, and another wall than the one farther on holds it from there.
      EXPECT_GE(fast_same, rests - rests / 10);
      if (looks == 1) {
        EXPECT_GT(longer, 0) << "it was broken off";
      }
    }
  }
}

/// A bar with a bore through it along z, whose facets touch the circle of this radius from outside.
TriangleSoup bore_soup(double radius_m, int facets) {
  const double inner_m = radius_m / std::cos(std::numbers::pi / facets);
  TriangleSoup soup;
  soup.vertices_P.resize(3, 4 * facets);
  soup.triangles.resize(3, 8 * facets);
  for (int k = 0; k < facets; ++k) {
    const double angle = 2 * std::numbers::pi * k / facets;
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    for (int i = 0; i < 4; ++i)
      soup.vertices_P.col(4 * k + i) =
          (i < 2 ? inner_m : 3 * radius_m) * out + (i % 2 == 0 ? 4 : -4) * radius_m * Vec3::UnitZ();
    const int a = 4 * k, b = 4 * ((k + 1) % facets);
    const int quads[4][4] = {{a, a + 1, b + 1, b},
                             {a + 2, b + 2, b + 3, a + 3},
                             {a, b, b + 2, a + 2},
                             {a + 1, a + 3, b + 3, b + 1}};
    for (int i = 0; i < 4; ++i) {
      soup.triangles.col(8 * k + 2 * i) << quads[i][0], quads[i][1], quads[i][2];
      soup.triangles.col(8 * k + 2 * i + 1) << quads[i][0], quads[i][2], quads[i][3];
    }
  }
  return soup;
}

TEST(ProxyLooks, ABallInABoreOfItsOwnRadiusSlidesAlongItWithinItsLooks) {
  struct Bore {
    int facets;
    double most_behind_m;  ///< finer facets take several ticks, in which the finger goes on
  };
  for (const Bore& bore : {Bore{360, 1e-4}, Bore{1440, 3e-3}}) {
    SCOPED_TRACE(bore.facets);
    // Thirty nanometres of room, since a ball keeps its skin.
    const PlacedSurface surface = surface_of(bore_soup(0.003 * (1 + 1e-5), bore.facets));
    Proxy proxy = fast_proxy({surface}, 0.003, Normals::smooth);
    int touched = 0, settled = 0;
    double most_behind_m = 0;
    for (int k = 0; k < walk_ticks / 3; ++k) {
      // Pressed against the wall all around it, and along the bore.
      const Vec3 goal(2e-4 * std::sin(0.01 * k), 2e-4 * std::cos(0.013 * k), 5e-3 * std::sin(0.005 * k));
      const ProxyContact& c = proxy.move(goal, 1e-3);
      ASSERT_LE(proxy.looks().spent(), ServoLooks::most + most_beyond);
      touched += c.placed && c.touching() ? 1 : 0;
      settled += c.placed && c.settled ? 1 : 0;
      if (k >= 20) most_behind_m = std::max(most_behind_m, std::abs(proxy.ball_W().z() - goal.z()));
    }
    const int after_start = walk_ticks / 3 - 40;
    EXPECT_GT(touched, after_start);
    EXPECT_LT(most_behind_m, bore.most_behind_m);
    if (bore.facets == 360) {
      EXPECT_GT(settled, after_start / 3);
    }
  }
}

TEST(ProxyLooks, AFingerThatLeavesAFanOfAHundredThousandSliversIsNotHeld) {
  constexpr int facets = 100000;
  TriangleSoup soup;
  soup.vertices_P.resize(3, facets + 1);
  soup.triangles.resize(3, facets);
  soup.vertices_P.col(0) = Vec3::Zero();
  for (int k = 0; k < facets; ++k) {
    const double angle = 2 * std::numbers::pi * k / facets;
    soup.vertices_P.col(k + 1) = Vec3(0.02 * std::cos(angle), 0.02 * std::sin(angle), -0.002);
    soup.triangles.col(k) << 0, k + 1, (k + 1) % facets + 1;
  }
  Proxy proxy = fast_proxy({surface_of(soup)}, 0, Normals::smooth);
  bool touched = false;
  for (int k = 0; k <= 400; ++k) {
    // Onto the tip, a millimetre deep, and away again.
    const double z_m = 1e-3 * std::abs(4 - 0.02 * k * 1.25) - 1e-3;
    const ProxyContact& c = proxy.move(Vec3(1e-7, 0, z_m), 1e-3);
    ASSERT_LE(proxy.looks().spent(), ServoLooks::most + most_beyond);
    touched |= c.touching();
    if (c.touching()) {
      ASSERT_GT(c.direction_W.z(), 0) << "pushed out, never pulled in " << k;
    }
    ASSERT_TRUE(!c.touching() || z_m < 1e-4) << "held " << z_m << " m above the tip";
  }
  EXPECT_TRUE(touched);
  for (int k = 0; k < 300; ++k) proxy.move(Vec3(1e-7, 0, 4e-3), 1e-3);
  EXPECT_FALSE(proxy.state().contact.touching());
  EXPECT_GT(proxy.ball_W().z(), 3.9e-3) << "it followed";
}

}  // namespace
}  // namespace fingerpad::proxy_looks_test
