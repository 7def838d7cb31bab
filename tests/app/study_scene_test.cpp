#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shapes.hpp"
#include "support/shell.hpp"

// `study scene`, from the command line to its files.

namespace fingerpad::study_scene_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

const std::string plane = "name = \"rub\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n";
const std::string rub =
    "[motion]\nkind = \"sine\"\ncentre_m = [0, 0, -0.001]\namplitude_m = 0.005\nfrequency_hz = 1\n"
    "duration_s = 0.4\n";

fs::path folder_with(const std::string& scene) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "rub.toml") << scene;
  std::ofstream(folder / "box.stl") << test::text_stl(test::box_soup({20, 20, 10}));
  return folder;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::istringstream text(bytes_of(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

void expect_refused(const std::string& scene, int code, const std::string& words) {
  const auto result = test::fingerpad("study scene rub.toml --out o", folder_with(scene));
  EXPECT_EQ(result.exit_code, code) << result.err;
  EXPECT_THAT(result.err, HasSubstr(words));
}

TEST(StudyScene, WritesEveryChoiceAndTheLinesToPaste) {
  const std::string part = "name = \"rub\"\n[[part]]\nmesh = \"box.stl\"\n";
  const std::string on_top =
      "[motion]\nkind = \"sine\"\ncentre_m = [0, 0, 0.0045]\namplitude_m = 0.005\nfrequency_hz = "
      "1\nduration_s = "
      "0.2\n";
  const fs::path folder = folder_with(part + on_top);
  const auto result = test::fingerpad("study scene rub.toml --out o", folder);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(StartsWith("rub: "), HasSubstr("o/scene.toml")));
  const auto lines = lines_of(folder / "o" / "choices.csv");
  ASSERT_EQ(lines.size(), 1u + 2 * 3 * 7 * 2 + 1);  // methods, normals, rates, events; and the model
  EXPECT_THAT(lines[0], StartsWith("method,normals,rate_hz,events,force_rms_share,ns_per_tick,keeps,"));
  EXPECT_THAT(lines[1], StartsWith("closest-point,facet,250,exact,"));
  EXPECT_THAT(lines.back(), StartsWith("proxy,curved,40000,exact,0,"));
  const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  EXPECT_THAT(lines.back(), MatchesRegex(".*,model,"));  // what it loses is empty
  EXPECT_EQ(commas(lines.back()), commas(lines[0]));
  for (const std::string& line : lines) EXPECT_GE(commas(line), commas(lines[0]));
  EXPECT_EQ(commas(lines[1].substr(0, lines[1].find('"'))), commas(lines[0]));
  // What is pasted is a scene's, and is replayed.
  std::string kept = bytes_of(folder / "o" / "scene.toml");
  for (const char* word :
       {"[contact]\nmethod = \"", "\nnormals = \"", "[friction]\nevents = \"", "rate_hz = "})
    EXPECT_THAT(kept, HasSubstr(word));
  kept.replace(kept.find("[motion]\n"), 9, on_top);
  std::ofstream(folder / "kept.toml") << part << kept;
  EXPECT_EQ(test::fingerpad("replay kept.toml --out p --quiet", folder).exit_code, 0) << kept;
}

TEST(StudyScene, IsTheSameAtEveryRunButForTimes) {
  const fs::path folder = folder_with(plane + rub);
  const auto untimed = [&](const std::string& out) {
    EXPECT_EQ(test::fingerpad("study scene rub.toml --out " + out, folder).exit_code, 0);
    std::string all;
    for (const std::string& line : lines_of(folder / out / "choices.csv")) {
      std::istringstream cells(line);
      std::string cell;
      // Times, what follows from them, and the mark of the cheapest are left out.
      for (int column = 0; std::getline(cells, cell, ','); ++column)
        all += column == 5 || (column >= 20 && column <= 22) ? "" : cell + ',';
      all += '\n';
    }
    return all;
  };
  const std::string first = untimed("o");
  EXPECT_EQ(first, untimed("p"));
  EXPECT_THAT(bytes_of(folder / "o" / "choices.csv"), HasSubstr(",auto"));
  EXPECT_EQ(std::count(first.begin(), first.end(), '\n'), 1 + 7 * 2 + 1);  // a plane searches for nothing
}

TEST(StudyScene, RefusesWhatItCannotCompareWithTheMend) {
  expect_refused(plane, 3, "the scene has no motion to follow");
  expect_refused(plane + rub + "[[set]]\nfriction.law = [\"dahl\", \"lugre\"]\n", 3,
                 "rub.toml: is a set of 2 jobs, which differ in 'friction.law'");
  expect_refused("[[plane]]\npoint_m = [0, 0, -1]\nnormal = [0, 0, 1]\n" + rub, 3, "touches nothing");
  expect_refused("[[part]]\nmesh = \"none.stl\"\n" + rub, 3, "none.stl");
}

TEST(StudyScene, TakesASetOfNothingButChoicesForOneScene) {
  const fs::path folder = folder_with(plane + rub + "[[set]]\nmotion.rate_hz = [250, 500]\n");
  EXPECT_EQ(test::fingerpad("study scene rub.toml --out o", folder).exit_code, 0);
}

TEST(StudyScene, FollowsTheWayOfAHand) {
  const std::string hand = "[hand]\nmass_kg = 0.072\nencoder_m = 0\n";
  const fs::path folder = folder_with(plane + "[friction]\nlaw = \"none\"\n" + rub + hand);
  const auto result = test::fingerpad("study scene rub.toml --out o", folder);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("in its [hand]"));
  // SCIENCE 4: 1001 N/m is held at 1 kHz and 2002 at 2 kHz; half of that is kept in reserve.
  const auto lines = lines_of(folder / "o" / "choices.csv");
  ASSERT_EQ(lines.size(), 1u + 7 + 1);
  EXPECT_THAT(lines[3],
              AllOf(HasSubstr(",1000,exact,"), HasSubstr(",false,"), HasSubstr("holds up to 1001 N/m")));
  EXPECT_THAT(lines[4], AllOf(HasSubstr(",2000,exact,"), HasSubstr(",true,")));
}

TEST(StudyScene, NeverWritesOverWhatItReads) {
  const fs::path folder = folder_with(plane + rub);
  fs::rename(folder / "rub.toml", folder / "scene.toml");
  const std::string before = bytes_of(folder / "scene.toml");
  EXPECT_NE(test::fingerpad("study scene scene.toml --out .", folder).exit_code, 0);
  EXPECT_EQ(bytes_of(folder / "scene.toml"), before);
}

TEST(StudyScene, IsUsedWithASceneAndNoOtherStudyIs) {
  const fs::path folder = folder_with(plane + rub);
  for (const char* call : {"study scene --out o", "study friction rub.toml --out o"}) {
    const auto result = test::fingerpad(call, folder);
    EXPECT_EQ(result.exit_code, 2) << call;
    EXPECT_THAT(result.err, HasSubstr("scene")) << call;
  }
}

TEST(AutomaticRate, IsToldAndKeptInTheTrace) {
  const fs::path folder = folder_with(plane + "[motion]\nrate_hz = \"auto\"\n" + rub.substr(9));
  const auto result = test::fingerpad("replay rub.toml --out o --format csv", folder);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("because held from tick to tick at 1000 Hz"));
  EXPECT_EQ(lines_of(folder / "o" / "rub.csv").size(), 1u + 801);
}

}  // namespace
}  // namespace fingerpad::study_scene_test
