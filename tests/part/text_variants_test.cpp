// Every text format as other programs and systems write it: a mark of UTF-8, the line ends of three systems,
// form feeds, blank lines, comments. A file is read exactly right, or refused with the reason: a mark once
// hid an OBJ's first vertex, so that every index shifted and half the triangles were gone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <numbers>

#include "part/import.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/text_variants.hpp"

namespace fingerpad::text_variants_test {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::IsEmpty;

struct TextFormat {
  const char* file;
  std::string (*text)(const TriangleSoup&);
  const char* comment;  ///< a line with its end; "" where the format has none
};

class EveryTextFormat : public testing::TestWithParam<TextFormat> {};

INSTANTIATE_TEST_SUITE_P(Import, EveryTextFormat,
                         testing::Values(TextFormat{"t.stl", text_stl, ""},
                                         TextFormat{"t.obj", obj_text, "# f 1 2 3\n"},
                                         TextFormat{"t.off", off_text, "# 3 0 1 2\n"},
                                         TextFormat{"t.ply", ply_text, ""}),
                         [](const auto& format) { return std::string(format.param.file).substr(2); });

ImportedPart import_bytes(const std::string& name, const std::string& bytes) {
  return import_part(write_file(scratch_dir(), name, bytes).string(), 1e-3, std::numbers::pi / 6);
}

void expect_the_same(const ImportedPart& imported, const Part& plain) {
  ASSERT_NE(imported.part, nullptr) << imported.verdict.error;
  EXPECT_EQ(imported.verdict.triangles, 12);
  EXPECT_DOUBLE_EQ(imported.verdict.volume_m3, 6e-6);
  EXPECT_EQ(imported.part->vertices, plain.vertices);
  EXPECT_EQ(imported.part->triangles, plain.triangles);
  EXPECT_EQ(imported.part->file_triangle, plain.file_triangle);
}

/// 1 x 2 x 3 cm, on whole millimetres: exact in any form.
TriangleSoup block() {
  return box_soup({10, 20, 30});
}

TEST_P(EveryTextFormat, IsReadExactlyRightOrRefusedWhateverItsLineEnds) {
  const std::string text = GetParam().text(block());
  const ImportedPart plain = import_bytes(GetParam().file, text);
  ASSERT_NE(plain.part, nullptr) << plain.verdict.error;
  for (const TextVariant& variant : text_variants()) {
    SCOPED_TRACE(variant.name);
    const ImportedPart imported = import_bytes(GetParam().file, variant.of(text));
    if (imported.part || variant.must_read) {
      expect_the_same(imported, *plain.part);
    } else {
      EXPECT_THAT(imported.verdict.error, testing::Not(IsEmpty()));
    }
  }
}

TEST_P(EveryTextFormat, MayHaveCommentsWhereverALineMayStand) {
  const std::string text = GetParam().text(block()), comment = GetParam().comment;
  if (comment.empty()) GTEST_SKIP() << "this format has none";
  const ImportedPart plain = import_bytes(GetParam().file, text);
  for (const char* end : {"\n", "\r\n", "\r"}) {
    SCOPED_TRACE(testing::PrintToString(end));
    const std::string all = comment + replaced(text, "\n", " " + comment + comment);
    expect_the_same(import_bytes(GetParam().file, replaced(all, "\n", end)), *plain.part);
  }
}

TEST(TextVariants, APlysHeaderMayEndItsLinesAsItLikes) {
  for (const auto bytes_of : {ply_text, binary_ply}) {
    const std::string lf = bytes_of(block());
    const ImportedPart plain = import_bytes("b.ply", lf);
    const std::size_t body = lf.find("end_header\n") + 11;
    const std::string header =
                          replaced(lf.substr(0, body), "element face", "comment of the faces\nelement face"),
                      rest = lf.substr(body);
    for (const char* end : {"\r\n", "\r"}) {
      SCOPED_TRACE(testing::PrintToString(end));
      expect_the_same(import_bytes("b.ply", replaced(header, "\n", end) + rest), *plain.part);
    }
    expect_the_same(import_bytes("b.ply", mixed_ends(header) + rest), *plain.part);
  }
}

TEST(TextVariants, AnLfBehindTheLastCrOfAPlysHeaderIsTheBodysFirstByte) {
  TriangleSoup soup = block();
  double& first = soup.vertices_P(0, 0);
  first = std::bit_cast<double>((std::bit_cast<std::uint64_t>(first) & ~std::uint64_t{0xff}) | 0x0a);
  const std::string lf = binary_ply(soup);
  const std::size_t body = lf.find("end_header\n") + 11;
  ASSERT_EQ(lf[body], '\n');
  const ImportedPart plain = import_bytes("b.ply", lf);
  const ImportedPart bare = import_bytes("b.ply", replaced(lf.substr(0, body), "\n", "\r") + lf.substr(body));
  ASSERT_NE(bare.part, nullptr) << bare.verdict.error;
  EXPECT_EQ(bare.part->vertices, plain.part->vertices);
}

TEST(TextVariants, BinaryDataBehindAMarkOfUtf8IsRefused) {
  for (const auto bytes_of : {binary_stl, binary_ply}) {
    const auto imported =
        import_bytes(bytes_of == binary_stl ? "b.stl" : "b.ply", "\xef\xbb\xbf" + bytes_of(block()));
    EXPECT_THAT(imported.verdict.error, HasSubstr("a text tool has changed it"));
  }
}

TEST(TextVariants, ABinaryStlIsNotTakenForATextWhateverItsHeaderSays) {
  std::string bytes = binary_stl(block());
  const ImportedPart plain = import_bytes("b.stl", bytes);
  bytes.replace(0, 12, "\xef\xbb\xbfsolid\r\r\x1a\x1a");
  expect_the_same(import_bytes("b.stl", bytes), *plain.part);
}

TEST(TextVariants, LinesThatRunTogetherAreRefusedNotPassedOver) {
  const std::string obj = obj_text(block()), stl = text_stl(block());
  const auto refusal = [](const char* name, const std::string& bytes) {
    return import_bytes(name, bytes).verdict.error;
  };
  EXPECT_THAT(refusal("t.obj", replaced(obj, "\nv", "\fv")), HasSubstr("line 1: 'v' is not a number"));
  EXPECT_THAT(refusal("t.obj", obj + "7 8 9\n"), HasSubstr("'7' begins no line of an OBJ"));
  EXPECT_THAT(refusal("t.obj", obj + "\xc2\xa0v 1 2 3\n"), HasSubstr("begins no line of an OBJ"));
  EXPECT_THAT(refusal("t.stl", replaced(stl, "\n", " ")), HasSubstr("a facet on the line"));
  EXPECT_THAT(refusal("t.stl", replaced(stl, "\n facet", "\n color 1 0 0 facet")),
              HasSubstr("'facet' is not a number in a colour"));
}

TEST(TextVariants, ACommentThatEndsInABackslashSwallowsNoVertex) {
  const std::string obj = obj_text(block());
  const ImportedPart plain = import_bytes("t.obj", obj);
  const std::string path = "# C:\\models\\\n";
  expect_the_same(import_bytes("t.obj", path + obj), *plain.part);
  expect_the_same(import_bytes("t.obj", replaced(path + obj, "\n", "\r\n")), *plain.part);
  // Nor behind a line that goes on with the next.
  const std::string joined = obj.substr(0, obj.find(' ')) + " \\\n" + obj.substr(obj.find(' '));
  expect_the_same(import_bytes("t.obj", joined.substr(0, joined.find("\nv") + 1) + path +
                                            joined.substr(joined.find("\nv") + 1)),
                  *plain.part);
}

TEST(TextVariants, AWordThatIsNoneOfObjsIsToldWithItsLine) {
  const ImportedPart imported = import_bytes("t.obj", "V 1 2 3\n" + obj_text(block()));
  ASSERT_NE(imported.part, nullptr) << imported.verdict.error;
  EXPECT_THAT(imported.verdict.warnings, testing::Contains(HasSubstr("none of OBJ's ('V' on line 1)")));
}

}  // namespace
}  // namespace fingerpad::text_variants_test
