#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "contact/triangle_tree.hpp"
#include "part/import.hpp"
#include "scene/scene.hpp"
#include "support/effort.hpp"
#include "support/paths.hpp"
#include "support/worlds.hpp"
#include "touch/touch.hpp"

// Every real part, and the mesh of over a million triangles, touched by a finger that rubs over it and
// through it.

namespace fingerpad::real_parts_test {
namespace {

const int samples = test::sanitized() ? 300 : 10000;

std::vector<std::filesystem::path> real_parts() {
  auto parts = test::real_parts();
  for (const auto& dense : test::real_files("dense", {".ply"})) parts.push_back(dense);
  return parts;
}

/// A path along twenty facets spread over the part, at a finger's pace: half of the time in the surface by a
/// thousandth of the part's size, between them straight through it.
Vec3 finger_at(const Part& part, int k) {
  constexpr int stations = 20;
  const auto station = [&part](int i) -> Vec3 {
    const auto t =
        static_cast<Eigen::Index>((static_cast<long>(i % stations) * 7919 * 31) % part.triangle_count());
    const Vec3 middle = (part.vertices.col(part.triangles(0, t)) + part.vertices.col(part.triangles(1, t)) +
                         part.vertices.col(part.triangles(2, t))) /
                        3;
    return part.centre_P + middle - 1e-3 * part.size_m() * part.facet_normals.col(t);
  };
  const double along = static_cast<double>(k) * stations / samples;
  const int i = static_cast<int>(along);
  const double u = std::clamp(2 * (along - i) - 0.5, 0.0, 1.0);  // rests, goes, rests
  return (1 - u) * station(i) + u * station(i + 1);
}

class RealPart : public testing::TestWithParam<std::filesystem::path> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealPart);

TEST_P(RealPart, IsTouchedForTenThousandSamplesWithinItsLimits) {
  const ImportedPart imported = import_touchable(GetParam().string(), 1e-3, 30 * std::numbers::pi / 180);
  auto world = std::make_shared<World>(*test::plane_world());
  world->surfaces[0].part = imported.part;
  world->surfaces[0].tree = std::make_shared<const TriangleTree>(imported.part);
  Scene scene = test::plane_scene("finger-pad");
  scene.finger.radius_m = 0.01 * imported.part->size_m();
  Touch touch(world, scene);
  long touched = 0;
  for (int k = 0; k < samples; ++k) {
    FingerSample sample;
    sample.p_WQ = finger_at(*imported.part, k);
    const TickRecord row = touch.tick(sample);
    ASSERT_TRUE(row.force_W_n.allFinite()) << k;
    ASSERT_LE(row.friction_W_n.norm(), 0.3 * (1 + 1e-9) * row.normal_force_n) << k;
    ASSERT_NEAR(row.normal_force_n, 1000 * row.depth_m, 1e-9 * (1 + row.normal_force_n)) << k;
    touched += row.phase != Phase::free ? 1 : 0;
  }
  EXPECT_GT(touched, samples / 4);
}

INSTANTIATE_TEST_SUITE_P(SharedData, RealPart, testing::ValuesIn(real_parts()), [](const auto& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace fingerpad::real_parts_test
