#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/paths.hpp"
#include "support/shell.hpp"

// A second `replay` into a folder that holds results already.

namespace fingerpad::other_scene_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using testing::HasSubstr;

fs::path folder_with_scenes() {
  const fs::path folder = test::scratch_dir();
  for (const std::string name : {"a", "b"}) {
    std::ofstream(folder / (name + ".toml"))
        << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nkind = \"line\"\nfrom_m = [0, 0, "
           "-0.001]\nto_m = [0.01, 0, -0.001]\nspeed_m_per_s = 0.2\n";
  }
  return folder;
}

TEST(ASecondReplay, DoesNotReplaceTheSummaryOfAnotherScene) {
  const fs::path folder = folder_with_scenes();
  ASSERT_EQ(test::fingerpad("replay a.toml --quiet --out out", folder).exit_code, 0);
  const std::string summary = bytes_of(folder / "out" / "summary.csv");
  for (const std::string resume : {"", " --resume"}) {
    const auto result = test::fingerpad("replay b.toml --quiet --out out" + resume, folder);
    EXPECT_EQ(result.exit_code, 2) << resume;
    EXPECT_THAT(result.err, HasSubstr("out/summary.csv: is of scene 'a', which is not in this batch"));
    EXPECT_THAT(result.err, HasSubstr("--force"));
    EXPECT_EQ(bytes_of(folder / "out" / "summary.csv"), summary);
    EXPECT_FALSE(fs::exists(folder / "out" / "b.h5"));
  }
  EXPECT_EQ(test::fingerpad("replay b.toml --quiet --out out --shard 1/2", folder).exit_code, 0)
      << "a shard has a summary of its own";
  EXPECT_EQ(test::fingerpad("replay a.toml b.toml --resume --quiet --out out", folder).exit_code, 0);
  EXPECT_THAT(bytes_of(folder / "out" / "summary.csv"), HasSubstr("\nb,0,ok"));
  EXPECT_EQ(test::fingerpad("replay b.toml --force --quiet --out out", folder).exit_code, 0);
  EXPECT_EQ(test::fingerpad("replay b.toml --quiet --out out", folder).exit_code, 0) << "its own it replaces";
}

TEST(ASecondReplay, DoesNotReplaceATableOfAnotherProgram) {
  const fs::path folder = folder_with_scenes();
  fs::create_directory(folder / "out");
  std::ofstream(folder / "out" / "summary.csv") << "income,year\n1,2026\n";
  const auto result = test::fingerpad("replay a.toml --quiet --out out", folder);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("is of another program"));
}

}  // namespace
}  // namespace fingerpad::other_scene_test
