#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "contact/contact_method_table.hpp"
#include "replay/run_job.hpp"
#include "scene/scene_file.hpp"
#include "study/contact_runs.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/worlds.hpp"
#include "touch/touch.hpp"
#include "trace/trace_column.hpp"
#include "trace/trace_writer.hpp"

// What a stranger adds: a contact method, normals, a law and a trace column, each a file of this folder and
// its line in the table, where CMake puts it. Nothing else in src/ knows of them. (added_rows_test.cpp has
// the others.)

namespace fingerpad {
namespace {

using testing::HasSubstr;

constexpr const char* plane = "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n";

Scene read_scene(const std::string& text) {
  return read_scene_text(plane + text, "s.toml").scene;
}

std::string refusal(const std::string& text) {
  try {
    read_scene(text);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

Scene scene_with(const std::string& method, const std::string& normals, const std::string& law) {
  return read_scene("[contact]\nmethod = \"" + method + "\"\nnormals = \"" + normals +
                    "\"\n[friction]\nlaw = \"" + law + "\"\n");
}

TEST(Rows, ASceneMayNameThem) {
  const Scene scene = read_scene(
      "[contact]\nmethod = \"brute-force\"\nnormals = \"face\"\n"
      "[friction]\nlaw = \"viscous\"\ndamping_n_s_per_m = 3\n");
  EXPECT_EQ(scene.contact.method, "brute-force");
  EXPECT_EQ(scene.contact.normals->name, "face");
  EXPECT_EQ(scene.friction.law, "viscous");
  EXPECT_THAT(refusal("[contact]\nmethod = \"brute-farce\"\n"), HasSubstr("did you mean 'brute-force'?"));
  EXPECT_THAT(refusal("[contact]\nnormals = \"fcae\"\n"), HasSubstr("face"));
}

TEST(Rows, WhatNoTableHasIsRefused) {
  Scene scene = scene_with("brute-force", "facet", "none");
  scene.contact.method = "no such method";
  EXPECT_THROW(Touch(test::plane_world(), scene), Error);
}

TEST(Rows, HelpAndStudiesListThem) {
  EXPECT_THAT(contact_help_text(), HasSubstr("  brute-force      looks at every triangle\n"));
  EXPECT_THAT(contact_help_text(), HasSubstr("  face             each facet's own normal"));
  const auto& variants = contact_variants();
  EXPECT_EQ(variants.size(), contact_method_table().size() * normals_table().size());
  EXPECT_TRUE(std::any_of(variants.begin(), variants.end(),
                          [](const ContactVariant& v) { return v.name() == "brute-force, face"; }));
}

TEST(Rows, TheNewMethodFeelsWhatTheClosestPointDoes) {
  const auto world = test::world_of(test::torus_soup(0.05, 0.02, 24, 12));
  for (const double radius_m : {0.0, 0.004}) {
    Scene brute = scene_with("brute-force", "facet", "none"),
          closest = scene_with("closest-point", "facet", "none");
    brute.finger.radius_m = closest.finger.radius_m = radius_m;
    Touch slow(world, brute), fast(world, closest);
    int touches = 0;
    for (int k = 0; k < 300; ++k) {
      const double across = 0.0317 + 0.02 * k, along = 0.0123 + 0.0071 * k,
                   r = 0.0193 + radius_m + 0.001 * std::sin(0.05 * k);
      const FingerSample sample{1e-3 * k,
                                Vec3((0.05 + r * std::cos(across)) * std::cos(along),
                                     (0.05 + r * std::cos(across)) * std::sin(along), r * std::sin(across))};
      const TickRecord a = slow.tick(sample), b = fast.tick(sample);
      // The normal is a direction over the depth, 1e-5 m and more here, of points good to 1e-17 m.
      ASSERT_LT((a.force_W_n - b.force_W_n).norm(), 1e-10) << k;
      touches += a.phase != Phase::free ? 1 : 0;
    }
    EXPECT_GT(touches, 100);
  }
}

TEST(Rows, TheNewNormalsAreFeltOverASmoothEdge) {
  const auto world = test::world_of(test::sphere_soup(0.05, 1));
  const Part& part = *world->surfaces[0].part;
  const Vec3 middle = (part.vertices.col(part.triangles(0, 0)) + part.vertices.col(part.triangles(1, 0))) / 2;
  const auto normal_of = [&](const std::string& normals) {
    Touch touch(world, scene_with("closest-point", normals, "none"));
    return touch.tick({0, part.centre_P + 0.98 * middle}).normal_W;
  };
  const auto is_facets = [&](const Vec3& normal) {
    for (int t = 0; t < part.triangle_count(); ++t) {
      if (normal == Vec3(part.facet_normals.col(t))) return true;
    }
    return false;
  };
  EXPECT_TRUE(is_facets(normal_of("face")));
  EXPECT_FALSE(is_facets(normal_of("smooth")));
}

TEST(Rows, TheNewLawHoldsTheFinger) {
  Touch touch(test::plane_world(), scene_with("auto", "smooth", "viscous"));
  touch.tick({0, Vec3(0, 0, -0.001)});
  EXPECT_NEAR(touch.tick({0.001, Vec3(0.0001, 0, -0.001)}).friction_W_n.x(), -2 * 0.1, 1e-12);
}

TEST(Rows, AutoGoesOnAsItDid) {
  Scene scene = scene_with("auto", "auto", "none");
  const auto chosen = [&scene](const TriangleSoup& soup) {
    const auto world = test::world_of(soup);
    const PartMeasures measures = measure_part(*world->surfaces[0].part, *world->surfaces[0].tree);
    return choose_contact(scene, world->surfaces, {&measures, 1});
  };
  EXPECT_EQ(chosen(test::box_soup({0.1, 0.1, 0.001})).method, "proxy");
  scene.finger.radius_m = 0.007;
  EXPECT_EQ(chosen(test::sphere_soup(0.05, 5)).method, "closest-point");
  EXPECT_EQ(chosen(test::box_soup({0.1, 0.1, 0.1})).normals, Normals::facet);
}

TEST(Rows, ATraceCarriesTheNewColumnAndTheMethodsName) {
  const auto world = test::world_of(test::box_soup({0.1, 0.1, 0.1}));
  const Scene scene = scene_with("brute-force", "face", "viscous");
  const TraceInfo info = trace_info(scene, *world, "0");
  EXPECT_EQ(info.contact_method, "brute-force");
  EXPECT_EQ(info.contact_normals, "face");
  std::vector<TickRecord> rows(3);
  rows[1].remedied = true;
  for (const TraceFormat format : {TraceFormat::hdf5, TraceFormat::csv}) {
    const std::string path = (test::scratch_dir() / "trace").string();
    const auto writer = TraceWriter::create(path, format, info, *world);
    writer->append(rows);
    writer->finish();
    const Trace trace = read_trace(path);
    ASSERT_EQ(trace.rows.size(), 3u);
    EXPECT_FALSE(trace.rows[0].remedied);
    EXPECT_TRUE(trace.rows[1].remedied);
  }
  EXPECT_THAT(trace_columns_text(), HasSubstr("| `remedied` | 1 | "));
}

}  // namespace
}  // namespace fingerpad
