#include "scene/scene_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "friction/law_table.hpp"
#include "scene_text.hpp"
#include "support/paths.hpp"

namespace fingerpad::scene_file_test {
namespace {

using test::plane_scene;
using test::read_scene;

const std::string contract_profile =
    "lateral_axis_m = 3e-4\nlongitudinal_axis_m = 2.4e-4\nsource = \"a test\"\n";

/// The sample of the contract, word for word but for the methods that are not built.
const std::string contract_scene = R"(name = "bracket"
seed = 7

[[part]]                       # or [[plane]] with point_m and normal, which needs no mesh
mesh = "parts/bracket.stl"     # relative to this file, or absolute; so are all paths in a scene
unit = "cm"                    # m, mm, cm, in
position_m = [0, 0.5, -1]
rotation = { axis = [0,0,1], angle_deg = 90 }
crease_deg = 40
stiffness_n_per_m = 1500
damping_n_s_per_m = 0.25
mu_static = 0.4
mu_dynamic = 0.1

[contact]
method = "closest-point"
normals = "facet"

[friction]
law = "stick-slip"
v_min_m_per_s = 0.05
restick = "crossing"
stick_stiffness_per_m = 300
vibration = { frequency_hz = 80, bandwidth_hz = 10, amplitude = 0.03, normal_amplitude = 0.01 }

[finger]
radius_m = 0.002
direction = [0, 0.7071, -0.7071]
profile = "profiles/default.toml"

[motion]
file = "motions/rub.csv"
rate_hz = 500

[hand]
mass_kg = 0.1
damping_n_s_per_m = 0.6
stiffness_n_per_m = 150
encoder_m = 1e-5
delay_ticks = 2
coulomb_n = 0.01
axes = "xz"
)";

TEST(SceneFile, ReadsEveryKeyOfTheContract) {
  const auto folder = test::scratch_dir();
  test::write_file(folder / "profiles/default.toml", contract_profile);
  test::write_file(folder / "b.toml", contract_scene);
  const std::string path = (folder / "b.toml").string();
  const SceneFile file = read_scene_file(path);
  const Scene& s = file.scene;
  EXPECT_FALSE(file.is_set);
  ASSERT_EQ(file.jobs.size(), 1u);
  EXPECT_EQ(file.jobs[0].number, 0);
  EXPECT_EQ(s.name, "bracket");
  EXPECT_EQ(s.path, path);
  EXPECT_EQ(s.seed, 7u);
  EXPECT_EQ(s.text, contract_scene);
  ASSERT_EQ(s.parts.size(), 1u);
  const PartEntry& part = s.parts[0];
  EXPECT_EQ(part.mesh, "parts/bracket.stl");
  EXPECT_EQ(part.mesh_path, (folder / "parts/bracket.stl").string());
  EXPECT_EQ(part.metres_per_unit, 0.01);
  EXPECT_EQ(part.position_m, Vec3(0, 0.5, -1));
  // A quarter turn about z takes x to y; the cosine of a rounded pi/2 is not quite 0.
  EXPECT_LT((part.rotation * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_EQ(part.crease_deg, 40);
  EXPECT_EQ(part.surface.stiffness_n_per_m, 1500);
  EXPECT_EQ(part.surface.damping_n_s_per_m, 0.25);
  EXPECT_EQ(part.surface.mu_static, 0.4);
  EXPECT_EQ(part.surface.mu_dynamic, 0.1);
  EXPECT_EQ(s.contact.method, "closest-point");
  EXPECT_EQ(s.contact.normals, Normals::facet);
  EXPECT_EQ(s.friction.law, "stick-slip");
  EXPECT_EQ(s.friction.settings.restick, Restick::crossing);
  EXPECT_EQ(s.friction.settings.numbers.at("v_min_m_per_s"), 0.05);
  EXPECT_EQ(s.friction.settings.numbers.at("stick_stiffness_per_m"), 300);
  ASSERT_TRUE(s.friction.vibration.has_value());
  EXPECT_EQ(s.friction.vibration->frequency_hz, 80);
  EXPECT_EQ(s.friction.vibration->bandwidth_hz, 10);
  EXPECT_EQ(s.friction.vibration->amplitude, 0.03);
  EXPECT_EQ(s.friction.vibration->normal_amplitude, 0.01);
  ASSERT_TRUE(s.friction.settings.profile.has_value());
  EXPECT_EQ(s.friction.settings.profile->lateral_axis_m, 3e-4);
  EXPECT_EQ(s.finger.radius_m, 0.002);
  // Made unit by another order of the same operations.
  EXPECT_LT((s.finger.direction - Vec3(0, 0.7071, -0.7071).normalized()).norm(), 1e-15);
  EXPECT_EQ(s.finger.profile, "profiles/default.toml");
  EXPECT_EQ(s.motion.file, "motions/rub.csv");
  EXPECT_EQ(s.motion.file_path, (folder / "motions/rub.csv").string());
  EXPECT_EQ(s.motion.rate_hz, 500);
  ASSERT_TRUE(s.hand.has_value());
  EXPECT_EQ(s.hand->mass_kg, 0.1);
  EXPECT_EQ(s.hand->damping_n_s_per_m, 0.6);
  EXPECT_EQ(s.hand->stiffness_n_per_m, 150);
  EXPECT_EQ(s.hand->encoder_m, 1e-5);
  EXPECT_EQ(s.hand->delay_ticks, 2);
  EXPECT_EQ(s.hand->coulomb_n, 0.01);
  EXPECT_TRUE(s.hand->free_axis[0] && !s.hand->free_axis[1] && s.hand->free_axis[2]);
}

TEST(SceneFile, DefaultsAreTheDocumentedOnes) {
  const Scene s = read_scene("[[part]]\nmesh = \"a.stl\"\n");
  EXPECT_EQ(s.name, "s");  // the file's stem
  EXPECT_EQ(s.seed, 1u);
  EXPECT_EQ(s.parts[0].metres_per_unit, 1e-3);
  EXPECT_EQ(s.parts[0].crease_deg, 30);
  EXPECT_EQ(s.parts[0].rotation, Mat3(Mat3::Identity()));
  EXPECT_EQ(s.parts[0].surface.stiffness_n_per_m, 1000);
  EXPECT_EQ(s.parts[0].surface.mu_static, 0.3);
  EXPECT_EQ(s.parts[0].surface.mu_dynamic, 0.2);
  EXPECT_EQ(s.contact.method, automatic_method);
  EXPECT_EQ(s.contact.normals, Normals::smooth);
  EXPECT_EQ(s.friction.law, "finger-pad");
  EXPECT_EQ(s.friction.settings.restick, Restick::level);
  EXPECT_FALSE(s.friction.vibration.has_value());
  EXPECT_FALSE(s.friction.settings.profile.has_value());
  EXPECT_EQ(s.finger.radius_m, 0);
  EXPECT_EQ(s.motion.rate_hz, 1000);
  EXPECT_FALSE(s.motion.given());
  EXPECT_FALSE(s.hand.has_value());
}

TEST(SceneFile, NormalsAreCalledByTheirNames) {
  const auto normals = [](const std::string& name) {
    return test::read_scene(test::plane_scene + "[contact]\nnormals = \"" + name + "\"\n").contact.normals;
  };
  EXPECT_EQ(normals("facet"), Normals::facet);
  EXPECT_EQ(normals("smooth"), Normals::smooth);
  EXPECT_EQ(normals("curved"), Normals::curved);
}

TEST(SceneFile, AcceptsTheNumbersOfEveryLaw) {
  for (const LawEntry& law : law_table()) {
    std::string text = plane_scene + "[friction]\nlaw = \"" + std::string(law.name) + "\"\n";
    for (const LawParameter& parameter : law.parameters) {
      text += std::string(parameter.key) + " = " +
              std::to_string(std::min(parameter.min + 1, parameter.max)) + "\n";
    }
    const Scene s = read_scene(text);
    EXPECT_EQ(s.friction.settings.numbers.size(), law.parameters.size()) << law.name;
  }
}

TEST(SceneFile, RefusesANumberAboveALawsOwnBound) {
  EXPECT_THROW(read_scene(plane_scene + "[friction]\nlaw = \"elasto-plastic\"\nelastic_share = 1.5\n"),
               Error);
}

TEST(SceneFile, KeysOfOtherLawsOfASetDoNotDisturb) {
  const SceneFile file = read_scene_text(
      plane_scene + "[friction]\nv_min_m_per_s = 0.2\n[[set]]\nfriction.law = [\"none\", \"stick-slip\"]\n",
      "s.toml");
  ASSERT_EQ(file.jobs.size(), 2u);
  for (const SceneJob& job : file.jobs) {
    EXPECT_EQ(job.error, "");
    EXPECT_EQ(job.scene.friction.settings.numbers.at("v_min_m_per_s"), 0.2);
  }
}

TEST(SceneFile, PathsAreFoundBesideTheSceneUnlessAbsolute) {
  const auto part_of = [](const std::string& mesh, const std::string& scene) {
    return read_scene_text("[[part]]\nmesh = \"" + mesh + "\"\n", scene).scene.parts[0].mesh_path;
  };
  EXPECT_EQ(part_of("a.stl", "s.toml"), "a.stl");
  EXPECT_EQ(part_of("a.stl", "dir/s.toml"), "dir/a.stl");
  EXPECT_EQ(part_of("/x/a.stl", "dir/s.toml"), "/x/a.stl");
}

TEST(SceneFile, ReadsPlanesAndScriptedMotions) {
  const Scene line = read_scene(plane_scene +
                                "[motion]\nkind = \"line\"\nfrom_m = [0, 0, 0]\nto_m = [0.3, 0, 0.4]\n"
                                "speed_m_per_s = 0.25\n");
  ASSERT_EQ(line.planes.size(), 1u);
  ASSERT_TRUE(line.motion.scripted.has_value());
  EXPECT_EQ(line.motion.scripted->kind, ScriptedMotion::Kind::line);
  EXPECT_DOUBLE_EQ(line.motion.scripted->duration_s, 2);  // 0.5 m at 0.25 m/s

  const Scene sine = read_scene(plane_scene +
                                "[motion]\nkind = \"sine\"\ncentre_m = [0, 0, 1]\ndirection = [0, 2, 0]\n"
                                "amplitude_m = 0.01\nfrequency_hz = 2\nduration_s = 3\n");
  EXPECT_EQ(sine.motion.scripted->direction, Vec3(Vec3::UnitY()));
  EXPECT_EQ(sine.motion.scripted->amplitude_m, 0.01);

  const Scene circle =
      read_scene(plane_scene +
                 "[motion]\nkind = \"circle\"\ncentre_m = [0, 0, 1]\nnormal = [0, 0, 3]\n"
                 "direction = [1, 0, 5]\nradius_m = 0.02\nfrequency_hz = 2\nduration_s = 3\n");
  EXPECT_EQ(circle.motion.scripted->normal, Vec3(Vec3::UnitZ()));
  EXPECT_EQ(circle.motion.scripted->direction, Vec3(Vec3::UnitX()));  // the part of it across the normal
  EXPECT_EQ(circle.motion.scripted->amplitude_m, 0.02);
}

TEST(SceneFile, ACircleWithoutADirectionStartsAcrossItsNormal) {
  for (const char* normal : {"[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]", "[1, 1, 1]", "[-1, 2, 0.1]"}) {
    const Scene s =
        read_scene(plane_scene + "[motion]\nkind = \"circle\"\ncentre_m = [0, 0, 0]\nnormal = " + normal +
                   "\nradius_m = 0.02\nfrequency_hz = 2\nduration_s = 3\n");
    // Across to the rounding of a projection.
    EXPECT_LT(std::abs(s.motion.scripted->direction.dot(s.motion.scripted->normal)), 1e-15) << normal;
    EXPECT_NEAR(s.motion.scripted->direction.norm(), 1, 1e-15) << normal;
  }
}

TEST(SceneFile, SceneOfAMeshReadsBackFromItsText) {
  const Scene s = scene_of_mesh("a \"b\"/c.stl", 0.0254);
  EXPECT_EQ(s.name, "c");
  EXPECT_EQ(s.path, "");
  ASSERT_EQ(s.parts.size(), 1u);
  EXPECT_EQ(s.parts[0].mesh_path, "a \"b\"/c.stl");
  const Scene again = read_scene_text(s.text, s.path).scene;
  EXPECT_EQ(again.parts[0].mesh_path, s.parts[0].mesh_path);
  EXPECT_EQ(again.parts[0].metres_per_unit, 0.0254);
}

TEST(SceneFile, CreaseAnglesAreReadFromTextAlone) {
  const std::string text =
      "[[part]]\nmesh = \"a\"\ncrease_deg = 12\n[[part]]\nmesh = \"b\"\n[finger]\nprofile = \"absent\"\n";
  EXPECT_THAT(part_crease_degs(text), testing::ElementsAre(12, 30));
  EXPECT_TRUE(part_crease_degs("no [ toml").empty());
}

}  // namespace
}  // namespace fingerpad::scene_file_test
