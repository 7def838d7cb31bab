#include <cmath>

#include "contact/proxies.hpp"

// A proxy among planes alone, where there is no part to compare lengths with.

namespace fingerpad {
namespace {

class ProxyAmongPlanes : public EitherProxy {};
INSTANTIATE_TEST_SUITE_P(Kinds, ProxyAmongPlanes, testing::ValuesIn(proxy_kinds), kind_name);

/// Two planes through the y axis that leave free what is above both, each at this angle from the vertical.
std::vector<PlacedSurface> v_of_planes(double half_angle_rad, const Vec3& at) {
  const double c = std::cos(half_angle_rad), s = std::sin(half_angle_rad);
  return {plane_of(at, Vec3(c, 0, s)), plane_of(at, Vec3(-c, 0, s))};
}

TEST_P(ProxyAmongPlanes, ABallThatStartsInAVOfTwoPlanesIsPlacedAndFeelsBoth) {
  for (const double half_angle_rad : {0.03, 0.4, M_PI / 4, 1.2, 1.5}) {
    for (const double radius_m : {0.0, 0.004}) {
      for (const Vec3& at : {Vec3(0, 0, 0), Vec3(0.3, -0.7, 0.2)}) {
        const auto planes = v_of_planes(half_angle_rad, at);
        Proxy proxy = make_proxy(planes, radius_m, Normals::smooth);
        const Vec3 rest = at + Vec3(0, 0.001, radius_m / std::sin(half_angle_rad));
        const Vec3 goal = rest - Vec3(0, 0, 0.002);
        // Coordinates of 1 m round by 1e-16, which the V's angle magnifies.
        const double rounding_m = 4e-16 / std::sin(half_angle_rad);
        for (int k = 0; k < 20; ++k) {
          const ProxyContact& contact = proxy.move(goal, 1e-3);
          SCOPED_TRACE(testing::Message() << half_angle_rad << " " << radius_m << " tick " << k);
          ASSERT_TRUE(contact.placed && contact.touching);
          ASSERT_EQ(contact.started, k == 0);
          ASSERT_EQ(contact.hold_count, 2);
          ASSERT_NEAR(contact.depth_m, 0.002, rounding_m);
          ASSERT_LT((contact.proxy_W - rest).norm(), rounding_m);
          for (int h = 0; h < 2; ++h)
            ASSERT_NEAR(contact.holds[static_cast<std::size_t>(h)].share_m, 0.001 / std::sin(half_angle_rad),
                        rounding_m / std::sin(half_angle_rad));
        }
      }
    }
  }
}

TEST_P(ProxyAmongPlanes, AStartOnOneSideOfTheVFeelsThatSideAlone) {
  Proxy proxy = make_proxy(v_of_planes(M_PI / 4, Vec3::Zero()), 0.001, Normals::smooth);
  const ProxyContact& contact = proxy.move(Vec3(-0.02, 0, 0.02), 1e-3);
  EXPECT_EQ(contact.hold_count, 1);
  EXPECT_NEAR(contact.depth_m, 0.001, 1e-16);
  EXPECT_EQ(contact.holds[0].surface, 0);
}

TEST_P(ProxyAmongPlanes, NoPlaceIsFoundBetweenPlanesThatFaceEachOtherTooNear) {
  Proxy proxy =
      make_proxy({plane_of(Vec3::Zero(), Vec3::UnitZ()), plane_of(Vec3(0, 0, 0.01), -Vec3::UnitZ())}, 0.006,
                 Normals::smooth);
  EXPECT_FALSE(proxy.move(Vec3(0, 0, 0.004), 1e-3).placed);
}

}  // namespace
}  // namespace fingerpad
