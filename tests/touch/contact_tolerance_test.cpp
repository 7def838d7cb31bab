#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "contact/contact_method_table.hpp"
#include "contact/part_measures.hpp"
#include "contact/reckoned_error.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/contact_choice.hpp"
#include "touch/touch.hpp"

// What `auto` promises of the force, and says where it cannot keep it.

namespace fingerpad::contact_tolerance_test {
namespace {

using test::box_soup;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<Surface> surfaces_of(const TriangleSoup& soup, double crease_deg = 30) {
  Surface surface;
  surface.part = std::make_shared<const Part>(make_part(soup, crease_deg * std::numbers::pi / 180));
  surface.tree = std::make_shared<const TriangleTree>(surface.part);
  surface.mesh = "models/part.stl";
  return {surface};
}

ContactChoice choice_for(const Scene& scene, const std::vector<Surface>& surfaces) {
  std::vector<PartMeasures> measures;
  for (const Surface& surface : surfaces) {
    if (surface.part) measures.push_back(measure_part(*surface.part, *surface.tree));
  }
  return choose_contact(scene, surfaces, measures);
}

Normals normals_for(Scene scene, const TriangleSoup& soup) {
  scene.contact.automatic_normals = true;
  return choice_for(scene, surfaces_of(soup)).normals;
}

TEST(ContactTolerance, NormalsFollowHowFarTheForceIsOff) {
  EXPECT_EQ(normals_for(Scene(), box_soup({0.1, 0.1, 0.1})), Normals::facet);
  // So fine that only the normals count: sag 6 um.
  const auto surfaces = surfaces_of(test::sphere_soup(0.05, 6));
  const PartMeasures m = measure_part(*surfaces[0].part, *surfaces[0].tree);
  Scene scene;
  scene.contact.automatic_normals = true;
  scene.contact.method = "closest-point";
  const double off =
      reckoned_error(m.places, {1000, 0, 10}, *find_contact_method("closest-point"), Normals::facet)
          .force_share;
  ASSERT_LT(off, 0.025);
  scene.contact.force_tolerance = 1.01 * off;
  EXPECT_EQ(choice_for(scene, surfaces).normals, Normals::facet);
  scene.contact.force_tolerance = 0.99 * off;
  EXPECT_EQ(choice_for(scene, surfaces).normals, Normals::smooth);
}

TEST(ContactTolerance, TheMeanTiltOfTheNormalsCountsForTheMeanCoefficient) {
  const auto surfaces = surfaces_of(test::sphere_soup(0.05, 6));
  const PartMeasures m = measure_part(*surfaces[0].part, *surfaces[0].tree);
  Scene scene;
  scene.contact.automatic_normals = true;
  scene.contact.method = "closest-point";
  const double tilt =
      reckoned_error(m.places, {1000, 0, 10}, *find_contact_method("closest-point"), Normals::facet)
          .mean_tilt_rad;
  scene.contact.mu_tolerance = 1.01 * tilt / 0.2;
  EXPECT_EQ(choice_for(scene, surfaces).normals, Normals::facet);
  scene.contact.mu_tolerance = 0.99 * tilt / 0.2;
  EXPECT_EQ(choice_for(scene, surfaces).normals, Normals::smooth);
}

TEST(ContactTolerance, OfWhatKeepsTheToleranceTheCheapestIsTaken) {
  // Where both methods do, a proxy is cheaper under a point on a small part, and dearer under a ball.
  const auto surfaces = surfaces_of(test::sphere_soup(0.05, 5));
  Scene scene;
  scene.contact.automatic_normals = true;
  scene.contact.force_tolerance = 0.1;
  EXPECT_EQ(choice_for(scene, surfaces).method, "proxy");
  scene.finger.radius_m = 0.007;
  const ContactChoice ball = choice_for(scene, surfaces);
  EXPECT_EQ(ball.method, "closest-point");
  EXPECT_THAT(ball.limits.at(0).said, IsEmpty());
}

TEST(ContactTolerance, FacetsThatCutTooDeepForALightTouchGetCurvedNormals) {
  const auto surfaces = surfaces_of(test::sphere_soup(0.05, 5));  // 8192 facets that cut in by 0.04 mm
  Scene scene;
  scene.contact.automatic_normals = true;
  // A tenth of the greatest force is the lightest touch that must be true.
  const ContactChoice choice = choice_for(scene, surfaces);
  EXPECT_EQ(choice.method, "closest-point");
  EXPECT_EQ(choice.normals, Normals::curved);
  EXPECT_THAT(choice.limits.at(0).said, IsEmpty());
  EXPECT_EQ(choice.limits[0].kept_tolerance, 0.03);
}

TEST(ContactTolerance, WhereNothingKeepsItLightPressesCountAsMuchAsHardOnes) {
  // 10 N take the point to the middle of a ball of 10.1 mm, where any normals are off by the whole force; 1 N
  // is felt by smooth ones to 3 %, by facets to 10.
  Scene scene;
  scene.contact.method = "proxy";
  EXPECT_EQ(normals_for(scene, test::sphere_soup(0.0101, 3)), Normals::smooth);
}

TEST(ContactTolerance, SaysWhatTheMeshCannotKeepAndWhatItCan) {
  const auto surfaces = surfaces_of(test::sphere_soup(0.05, 4));
  Scene scene;
  scene.contact.automatic_normals = true;
  scene.contact.method = "proxy";
  const ContactChoice choice = choice_for(scene, surfaces);
  ASSERT_EQ(choice.limits.size(), 1u);
  // The middle of a facet is 0.18 mm off the sphere, which is felt at 1 N, a tenth of the greatest force.
  const PartMeasures m = measure_part(*surfaces[0].part, *surfaces[0].tree);
  double deepest_m = 0;
  for (const SurfacePlace& place : m.places) deepest_m = std::max(deepest_m, place.sag_m);
  // A third more than on all but a hundredth of the region where it is the most.
  EXPECT_NEAR(choice.limits[0].kept_tolerance, 4.0 / 3 * deepest_m / 1e-3, 0.03 * deepest_m / 1e-3);
  EXPECT_THAT(choice.limits[0].said,
              HasSubstr("force_tolerance 0.03 cannot be kept, 0.26 can: its facets cut"));
  EXPECT_THAT(choice.limits[0].said, HasSubstr("a finer mesh would"));
  EXPECT_EQ(choice.reasons.back(), "part.stl: " + choice.limits[0].said + " (auto)");
  scene.contact.force_tolerance = 0.2;
  EXPECT_THAT(choice_for(scene, surfaces).limits[0].said, IsEmpty());
  scene.contact.force_tolerance = 0.03;
  EXPECT_THAT(choice_for(scene, surfaces_of(test::sphere_soup(0.05, 6))).limits[0].said, IsEmpty());
}

TEST(ContactTolerance, SaysThatTheNormalsOfASceneCannotKeepIt) {
  Scene scene;
  scene.contact.normals = Normals::facet;
  const ContactChoice choice = choice_for(scene, surfaces_of(test::sphere_soup(0.05, 4)));
  EXPECT_THAT(choice.limits.at(0).said,
              EndsWith("normals = \"auto\" would; mu_tolerance 0.1 cannot be kept, 0.38 can"));
  const ContactChoice coarse = choice_for(scene, surfaces_of(test::sphere_soup(0.05, 2)));
  EXPECT_THAT(coarse.limits.at(0).said, HasSubstr("or normals = \"auto\" would do better"));
}

/// A row of so many balls of few facets, a ball wide apart.
std::vector<Surface> row_of_balls(std::size_t count) {
  std::vector<Surface> row(count, surfaces_of(test::sphere_soup(0.05, 2))[0]);
  for (std::size_t i = 0; i < count; ++i) row[i].p_WP = Vec3(0.2 * static_cast<double>(i), 0, 0);
  return row;
}

TEST(ContactTolerance, AdviceOnManyPartsCostsLittleMoreThanOnOne) {
  Scene scene;
  scene.contact.automatic_normals = true;
  scene.finger.radius_m = 0.007;
  const ContactChoice one = choice_for(scene, row_of_balls(1)), eight = choice_for(scene, row_of_balls(8));
  ASSERT_THAT(one.limits.at(0).said, HasSubstr("would"));
  // Of one shape under one press, they are reckoned as one, and told the same.
  EXPECT_EQ(eight.reckoned, one.reckoned);
  for (const ContactLimit& limit : eight.limits) EXPECT_EQ(limit.said, one.limits[0].said);
  // Each of another stiffness: advice is looked for on the first.
  std::vector<Surface> differ = row_of_balls(8);
  for (std::size_t i = 0; i < differ.size(); ++i)
    differ[i].properties.stiffness_n_per_m += 10 * static_cast<double>(i);
  const ContactChoice others = choice_for(scene, differ);
  EXPECT_LE(others.reckoned, 3 * 8 * one.reckoned);
  EXPECT_THAT(others.limits.at(7).said, HasSubstr("what would is only looked for on part.stl"));
}

}  // namespace
}  // namespace fingerpad::contact_tolerance_test
