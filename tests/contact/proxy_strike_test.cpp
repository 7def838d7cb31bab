#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/random_stream.hpp"
#include "contact/proxies.hpp"
#include "contact/proxy_leash.hpp"
#include "support/shapes.hpp"

// Fingers that come out of the air deep into a part within a tick, again and again: the ball ends on the face
// that it meets, whatever it has touched before and whatever else is nearer to the finger.

namespace fingerpad::proxy_strike_test {
namespace {

constexpr double half_m = 0.5, dt_s = 0.001;

/// A cube about the origin, each face of 24 x 24 cells split in two.
TriangleSoup fine_cube() {
  constexpr int cells = 24;
  std::optional<TriangleSoup> cube;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      TriangleSoup face = test::square_soup(2 * half_m, cells);
      for (Eigen::Index i = 0; i < face.vertices_P.cols(); ++i) {
        const Vec3 p = face.vertices_P.col(i);
        Vec3 turned;
        turned[axis] = side * half_m;
        turned[(axis + 1) % 3] = p.x();
        turned[(axis + 2) % 3] = p.y();
        face.vertices_P.col(i) = turned;
      }
      if (side < 0) face = test::reversed(std::move(face));
      cube = cube ? test::joined(*cube, face) : face;
    }
  }
  return *cube;
}

double distance_to_cube_m(const Vec3& p) {
  return (p - p.cwiseMax(Vec3::Constant(-half_m)).cwiseMin(Vec3::Constant(half_m))).norm();
}

/// The outward normal of the face on which a ball ends that comes on a straight way: the one that its
/// centre's way enters. Where an edge is met first the ball slips off to the side on which the way passes it,
/// which is that face's too. None where it is a corner.
std::optional<Vec3> face_met(const Vec3& from, const Vec3& to, double radius_m) {
  double outside = 0, inside = 1;
  // From within the cube outwards: the cube with its rounding is convex.
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (outside + inside);
    (distance_to_cube_m(from + middle * (to - from)) > radius_m ? outside : inside) = middle;
  }
  const Vec3 touch = from + outside * (to - from);
  if ((touch.cwiseAbs().array() > half_m).count() == 3) return std::nullopt;
  double entry = -1;
  Vec3 normal = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(from[axis]) <= half_m) continue;
    const double side = std::copysign(1.0, from[axis]);
    const double along = (side * half_m - from[axis]) / (to[axis] - from[axis]);
    if (along <= entry) continue;
    entry = along;
    normal = side * Vec3::Unit(axis);
  }
  return normal;
}

/// From one direction to another, far outside.
std::vector<Vec3> way_round(const Vec3& from, const Vec3& to) {
  constexpr int ticks = 16;
  const Vec3 a = from.normalized(), b = to.normalized();
  const double angle = std::acos(std::clamp(a.dot(b), -1.0, 1.0));
  std::vector<Vec3> way;
  for (int k = 0; k <= ticks; ++k) {
    const double turned = angle * k / ticks;
    way.emplace_back(2 * (std::sin(angle - turned) * a + std::sin(turned) * b) / std::sin(angle));
  }
  return way;
}

Vec3 any_within(RandomStream& random, double size_m) {
  return Vec3(random.uniform(), random.uniform(), random.uniform()) * 2 * size_m - Vec3::Constant(size_m);
}

/// Strikes again and again, and holds the finger still for some ticks each time: how many ended, and those
/// that did not on the face that they met, or at all.
struct Strikes {
  int ended = 0, elsewhere = 0, never = 0;
};

Strikes strikes_of(Proxy proxy, double radius_m, int count, int ticks) {
  RandomStream random(24);
  Strikes strikes;
  Vec3 outside(0, 0, 1);
  for (int k = 0; k < count; ++k) {
    const Vec3 next = any_within(random, 1.1);
    if (next.cwiseAbs().maxCoeff() < half_m + radius_m + 0.02) continue;
    // The way back out of the part is the way in.
    for (int tick = 0; tick < ticks; ++tick) proxy.move(outside, dt_s);
    for (const Vec3& p : way_round(outside, next)) proxy.move(p, dt_s);
    for (int tick = 0; tick < ticks; ++tick) proxy.move(next, dt_s);
    EXPECT_FALSE(proxy.state().contact.touching());
    outside = next;
    const Vec3 finger = any_within(random, half_m - 0.03);
    for (int tick = 0; tick < ticks; ++tick) proxy.move(finger, dt_s);
    const ProxyContact& contact = proxy.state().contact;
    const auto face = face_met(next, finger, radius_m);
    if (!face) continue;
    ++strikes.ended;
    if (!contact.settled) {
      ++strikes.never;
    } else if (std::abs(contact.depth_m - (half_m + radius_m - face->dot(finger))) > 1e-9 ||
               contact.direction_W.dot(*face) < 1 - 1e-9) {
      ++strikes.elsewhere;
    }
  }
  return strikes;
}

