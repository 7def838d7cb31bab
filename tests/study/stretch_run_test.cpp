#include "study/stretch_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "study/force_comparison.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"

namespace fingerpad::stretch_run_test {
namespace {

/// A recording of these places, one every millisecond.
FingerPath path_of(double seconds, const std::function<Vec3(double t_s)>& place) {
  Motion motion;
  const auto samples = static_cast<Eigen::Index>(std::lround(seconds * 1000)) + 1;
  motion.p_WQ.resize(3, samples);
  for (Eigen::Index k = 0; k < samples; ++k) {
    motion.t_s.push_back(static_cast<double>(k) / 1000);
    motion.p_WQ.col(k) = place(motion.t_s.back());
  }
  return {std::move(motion), 1000, Vec3(0, 0.6, -0.8)};
}

/// Comes down on the plane z = 0 and goes along x, 1 mm deep.
FingerPath drag_of(double seconds, double speed_m_per_s) {
  return path_of(seconds, [=](double t_s) {
    return Vec3(speed_m_per_s * t_s, 0, 1e-3 - 2e-3 * std::min(1.0, t_s / 0.02));
  });
}

ForceFigures figures_of(const std::shared_ptr<const World>& world, const Scene& scene, const FingerPath& path,
                        const TouchChoice& choice, const MotionStretch& stretch) {
  ForceComparison comparison(Promises(scene.contact));
  comparison.add(run_stretch(world, scene, path, choice, stretch),
                 run_stretch(world, scene, path, model_choice(), stretch));
  return comparison.figures();
}

TEST(StretchRun, OfAPlaneIsTheSameWithAllMethodsAndNormals) {
  const auto world = test::plane_world();
  const Scene scene = test::plane_scene("finger-pad");
  const FingerPath path = drag_of(0.5, 0.03);
  const MotionStretch stretch{0, 0.1, 0.5};
  const StretchRun first = run_stretch(world, scene, path, {"closest-point", Normals::facet}, stretch);
  ASSERT_EQ(first.tick_count(), 400u);
  EXPECT_NEAR(first.normal_n[0], 1, 1e-6);  // 1 mm on 1000 N/m, kept as a float
  for (const char* method : {"closest-point", "proxy"}) {
    for (const Normals normals : normals_table()) {
      const StretchRun run = run_stretch(world, scene, path, {method, normals}, stretch);
      ASSERT_EQ(run.tick_count(), first.tick_count());
      for (std::size_t k = 0; k < run.tick_count(); ++k)
        ASSERT_LT((run.force_W_n[k] - first.force_W_n[k]).norm(), 1e-12)
            << method << " " << normals->name << k;
    }
  }
}

TEST(StretchRun, BeginsWithTheMemoryThatItsLeadInHasLeft) {
  const auto world = test::plane_world();
  const Scene scene = test::plane_scene("stick-slip");
  const FingerPath path = drag_of(1, 0.03);
  const TouchChoice choice{"proxy", Normals::facet, 1000};
  const StretchRun whole = run_stretch(world, scene, path, choice, {0, 0, 1});
  const StretchRun part = run_stretch(world, scene, path, choice, {0, 0.6, 0.8});
  ASSERT_EQ(part.tick_count(), 200u);
  for (std::size_t k = 0; k < part.tick_count(); ++k)
    ASSERT_LT((part.force_W_n[k] - whole.force_W_n[600 + k]).norm(), 1e-12) << k;
  // Begun there without one, the pad is unstretched.
  const StretchRun cold = run_stretch(world, scene, path, choice, {0.6, 0.6, 0.8});
  EXPECT_EQ(cold.friction_W_n[0].norm(), 0);
  EXPECT_GT(part.friction_W_n[0].norm(), 0.1);
}

TEST(StretchRun, MissesRupturesAtACoarseRateOnlyWhereTheyAreLookedForAtTicks) {
  const auto world = test::plane_world();
  const Scene scene = test::plane_scene("stick-slip");
  // Teeth of 0.1 mm at 0.0517 m/s: 517 a second, and 250 ticks.
  const FingerPath path = drag_of(1, 0.0517);
  const MotionStretch stretch{0, 0.1, 1};
  TouchChoice choice{"closest-point", Normals::facet, 250, Events::exact};
  EXPECT_NEAR(static_cast<double>(run_stretch(world, scene, path, choice, stretch).ruptures), 465, 1);
  const ForceFigures exact = figures_of(world, scene, path, choice, stretch);
  EXPECT_LE(std::abs(exact.ruptures_missed), 1);  // at an end of the stretch
  EXPECT_NEAR(exact.model_mean_mu, 0.25, 1e-3);   // SCIENCE 3; half a tick of a tooth at 40 kHz
  choice.events = Events::tick;
  EXPECT_GT(figures_of(world, scene, path, choice, stretch).ruptures_missed,
            225);  // at most one every other tick
}

/// A prism of `sides` sides about the z axis, open at its ends; vertices on the cylinder, wound outwards.
TriangleSoup prism(double radius_m, double height_m, int sides) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, 2 * sides);
  soup.triangles.resize(3, 2 * sides);
  for (int i = 0; i < sides; ++i) {
    const double turn = 2 * std::numbers::pi * i / sides;
    for (int end = 0; end < 2; ++end)
      soup.vertices_P.col(2 * i + end) =
          Vec3(radius_m * std::cos(turn), radius_m * std::sin(turn), (end - 0.5) * height_m);
    const int next = (i + 1) % sides;
    soup.triangles.col(2 * i) << 2 * i, 2 * next, 2 * next + 1;
    soup.triangles.col(2 * i + 1) << 2 * i, 2 * next + 1, 2 * i + 1;
  }
  return soup;
}

TEST(StretchRun, OverFacetsIsOffByTheirTilt) {
  // Round a cylinder of 20 mm in 64 sides, 1 mm deep. The model, a proxy with curved normals, stands on the
  // same facets, so that what is left is the facets' tilt, even from -pi/64 to pi/64: RMS (pi/64)/sqrt(3).
  // The foot of a point at 19 of 20 mm goes over 19/20 of each facet, and so does the normal that is shaded
  // there.
  constexpr int sides = 64;
  const auto world = test::world_of(prism(0.02, 0.04, sides));
  prepare_normals(*world);
  Scene scene = test::plane_scene("none");
  const FingerPath path = path_of(2, [](double t_s) {
    const double r_m = t_s < 0.2 ? 0.021 - 0.01 * t_s : 0.019, turn = 3 * (t_s - 0.2);
    return Vec3(r_m * std::cos(turn), r_m * std::sin(turn), 1.234e-3);
  });
  const ForceFigures figures = figures_of(world, scene, path, {"closest-point", Normals::facet}, {0, 0.4, 2});
  const double tilt = 19.0 / 20 * std::numbers::pi / sides;
  // The patches' own normals are of second order: off by tilt^2 or so.
  EXPECT_NEAR(figures.contact_rms_share, tilt / std::sqrt(3), 0.02 * tilt);
  EXPECT_NEAR(figures.contact_largest_share, tilt, 0.05 * tilt);
  EXPECT_NEAR(figures.contact_99_share, 0.99 * tilt, 0.05 * tilt);
  EXPECT_EQ(figures.force_rms_share, figures.contact_rms_share);  // no friction here
}

}  // namespace
}  // namespace fingerpad::stretch_run_test
