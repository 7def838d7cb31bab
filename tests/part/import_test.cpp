#include "part/import.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"

namespace fingerpad::import_test {
namespace {

using namespace test;
using testing::AnyOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double crease_rad = std::numbers::pi / 6;

ImportedPart import_bytes(const std::string& name, const std::string& bytes, double metres_per_unit = 1) {
  return import_part(write_file(scratch_dir(), name, bytes).string(), metres_per_unit, crease_rad);
}

void expect_refused(const ImportedPart& imported, const std::string& word) {
  EXPECT_FALSE(imported.verdict.touchable);
  EXPECT_EQ(imported.part, nullptr);
  EXPECT_THAT(imported.verdict.error, HasSubstr(word));
}

void expect_warned(const ImportedPart& imported, const std::string& word) {
  EXPECT_TRUE(imported.verdict.touchable) << imported.verdict.error;
  ASSERT_NE(imported.part, nullptr);
  EXPECT_THAT(imported.verdict.warnings, Contains(HasSubstr(word)));
}

struct Format {
  const char* name;
  std::string (*bytes)(const TriangleSoup&);
};

class EveryFormat : public testing::TestWithParam<Format> {};

INSTANTIATE_TEST_SUITE_P(Import, EveryFormat,
                         testing::Values(Format{"b.stl", binary_stl}, Format{"t.STL", text_stl},
                                         Format{"o.obj", obj_text}, Format{"o.off", off_text},
                                         Format{"t.ply", ply_text}, Format{"b.ply", binary_ply}),
                         [](const auto& format) {
                           std::string name = format.param.name;
                           name[1] = '_';
                           return name;
                         });

TEST_P(EveryFormat, ReadsASphereInTheFilesOrder) {
  const TriangleSoup sphere = sphere_soup(20, 2);
  const ImportedPart imported = import_bytes(GetParam().name, GetParam().bytes(sphere), 1e-3);
  const Verdict& verdict = imported.verdict;
  ASSERT_TRUE(verdict.touchable) << verdict.error;
  EXPECT_TRUE(verdict.closed && verdict.winding_consistent);
  EXPECT_EQ(verdict.triangles, 128);
  EXPECT_EQ(verdict.kept, 128);
  EXPECT_EQ(verdict.components, 1);
  const Part& part = *imported.part;
  for (int t = 0; t < part.triangle_count(); ++t) {
    ASSERT_EQ(part.file_triangle[static_cast<std::size_t>(t)], t);
    for (int k = 0; k < 3; ++k) {
      const Vec3 read = part.centre_P + part.vertices.col(part.triangles(k, t));
      const Vec3 wanted = 1e-3 * sphere.vertices_P.col(sphere.triangles(k, t)).unaryExpr(&as_float32);
      ASSERT_NEAR((read - wanted).norm(), 0,
                  1e-17);  // float32 by the readers; a rounding each of unit and centre
    }
  }
}

TEST_P(EveryFormat, RefusesAFileThatEndsEarly) {
  const std::string bytes = GetParam().bytes(box_soup({1, 2, 3}));
  const ImportedPart imported = import_bytes(GetParam().name, bytes.substr(0, bytes.size() - 31));
  if (std::string(GetParam().name) == "o.obj") {
    // An OBJ announces nothing, so that only the hole tells.
    expect_warned(imported, "open");
  } else {
    expect_refused(imported, "truncated");
  }
}

TEST_P(EveryFormat, RefusesAnEmptyFileAsEmpty) {
  expect_refused(import_bytes(GetParam().name, ""), "empty (0 bytes)");
}

TEST_P(EveryFormat, RefusesCoordinatesThatAreNotFinite) {
  TriangleSoup soup = box_soup({1, 1, 1});
  soup.vertices_P(1, 3) = std::numeric_limits<double>::quiet_NaN();
  expect_refused(import_bytes(GetParam().name, GetParam().bytes(soup)), "not finite");
  soup.vertices_P(1, 3) = -std::numeric_limits<double>::infinity();
  expect_refused(import_bytes(GetParam().name, GetParam().bytes(soup)), "not finite");
}

TEST_P(EveryFormat, SaysWhereRoundingToFloat32MovesTheSurface) {
  // At 1e6 a float32 steps by 1/16, so that a thousandth is lost.
  const TriangleSoup soup = moved(box_soup({1.001, 1, 1}), {1e6, 0, 0});
  const ImportedPart imported = import_bytes(GetParam().name, GetParam().bytes(soup));
  expect_warned(imported, "float32");
  EXPECT_NEAR(imported.verdict.resolution_m, 0.0625, 1e-12);
}

TEST_P(EveryFormat, RefusesAMeshWithoutATriangle) {
  TriangleSoup soup = box_soup({1, 1, 1});
  soup.triangles.resize(3, 0);
  expect_refused(import_bytes(GetParam().name, GetParam().bytes(soup)), "no triangle");
}

TEST_P(EveryFormat, RefusesAMeshWithoutArea) {
  TriangleSoup soup = box_soup({1, 1, 1});
  soup.vertices_P.row(0).setZero();
  soup.vertices_P.row(2).setZero();
  expect_refused(import_bytes(GetParam().name, GetParam().bytes(soup)), "no triangle with an area");
}

TEST_P(EveryFormat, WarnsOfHolesAndInwardWindingAndDoubleSides) {
  TriangleSoup open = box_soup({1, 1, 1});
  open.triangles.conservativeResize(3, 11);
  expect_warned(import_bytes(GetParam().name, GetParam().bytes(open)), "open: 3 boundary edges");
  const TriangleSoup box = box_soup({1, 1, 1});
  expect_warned(import_bytes(GetParam().name, GetParam().bytes(reversed(box))), "swapped");
  expect_warned(import_bytes(GetParam().name, GetParam().bytes(joined(box, reversed(box)))),
                "12 duplicate triangles");
}

TEST(Import, AnUntouchableFileThrowsWithItsNameWhereAPartIsNeeded) {
  const std::string path = write_file(scratch_dir(), "empty.stl", "").string();
  try {
    import_touchable(path, 1, crease_rad);
    FAIL() << "must throw";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_EQ(error.what(), path + ": is empty (0 bytes)");
  }
  EXPECT_EQ(refusal_text(import_part(path, 1, crease_rad).verdict), path + ": is empty (0 bytes)");
}

TEST(Import, WhatIsNoFileIsRefused) {
  const auto folder = scratch_dir();
  expect_refused(import_part((folder / "absent.stl").string(), 1, crease_rad), "no such file");
  expect_refused(import_part(folder.string(), 1, crease_rad), "folder");
  const std::string pipe = (folder / "pipe.stl").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expect_refused(import_part(pipe, 1, crease_rad), "not a regular file");
}

TEST(Import, StrangersAreToldAsWhatTheyAre) {
  using namespace std::string_literals;
  const std::string stl = binary_stl(box_soup({1, 1, 1}));
  expect_refused(import_bytes("a.stl", "\x89PNG\r\n\x1a\n0000"s), "PNG picture");
  expect_refused(import_bytes("a.obj", "PK\x03\x04mesh"s), "ZIP archive");
  expect_refused(import_bytes("a.obj", "version https://git-lfs.github.com/spec/v1\n"), "Git LFS");
  expect_refused(import_bytes("a.stp", "ISO-10303-21;\nHEADER;\n"), "tessellate");
  expect_refused(import_bytes("a.stl", "ISO-10303-21;\nHEADER;\n"), "STEP");
  expect_refused(import_bytes("a.stp", stl), "STL");
  expect_refused(import_bytes("a.obj", stl), "rename");
  expect_refused(import_bytes("a.off", ply_text(box_soup({1, 1, 1}))), "PLY");
  expect_refused(import_bytes("a.gltf", "{}"), "STL, OBJ, PLY and OFF");
  expect_refused(import_bytes("a.stl", "hello"), "is no STL");
  expect_refused(import_bytes("a.obj", "\xff\xfev\0 \0001\0"s), "UTF-16");
  std::string wide;
  for (const char c : obj_text(box_soup({1, 1, 1}))) wide += {'\0', c};
  expect_refused(import_bytes("a.obj", wide), "UTF-16");
  expect_refused(import_bytes("a.obj", "v 0 0 0\0\n"s), "zero byte");
}

TEST(ImportStl, ABinaryOneMayBeginWithSolid) {
  std::string bytes = binary_stl(box_soup({1, 1, 1}));
  const std::string imitation = "solid x\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n";
  bytes.replace(0, imitation.size(), imitation);
  const ImportedPart imported = import_bytes("a.stl", bytes);
  EXPECT_EQ(imported.verdict.format, "binary STL");
  EXPECT_TRUE(imported.verdict.closed);
}

TEST(ImportStl, AWrongCountIsRefusedWithBothNumbers) {
  std::string bytes = binary_stl(box_soup({1, 1, 1}));
  bytes[80] = 20;
  expect_refused(import_bytes("a.stl", bytes), "announces 20 triangles, but the file ends after 12");
  bytes[80] = 5;
  expect_refused(import_bytes("a.stl", bytes), "announces 5 triangles, but bytes for 12");
  bytes[80] = 12;
  expect_warned(import_bytes("a.stl", bytes + "trailer"), "7 bytes after the last triangle");
}

TEST(ImportStl, TheWindingIsTrustedOverStoredNormals) {
  std::string text = text_stl(box_soup({1, 1, 1}));
  expect_warned(import_bytes("a.stl", text), "stored normals are zero");
  const auto first = text.find("0 0 0\n");
  text.replace(first, 5, "0 0 1");  // the first facet looks down
  const ImportedPart imported = import_bytes("a.stl", text);
  expect_warned(imported, "1 of 12 stored normals contradict");
  EXPECT_NEAR(imported.part->facet_normals(2, 0), -1, 1e-15);
}

TEST(ImportStl, ASolidsNameIsNoKeyword) {
  std::string text = text_stl(box_soup({1, 1, 1}));
  text.replace(6, 4, "outer ring, facet normal 1 2 3");
  const ImportedPart imported = import_bytes("a.stl", text);
  EXPECT_TRUE(imported.verdict.closed);
  EXPECT_THAT(imported.verdict.warnings, Not(Contains(HasSubstr("OpenMesh"))));
}

TEST(ImportStl, ATextWithoutItsEndIsToldAndOneCutInANumberRefused) {
  const std::string text = text_stl(box_soup({1, 1, 1}));
  expect_warned(import_bytes("a.stl", text.substr(0, text.find("endsolid"))), "without 'endsolid'");
  expect_refused(import_bytes("a.stl", text.substr(0, text.rfind("vertex") + 10)), "truncated");
}

TEST(ImportStl, NumbersThatAreNoneAreRefusedAtTheirLine) {
  std::string text = text_stl(box_soup({1, 1, 1}));
  const auto at = text.find("-0.5");
  expect_refused(import_bytes("a.stl", std::string(text).replace(at, 4, "-0,5")),
                 "line 4: '-0,5' is not a number (a decimal comma");
  expect_refused(import_bytes("a.stl", std::string(text).replace(at, 4, "-1.#IND")),
                 "line 4: vertex 0 has a coordinate that is not finite");
  expect_refused(import_bytes("a.stl", std::string(text).replace(at, 4, "1e99")), "not finite");
  expect_refused(import_bytes("a.stl", std::string(text).replace(at, 4, "abc")), "'abc' is not a number");
}

TEST(ImportObj, PolygonsAreFannedAndDroppedFacesKeepTheirNumbers) {
  const ImportedPart imported = import_bytes("a.obj",
                                             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                             "f 1 2 3 9\n"              // 0, 1: vertex 9 is not there
                                             "f 1 2\n"                  // no triangle, no number
                                             "f 1//1 2//1 3//1 4//1\n"  // 2, 3
                                             "f -4 -3 0\n");            // 4: no vertex 0
  expect_warned(imported, "out of range");
  expect_warned(imported, "1 face with fewer than three corners");
  EXPECT_EQ(imported.verdict.triangles, 5);
  EXPECT_EQ(imported.verdict.out_of_range, 3);
  EXPECT_EQ(imported.part->file_triangle, (std::vector<int>{2, 3}));
}

TEST(ImportObj, NonManifoldFacesAreAllKept) {
  // Three sheets on one edge, one of them twice: a half-edge mesh would drop or split them.
  const ImportedPart imported = import_bytes("a.obj",
                                             "v 0 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 0\nv 0 0 1\n"
                                             "f 2 1 3\nf 1 2 4\nf 1 2 5\nf 2 1 3\n");
  expect_warned(imported, "non-manifold: 1 edge");
  expect_warned(imported, "1 duplicate triangle");
  EXPECT_EQ(imported.verdict.triangles, 4);
  EXPECT_EQ(imported.part->triangle_count(), 3);
  EXPECT_THAT(imported.verdict.warnings, Not(Contains(HasSubstr("OpenMesh"))));
}

TEST(ImportObj, AConcavePolygonIsTold) {
  expect_warned(import_bytes("a.obj", "v 0 0 0\nv 2 0 0\nv 0.5 0.2 0\nv 0 2 0\nf 2 3 4 1\nf 3 4 1 2\n"),
                "1 polygon is concave");
}

TEST(ImportObj, LongLinesContinuationsCommentsAndMaterialsAreRead) {
  const std::string text =
      "# " + std::string(5000, 'x') +
      "\nmtllib /dev/zero\nusemtl none\r\nv 0 0 0 1 0.5 0.5\r\nv 1 0 \\\n0\nv 0 1 0\nvn 0 0 1\nvt 0\n"
      "f 1//1 2//1 \\\n 3//1 # done";
  const ImportedPart imported = import_bytes("a.obj", text);
  ASSERT_TRUE(imported.verdict.touchable) << imported.verdict.error;
  EXPECT_EQ(imported.verdict.kept, 1);
}

TEST(ImportObj, VerticesThatNoFaceUsesMayBeAnywhere) {
  const ImportedPart imported =
      import_bytes("a.obj", "v 9 9 9\nv nan 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n");
  ASSERT_TRUE(imported.verdict.touchable) << imported.verdict.error;
  EXPECT_EQ(imported.verdict.bounds_m.max, Vec3(1, 1, 0));
}

TEST(ImportOff, AbsurdCountsAreRefused) {
  expect_refused(import_bytes("a.off", "OFF\n353535235358 6 0\n0 0 0\n"), "announces 353535235358 vertices");
  expect_refused(import_bytes("a.off", "OFF\n-8 -6 0\n0 0 0\n"), "below zero");
  expect_refused(import_bytes("a.off", "OFF\n3 99999 0\n0 0 0\n1 0 0\n0 1 0\n"), "announces 99999 faces");
  expect_refused(import_bytes("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n9999999 0 1\n"),
                 "corner 3 of 9999999");
  expect_refused(import_bytes("a.off", "OFF BINARY\n3 1 0\n"), "binary OFF");
}

TEST(ImportOff, CommentsColoursAndASharedHeaderLineAreRead) {
  const ImportedPart imported =
      import_bytes("a.off", "  OFF3 1 # none\n# c\n\n0 0 0 # here\n1 0 0\n0 1 0\n3 0 1 2 0.5 0.5 0.5");
  EXPECT_EQ(imported.verdict.kept, 1);
  EXPECT_THAT(imported.verdict.warnings, Not(Contains(HasSubstr("OpenMesh"))));
}

std::string ply(const std::string& header, const std::string& body) {
  return "ply\n" + header + "end_header\n" + body;
}

TEST(ImportPly, HeadersAreReadStrictly) {
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_TRUE(
      import_bytes("a.ply", ply("format ascii 1.0\nelement vertex 3\n" + xyz + faces, points + "3 0 1 2"))
          .verdict.touchable);
  expect_refused(import_bytes("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"), "within its header");
  expect_refused(import_bytes("a.ply", ply("format ascii 1.0\nelement vertex 3\nproperty quad x\n", points)),
                 "no type");
  expect_refused(import_bytes("a.ply", ply("format ascii 1.0\nelement vertex\n", points)),
                 "number of elements");
  expect_refused(import_bytes("a.ply", ply("format ascii 1.0\nfoo\n", points)), "does not belong");
  expect_refused(import_bytes("a.ply", ply("element vertex 3\n" + xyz, points)), "no format");
  expect_refused(
      import_bytes("a.ply", ply("format ascii 1.0\nelement vertex 3\nproperty float x\n" + faces, points)),
      "no x, y and z");
  expect_refused(
      import_bytes("a.ply", ply("format ascii 1.0\nelement vertex 3\n" + xyz + faces, points + "-3 0 1 2")),
      "below zero");
  expect_refused(
      import_bytes("a.ply",
                   ply("format ascii 1.0\nelement void 4000000000\nelement vertex 3\n" + xyz, points)),
      "announces 4000000000");
}

TEST(ImportPly, WhatKeepsOpenMeshReadingForEverIsReadInATrice) {
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string list = "property list uchar int vertex_indices\n";
  // A version that is no number makes its header reader wait for a stream that has failed.
  const std::string version = "format ascii one\nelement vertex 3\n" + xyz + "element face 1\n" + list;
  EXPECT_EQ(import_bytes("a.ply", ply(version, points + "3 0 1 2\n")).verdict.kept, 1);
  // A property before the list: it would take its bytes for the count of corners.
  const std::string before =
      "format ascii 1.0\nelement vertex 3\n" + xyz + "element face 1\nproperty int flags\n" + list;
  EXPECT_EQ(import_bytes("a.ply", ply(before, points + "2000000000 3 0 1 2\n")).verdict.kept, 1);
  // A number that its stream cannot take leaves its counters as they were.
  const std::string more = "format ascii 1.0\nelement vertex 4\n" + xyz + "element face 1\n" + list;
  const ImportedPart imported = import_bytes("a.ply", ply(more, points + "nan 1e999 0\n3 0 1 2\n"));
  EXPECT_EQ(imported.verdict.kept, 1);
  EXPECT_THAT(imported.verdict.warnings, Not(Contains(HasSubstr("OpenMesh"))));
}

TEST(ImportPly, PropertiesThatAreNotNeededArePassedOver) {
  const std::string header =
      "format ascii 1.0\ncomment c\nelement vertex 3\nproperty uchar red\nproperty double x\nproperty float "
      "y\n"
      "property float z\nproperty float quality\nelement face 2\nproperty list uchar int "
      "vertex_index\nproperty uchar flags\n";
  const ImportedPart imported =
      import_bytes("a.ply", ply(header, "9 0 0 0 1\n9 1 0 0 1\n9 0 1 0 1\n3 0 1 2 7\n3 0 1 5 7\n"));
  expect_warned(imported, "out of range");
  EXPECT_EQ(imported.verdict.kept, 1);
  EXPECT_EQ(imported.verdict.out_of_range, 1);
}

TEST(ImportPly, WholeNumbersAsCoordinatesAreRead) {
  // OpenMesh passes over coordinates of these types without reading their bytes, takes them for a face's
  // count and goes on for minutes.
  using namespace std::string_literals;
  const std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty short x\nproperty short y\nproperty "
      "short z\nelement face 1\nproperty list int ushort vertex_indices\nend_header\n"
      "\0\0\0\0\0\0\7\0\0\0\0\0\0\0\7\0\0\0\3\0\0\0\0\0\1\0\2\0"s;
  const ImportedPart imported = import_bytes("short.ply", bytes);
  ASSERT_NE(imported.part, nullptr) << imported.verdict.error;
  EXPECT_EQ(imported.part->size_m(), 7 * std::sqrt(2.0));
}

TEST(Verdict, TextNamesTheFileTheDamageAndTheNumbers) {
  TriangleSoup open = box_soup({1, 2, 3});
  open.triangles.conservativeResize(3, 11);
  const Verdict verdict = import_bytes("open.obj", obj_text(open), 1e-3).verdict;
  const std::string text = verdict_text(verdict);
  EXPECT_THAT(text, HasSubstr("open.obj: can be touched, with care"));
  EXPECT_THAT(text, HasSubstr("3 boundary edges"));
  EXPECT_THAT(text, HasSubstr("8 vertices, 11 triangles, 11 kept"));
  EXPECT_THAT(text, HasSubstr("1 x 2 x 3 mm"));
  EXPECT_EQ(text.back(), '\n');
}

/// Looking for a comment to the file's end on every line would take some ten minutes here, and a watchdog
/// ends the test.
TEST(Import, ALongObjWithoutCommentsIsReadInOnePass) {
  std::string text;
  for (int i = 0; i < 1500000; ++i) text += "v 0 0 0\n";
  expect_refused(import_bytes("long.obj", text), "holds no triangle");
}

TEST(Import, AFaceOfMoreCornersThanAnyModelerDrawsIsRefused) {
  std::string text, face = "f";
  for (int i = 0; i < 400000; ++i) {
    text += "v " + std::to_string(i) + " " + std::to_string(i % 7) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  expect_refused(import_bytes("huge_face.obj", text + face + "\n"),
                 "face 0 has 400000 corners; at most 20000");
}

}  // namespace
}  // namespace fingerpad::import_test
