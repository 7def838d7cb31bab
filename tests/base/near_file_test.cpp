#include "base/near_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/paths.hpp"

namespace fingerpad::near_file_test {
namespace {

namespace fs = std::filesystem;

/// A fresh folder with these files, and folders where a name ends in a slash.
fs::path folder_with(const std::vector<std::string>& names) {
  const fs::path folder = test::scratch_dir();
  for (const std::string& name : names) {
    if (name.ends_with('/'))
      fs::create_directories(folder / name);
    else
      std::ofstream(folder / name) << "x";
  }
  return folder;
}

std::string near_name(const fs::path& folder, const std::string& asked) {
  return near_file(folder / asked).filename().string();
}

TEST(NearFile, MayBeMisspelledInItsNameItsCaseAndItsEnding) {
  const fs::path folder = folder_with({"bracket.stl", "bracket.toml", "rub.csv", "a.stl"});
  for (const char* asked : {"brackt.stl", "Bracket.stl", "BRACKET.STL", "bracket.STL", "brackt.slt"})
    EXPECT_EQ(near_name(folder, asked), "bracket.stl") << asked;
  for (const char* asked : {"bracket.tml", "bracket.TOML", "brackett.tom"})
    EXPECT_EQ(near_name(folder, asked), "bracket.toml") << asked;
  EXPECT_EQ(near_name(folder, "rub.cvs"), "rub.csv");
  EXPECT_EQ(near_name(folder, "a.STL"), "a.stl");
}

TEST(NearFile, OfAnotherEndingOrAnotherNameIsNotMeant) {
  const fs::path folder = folder_with({"bracket.toml", "rub.csv", "a.stl", "readme"});
  for (const char* asked : {"bracket.stl", "bracket.obj", "tap.csv", "b.stl", "rub", "readme.csv", ""})
    EXPECT_EQ(near_name(folder, asked), "") << asked;
}

TEST(NearFile, OfOtherDigitsIsAnotherTrials) {
  const fs::path folder = folder_with({"trial_01.csv", "knob.stl"});
  for (const char* asked :
       {"trial_02.csv", "Trial_02.csv", "trial_02.CSV", "trail_02.csv", "trial.csv", "knob2.stl"})
    EXPECT_EQ(near_name(folder, asked), "") << asked;
  EXPECT_EQ(near_name(folder, "trail_01.csv"), "trial_01.csv");
  EXPECT_EQ(near_name(folder, "trial_01.CSV"), "trial_01.csv");
}

TEST(NearFile, IsTheSameNameBeforeANearOne) {
  const fs::path folder = folder_with({"bracket.toml", "brackets.tml", "knob.STL", "knob.stl"});
  EXPECT_EQ(near_name(folder, "bracket.tml"), "bracket.toml");
  EXPECT_EQ(near_name(folder, "knbo.stl"), "knob.stl") << "of two endings the one that was asked for";
}

TEST(NearFile, IsNoFolder) {
  EXPECT_EQ(near_name(folder_with({"bracket.stl/"}), "brackt.stl"), "");
}

TEST(NearFile, IsNotGuessedInAFolderOfThousands) {
  const fs::path folder = folder_with({"bracket.stl"});
  for (int i = 0; i < 1000; ++i) std::ofstream(folder / std::to_string(i)) << "x";
  EXPECT_EQ(near_name(folder, "brackt.stl"), "");
}

TEST(NearFolder, MayBeMisspelledWithThoseThatLeadToIt) {
  const fs::path folder = folder_with({"scenes/", "scenes/parts/", "scenes/run_1/", "partss"});
  EXPECT_EQ(near_folder(folder / "scenes" / "Parts"), folder / "scenes" / "parts");
  EXPECT_EQ(near_folder(folder / "scene" / "part"), folder / "scenes" / "parts");
  EXPECT_EQ(near_folder(folder / "scene" / "parts"), folder / "scenes" / "parts");
  EXPECT_EQ(near_folder(folder / "scene" / ""), folder / "scenes") << "with a slash at its end";
  EXPECT_EQ(near_folder(folder / "motions" / "parts"), "");
  EXPECT_EQ(near_folder(folder / "scenes" / "run_2"), "");
}

}  // namespace
}  // namespace fingerpad::near_file_test
