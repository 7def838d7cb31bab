#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "base/error.hpp"
#include "device/device_table.hpp"
#include "part/import.hpp"
#include "part/mesh_format.hpp"
#include "replay/figures.hpp"
#include "replay/summary_column.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_key.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"

// A mesh format, a scene key and a live device, added as rows_test.cpp adds a method, normals, a law and a
// column.

namespace fingerpad {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& scene) {
  try {
    read_scene_text(scene, "s.toml");
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(AddedKey, IsReadRangedHintedSetAndShown) {
  const std::string plane = "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[finger]\n";
  EXPECT_EQ(read_scene_text(plane + "pad_radius_m = 0.004\n", "s.toml").scene.finger.radius_m, 0.004);
  EXPECT_THAT(refusal(plane + "pad_radius_m = 2\n"), HasSubstr("at least 0 and at most 1"));
  EXPECT_THAT(refusal(plane + "pad_radus_m = 0.1\n"), HasSubstr("did you mean 'pad_radius_m'?"));
  EXPECT_THAT(refusal(plane + "colour = 1\n"), HasSubstr("known: radius_m, pad_radius_m, direction"));
  const SceneFile set = read_scene_text(plane + "[[set]]\nfinger.pad_radius_m = [0.001, 0.002]\n", "s.toml");
  ASSERT_EQ(set.jobs.size(), 2u);
  EXPECT_EQ(set.jobs[1].scene.finger.radius_m, 0.002);
  EXPECT_THAT(scene_keys_text(), HasSubstr("\npad_radius_m = 0               # as a ball\n"));
  EXPECT_THAT(scene_keys_text(), HasSubstr("# or closest-point, proxy, brute-force; auto: "));
}

TEST(AddedFormat, IsReadAndTold) {
  const TriangleSoup box = test::box_soup({0.1, 0.1, 0.1});
  std::ostringstream text;
  for (Eigen::Index t = 0; t < box.triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) text << box.vertices_P.col(box.triangles(k, t)).transpose() << '\n';
  }
  const auto folder = test::scratch_dir();
  const auto path = test::write_file(folder, "box.tri", text.str());
  const ImportedPart imported = import_touchable(path.string(), 1, 0.5);
  EXPECT_EQ(imported.verdict.format, "TRI");
  EXPECT_EQ(imported.verdict.kept, 12);
  EXPECT_TRUE(imported.verdict.closed);
  EXPECT_NEAR(imported.verdict.volume_m3, 1e-3, 1e-12);  // six digits were written of each coordinate
  EXPECT_EQ(mesh_format_names("or"), "STL, OBJ, PLY, OFF or TRI");

  test::write_file(folder, "box.tri", "1 2 x");
  EXPECT_THAT(import_part(path.string(), 1, 0.5).verdict.error, HasSubstr("line 1: 'x' is not a number"));
  const auto other = test::write_file(folder, "box.xyz", text.str());
  EXPECT_THAT(import_part(other.string(), 1, 0.5).verdict.error,
              HasSubstr("STL, OBJ, PLY, OFF and TRI are read"));
}

TEST(AddedDevice, IsFoundToldAndMade) {
  const DeviceEntry* still = find_device("still");
  ASSERT_NE(still, nullptr);
  EXPECT_THAT(device_help_text(), HasSubstr("  still            a finger that stays where it is\n"));
  const auto device = still->make({Scene{}, nullptr, {0, Vec3(1, 2, 3)}});
  device->set_target({0, Vec3(4, 5, 6)});
  EXPECT_EQ(device->advance(0.5).p_WQ, Vec3(1, 2, 3));
  EXPECT_EQ(find_device("stil"), nullptr);
  EXPECT_EQ(device_table().front().name, "mouse");
  EXPECT_EQ(find_device("pointer"), &device_table().front());
  EXPECT_EQ(find_device(""), nullptr);
}

TEST(AddedFigure, IsCountedAndStandsInTheTableAndInItsSchema) {
  Figures figures;
  TickRecord torn;
  torn.phase = Phase::slip;
  torn.ruptures = 1;
  for (int k = 0; k < 3; ++k) figures.observe(torn);
  ASSERT_EQ(Figures::names()[1], "teeth");
  EXPECT_EQ(Figures::of(figures.values(), "teeth"), 2);
  EXPECT_EQ(Figures::of(figures.values(), "contact_ticks"), 3) << "those behind it stay what they were";
  EXPECT_THAT(summary_header({}), testing::Contains("teeth"));
  EXPECT_THAT(summary_schema_text({}), HasSubstr("teeth of stick and slip"));
}

/// What src/README.md says of adding to the house.
std::string readme_of_adding() {
  const std::string text = test::bytes_of(test::source_dir() / "src" / "README.md");
  const std::size_t from = text.find("## To add"), to = text.find("\n## ", from);
  EXPECT_NE(to, std::string::npos);
  return text.substr(from, to - from);
}

TEST(SourceReadme, NamesTheTablesThatWereAddedToHere) {
  const std::string adding = readme_of_adding();
  std::istringstream tables(FINGERPAD_TABLES_WITH_ROWS);
  int count = 0;
  for (std::string table; tables >> table; ++count) EXPECT_THAT(adding, HasSubstr("`" + table + "`"));
  EXPECT_EQ(count, 8);
}

TEST(SourceReadme, NamesNoFileThatIsNot) {
  const std::string adding = readme_of_adding();
  const auto is_path = testing::MatchesRegex("[a-z]+/[a-z_/]+(\\.[a-z]+)?");
  std::istringstream quoted(adding);
  int count = 0;
  std::string name;
  // Every second stretch between backticks is quoted.
  for (bool is_quoted = false; std::getline(quoted, name, '`'); is_quoted = !is_quoted) {
    if (!is_quoted || !testing::Value(name, is_path)) continue;
    ++count;
    const bool outside = name.starts_with("tests/") || name.starts_with("tools/");
    const auto path = outside ? test::source_dir() / name : test::source_dir() / "src" / name;
    EXPECT_TRUE(std::filesystem::exists(path)) << name;
  }
  EXPECT_GT(count, 8);
}

}  // namespace
}  // namespace fingerpad
