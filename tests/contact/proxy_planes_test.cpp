#include <Eigen/Geometry>
#include <cmath>

#include "base/random_stream.hpp"
#include "contact/proxies.hpp"

// A proxy among planes alone, where there is no part to compare lengths with.

namespace fingerpad::proxy_planes_test {
namespace {

class ProxyAmongPlanes : public EitherProxy {};
INSTANTIATE_TEST_SUITE_P(Kinds, ProxyAmongPlanes, testing::ValuesIn(proxy_kinds), kind_name);

/// Two planes through the y axis that leave free what is above both, each at this angle from the vertical.
std::vector<PlacedSurface> v_of_planes(double half_angle_rad, const Vec3& at,
                                       const Mat3& turn = Mat3::Identity()) {
  const double c = std::cos(half_angle_rad), s = std::sin(half_angle_rad);
  // Points of the planes that are not the same: no number is exact by luck.
  return {plane_of(at + turn * Vec3(s, 0.4, -c), turn * Vec3(c, 0, s)),
          plane_of(at + turn * Vec3(-s, -0.2, -c), turn * Vec3(-c, 0, s))};
}

Vec3 random_vector(RandomStream& random) {
  return {random.normal(), random.normal(), random.normal()};
}

TEST_P(ProxyAmongPlanes, ABallThatStartsInAVOfTwoPlanesIsPlacedAndFeelsBothAllAlongIt) {
  RandomStream random(3);
  for (const double half_angle_rad : {0.03, 0.4, M_PI / 4, 1.2, 1.5}) {
    for (int trial = 0; trial < 60; ++trial) {
      const double radius_m = trial % 3 == 0 ? 0 : 0.004;
      const Vec3 at = random_vector(random);
      const Mat3 turn =
          Eigen::AngleAxisd(3 * random.uniform(), random_vector(random).normalized()).toRotationMatrix();
      Proxy proxy = make_proxy(v_of_planes(half_angle_rad, at, turn), radius_m, Normals::smooth);
      // What rounding leaves of coordinates of some metres, and the V's angle magnifies.
      const double rounding_m = 1e-13 / std::sin(2 * half_angle_rad);
      for (int k = 0; k < 20; ++k) {
        const Vec3 rest = at + turn * Vec3(0, 1e-4 * k, radius_m / std::sin(half_angle_rad));
        const Vec3 p_WQ = rest - turn * Vec3(0, 0, 0.002);
        const ProxyContact& contact = proxy.move(p_WQ, 1e-3);
        SCOPED_TRACE(testing::Message() << half_angle_rad << " trial " << trial << " tick " << k);
        ASSERT_TRUE(contact.placed && contact.touching() && contact.settled);
        ASSERT_EQ(contact.started, k == 0);
        ASSERT_EQ(contact.hold_count, 2);
        ASSERT_NEAR(contact.depth_m, 0.002, rounding_m);
        ASSERT_LT((shown_place_W(contact, p_WQ) - rest).norm(), rounding_m);
        for (std::size_t h = 0; h < 2; ++h)
          ASSERT_NEAR(contact.holds[h].share_m, 0.001 / std::sin(half_angle_rad),
                      rounding_m / std::sin(2 * half_angle_rad));
      }
    }
  }
}

// Where both planes are named by a point of the edge between them, the edge is at 0 to the proxy.
TEST_P(ProxyAmongPlanes, APointThatStartsBehindBothIsPutOntoTheEdgeThatBothAreNamedBy) {
  RandomStream random(11);
  for (const double half_angle_rad : {0.1, 0.451, M_PI / 4, 1.1}) {
    const double c = std::cos(half_angle_rad), s = std::sin(half_angle_rad);
    for (int trial = 0; trial < 60; ++trial) {
      const Mat3 turn =
          Eigen::AngleAxisd(3 * random.uniform(), random_vector(random).normalized()).toRotationMatrix();
      Proxy proxy = make_proxy(
          {plane_of(Vec3::Zero(), turn * Vec3(c, 0, s)), plane_of(Vec3::Zero(), turn * Vec3(-c, 0, s))}, 0,
          Normals::smooth);
      // Nearer to the edge than to what either plane leaves alone.
      const double aside_m = 0.9 * 0.002 * (2 * random.uniform() - 1) * c / s;
      for (int k = 0; k < 20; ++k) {
        const Vec3 p_WQ = turn * Vec3(aside_m, 1e-5 * k, -0.002);
        const ProxyContact& contact = proxy.move(p_WQ, 1e-3);
        SCOPED_TRACE(testing::Message() << half_angle_rad << " trial " << trial << " tick " << k);
        ASSERT_TRUE(contact.placed && contact.touching() && contact.settled);
        ASSERT_EQ(contact.hold_count, 2);
        ASSERT_LT((shown_place_W(contact, p_WQ) - turn * Vec3(0, 1e-5 * k, 0)).norm(),
                  1e-15 + 1e-13 * p_WQ.norm());
      }
    }
  }
}

TEST_P(ProxyAmongPlanes, AStartOnOneSideOfTheVFeelsThatSideAlone) {
  Proxy proxy = make_proxy(v_of_planes(M_PI / 4, Vec3::Zero()), 0.001, Normals::smooth);
  const ProxyContact& contact = proxy.move(Vec3(-0.02, 0, 0.02), 1e-3);
  EXPECT_EQ(contact.hold_count, 1);
  EXPECT_NEAR(contact.depth_m, 0.001, 1e-14);
  EXPECT_EQ(contact.holds[0].surface, 0);
}

TEST_P(ProxyAmongPlanes, NoPlaceIsFoundBetweenPlanesThatFaceEachOtherTooNear) {
  Proxy proxy =
      make_proxy({plane_of(Vec3::Zero(), Vec3::UnitZ()), plane_of(Vec3(0, 0, 0.01), -Vec3::UnitZ())}, 0.006,
                 Normals::smooth);
  EXPECT_FALSE(proxy.move(Vec3(0, 0, 0.004), 1e-3).placed);
}

}  // namespace
}  // namespace fingerpad::proxy_planes_test
