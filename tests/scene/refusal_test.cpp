#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "scene_text.hpp"
#include "support/paths.hpp"

namespace fingerpad::refusal_test {
namespace {

using test::plane_scene;
using test::refusal;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// Lines 1-4 are the plane's; what a test adds starts at line 5.

TEST(SceneRefusal, NamesFileLineAndColumnOfAnUnknownKey) {
  EXPECT_THAT(refusal(plane_scene + "[friction]\n  colour = \"red\"\n", "u.toml"),
              AllOf(StartsWith("u.toml:6:3: unknown key 'colour' in [friction]"), HasSubstr("known: law, ")));
  EXPECT_THAT(refusal("sed = 1\n" + plane_scene),
              StartsWith("s.toml:1:1: unknown key 'sed' in the scene; did you mean 'seed'?"));
  EXPECT_THAT(refusal(plane_scene + "mu_statc = 0.3\n"),
              StartsWith("s.toml:5:1: unknown key 'mu_statc' in [[plane]]; did you mean 'mu_static'?"));
  EXPECT_THAT(refusal("[[part]]\nmesh = \"a\"\nrotation = { axis = [0,0,1], angle = 3 }\n"),
              StartsWith("s.toml:3:30: unknown key 'angle' in rotation of [[part]]"));
  EXPECT_THAT(refusal(plane_scene + "[friction]\nvibration = { hz = 3 }\n"),
              StartsWith("s.toml:6:15: unknown key 'hz' in vibration of [friction]"));
}

TEST(SceneRefusal, NamesTheTableOfAKeyThatStandsInAnother) {
  EXPECT_THAT(refusal("[[part]]\nmesh = \"a\"\nstick_stiffness = 800\n"),
              StartsWith("s.toml:3:1: unknown key 'stick_stiffness' in [[part]]; did you mean "
                         "'stick_stiffness_per_m' in [friction] or 'stick_stiffness_n_per_m' in [friction]? "
                         "(known: mesh, "));
  EXPECT_THAT(refusal(plane_scene + "[friction]\nmu_static = 0.3\n"),
              HasSubstr("; did you mean 'mu_static' in [[part]] or 'mu_static' in [[plane]]?"));
  // What is like a key of its own table is meant to be that one.
  EXPECT_THAT(refusal(plane_scene + "[contact]\nmethd = \"x\"\n"), HasSubstr("; did you mean 'method'?"));
  EXPECT_THAT(refusal("[[part]]\nmesh = \"a\"\ncolour = 3\n"), Not(HasSubstr("did you mean")));
}

TEST(SceneRefusal, AsksForADecimalPointWhereANumberHasAComma) {
  EXPECT_THAT(refusal(plane_scene + "mu_static = 0,3\n"),
              StartsWith("s.toml:5:14: a number has a comma: write a decimal point, as in 0.3"));
  EXPECT_THAT(refusal(plane_scene + "mu_static = 12,3 # high\n"), HasSubstr("decimal point"));
  EXPECT_THAT(refusal(plane_scene + "mu_static = 0.3, mu_dynamic = 0.2\n"), Not(HasSubstr("decimal point")));
  EXPECT_THAT(refusal(plane_scene + "[finger]\ndirection = [0,1 2]\n"), Not(HasSubstr("decimal point")));
}

TEST(SceneRefusal, NamesThePlaceOfAWrongType) {
  EXPECT_THAT(refusal(plane_scene + "mu_static = \"high\"\n"),
              StartsWith("s.toml:5:13: 'mu_static' in [[plane]] must be a number, not a string"));
  EXPECT_THAT(refusal(plane_scene + "[friction]\nlaw = 3\n"),
              StartsWith("s.toml:6:7: 'law' in [friction] must be a string, not a whole number"));
  EXPECT_THAT(refusal("seed = 1.5\n" + plane_scene),
              StartsWith("s.toml:1:8: 'seed' in the scene must be a whole"));
  EXPECT_THAT(refusal(plane_scene + "[finger]\ndirection = [0, 1]\n"),
              StartsWith("s.toml:6:13: 'direction' in [finger] must be a list of three numbers, not of 2"));
  EXPECT_THAT(refusal(plane_scene + "[finger]\ndirection = [0, 1, \"z\"]\n"), StartsWith("s.toml:6:13: "));
  EXPECT_THAT(refusal("contact = 3\n" + plane_scene),
              StartsWith("s.toml:1:1: 'contact' must be a table, [contact], not a whole number"));
  EXPECT_THAT(refusal("[part]\nmesh = \"a\"\n"), HasSubstr("write it as [[part]]"));
  EXPECT_THAT(refusal(plane_scene + "stiffness_n_per_m = 2020-01-01\n"), HasSubstr("not a date or time"));
  EXPECT_THAT(refusal(plane_scene + "[friction]\nvibration = true\n"), StartsWith("s.toml:6:13: "));
}

TEST(SceneRefusal, NamesThePlaceOfAnUnknownName) {
  EXPECT_THAT(refusal(plane_scene + "[friction]\nlaw = \"glue\"\n"),
              AllOf(StartsWith("s.toml:6:7: [friction]: unknown law 'glue'"), HasSubstr("stick-slip")));
  EXPECT_THAT(refusal(plane_scene + "[friction]\nlaw = \"stick-slp\"\n"),
              HasSubstr("did you mean 'stick-slip'?"));
  EXPECT_THAT(refusal(plane_scene + "[friction]\nrestick = \"x\"\n"), StartsWith("s.toml:6:11: "));
  EXPECT_THAT(refusal(plane_scene + "[contact]\nmethod = \"x\"\n"), StartsWith("s.toml:6:10: "));
  EXPECT_THAT(refusal(plane_scene + "[contact]\nnormals = \"x\"\n"), StartsWith("s.toml:6:11: "));
  EXPECT_THAT(refusal(plane_scene + "[motion]\nkind = \"spiral\"\n"), StartsWith("s.toml:6:8: "));
  EXPECT_THAT(refusal("[[part]]\nmesh = \"a\"\nunit = \"furlong\"\n"),
              StartsWith("s.toml:3:8: [[part]]: unknown unit 'furlong' (known: m, mm, cm, in, um)"));
}

TEST(SceneRefusal, ValuesOutOfRangeNameTheirPlace) {
  const struct {
    const char* lines;
    const char* place;
  } cases[] = {
      {"stiffness_n_per_m = 0\n", "s.toml:5:21: "},
      {"stiffness_n_per_m = -1\n", "s.toml:5:21: "},
      {"stiffness_n_per_m = nan\n", "s.toml:5:21: "},
      {"stiffness_n_per_m = inf\n", "s.toml:5:21: "},
      {"damping_n_s_per_m = -0.1\n", "s.toml:5:21: "},
      {"mu_static = -0.1\n", "s.toml:5:13: "},
      {"mu_static = 0.3\nmu_dynamic = 0.31\n", "s.toml:6:14: "},
      {"mu_static = 0.1\n", "s.toml:5:13: "},  // below the default mu_dynamic
      {"[motion]\nrate_hz = 0.5\n", "s.toml:6:11: "},
      {"[motion]\nrate_hz = 2e6\n", "s.toml:6:11: "},
      {"[finger]\nradius_m = -1\n", "s.toml:6:12: "},
      {"[finger]\ndirection = [0, 0, 0]\n", "s.toml:6:13: "},
      {"[finger]\ndirection = [0, inf, 0]\n", "s.toml:6:13: "},
      {"[friction]\nv_min_m_per_s = -1\n", "s.toml:6:17: "},
      {"[friction]\nvibration = { amplitude = -1 }\n", "s.toml:6:27: "},
      {"[hand]\nmass_kg = 0\n", "s.toml:6:11: "},
      {"[hand]\ndelay_ticks = -1\n", "s.toml:6:15: "},
      {"[hand]\naxes = \"xq\"\n", "s.toml:6:8: "},
      {"[hand]\naxes = \"xx\"\n", "s.toml:6:8: "},
      {"[[part]]\nmesh = \"a\"\ncrease_deg = 181\n", "s.toml:7:14: "},
      {"[[part]]\nmesh = \"a\"\nrotation = { axis = [0,0,0], angle_deg = 3 }\n", "s.toml:7:21: "},
      {"[[part]]\nmesh = \"\"\n", "s.toml:6:8: "},
      {"[[part]]\nmesh = \"a\\u0000b\"\n", "s.toml:6:8: "},
      {"[motion]\nfile = \"a\"\nkind = \"sine\"\n", "s.toml:7:8: "},
      {"[motion]\nfrequency_hz = 3\n", "s.toml:6:16: "},
      {"[motion]\nkind = \"circle\"\ncentre_m = [0,0,0]\ndirection = [0,0,1]\nradius_m = 1\nfrequency_hz = "
       "1\n"
       "duration_s = 1\n",
       "s.toml:8:13: "},
  };
  for (const auto& wrong : cases)
    EXPECT_THAT(refusal(plane_scene + wrong.lines), StartsWith(wrong.place)) << wrong.lines;
}

TEST(SceneRefusal, KeysOfAnotherKindOfMotionAreRefused) {
  EXPECT_THAT(refusal(plane_scene + "[motion]\nkind = \"sine\"\nfrom_m = [0,0,0]\n"),
              StartsWith("s.toml:7:10: 'from_m' in [motion] does not go with kind = \"sine\""));
}

TEST(SceneRefusal, MissingKeysNameTheirTable) {
  EXPECT_THAT(refusal("\n[[part]]\nunit = \"mm\"\n"),
              StartsWith("s.toml:2:1: [[part]] needs the key 'mesh'"));
  EXPECT_THAT(refusal("[[plane]]\npoint_m = [0,0,0]\n"),
              StartsWith("s.toml:1:1: [[plane]] needs the key 'normal'"));
  EXPECT_THAT(refusal("name = \"x\"\n"), StartsWith("s.toml: the scene has nothing to touch"));
  EXPECT_THAT(refusal(plane_scene + "[motion]\nkind = \"line\"\n"), StartsWith("s.toml:5:1: [motion] needs"));
}

TEST(SceneRefusal, AMissingProfileIsToldAtItsKey) {
  EXPECT_THAT(refusal(plane_scene + "[finger]\nprofile = \"no.toml\"\n", "x/s.toml"),
              StartsWith("x/s.toml:6:11: the profile x/no.toml cannot be read"));
}

TEST(SceneRefusal, NamesThatAreNoFileNamesAreRefused) {
  for (const char* name : {"", "a/b", "..", ".", "a\\\\b", "a\\nb"}) {
    EXPECT_THAT(refusal("name = \"" + std::string(name) + "\"\n[[plane]]\npoint_m=[0,0,0]\nnormal=[0,0,1]\n"),
                StartsWith("s.toml:1:8: "))
        << name;
  }
}

TEST(SceneRefusal, BadSyntaxNamesItsPlace) {
  EXPECT_THAT(refusal("a = 1\n[[part\n"), StartsWith("s.toml:2:"));
  EXPECT_THAT(refusal("a = 1\na = 2\n"), StartsWith("s.toml:2:"));
  EXPECT_THAT(refusal(std::string("\xff\xfe\x00\x41", 4)), StartsWith("s.toml:1:"));
}

TEST(SceneRefusal, AFileThatIsNoneIsToldAsWhatItIs) {
  EXPECT_THAT(([] {
                try {
                  read_scene_file("/no/such.toml");
                } catch (const Error& error) {
                  return std::string(error.what());
                }
                return std::string();
              })(),
              StartsWith("/no/such.toml: cannot be read"));
  EXPECT_THROW(read_scene_file(test::scratch_dir().string()), Error);
  EXPECT_THAT(refusal(std::string(5 << 20, ' ')), StartsWith("s.toml: is larger than"));
}

TEST(SceneRefusal, DeepNestingEndsInAMessage) {
  std::string dotted = "a";
  for (int i = 0; i < 200000; ++i) dotted += ".a";
  EXPECT_THAT(refusal(dotted + " = 1\n"), HasSubstr("a key of over"));
  EXPECT_THAT(refusal("x = 1\n[" + dotted + "]\n"), StartsWith("s.toml:2: a key of over"));
  EXPECT_THAT(refusal("x = \"\"\"\n\"\n\"\"\"\n[[set]]\nq = { " + dotted + " = 1 }\n"),
              StartsWith("s.toml:5: "));
  EXPECT_NE(refusal("a = " + std::string(200000, '[')), "");
  std::string tables = "a = ";
  for (int i = 0; i < 100000; ++i) tables += "{ a = ";
  EXPECT_NE(refusal(tables), "");
}

TEST(SceneRefusal, DotsInTextsAndNumbersAreNoDeepKeys) {
  EXPECT_EQ(refusal("# " + std::string(100, '.') + "\nname = \"" + std::string(100, '.') +
                    "a\"\n[[plane]]\npoint_m = [0.0, 0.0, 0.0]\nnormal = [0.0, 0.0, 1.0]\n"),
            "");
}

TEST(SceneRefusal, NoCutOrDamageOfASceneCrashes) {
  const std::string whole =
      plane_scene +
      "[friction]\nlaw = \"stick-slip\"\nvibration = { frequency_hz = 3 }\n[motion]\n"
      "kind = \"sine\"\ncentre_m = [0,0,0]\namplitude_m = 1\nfrequency_hz = 1\nduration_s = 1\n"
      "[[set]]\nfriction.law = [\"none\", \"coulomb\"]\nseed = [1, 2]\n";
  for (std::size_t length = 0; length <= whole.size(); ++length) refusal(whole.substr(0, length));
  std::srand(1);
  for (int round = 0; round < 3000; ++round) {
    std::string damaged = whole;
    for (int i = 0; i < 3; ++i) {
      damaged[static_cast<std::size_t>(std::rand()) % damaged.size()] = static_cast<char>(std::rand() % 256);
    }
    const std::string message = refusal(damaged);
    EXPECT_TRUE(message.empty() || message.find("s.toml") == 0) << message;
  }
}

}  // namespace
}  // namespace fingerpad::refusal_test