TEST(ProxyStrike, EndsOnTheFaceThatItMeets) {
  const PlacedSurface cube = surface_of(fine_cube());
  for (const double radius_m : {0.0, 0.02, 0.07}) {
    const Strikes strikes = strikes_of(usual_proxy({cube}, radius_m, Normals::facet), radius_m, 650, 21);
    EXPECT_GT(strikes.ended, 480) << radius_m;
    EXPECT_EQ(strikes.elsewhere, 0) << radius_m;
    EXPECT_EQ(strikes.never, 0) << radius_m;
  }
}

// What is left of a blow is no push that a leash holds back: the ball is there within some ticks, and does
// not creep for seconds under a force that it does not have to bear.
TEST(ProxyStrike, WhereATicksLooksRunOutItComesToItsEndInTheNext) {
  const PlacedSurface cube = surface_of(fine_cube());
  constexpr double radius_m = 0.07;
  for (const long looks : {2000L, 5000L}) {
    const Strikes strikes =
        strikes_of(fast_proxy({cube}, radius_m, Normals::facet, Looks(looks)), radius_m, 650, 21);
    EXPECT_GT(strikes.ended, 480) << looks;
    EXPECT_LE(strikes.elsewhere, strikes.ended / 100) << looks;
    EXPECT_EQ(strikes.never, 0) << looks;
  }
}

// To the very same place: what the first strike was likely to meet is not what the second does.
TEST(ProxyStrike, FromAnotherSideEndsOnThatSide) {
  const PlacedSurface cube = surface_of(fine_cube());
  RandomStream random(9);
  for (const double radius_m : {0.0, 0.02, 0.07}) {
    Proxy proxy = usual_proxy({cube}, radius_m, Normals::facet);
    Vec3 outside(0, 0, 2);
    int judged = 0;
    for (int k = 0; k < 60; ++k) {
      const Vec3 finger = any_within(random, half_m - 0.03);
      for (int side = 0; side < 3; ++side) {
        const Vec3 from = 2 * any_within(random, 1).normalized();
        for (const Vec3& p : way_round(outside, from)) proxy.move(p, dt_s);
        outside = from;
        for (int tick = 0; tick < 10; ++tick) proxy.move(finger, dt_s);
        const ProxyContact& contact = proxy.state().contact;
        const auto face = face_met(from, finger, radius_m);
        if (face && contact.settled) {
          ++judged;
          EXPECT_GT(contact.direction_W.dot(*face), 1 - 1e-9) << radius_m << ", " << k << ", " << side;
        }
        // Out slowly, the way it came.
        for (int tick = 0; tick <= 100; ++tick) proxy.move(finger + 0.01 * tick * (from - finger), dt_s);
      }
    }
    EXPECT_GT(judged, 150);
  }
}

TEST(ProxyStrike, IsOnALeashAgainOnceItsTimeIsOver) {
  Proxy proxy = fast_proxy({surface_of(fine_cube())}, 0.07, Normals::facet, Looks(300));
  RandomStream random(5);
  int arriving = 0, still_behind = 0;
  for (int k = 0; k < 60; ++k) {
    proxy.reset();
    const Vec3 side(random.uniform(), random.uniform(), 1), finger = 0.4 * (side - Vec3(0.5, 0.5, 0.5));
    for (int tick = 0; tick < 60; ++tick) proxy.move(1.5 * side, dt_s);
    int tick = 0;
    for (proxy.move(finger, dt_s); tick < 30 && proxy.state().contact.broken_off; ++tick) {
      const bool is_free_to_go = std::isinf(most_step_m(proxy.state(), 1));
      EXPECT_EQ(is_free_to_go, tick < 20 || !proxy.state().contact.touching()) << tick;
      arriving += is_free_to_go ? 1 : 0;
      proxy.move(finger, dt_s);
    }
    still_behind += tick > 20 ? 1 : 0;
  }
  EXPECT_GT(arriving, 60);
  EXPECT_GT(still_behind, 10);
}

// The way enters a block by its top and leaves it by a side, from whose plane's other side the point comes to
// the edge between both.
TEST(ProxyStrike, APointIsNotHeldAtAnEdgeThatItsWayLeadsOver) {
  const PlacedSurface block = surface_of(test::box_soup(Vec3::Constant(2 * half_m)));
  RandomStream random(23);
  for (const ProxyKind& kind : proxy_kinds) {
    for (int k = 0; k < 300; ++k) {
      const auto any = [&random](double most) { return most * (2 * random.uniform() - 1); };
      const Vec3 over(half_m - 0.2 * half_m * random.uniform(), any(0.5 * half_m), half_m);
      const Vec3 out(half_m, any(0.5 * half_m), half_m * (1 - 0.2 * random.uniform()));
      const Vec3 way = (out - over).normalized();
      const Vec3 start = over - half_m * way, finger = out + 0.3 * half_m * random.uniform() * way;
      Proxy proxy = kind.make({block}, 0, k % 2 == 0 ? Normals::facet : Normals::smooth);
      proxy.move(start, dt_s);
      ASSERT_TRUE(proxy.state().placed);
      proxy.move(finger, dt_s);
      const ProxyContact& contact = proxy.move(finger, dt_s);
      EXPECT_FALSE(contact.touching())
          << kind.name << " " << start.transpose() << " to " << finger.transpose() << ": " << contact.depth_m;
    }
  }
}

}  // namespace
}  // namespace fingerpad::proxy_strike_test
