#include "touch/contact_choice.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <numbers>
#include <set>
#include <thread>

#include "support/effort.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/contact_case.hpp"
#include "touch/mesh_store.hpp"
#include "touch/touch.hpp"

namespace fingerpad::contact_choice_test {
namespace {

using test::box_soup;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A point finger at 1 kHz that presses with 1 N on 1000 N/m: 1 mm, and 1 mm of motion in a tick.
Scene light_press() {
  Scene scene;
  scene.contact.greatest_force_n = 1;
  return scene;
}

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

/// Why the nearest surface point would not hold a scene's finger on the first of some surfaces.
std::string unheld(const Scene& scene, const std::vector<Surface>& surfaces) {
  std::vector<PartMeasures> measures;
  for (const Surface& surface : surfaces) {
    if (surface.part) measures.push_back(measure_part(*surface.part, *surface.tree));
  }
  return find_contact_method("closest-point")->fails(contact_cases(scene, surfaces, measures)[0].contact);
}

std::string unheld(const Scene& scene, const TriangleSoup& soup) {
  return unheld(scene, surfaces_of(soup));
}

TEST(ContactChoice, AThinPlateAndABoxNeedAProxyASphereDoesNot) {
  EXPECT_EQ(choice_for(Scene(), surfaces_of(box_soup({0.1, 0.1, 0.001}))).method, "proxy");
  EXPECT_THAT(unheld(Scene(), box_soup({0.1, 0.1, 0.001})), HasSubstr("walls are 1 mm thick"));
  EXPECT_THAT(unheld(Scene(), box_soup({0.1, 0.1, 0.1})), HasSubstr("near an edge of 90 degrees"));
  EXPECT_THAT(unheld(Scene(), test::sphere_soup(0.05, 4)), IsEmpty());
  Scene fingertip;
  fingertip.finger.radius_m = 0.012;  // its centre stays outside
  for (const TriangleSoup& soup : {box_soup({0.1, 0.1, 0.001}), box_soup({0.1, 0.1, 0.1})})
    EXPECT_THAT(unheld(fingertip, soup), IsEmpty());
}

TEST(ContactChoice, NearAnEdgeTheClosestPointTurnsToTheFaceBeside) {
  // 5 mm deep in a block's top, 4 mm from its side: what the rule of edges is for.
  const auto world = test::world_of(box_soup({0.1, 0.1, 0.1}));
  const auto force = [&](const char* method) {
    Scene scene = test::plane_scene("none");
    scene.contact.method = method;
    Touch touch(world, scene);
    TickRecord record;
    for (int k = 0; k <= 100; ++k)
      record = touch.tick({0.001 * k, {0.046, 0.003, 0.0501 - 5.1e-5 * k}, {0, 0, -1}});
    return record.force_W_n;
  };
  EXPECT_NEAR(force("proxy").z(), 5, 1e-3);  // 1000 N/m; the proxy's skin
  EXPECT_NEAR(force("closest-point").x(), 4, 1e-9);
}

/// A frustum of a cone about the z axis, closed by fans; a cylinder where both radii are equal.
TriangleSoup frustum_soup(double low_radius_m, double high_radius_m, double height_m, int sides) {
  TriangleSoup soup;
  soup.vertices_P.resize(3, 2 * sides + 2);
  soup.triangles.resize(3, 4 * sides);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides, x = std::cos(angle), y = std::sin(angle);
    soup.vertices_P.col(2 * i) << low_radius_m * x, low_radius_m * y, 0;
    soup.vertices_P.col(2 * i + 1) << high_radius_m * x, high_radius_m * y, height_m;
    const int low = 2 * i, high = low + 1, next_low = 2 * ((i + 1) % sides), next_high = next_low + 1;
    soup.triangles.middleCols<4>(4 * i) << low, low, 2 * sides, 2 * sides + 1,  //
        next_low, next_high, next_low, high,                                    //
        next_high, high, low, next_high;
  }
  soup.vertices_P.col(2 * sides) << 0, 0, 0;
  soup.vertices_P.col(2 * sides + 1) << 0, 0, height_m;
  return soup;
}

/// A ball of this half width, blown out to a box whose edges are rounded by `round_m`.
TriangleSoup rounded_box_soup(double half_m, double round_m) {
  TriangleSoup soup = test::sphere_soup(1, 5);
  for (int i = 0; i < soup.vertices_P.cols(); ++i) {
    const Vec3 n = soup.vertices_P.col(i);
    soup.vertices_P.col(i) = round_m * n + (half_m - round_m) * (20 * n).cwiseMin(1.0).cwiseMax(-1.0);
  }
  return soup;
}

TEST(ContactChoice, AConvexPartThickerThanItsPressNeedsAProxyForItsEdgesAlone) {
  for (const double radius_m : {0.0, 0.007}) {
    Scene scene;  // 10 N at 1000 N/m, 1 kHz
    scene.finger.radius_m = radius_m;
    // Twice the centre's depth: 22 mm for a point, 8 mm for a finger of 7 mm.
    const double least_m = 2 * (0.010 - radius_m + 0.001);
    for (const double times : test::cases({1.02, 2.0, 10.0, 100.0})) {
      const double d = times * least_m;
      const auto edge = HasSubstr("near an edge of");
      EXPECT_THAT(unheld(scene, box_soup({d, d, d})), edge) << "cube " << d;
      EXPECT_THAT(unheld(scene, box_soup({9 * d, 5 * d, d})), edge) << "slab " << d;
      // Facets cut into a sphere and a cylinder: 0.2 % here.
      EXPECT_THAT(unheld(scene, test::sphere_soup(1.005 * d / 2, 4)), IsEmpty()) << "sphere " << d;
      EXPECT_THAT(unheld(scene, frustum_soup(1.005 * d / 2, 1.005 * d / 2, d, 96)), edge) << "cylinder " << d;
      EXPECT_THAT(unheld(scene, frustum_soup(1.5 * d, d, d, 96)), edge) << "frustum " << d;
    }
    const auto wall = HasSubstr("walls are");
    EXPECT_THAT(unheld(scene, box_soup({1, 1, 0.98 * least_m})), wall);
    EXPECT_THAT(unheld(scene, test::sphere_soup(0.49 * least_m, 4)), wall);
    EXPECT_THAT(unheld(scene, frustum_soup(0.49 * least_m, 0.49 * least_m, 1, 96)), wall);
  }
}

TEST(ContactChoice, ARoundingTighterThanThePressNeedsAProxy) {
  const auto torus = test::torus_soup(0.06, 0.02, 128, 48);  // its tube turns by 7.5 degrees a facet
  Scene scene;
  scene.contact.greatest_force_n = 7;
  EXPECT_THAT(unheld(scene, torus), IsEmpty()) << "8 mm deep at the most, half of what is between its sides";
  const auto rounded = rounded_box_soup(0.05, 0.004);
  EXPECT_THAT(unheld(scene, rounded), HasSubstr("it is rounded by as little as"));
  scene.contact.greatest_force_n = 1;
  EXPECT_THAT(unheld(scene, rounded), IsEmpty());
}

TEST(ContactChoice, WhatOverlapsItselfGetsAProxy) {
  const TriangleSoup block = box_soup({0.1, 0.1, 0.1});
  const auto crossed = surfaces_of(test::joined(block, test::moved(block, {0.04, 0.03, 0.02})));
  const ContactChoice choice = choice_for(light_press(), crossed);
  EXPECT_EQ(choice.method, "proxy");
  EXPECT_THAT(choice.reasons, ElementsAre(HasSubstr("because it overlaps itself")));
  EXPECT_THAT(unheld(light_press(), test::joined(block, test::moved(block, {0.2, 0, 0}))),
              Not(HasSubstr("overlaps")))
      << "two blocks side by side, 10 cm apart";
}

TEST(ContactChoice, ATouchOfCrossedBlocksHoldsWhereTheNearestSheetIsHidden) {
  // 2 mm deep in the top of the wide block, 0.5 mm beside the tall one's side, which goes on within it: the
  // nearest sheet is that side, and the point lies outside of it.
  const auto crossed =
      test::joined(box_soup({0.1, 0.1, 0.02}), test::moved(box_soup({0.04, 0.04, 0.1}), {0, 0, 0.01}));
  const auto world = test::world_of(crossed);
  const auto force_z = [&](const char* method) {
    Scene scene = test::plane_scene("none");
    scene.contact.method = method;
    Touch touch(world, scene);
    FingerSample sample;
    TickRecord record;
    for (int k = 0; k <= 100; ++k) {
      sample.t_s = 0.001 * k;
      sample.p_WQ = {0.0205, 0, 0.0100 - 2e-5 * k + 1e-4};
      record = touch.tick(sample);
    }
    return record.force_W_n.z();
  };
  EXPECT_NEAR(force_z("proxy"), 1.9, 1e-3);  // 1000 N/m; the proxy's skin
  EXPECT_LT(force_z("closest-point"), 0.6) << "what the rule is for";
}

TEST(ContactChoice, ASphereOfAFewFacetsIsRoundWhereItsCreaseAngleSaysSo) {
  const TriangleSoup octahedron = test::sphere_soup(0.05, 0);  // its edges turn by 70.5 degrees
  Scene scene;
  scene.contact.automatic_normals = true;
  EXPECT_EQ(choice_for(scene, surfaces_of(octahedron, 30)).normals, Normals::facet) << "a solid with edges";
  const ContactChoice round = choice_for(scene, surfaces_of(octahedron, 75));
  EXPECT_EQ(round.normals, Normals::curved);
  EXPECT_THAT(round.reasons.back(), HasSubstr("its facets cut"));
}

TEST(ContactChoice, APlateIsThinBelowTwiceTheCentresDepth) {
  // 1 mm of press and 1 mm of a tick's motion: the middle of a plate of 4 mm.
  EXPECT_THAT(unheld(light_press(), box_soup({0.1, 0.1, 0.00399})), HasSubstr("walls are"));
  EXPECT_THAT(unheld(light_press(), box_soup({0.1, 0.1, 0.00401})), Not(HasSubstr("walls are")));
  Scene stiff = light_press();  // half the depth
  auto surfaces = surfaces_of(box_soup({0.1, 0.1, 0.00301}));
  surfaces[0].properties.stiffness_n_per_m = 2000;
  EXPECT_THAT(unheld(stiff, surfaces), Not(HasSubstr("walls are")));
  surfaces[0].properties.stiffness_n_per_m = 1900;
  EXPECT_THAT(unheld(stiff, surfaces), HasSubstr("walls are"));
  Scene fast = light_press();  // a tick's motion of 0.1 mm
  fast.motion.rate_hz = 10000;
  EXPECT_THAT(unheld(fast, box_soup({0.1, 0.1, 0.00221})), Not(HasSubstr("walls are")));
  EXPECT_THAT(unheld(fast, box_soup({0.1, 0.1, 0.00219})), HasSubstr("walls are"));
}

TEST(ContactChoice, AFingerWhoseCentreStaysOutsideNeedsNoWall) {
  Scene scene = light_press();
  scene.finger.radius_m = 0.00201;
  EXPECT_THAT(unheld(scene, box_soup({0.1, 0.1, 0.0005})), IsEmpty());
  scene.finger.radius_m = 0.0017;  // its centre goes 0.3 mm in
  EXPECT_THAT(unheld(scene, box_soup({0.1, 0.1, 0.0005})), HasSubstr("walls are"));
}

TEST(ContactChoice, WhatHasNoInsideGetsAProxy) {
  Scene scene = light_press();
  scene.finger.radius_m = 0.1;
  EXPECT_THAT(unheld(scene, test::square_soup(0.1, 2)), HasSubstr("not closed")) << "an open sheet";
  EXPECT_THAT(unheld(scene, test::reversed(box_soup({1, 1, 1}))), HasSubstr("inside out"));
}

TEST(ContactChoice, AKnifeEdgeIsToldFromABluntOne) {
  const auto wedge = [](double degrees) {  // a prism over a rhombus with this sharp angle
    const double angle_rad = degrees * std::numbers::pi / 180;
    TriangleSoup soup = box_soup({1, 1, 1});
    for (int i = 0; i < soup.vertices_P.cols(); ++i) {
      const double x = soup.vertices_P(0, i), y = soup.vertices_P(1, i);
      soup.vertices_P.col(i).head<2>() = Vec2(x + y * std::cos(angle_rad), y * std::sin(angle_rad));
    }
    return soup;
  };
  const auto knife = choice_for(light_press(), surfaces_of(wedge(58)));
  EXPECT_EQ(knife.method, "proxy");
  EXPECT_THAT(knife.reasons, ElementsAre(HasSubstr("an edge is as sharp as 58 degrees")));
  EXPECT_THAT(unheld(light_press(), wedge(62)), HasSubstr("near an edge of 62 degrees"));
}

TEST(ContactChoice, ACornerCountsForAFingerWithARadiusAndByTheTolerance) {
  const auto prism = [](double valley_deg) {  // a block with a notch on top, whose bottom turns by valley_deg
    const double depth = 0.5 * std::tan(valley_deg / 2 * std::numbers::pi / 180);
    TriangleSoup soup;
    soup.vertices_P.resize(3, 10);
    soup.vertices_P << -1, 1, 1, 0, -1, -1, 1, 1, 0, -1,   //
        -1, -1, depth, 0, depth, -1, -1, depth, 0, depth,  //
        0, 0, 0, 0, 0, 2, 2, 2, 2, 2;
    soup.triangles.resize(3, 16);
    soup.triangles << 0, 0, 0, 5, 5, 5, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4,  //
        3, 2, 4, 6, 7, 8, 1, 6, 2, 7, 3, 8, 4, 9, 0, 5,                //
        2, 1, 3, 7, 8, 9, 6, 5, 7, 6, 8, 7, 9, 8, 5, 9;
    return soup;
  };
  Scene scene = light_press();
  const auto block = surfaces_of(prism(80));
  EXPECT_THAT(unheld(scene, block), Not(HasSubstr("two walls"))) << "a point touches one wall";
  scene.finger.radius_m = 0.01;
  const ContactChoice both = choice_for(scene, block);
  EXPECT_EQ(both.method, "proxy");
  EXPECT_THAT(both.reasons, ElementsAre(HasSubstr("touches two walls at once")));
  // The nearest wall alone is wrong by sin(turn / 2) of the force.
  const double turn_rad = measure_part(*block[0].part, *block[0].tree).sharpest_valley_rad;
  ASSERT_GT(turn_rad, 0.6);
  scene.contact.force_tolerance = std::sin(turn_rad / 2) - 0.001;
  EXPECT_THAT(unheld(scene, block), HasSubstr("two walls"));
  scene.contact.force_tolerance = std::sin(turn_rad / 2) + 0.001;
  EXPECT_THAT(unheld(scene, block), IsEmpty());
}

TEST(ContactChoice, AFingerWiderThanAHollowGetsAProxy) {
  Scene scene = light_press();
  scene.finger.radius_m = 0.015;
  const auto torus = test::torus_soup(0.04, 0.01, 96, 48);
  EXPECT_THAT(unheld(scene, torus), IsEmpty()) << "its hole is 30 mm in radius";
  scene.finger.radius_m = 0.045;
  EXPECT_THAT(unheld(scene, torus), HasSubstr("bridges hollows"));
}

TEST(ContactChoice, SurfacesSideBySideGetAProxyForAll) {
  auto surfaces = surfaces_of(test::sphere_soup(0.05, 4));
  surfaces.emplace_back();  // the plane z = 0
  surfaces[0].p_WP = {0, 0, 0.2};
  EXPECT_THAT(unheld(light_press(), surfaces), IsEmpty()) << "15 cm above";
  surfaces[0].p_WP = {0, 0, 0.05};
  EXPECT_THAT(unheld(light_press(), surfaces), HasSubstr("another surface")) << "it stands on the plane";

  auto parts = surfaces_of(test::sphere_soup(0.05, 6));
  parts.push_back(surfaces_of(box_soup({0.1, 0.1, 0.001}))[0]);
  parts[1].p_WP = {0.5, 0, 0};
  parts[1].mesh = "plate.stl";
  Scene rough = light_press();
  rough.contact.force_tolerance = 0.2;  // the sphere's facets are felt by a light touch
  const ContactChoice choice = choice_for(rough, parts);
  EXPECT_EQ(choice.method, "proxy");
  EXPECT_THAT(choice.reasons,
              ElementsAre("part.stl: proxy, because plate.stl needs it (auto)",
                          "plate.stl: proxy, because walls are 1 mm thick and 1 N at 1000 N/m "
                          "presses 1 mm deep (auto)"));
}

TEST(ContactChoice, WhatASceneSaysIsKept) {
  Scene scene;
  scene.contact.method = "closest-point";
  const auto plate = surfaces_of(box_soup({0.1, 0.1, 0.001}));
  ContactChoice choice = choice_for(scene, plate);
  EXPECT_EQ(choice.method, "closest-point");
  EXPECT_EQ(choice.normals, Normals::smooth);
  EXPECT_THAT(choice.reasons, IsEmpty());
  scene.contact.automatic_normals = true;
  choice = choice_for(scene, plate);
  EXPECT_EQ(choice.method, "closest-point");
  EXPECT_THAT(choice.reasons,
              ElementsAre("part.stl: facet normals, because its faces are flat (auto)",
                          HasSubstr("cannot be kept by closest-point: walls are 1 mm thick")));
  scene.contact.method = automatic_method;
  choice = choice_for(scene, plate);
  EXPECT_EQ(choice.method, "proxy");
  EXPECT_THAT(
      choice.reasons,
      ElementsAre("part.stl: proxy, because walls are 1 mm thick and 10 N at 1000 N/m presses 10 mm deep; "
                  "facet normals, because its faces are flat (auto)"));
}

TEST(ContactChoice, PlanesAloneAreNothingToChoose) {
  const std::vector<Surface> plane(1);
  const ContactChoice choice = choice_for(Scene(), plane);
  EXPECT_EQ(choice.method, "closest-point");
  EXPECT_THAT(choice.reasons, IsEmpty());
  EXPECT_EQ(method_in(*test::plane_world(), choice.method), "plane");
  EXPECT_EQ(method_in(*test::world_of(box_soup({1, 1, 1})), choice.method), "closest-point");
}

std::vector<Surface> planes_with(const std::vector<Vec3>& normals) {
  std::vector<Surface> planes(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) planes[i].plane_normal_W = normals[i].normalized();
  return planes;
}

/// As `auto` touches them.
Touch frictionless_touch(const std::vector<Surface>& surfaces) {
  Scene scene;
  scene.friction.law = "none";
  World world;
  world.surfaces = surfaces;
  settle_contact(world, scene, {});
  return {std::make_shared<const World>(std::move(world)), scene};
}

// The deeper plane alone held a finger in their corner, and a step over its middle turned the push about.
TEST(ContactChoice, PlanesThatMeetHoldAFingerTogether) {
  const std::vector<Surface> groove = planes_with({{1, 0, 1}, {-1, 0, 1}});
  const ContactChoice choice = choice_for(Scene(), groove);
  EXPECT_EQ(choice.method, "proxy");
  EXPECT_THAT(choice.reasons,
              ElementsAre("planes: proxy, because two of them meet, and both hold a finger there (auto)"));
  EXPECT_EQ(choice_for(Scene(), planes_with({{0, 0, 1}, {0, 0, 1}})).method, "closest-point");
  EXPECT_EQ(choice_for(Scene(), planes_with({{0, 0, 1}, {0, 0, -1}})).method, "closest-point");
  Scene asked;
  asked.contact.method = "closest-point";
  EXPECT_EQ(choice_for(asked, groove).method, "closest-point") << "at the scene's word";
  World corner;
  corner.surfaces = groove;
  EXPECT_EQ(method_in(corner, choice.method), "proxy") << "and traces say so";

  Touch touch = frictionless_touch(groove);
  for (const double aside_m : {-1e-6, 0.0, 1e-6}) {
    FingerSample sample;
    sample.p_WQ = Vec3(aside_m, 0, -1e-3);
    const TickRecord tick = touch.tick(sample);
    EXPECT_LT((tick.force_W_n - Vec3(-1e3 * aside_m, 0, 1)).norm(), 1e-9) << aside_m;
    EXPECT_EQ(tick.walls, 2);
  }
}

// A millimetre and less below the apex of two planes, a point lost their groove in single ticks: what their
// large shares round to was more than they might be missed by.
TEST(ContactChoice, PlanesOfANarrowGrooveHoldAFingerInEveryTick) {
  for (const double degrees : {3.0, 1.0, 0.5, 0.2, 0.1}) {
    const double sine = std::sin(degrees * std::numbers::pi / 180), cosine = std::sqrt(1 - sine * sine);
    Touch touch = frictionless_touch(planes_with({{0, cosine, sine}, {0, -cosine, sine}}));
    for (int k = 0; k < 300; ++k) {
      FingerSample sample;
      sample.t_s = 1e-3 * k;
      sample.p_WQ =
          Vec3(1e-3 * std::sin(0.02 * k), 2e-5 * std::sin(0.3 * k) * sine, -1e-3 + 3e-4 * std::sin(0.07 * k));
      const TickRecord tick = touch.tick(sample);
      const Vec3 exact_n(0, -1e3 * sample.p_WQ.y(), -1e3 * sample.p_WQ.z());
      ASSERT_LT((tick.force_W_n - exact_n).norm(), 1e-6) << degrees << " degrees, tick " << k;
    }
  }
}

/// A part from a file in `folder`: a plate of 1 x 100 x 100 units.
PartEntry plate(const std::filesystem::path& folder, const std::string& name) {
  PartEntry entry;
  entry.mesh = name;
  entry.mesh_path = test::write_file(folder, name, test::binary_ply(box_soup({100, 100, 1}))).string();
  return entry;
}

Scene plate_scene() {
  Scene scene = test::plane_scene("coulomb");
  scene.parts.push_back(plate(test::scratch_dir(), "plate.ply"));
  return scene;
}

TEST(ContactChoice, TellsTheWayInATickWhereThatIsMoreThanThePress) {
  Scene scene = plate_scene();
  EXPECT_THAT(load_world(scene)->contact->reasons.at(0), Not(HasSubstr("a tick")));
  scene.contact.greatest_force_n = 0.1;
  EXPECT_THAT(load_world(scene)->contact->reasons.at(0),
              HasSubstr("presses 0.1 mm deep, and a tick at 1000 Hz takes a finger of 1 m/s 1 mm farther"));
}

TEST(ContactChoice, APartIsMeasuredOnceForItsContentAndOnlyWhereThereIsAChoice) {
  const auto folder = test::scratch_dir();
  Scene scene = test::plane_scene("coulomb");
  scene.parts.push_back(plate(folder, "plate.ply"));
  MeshStore meshes(1);
  Scene given = scene;
  given.contact.method = "proxy";
  load_world(given, meshes);
  EXPECT_EQ(meshes.measured_count(), 0) << "a scene that says all pays nothing";
  load_world(scene, meshes);
  load_world(scene, meshes);
  scene.parts[0] = plate(folder, "copy.ply");
  load_world(scene, meshes);
  EXPECT_EQ(meshes.measured_count(), 1) << "the same content in another file";
  scene.parts[0].crease_deg = 80;
  load_world(scene, meshes);
  scene.parts[0].metres_per_unit = 0.01;
  EXPECT_EQ(load_world(scene, meshes)->contact->method, "proxy");
  EXPECT_EQ(meshes.measured_count(), 3);
  scene.parts[0].metres_per_unit = 1;
  EXPECT_THAT(load_world(scene, meshes)->contact->reasons.at(0), HasSubstr("near an edge")) << "1 m thick";
}

/// Everything that a choice may go by, one after the other, in one store and each in one of its own.
TEST(ContactChoice, IsRememberedForNothingElse) {
  using Change = void (*)(Scene&);
  constexpr Change changes[] = {
      [](Scene& scene) { scene.finger.radius_m = 0.004; },
      [](Scene& scene) { scene.contact.greatest_force_n = 0.1; },
      [](Scene& scene) { scene.contact.force_tolerance = 1e-6; },
      [](Scene& scene) { scene.contact.automatic_normals = true; },
      [](Scene& scene) { scene.contact.mu_tolerance = 1e-9; },
      [](Scene& scene) { scene.contact.greatest_force_n = 20; },
      [](Scene& scene) { scene.parts[0].surface.mu_dynamic = 0.7; },
      [](Scene& scene) { scene.parts[0].surface.stiffness_n_per_m = 333; },
      [](Scene& scene) { scene.motion.rate_hz = 17; },
      [](Scene& scene) { scene.contact.normals = Normals::facet; },
      [](Scene& scene) { scene.parts[0].position_m.x() = 0.5; },
      [](Scene& scene) { scene.parts[0].crease_deg = 80; },
      [](Scene& scene) { scene.parts[0].mesh = "other.ply"; },
      [](Scene& scene) { scene.contact.method = "closest-point"; },
  };
  Scene scene = plate_scene();
  MeshStore meshes(1);
  std::set<std::string> said;
  for (const Change change : changes) {
    load_world(scene, meshes);
    change(scene);
    const ContactChoice shared = *load_world(scene, meshes)->contact, own = *load_world(scene)->contact;
    EXPECT_EQ(shared.method, own.method);
    EXPECT_EQ(shared.normals, own.normals);
    EXPECT_EQ(shared.reasons, own.reasons);
    said.insert(fmt::format("{} {} {}", own.method, own.normals->name, fmt::join(own.reasons, "\n")));
  }
  EXPECT_GE(said.size(), 7u) << "so that one taken for another would be seen";
}

TEST(ContactChoice, ManyThreadsMeasureAPartOnceAndChooseTheSame) {
  const Scene scene = plate_scene();
  MeshStore meshes(2);
  std::vector<std::string> reasons(8);
  std::vector<std::thread> threads;
  for (std::string& reason : reasons)
    threads.emplace_back([&] { reason = load_world(scene, meshes)->contact->reasons.at(0); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(meshes.measured_count(), 1);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_THAT(reasons, testing::Each(load_world(scene)->contact->reasons.at(0)));
}

TEST(ContactChoice, ATouchThatLeavesItOpenHoldsAtAThinPlate) {
  // Pressed 0.8 mm into a plate of 1 mm: past its middle, where the nearest surface is the far one.
  const auto deep_force_z = [](const Scene& scene) {
    Touch touch(load_world(scene), scene);
    FingerSample sample;
    TickRecord record;
    for (int k = 0; k <= 100; ++k) {
      sample.t_s = 0.001 * k;
      sample.p_WQ = {0.001, 0.002, 0.0007 - 1e-5 * k};
      record = touch.tick(sample);
    }
    return record.force_W_n.z();
  };
  Scene scene = plate_scene();
  EXPECT_NEAR(deep_force_z(scene), 0.8, 1e-3);  // 1000 N/m; the proxy's skin and float32 coordinates
  scene.contact.method = "closest-point";
  EXPECT_LT(deep_force_z(scene), 0) << "and says so where the scene insists";
}

/// A soup that was moved so far along x, and written in float32 numbers there.
TriangleSoup written_far_off(const TriangleSoup& soup, double offset_m) {
  TriangleSoup moved = test::moved(soup, Vec3(offset_m, 0, 0));
  for (double& coordinate : moved.vertices_P.reshaped())
    coordinate = static_cast<double>(static_cast<float>(coordinate));
  return moved;
}

TEST(ContactChoice, AMeshTooFarFromItsOriginForItsDigitsIsTold) {
  const TriangleSoup sphere = test::sphere_soup(0.02, 5);
  Scene scene;  // 1 mm deep at the least
  scene.contact.automatic_normals = true;
  const ContactChoice near = choice_for(scene, surfaces_of(written_far_off(sphere, 0.1)));
  EXPECT_THAT(near.limits[0].said, IsEmpty());
  // At 400 m vertices are rounded by 0.024 mm, which is felt, and no facet of a millimetre is believed.
  const ContactChoice far = choice_for(scene, surfaces_of(written_far_off(sphere, 400)));
  EXPECT_THAT(far.limits[0].said, HasSubstr("force_tolerance 0.03 cannot be kept, nor anything like it"));
  EXPECT_THAT(far.limits[0].said, HasSubstr("so far from its file's origin that its vertices are rounded"));
  EXPECT_THAT(far.limits[0].said, HasSubstr("move it nearer to its origin, and ask again"));
  // A box's sides are believed there, and stand 0.08 mm off.
  const TriangleSoup box = box_soup({0.1, 0.1, 0.1});
  const ContactChoice far_box = choice_for(scene, surfaces_of(written_far_off(box, 1300)));
  EXPECT_THAT(far_box.limits[0].said, HasSubstr("force_tolerance 0.03 cannot be kept, 0.1 can"));
  EXPECT_THAT(far_box.limits[0].said, HasSubstr("move it nearer to its origin, and ask again"));
  EXPECT_THAT(choice_for(scene, surfaces_of(box)).limits[0].said, IsEmpty());
}

TEST(ContactChoice, AStiffPartAtItsOriginHasDigitsEnough) {
  std::vector<Surface> stiff = surfaces_of(written_far_off(box_soup({4, 4, 1}), 0));
  stiff[0].properties.stiffness_n_per_m = 3e5;
  Scene scene;
  scene.contact.automatic_normals = true;
  EXPECT_THAT(choice_for(scene, stiff).limits[0].said, Not(HasSubstr("origin")));
}

}  // namespace
}  // namespace fingerpad::contact_choice_test
