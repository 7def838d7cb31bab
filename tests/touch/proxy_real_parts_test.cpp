#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <numbers>

#include "base/random_stream.hpp"
#include "part/import.hpp"
#include "support/brute_force.hpp"
#include "support/paths.hpp"
#include "support/worlds.hpp"
#include "touch/proxy_contact.hpp"
#include "touch/touch.hpp"

// A finger that wanders over and straight through every real part at up to 20 m/s, held by a proxy.

namespace fingerpad {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int ticks = 1200, least_touched = 24;  // a short walk spends most of it on the way there
#else
constexpr int ticks = 8000, least_touched = 800;
#endif

/// Goes towards one facet after another, some thousandth of the part under it, with a tremble, and now and
/// then far off. Begins close above the part's box.
class Wanderer {
 public:
  explicit Wanderer(const Part& part)
      : part_(part), at_(part.centre_P + Vec3(0, 0, part.half_extent.z() + 0.03 * part.size_m())) {
    aim();
  }

  Vec3 next() {
    const double size_m = part_.size_m();
    const double step_m = 1e-3 * size_m * (random_.uniform() < 0.01 ? 20 : 1);
    if ((aim_ - at_).norm() < step_m || random_.uniform() < 2e-4) aim();
    at_ += (aim_ - at_).normalized() * step_m + 2e-4 * size_m * random();
    return at_;
  }

 private:
  Vec3 random() { return {random_.normal(), random_.normal(), random_.normal()}; }
  void aim() {
    const auto t =
        static_cast<Eigen::Index>((static_cast<long>(++station_) * 7919 * 31) % part_.triangle_count());
    const Vec3 middle =
        (part_.vertices.col(part_.triangles(0, t)) + part_.vertices.col(part_.triangles(1, t)) +
         part_.vertices.col(part_.triangles(2, t))) /
        3;
    aim_ = part_.centre_P + middle - 5e-3 * part_.size_m() * part_.facet_normals.col(t);
    if (random_.uniform() < 0.2) aim_ += 0.3 * part_.size_m() * random();
  }

  const Part& part_;
  RandomStream random_{7};
  Vec3 at_, aim_ = Vec3::Zero();
  int station_ = 0;
};

class ProxyOnRealPart : public testing::TestWithParam<std::filesystem::path> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ProxyOnRealPart);

TEST_P(ProxyOnRealPart, NeverGetsInsideAndKeepsWithinTheFrictionLimit) {
  const ImportedPart imported = import_touchable(GetParam().string(), 1e-3, 30 * std::numbers::pi / 180);
  const Part& part = *imported.part;
  auto world = std::make_shared<World>(*test::plane_world());
  world->surfaces[0].part = imported.part;
  world->surfaces[0].tree = std::make_shared<const TriangleTree>(imported.part);
  for (const double radius_m : {0.0, 0.01 * part.size_m()}) {
    Scene scene = test::plane_scene("finger-pad");
    scene.contact.method = ContactMethod::proxy;
    scene.finger.radius_m = radius_m;
    Touch touch(world, scene);
    Proxy proxy = world_proxy(*world, radius_m, scene.contact.normals);  // the same again, to look into
    Wanderer finger(part);
    int touched = 0;
    for (int k = 0; k < ticks; ++k) {
      FingerSample sample;
      sample.p_WQ = finger.next();
      const TickRecord row = touch.tick(sample);
      const ProxyContact& contact = proxy.move(sample.p_WQ, 1e-3);
      ASSERT_EQ(contact.depth_m * (contact.touching ? 1 : 0), row.depth_m) << k;
      ASSERT_TRUE(row.force_W_n.allFinite()) << k;
      ASSERT_LE(row.friction_W_n.norm(), 0.3 * (1 + 1e-9) * row.normal_force_n) << k;
      touched += row.phase != Phase::free ? 1 : 0;
      if (k % (ticks / 20) != 0) continue;
      const Vec3 q = proxy.ball_W() - part.centre_P;
      // The skin's sixty-fourth is the tolerance, 2^-33 of half the size; the rest is rounding.
      ASSERT_GE(test::brute_closest(part, q).distance_m, proxy.clearance_m() - 1e-10 * part.size_m()) << k;
      if (!imported.verdict.closed) continue;
      ASSERT_LT(std::abs(test::winding_number(part, q)), 0.5) << k;
    }
    EXPECT_GT(touched, least_touched) << "it flew past the part: nothing was tested";
  }
}

INSTANTIATE_TEST_SUITE_P(SharedData, ProxyOnRealPart,
                         testing::ValuesIn(test::real_files("parts", {".stl", ".obj", ".ply", ".off"})),
                         [](const auto& info) {
                           std::string name = info.param.stem().string();
                           std::replace_if(
                               name.begin(), name.end(),
                               [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace fingerpad
