// The reference meshes beside the project: each skipped where they are absent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "part/import.hpp"
#include "support/paths.hpp"

namespace fingerpad::real_meshes_test {
namespace {

using namespace test;
using testing::HasSubstr;

constexpr double crease_rad = std::numbers::pi / 6;

ImportedPart import_real(const std::string& folder, const std::string& name) {
  return import_part((*real_data() / folder / name).string(), 1e-3, crease_rad);
}

/// What the data's manifest says of a part: triangles and topology after an exact weld, or as remarked.
struct Known {
  long triangles;
  int components = 1;
  bool closed = true;
  long boundary = 0, nonmanifold = 0, duplicate = 0, inconsistent = 0;
  bool near_weld = false;
};

const std::map<std::string, Known>& known_parts() {
  static const std::map<std::string, Known> parts{
      {"so101_base.stl", {9558}},
      {"so101_upper_arm.stl", {8038}},
      {"so101_handle.stl", {11220}},
      {"so101_waveshare_plate.stl", {752}},
      {"so100_mini_plate_layout.stl", {43342, 11}},
      {"so101_4040_base_mount.stl", {29694}},
      {"so101_under_arm_sim.stl", {39516}},
      {"so101_under_arm_mm.stl", {10508}},
      {"so100_gauge.stl", {1766}},
      {"trimesh_ADIS16480.stl", {7436}},
      {"trimesh_featuretype.stl", {.triangles = 3476, .near_weld = true}},
      {"trimesh_cycloidal.ply", {.triangles = 43368, .components = 100, .closed = false, .nonmanifold = 242}},
      // Two components where only equal vertices are welded, one once its cracks are closed.
      {"trimesh_idler_riser.stl", {.triangles = 1572, .near_weld = true}},
      {"trimesh_plate_holes.stl", {1252}},
      {"trimesh_torus.stl", {8700}},
      {"abb_irb6640_link1.stl",
       {.triangles = 45002,
        .components = 19,
        .closed = false,
        .boundary = 208,
        .nonmanifold = 269,
        .inconsistent = 77}},
      {"fanuc_cr35ia_link3.stl", {14652}},
      {"comma_neo_case_top.stl", {5850}},
      {"comma_pedal_case_top.stl", {4598}},
      {"comma_giraffe_hyundai.stl", {8240}},
      {"prius_hybrid_body_with_interior.obj",
       {.triangles = 1676, .components = 14, .closed = false, .boundary = 86, .nonmanifold = 70}},
      {"prius_steering_wheel.obj", {.triangles = 196, .components = 4, .closed = false, .boundary = 20}},
      {"barkour_handle.stl", {14780, 12}},
      {"barkour_powercable.stl",
       {.triangles = 23998,
        .components = 5,
        .closed = false,
        .boundary = 20,
        .nonmanifold = 36,
        .duplicate = 26}},
      {"mujoco_mug.obj", {24544}},
      {"triathlete_hip.stl", {.triangles = 886, .components = 3, .near_weld = true}},
      {"axom_boxedSphere.stl", {65492, 2}},
      {"axom_cap_ascii.stl", {4496}},
      {"openmesh_cube1_ascii.stl", {15048}},
      {"openmesh_cube1.off", {15048}},
      {"tinymovr_servokit_part2.stl", {6940}},
      {"manifold_hull_mask.obj", {7980, 3}},
      {"scan_boot.obj", {39906}},
      {"wingnut.obj", {6090}},
      {"scan_pizza_open.obj", {.triangles = 49954, .closed = false, .boundary = 168}},
  };
  return parts;
}

void expect_sound(const Part& part) {
  for (const Points* normals :
       {&part.facet_normals, &part.edge_pseudonormals, &part.vertex_pseudonormals, &part.corner_normals}) {
    // A few roundings of a square root; NaN fails the comparison too.
    EXPECT_TRUE(((normals->colwise().norm().array() - 1).abs() < 1e-12).all());
  }
}

TEST(RealParts, TheVerdictsAreThoseOfTheManifest) {
  if (!real_data()) GTEST_SKIP() << "no reference meshes";
  for (const auto& [name, known] : known_parts()) {
    SCOPED_TRACE(name);
    const ImportedPart imported = import_real("parts", name);
    const Verdict& verdict = imported.verdict;
    ASSERT_TRUE(verdict.touchable) << verdict.error;
    EXPECT_EQ(verdict.triangles, known.triangles);
    EXPECT_EQ(verdict.kept, known.triangles - known.duplicate);
    EXPECT_EQ(verdict.components, known.components);
    EXPECT_EQ(verdict.closed, known.closed);
    EXPECT_EQ(verdict.boundary_edges, known.boundary);
    EXPECT_EQ(verdict.nonmanifold_edges, known.nonmanifold);
    EXPECT_EQ(verdict.duplicate, known.duplicate);
    EXPECT_EQ(verdict.inconsistent_edges, known.inconsistent);
    EXPECT_EQ(verdict.weld_distance_m > 0, known.near_weld);
    if (known.closed) {
      EXPECT_GT(verdict.volume_m3, 0);
    }
    expect_sound(*imported.part);
  }
}

TEST(RealParts, NoFileNeedsItsFacesTakenFromElsewhereThanOpenMesh) {
  for (const auto& path : real_files("parts", {".obj", ".off", ".ply"})) {
    for (const std::string& warning : import_part(path.string(), 1, crease_rad).verdict.warnings) {
      EXPECT_THAT(warning, Not(HasSubstr("OpenMesh"))) << path;
    }
  }
}

TEST(RealParts, TheMillionTriangleMeshIsClosedAndHasItsVolume) {
  const auto files = real_files("dense", {".ply"});
  if (files.empty()) GTEST_SKIP() << "no reference meshes";
  const Verdict verdict = import_part(files.front().string(), 1e-3, crease_rad).verdict;
  EXPECT_EQ(verdict.kept, 1092708);
  EXPECT_TRUE(verdict.closed && verdict.winding_consistent);
  EXPECT_NEAR(verdict.volume_m3, 1.4646e-2, 1e-6);  // the manifest's five digits
}

/// How a damaged file must end, and a word that names its damage among the error or the warnings.
struct Ending {
  bool touchable;
  const char* word;
};

const std::map<std::string, Ending>& malformed() {
  static const std::map<std::string, Ending> files{
      {"empty_0byte.off", {false, "empty (0 bytes)"}},
      {"empty_0byte.ply", {false, "empty (0 bytes)"}},
      {"out_of_memory_count.off", {false, "announces 353535235358 vertices"}},
      {"malformed_index_range.obj", {true, "out of range"}},
      {"malformed_missing_material.obj", {true, "open: 4 boundary edges"}},
      {"invalid_header.off", {false, "line 7"}},
      {"triangle_empty_solid.stl", {true, "open: 3 boundary edges"}},
      {"number_formats.obj", {false, "'3.1+e2' is not a number"}},
      {"concave_polygon.obj", {true, "concave"}},
      {"box_utf16be.obj", {false, "UTF-16"}},
      {"box_without_lineending.obj", {true, ""}},
      {"box_longline_continuation.obj", {true, "466 degenerate"}},
      {"cube_binary_crlf_header.ply", {true, ""}},
      {"cube_binary_starts_with_nl.ply", {true, ""}},
      {"soup.stl", {true, "a soup"}},
      {"shared.stl", {true, "non-manifold: 1 edge"}},
      {"multibody.stl", {true, "inconsistent winding: at 12 edges"}},
      {"negative_indices.obj", {true, ""}},
      {"notenoughindices.obj", {true, "fewer than three corners"}},
      {"jacked.obj", {true, ""}},
      {"singlevn.obj", {true, "open: 4 boundary edges"}},
      {"wallhole.obj", {true, "11 degenerate"}},
      {"stl_empty_ascii.stl", {false, "no triangle"}},
      {"stl_tiny.stl", {false, "no triangle"}},
      {"ply_empty_header.ply", {false, "no triangle"}},
      {"comments.off", {true, ""}},
      {"whitespace.off", {true, ""}},
      {"points_emptyface.ply", {false, "only 1024 points"}},
      {"two_inverted_faces.obj", {true, "open: 8 boundary edges"}},
      {"neg_volume.obj", {true, "open: 3 boundary edges"}},
      {"cube_with_hole.obj", {true, ""}},
      {"self_intersectA.obj", {true, ""}},
      {"pointcloud_bad_encoding.ply", {false, "only 10 points"}},
      {"triple_vierbein_nonmanifold.obj", {true, "non-manifold: 20 edges"}},
      {"name_with_white_spaces.obj", {true, ""}},
      {"step_select_segfault.stp", {false, "tessellate"}},
      {"step_nonmanifold_four_use_edge.stp", {false, "tessellate"}},
      {"step_zero_area_face.stp", {false, "tessellate"}},
      {"d_count_too_large.stl", {false, "announces 2252 triangles, but the file ends after 1252"}},
      {"d_count_too_small.stl", {false, "announces 600 triangles, but bytes for 1252"}},
      {"d_binary_header_looks_ascii.stl", {true, ""}},
      {"d_inf_coords.stl", {false, "not finite"}},
      {"d_far_offset_1e6mm.stl", {true, "far from the origin"}},
      {"d_random_half_flipped.stl", {true, "inconsistent winding: at 974 edges"}},
      {"d_normals_contradict_winding.stl", {true, "1252 of 1252 stored normals contradict"}},
      {"d_zero_normals.stl", {true, "stored normals are zero"}},
      {"d_double_sided.stl", {true, "1252 duplicate"}},
      {"d_5pct_facets_missing.stl", {true, "open: 163 boundary edges"}},
      {"d_cracked_1e-4mm.stl", {true, "cracks wider"}},
      {"d_all_zero_area.stl", {false, "no triangle with an area"}},
      {"d_all_points_equal.stl", {false, "no triangle with an area"}},
      {"d_ascii_truncated_in_number.stl", {false, "truncated"}},
      {"d_ascii_nan_inf_tokens.stl", {false, "not finite"}},
      {"d_ascii_decimal_commas.stl", {false, "decimal comma"}},
      {"d_ünïcödé 名前 part.stl", {true, ""}},
      {"d_obj_nan_vertex.obj", {false, "not finite"}},
      {"d_obj_tjunction_box.obj", {true, "open: 3 boundary edges"}},
      {"d_thin_slab_0.05mm.stl", {true, ""}},
      {"d_gap_0.2mm_two_plates.stl", {true, ""}},
      {"d_interpenetrating_boxes.stl", {true, ""}},
      {"d_needles.stl", {true, "open: 2002 boundary edges"}},
      {"d_off_negative_counts.off", {false, "below zero"}},
      {"d_off_face_index_oob.off", {false, "out of range"}},
      {"d_ply_truncated_faces.ply", {false, "truncated"}},
      {"d_ply_face_index_oob.ply", {true, "out of range"}},
      {"d_ply_count_bomb.ply", {false, "announces 4000000000"}},
      {"d_step_empty_0byte.stp", {false, "empty (0 bytes)"}},
      {"d_step_is_really_stl.stp", {false, "STL"}},
      {"d_stl_is_really_png.stl", {false, "PNG picture"}},
  };
  return files;
}

TEST(MalformedFiles, EachEndsTouchableOrRefusedWithItsDamageNamed) {
  if (!real_data()) GTEST_SKIP() << "no reference meshes";
  for (const auto& [name, ending] : malformed()) {
    SCOPED_TRACE(name);
    const ImportedPart imported = import_real("malformed", name);
    const Verdict& verdict = imported.verdict;
    EXPECT_EQ(verdict.touchable, ending.touchable) << verdict.error;
    EXPECT_EQ(imported.part != nullptr, ending.touchable);
    const std::string text = verdict_text(verdict);
    EXPECT_THAT(text, HasSubstr(name));
    EXPECT_THAT(text, HasSubstr(ending.word));
    // A file that is sound but for its form goes without a word.
    if (*ending.word == '\0') {
      EXPECT_THAT(verdict.warnings, testing::IsEmpty());
    }
    if (imported.part) expect_sound(*imported.part);
  }
}

TEST(MalformedFiles, EveryFileOfTheFolderIsListedHere) {
  for (const auto& path : real_files("malformed", {".stl", ".obj", ".ply", ".off", ".stp"})) {
    EXPECT_TRUE(malformed().contains(path.filename().string())) << path;
  }
}

}  // namespace
}  // namespace fingerpad::real_meshes_test
