#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "contact/surface_point.hpp"
#include "study/contact_runs.hpp"
#include "study/shape_meshes.hpp"

namespace fingerpad::contact_test {
namespace {

const ContactVariant& variant(const std::string& name) {
  const auto& all = contact_variants();
  return *std::find_if(all.begin(), all.end(), [&](const ContactVariant& v) { return v.name() == name; });
}

const ExactSurface& surface(const std::string& name) {
  static const std::vector<ExactSurface> all = exact_surfaces();
  return *std::find_if(all.begin(), all.end(), [&](const ExactSurface& s) { return s.name == name; });
}

TEST(ExactSurfaces, HaveTheirMeshesVerticesAndTheirWayOnThem) {
  for (const ExactSurface& s : exact_surfaces()) {
    const TriangleSoup soup = s.mesh(s.levels[1]);
    for (Eigen::Index i = 0; i < soup.vertices_P.cols(); ++i)
      ASSERT_NEAR(s.foot(soup.vertices_P.col(i)).signed_distance_m, 0, 1e-16) << s.name;
    for (int k = 0; k <= 1000; ++k)
      ASSERT_NEAR(s.foot(s.way(k / 1000.0)).signed_distance_m, 0, 1e-16) << s.name;
  }
}

TEST(ExactSurfaces, HaveUnitNormalsThatAreTheirDistancesGradient) {
  constexpr double h = 1e-6;
  for (const ExactSurface& s : exact_surfaces()) {
    for (int k = 0; k < 200; ++k) {
      const Vec3 on = s.way(k / 200.0), p = on - 8e-4 * s.foot(on).normal;
      Vec3 gradient;
      for (int i = 0; i < 3; ++i) {
        gradient[i] = (s.foot(p + h * Vec3::Unit(i)).signed_distance_m -
                       s.foot(p - h * Vec3::Unit(i)).signed_distance_m) /
                      (2 * h);
      }
      // Central differences across the fillet's ends are off by h over its radius of 5 mm.
      ASSERT_LT((gradient - s.foot(p).normal).norm(), 2e-4) << s.name << " " << k;
    }
  }
}

TEST(ExactSurfaces, AreMeshedClosedAndOutward) {
  for (const ExactSurface& s : exact_surfaces()) {
    const auto world = world_of_mesh(s.mesh(s.levels[0]), s.name);
    const Part& part = *world->surfaces[0].part;
    EXPECT_GE(part.neighbours.minCoeff(), 0) << s.name;
    // A little outside of a generic point, a facet's normal points out.
    for (const double along : {0.13, 0.57, 0.91}) {
      const Vec3 on = s.way(along), out = on + 5e-3 * s.foot(on).normal;
      const SurfacePoint near = nearest_surface_point(*world->surfaces[0].tree, out, Normals::facet, -1, 1);
      EXPECT_GT(near.signed_distance_m, 0) << s.name;
    }
  }
}

/// The order between two tessellations of the torus, one with half the other's facets' size.
double order(const std::string& name, double RubError::*number, double under_m, double radius_m) {
  const ExactSurface& s = surface("torus");
  const Rub rub = rub_under(s, under_m, radius_m);
  const RubError coarse = rub_error(world_of_mesh(s.mesh(128), s.name), s, variant(name), rub);
  const RubError fine = rub_error(world_of_mesh(s.mesh(256), s.name), s, variant(name), rub);
  return std::log2(coarse.*number / fine.*number);
}

TEST(ContactStudy, FindsTheOrdersOfTheoryOnATorus) {
  // SCIENCE 5. Two tessellations give a slope to a quarter: the rub meets other places of the facets.
  for (const auto& [name, position, normal] :
       {std::tuple("closest-point, facet", 2, 1), std::tuple("closest-point, smooth", 2, 2),
        std::tuple("closest-point, curved", 3, 2)}) {
    // A ball whose centre goes along the surface.
    EXPECT_NEAR(order(name, &RubError::position_rms_m, 0, 1e-3), position, 0.25) << name;
    EXPECT_NEAR(order(name, &RubError::normal_rms_rad, 0, 1e-3), normal, 0.25) << name;
  }
}

TEST(ContactStudy, FindsInterpolatedNormalsOfSecondOrderOnTheSurfaceAndOfFirstDeepUnderIt) {
  // A deep finger's foot on a facet is off sideways by its depth times the facet's tilt, and there the normal
  // is another's: an error of depth/radius times that tilt, of first order.
  EXPECT_GT(order("closest-point, smooth", &RubError::normal_rms_rad, 0, 1e-3), 1.75);
  EXPECT_LT(order("closest-point, smooth", &RubError::normal_rms_rad, 4e-3, 0), 1.3);
}

TEST(ContactStudy, FindsNoErrorWhereThereIsNone) {
  // The cylinder's flat top: facets are exact there, and the force step of a rub on it is rounding.
  ExactSurface flat = surface("fillet");
  flat.way = [](double along) { return Vec3(0.009 + 0.004 * along, 0.002, 0.015); };
  const auto world = world_of_mesh(flat.mesh(8), flat.name);
  for (const char* name : {"closest-point, facet", "proxy, facet"}) {
    const RubError error = rub_error(world, flat, variant(name), rub_under(flat, 1e-3, 0));
    EXPECT_LT(error.position_worst_m, 1e-15);
    EXPECT_LT(error.normal_worst_rad, 1e-12);
    EXPECT_LT(error.force_worst_share, 1e-12);
    EXPECT_LT(error.step_share, 1e-12);
    EXPECT_EQ(error.lost_ticks, 0);
  }
}

TEST(ContactStudy, SeesTheClosestPointPopThroughWallsThinnerThanTwiceTheDepth) {
  for (TriangleSoup (*mesh)(double) : {plate_mesh, hollow_ball_mesh}) {
    // 5.5 mm deep: the middle of a wall is passed under 11 mm. A ball's inner side is nearer a little sooner.
    const auto thin = world_of_mesh(mesh(1e-3), "thin"), thick = world_of_mesh(mesh(12e-3), "thick");
    for (const double speed : {0.05, 0.5, 5.0}) {
      const Strike strike{speed, 0, Vec2(0.001, 0.002), 0.37};
      EXPECT_TRUE(pops_through(thin, variant("closest-point, facet"), strike)) << speed;
      EXPECT_FALSE(pops_through(thick, variant("closest-point, facet"), strike)) << speed;
    }
  }
}

TEST(ContactStudy, SeesNoStrikeGetPastTheProxy) {
  for (TriangleSoup (*mesh)(double) : {plate_mesh, hollow_ball_mesh}) {
    for (const double thickness_m : {1e-3, 2e-4}) {
      const auto world = world_of_mesh(mesh(thickness_m), "wall");
      for (const double speed : {0.05, 0.2, 1.0, 5.0}) {
        for (const double radius_m : {0.0, 0.004}) {
          EXPECT_FALSE(
              pops_through(world, variant("proxy, smooth"), {speed, radius_m, Vec2(0.001, 0.002), 0.37}))
              << thickness_m << " " << speed << " " << radius_m;
        }
      }
    }
  }
}

}  // namespace
}  // namespace fingerpad::contact_test
