#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>

#include "contact/fast_proxy.hpp"
#include "scene/scene.hpp"
#include "support/brute_force.hpp"
#include "support/effort.hpp"
#include "support/paths.hpp"
#include "support/wanderer.hpp"
#include "support/worlds.hpp"
#include "touch/touch.hpp"

// A finger that wanders over and straight through every real part at up to 20 m/s, held by a proxy with the
// normals that auto chooses. The walk of a million ticks over each part, with its figures told:
//   FINGERPAD_WALK_TICKS=1000000 build/bin/test_touch --gtest_filter='*ProxyOnRealPart*'

namespace fingerpad::proxy_real_parts_test {
namespace {

const int usual_ticks = test::sanitized() ? 1200 : 8000;
const int ticks_a_touch = test::sanitized() ? 50 : 10;  // a short walk spends most of it on the way there

int walk_ticks() {
  const char* asked = std::getenv("FINGERPAD_WALK_TICKS");
  return asked != nullptr ? std::max(100, std::atoi(asked)) : usual_ticks;
}

std::vector<std::filesystem::path> real_parts() {
  auto parts = test::real_parts();
  // There the load of the dense one takes longer than all other walks; RealPart loads it.
  if (test::sanitized()) return parts;
  for (const auto& dense : test::real_files("dense", {".ply"})) parts.push_back(dense);
  return parts;
}

class ProxyOnRealPart : public testing::TestWithParam<std::filesystem::path> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ProxyOnRealPart);

Scene walk_scene(const std::filesystem::path& mesh, double radius_m) {
  Scene scene = test::plane_scene("finger-pad");
  scene.contact.method = "proxy";
  scene.contact.automatic_normals = true;
  scene.finger.radius_m = radius_m;
  PartEntry& part = scene.parts.emplace_back();
  part.mesh = mesh.filename().string();
  part.mesh_path = mesh.string();
  return scene;
}

struct WalkFigures {
  int touched = 0;
  long non_finite = 0;
  double worst_excess = -1;  ///< of the friction over mu_s n, as a share of it
};

WalkFigures walk(const std::shared_ptr<const World>& world, const Scene& scene, int ticks) {
  const Part& part = *world->surfaces[0].part;
  Touch touch(world, scene);
  // The same again, to look into.
  Proxy proxy =
      fast_proxy(placed_surfaces(*world), scene.finger.radius_m, settled_contact(scene, *world).normals);
  test::Wanderer finger(part);
  WalkFigures figures;
  const int looks = part.triangle_count() > 300000 ? 4 : 20;  // brute force is slow
  for (int k = 0; k < ticks; ++k) {
    FingerSample sample;
    sample.p_WQ = finger.next();
    const TickRecord row = touch.tick(sample);
    const ProxyContact& contact = proxy.move(sample.p_WQ, 1e-3);
    EXPECT_EQ(contact.depth_m * (contact.touching() ? 1 : 0), row.depth_m) << k;
    figures.non_finite += row.force_W_n.allFinite() ? 0 : 1;
    if (row.phase != Phase::free) {
      ++figures.touched;
      const double limit_n = world->surfaces[0].properties.mu_static * row.normal_force_n;
      if (row.friction_W_n.norm() > 0)
        figures.worst_excess = std::max(figures.worst_excess, row.friction_W_n.norm() / limit_n - 1);
    }
    if (k % (ticks / looks) == 0) {
      const Vec3 q = proxy.ball_W() - part.centre_P;
      // The skin's sixty-fourth is the tolerance, 2^-33 of half the size; the rest is rounding.
      EXPECT_GE(test::brute_closest(part, q).distance_m, proxy.clearance_m() - 1e-10 * part.size_m()) << k;
      if (world->verdicts[0].closed) {
        EXPECT_LT(std::abs(test::winding_number(part, q)), 0.5) << k;
      }
    }
    if (testing::Test::HasFailure()) break;
  }
  return figures;
}

TEST_P(ProxyOnRealPart, NeverGetsInsideAndKeepsWithinTheFrictionLimit) {
  const int ticks = walk_ticks();
  auto world = load_world(walk_scene(GetParam(), 0));
  const double ball_m = 0.01 * world->surfaces[0].part->size_m();
  for (const double radius_m : {0.0, ball_m}) {
    const Scene scene = walk_scene(GetParam(), radius_m);
    const auto start = std::chrono::steady_clock::now();
    const WalkFigures figures = walk(world, scene, ticks);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_EQ(figures.non_finite, 0);
    EXPECT_LE(figures.worst_excess, 1e-9);
    EXPECT_GT(figures.touched, ticks / ticks_a_touch) << "it flew past the part: nothing was tested";
    if (ticks == usual_ticks) continue;
    fmt::print(
        "{}: {} normals, ball of {:.3g} mm, {} ticks, {:.1f} % in contact, friction at most {:+.1e} over "
        "its limit, {} forces not finite, {:.1f} s\n",
        GetParam().filename().string(), settled_contact(scene, *world).normals->name, 1e3 * radius_m, ticks,
        100.0 * figures.touched / ticks, figures.worst_excess, figures.non_finite, took.count());
  }
}

INSTANTIATE_TEST_SUITE_P(SharedData, ProxyOnRealPart, testing::ValuesIn(real_parts()), [](const auto& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace fingerpad::proxy_real_parts_test
