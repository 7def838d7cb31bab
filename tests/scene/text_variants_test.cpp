// Scenes and profiles as other programs and systems write them: read exactly right, or refused.
#include "support/text_variants.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "friction/pad_profile.hpp"
#include "scene/pad_profile_file.hpp"
#include "scene_text.hpp"
#include "support/paths.hpp"

namespace fingerpad::text_variants_test {
namespace {

/// Marks of UTF-8 and the line ends that TOML knows; a bare CR is none (TOML 1.0).
bool must_read(const test::TextVariant& variant) {
  const std::string name = variant.name;
  return name == "mark" || name == "mark and CR LF" || name == "CR LF" || name == "tabs" ||
         name == "blank lines between" || name == "blank lines first" || name == "no last end" ||
         name == "blanks before ends";
}

TEST(SceneTextVariants, AreReadExactlyRightOrRefused) {
  const std::string text =
      "name = 'n'  # a name = 'm'\n# [[plane]]\n[[plane]]\npoint_m = [1, 2, 3]\nnormal = [0, 0, 1]\n"
      "stiffness_n_per_m = 500\n# mu_static = 0.9\n[friction]\nlaw = 'coulomb'\n";
  for (const test::TextVariant& variant : test::text_variants()) {
    SCOPED_TRACE(variant.name);
    const auto path = test::scratch_dir() / "v.toml";
    test::write_file(path, variant.of(text));
    try {
      const Scene scene = read_scene_file(path.string()).scene;
      EXPECT_EQ(scene.name, "n");
      ASSERT_EQ(scene.planes.size(), 1u);
      EXPECT_EQ(scene.planes[0].point_m, Vec3(1, 2, 3));
      EXPECT_EQ(scene.planes[0].surface.stiffness_n_per_m, 500);
      EXPECT_EQ(scene.planes[0].surface.mu_static, SurfaceProperties().mu_static);
      EXPECT_EQ(scene.friction.law, "coulomb");
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      EXPECT_FALSE(must_read(variant)) << error.what();
    }
  }
}

TEST(ProfileTextVariants, AreReadExactlyRightOrRefused) {
  const std::string text =
      "lateral_axis_m = 3e-4\n# lateral_axis_m = 9e-4\nlongitudinal_axis_m = 2e-4\nmu_static = 0.4\n# end\n";
  for (const test::TextVariant& variant : test::text_variants()) {
    SCOPED_TRACE(variant.name);
    const auto path = test::scratch_dir() / "p.toml";
    test::write_file(path, variant.of(text));
    try {
      const PadProfile profile = read_profile(path.string());
      EXPECT_EQ(profile.lateral_axis_m, 3e-4);
      EXPECT_EQ(profile.longitudinal_axis_m, 2e-4);
      EXPECT_EQ(profile.mu_static, 0.4);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      EXPECT_FALSE(must_read(variant)) << error.what();
    }
  }
}

}  // namespace
}  // namespace fingerpad::text_variants_test
