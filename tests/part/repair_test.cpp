#include "part/repair.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/triangle_tree.hpp"
#include "part/import.hpp"
#include "support/brute_force.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/signs.hpp"

namespace fingerpad::repair_test {
namespace {

using namespace test;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

ImportedPart import_repaired(const std::string& name, const std::string& bytes) {
  ImportOptions options;
  options.metres_per_unit = 1;
  options.repair = true;
  return import_part(write_file(scratch_dir(), name, bytes).string(), options);
}

/// The soup with about this share of its triangles turned round.
TriangleSoup badly_wound(TriangleSoup soup, double share) {
  std::mt19937 random(3);
  std::vector<bool> turned(static_cast<std::size_t>(soup.triangles.cols()));
  for (std::size_t t = 0; t < turned.size(); ++t) turned[t] = random() < share * std::mt19937::max();
  turn(soup.triangles, turned);
  return soup;
}

void expect_told(const ImportedPart& imported, const std::string& words) {
  ASSERT_NE(imported.part, nullptr) << imported.verdict.error;
  EXPECT_THAT(imported.verdict.warnings, Contains(HasSubstr(words)));
}

/// Closed, wound in one way, outwards: the signs are those of the winding number.
void expect_sound(const ImportedPart& imported) {
  ASSERT_NE(imported.part, nullptr) << imported.verdict.error;
  EXPECT_TRUE(imported.verdict.closed);
  EXPECT_TRUE(imported.verdict.winding_consistent);
  EXPECT_GT(imported.verdict.volume_m3, 0);
  const Part& part = *imported.part;
  const int inside = expect_touchable(
      imported.part, 100, [&](const Vec3& p) { return winding_number(part, p - part.centre_P) > 0.5; });
  EXPECT_GT(inside, 2);
}

void expect_file_order(const Part& part) {
  for (int t = 0; t < part.triangle_count(); ++t) {
    ASSERT_EQ(part.file_triangle[static_cast<std::size_t>(t)], t);
  }
}

TEST(Repair, ABadlyWoundSphereIsWoundOutwardsTriangleByTriangleInTheFilesOrder) {
  for (const double share : {0.1, 0.5, 0.9, 1.0}) {
    const TriangleSoup soup = badly_wound(sphere_soup(1, 3), share);
    const ImportedPart imported = import_repaired("ball.ply", binary_ply(soup));
    expect_sound(imported);
    EXPECT_THAT(imported.verdict.warnings.front(), HasSubstr("repaired: "));
    expect_file_order(*imported.part);
    for (int t = 0; t < imported.part->triangle_count(); ++t) {
      Vec3 middle = Vec3::Zero();
      for (int k = 0; k < 3; ++k) middle += imported.part->vertices.col(imported.part->triangles(k, t));
      EXPECT_GT(imported.part->facet_normals.col(t).dot(middle), 0) << "of an outward facet";
    }
  }
}

TEST(Repair, TheFewerTrianglesOfAPieceAreTurned) {
  TriangleSoup soup = square_soup(1, 4);
  const auto turn_first = [](TriangleSoup sheet, int count) {
    std::vector<bool> turned(static_cast<std::size_t>(sheet.triangles.cols()), false);
    std::fill_n(turned.begin(), count, true);
    turn(sheet.triangles, turned);
    return sheet;
  };
  const ImportedPart few = import_repaired("few.obj", obj_text(turn_first(soup, 5)));
  expect_told(few, "repaired: 5 triangles turned round");
  EXPECT_EQ(few.part->facet_normals.col(0), Vec3::UnitZ());
  const ImportedPart many = import_repaired("many.obj", obj_text(turn_first(soup, 30)));
  expect_told(many, "repaired: 2 triangles turned round");
  EXPECT_EQ(many.part->facet_normals.col(0), -Vec3::UnitZ());
  // An open sheet stays open, and that is told as ever.
  expect_told(few, "open: 16 boundary edges");
  EXPECT_FALSE(few.verdict.closed);
}

TEST(Repair, AMixedCubeAndAnInvertedShellAreMended) {
  const TriangleSoup cube = moved(box_soup({1, 2, 3}), {10, 20, 30});
  expect_sound(import_repaired("mixed.obj", obj_text(badly_wound(cube, 0.4))));
  const ImportedPart inverted = import_repaired("inverted.ply", binary_ply(reversed(cube)));
  expect_sound(inverted);
  expect_told(inverted, "repaired: 1 closed shell turned outwards");
  EXPECT_THAT(inverted.verdict.warnings, testing::SizeIs(1));
}

TEST(Repair, NestedShellsAreWoundByTheirDepth) {
  const TriangleSoup whole = joined(joined(sphere_soup(1, 3), sphere_soup(0.75, 3)),
                                    joined(sphere_soup(0.5, 3), moved(sphere_soup(0.125, 2), {0, 2, 0})));
  for (const TriangleSoup& soup : {whole, reversed(whole), badly_wound(whole, 0.5)}) {
    const ImportedPart imported = import_repaired("nested.off", off_text(soup));
    expect_sound(imported);
    EXPECT_EQ(imported.verdict.components, 4);
    // Facets of the shells lie up to 1.4 % of the radius within their spheres: such places are nobody's.
    expect_touchable(imported.part, 300, [&](const Vec3& p) {
      return winding_number(*imported.part, p - imported.part->centre_P) > 0.5;
    });
    const TriangleTree tree(imported.part);
    const auto sign_at = [&](double x) {
      return nearest_surface_point(tree, {x, 0.01, 0.02}, Normals::facet, -1, 10).signed_distance_m;
    };
    EXPECT_GT(sign_at(1.1), 0);
    EXPECT_LT(sign_at(0.9), 0);
    EXPECT_GT(sign_at(0.6), 0);
    EXPECT_LT(sign_at(0.4), 0);
  }
  expect_told(import_repaired("out.off", off_text(whole)),
              "repaired: 1 closed shell inside a body turned inwards, as a cavity");
}

TEST(Repair, ShellsThatTouchInAnEdgeAreTurnedEachForItself) {
  const TriangleSoup boxes = joined(box_soup({1, 1, 1}), moved(reversed(box_soup({1, 1, 1})), {1, 1, 0}));
  const ImportedPart imported = import_repaired("edge.obj", obj_text(boxes));
  expect_told(imported, "repaired: 1 closed shell turned outwards");
  expect_told(imported, "non-manifold: 1 edge");
  expect_touchable(imported.part, 300, [&](const Vec3& p) {
    return winding_number(*imported.part, p - imported.part->centre_P) > 0.5;
  });
}

TEST(Repair, DuplicatesOfEitherWindingAndCollapsedFacesAreLeftOut) {
  const TriangleSoup box = box_soup({1, 1, 1});
  TriangleSoup soup = joined(joined(box, reversed(box)), box);
  soup.triangles.conservativeResize(3, 37);
  soup.triangles.col(36) << 0, 0, 1;
  const ImportedPart imported = import_repaired("thrice.obj", obj_text(soup));
  expect_sound(imported);
  expect_told(imported, "24 duplicate triangles");
  expect_told(imported, "1 degenerate triangle (without area): left out");
  EXPECT_EQ(imported.verdict.kept, 12);
  expect_file_order(*imported.part);
}

/// A box from the origin to (1, 1, 1) whose faces have vertices of their own; those in planes through the
/// origin are moved by 1e-8, which float32 keeps there.
TriangleSoup cracked_box() {
  TriangleSoup soup = unshared(moved(box_soup({1, 1, 1}), {0.5, 0.5, 0.5}));
  for (Eigen::Index i = 0; i < soup.vertices_P.size(); ++i) {
    double& x = soup.vertices_P.reshaped()[i];
    if (x == 0) x = 1e-8 * static_cast<double>(i / 9 % 3);  // by triangle
  }
  return soup;
}

TEST(Repair, GapsOfAHundredMillionthAreWeldedWithoutMovingAVertex) {
  const ImportedPart whole = import_repaired("cracked.off", off_text(cracked_box()));
  expect_sound(whole);
  expect_told(whole, "were taken as one");
  // With a hole besides, welding does not close the box: without repair it is not done.
  TriangleSoup holed = cracked_box();
  holed.triangles.conservativeResize(3, 11);
  const ImportedPart repaired = import_repaired("holed.off", off_text(holed));
  EXPECT_EQ(repaired.verdict.boundary_edges, 3);
  expect_told(repaired, "open: 3 boundary edges");
  const auto path = write_file(scratch_dir(), "holed.off", off_text(holed));
  const ImportedPart as_it_is = import_part(path.string(), 1, 0.5);
  EXPECT_GT(as_it_is.verdict.boundary_edges, 3);
  EXPECT_EQ(as_it_is.part->vertices, repaired.part->vertices) << "no coordinate is changed";
}

TEST(Repair, AStripWithOneSideKeepsAnEdgeThatClashesAndSaysSo) {
  constexpr int steps = 24;
  TriangleSoup strip;
  strip.vertices_P.resize(3, 2 * steps);
  strip.triangles.resize(3, 2 * steps);
  for (int i = 0; i < steps; ++i) {
    const double turn = 2 * std::numbers::pi * i / steps;
    const Vec3 out(std::cos(turn), std::sin(turn), 0);
    const Vec3 across = 0.25 * (std::cos(turn / 2) * out + std::sin(turn / 2) * Vec3::UnitZ());
    strip.vertices_P.col(2 * i) = out - across;
    strip.vertices_P.col(2 * i + 1) = out + across;
    const bool last = i + 1 == steps;  // there the strip meets its other side
    const int a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    strip.triangles.col(2 * i) << a, c, b;
    strip.triangles.col(2 * i + 1) << b, c, d;
  }
  const ImportedPart imported = import_repaired("moebius.obj", obj_text(strip));
  expect_told(imported, "inconsistent winding: at 1 edge");
  expect_told(imported, "open: 48 boundary edges");
  expect_touchable(imported.part, 100, nullptr);
}

TEST(Repair, AHealthyPartComesOutAsItWentIn) {
  const std::string bytes = obj_text(torus_soup(2, 0.5, 24, 12));
  const ImportedPart repaired = import_repaired("ring.obj", bytes);
  const ImportedPart plain = import_part(write_file(scratch_dir(), "r.obj", bytes).string(), 1, 0.5);
  EXPECT_THAT(repaired.verdict.warnings, IsEmpty());
  EXPECT_EQ(repaired.part->vertices, plain.part->vertices);
  EXPECT_EQ(repaired.part->triangles, plain.part->triangles);
  EXPECT_EQ(repaired.part->welded, plain.part->welded);
  EXPECT_EQ(repaired.part->vertex_pseudonormals, plain.part->vertex_pseudonormals);
}

TEST(Repair, TheSameBytesGiveTheSamePart) {
  const std::string bytes = binary_stl(badly_wound(joined(sphere_soup(1, 3), sphere_soup(0.5, 2)), 0.5));
  const ImportedPart first = import_repaired("a.stl", bytes), second = import_repaired("b.stl", bytes);
  EXPECT_EQ(first.part->triangles, second.part->triangles);
  EXPECT_EQ(first.part->edge_pseudonormals, second.part->edge_pseudonormals);
  EXPECT_EQ(first.verdict.warnings, second.verdict.warnings);
}

TEST(Repair, RealDamageIsMended) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "no real meshes here";
  ImportOptions options;
  options.repair = true;
  const ImportedPart flipped =
      import_part((*data / "malformed" / "d_random_half_flipped.stl").string(), options);
  expect_sound(flipped);
}

}  // namespace
}  // namespace fingerpad::repair_test
