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

TEST(ASecondReplay, KeepsTheSummaryOfAnotherScene) {
  const fs::path folder = folder_with_scenes();
  ASSERT_EQ(test::fingerpad("replay a.toml --quiet --out out", folder).exit_code, 0);
  const std::string summary = bytes_of(folder / "out" / "summary.csv");
  const auto second = test::fingerpad("replay b.toml --out out", folder);
  EXPECT_EQ(second.exit_code, 0);
  EXPECT_THAT(second.err,
              HasSubstr("out/summary.csv: was of scene 'a', which is not in this batch, and is kept "
                        "as summary.kept-1.csv"));
  EXPECT_EQ(bytes_of(folder / "out" / "summary.kept-1.csv"), summary);
  EXPECT_THAT(bytes_of(folder / "out" / "summary.csv"), HasSubstr("\nb,0,ok"));
  EXPECT_EQ(test::fingerpad("replay b.toml --quiet --out out", folder).err, "") << "its own it replaces";
  const auto third = test::fingerpad("replay a.toml --resume --out out", folder);
  EXPECT_THAT(third.err, HasSubstr("is kept as summary.kept-2.csv"));
  EXPECT_EQ(bytes_of(folder / "out" / "summary.csv"), summary);
  EXPECT_EQ(test::fingerpad("replay b.toml --quiet --out out --shard 1/2", folder).err, "")
      << "a shard has a summary of its own";
}

TEST(ASecondReplay, KeepsATableOfAnotherProgram) {
  const fs::path folder = folder_with_scenes();
  fs::create_directory(folder / "out");
  std::ofstream(folder / "out" / "summary.csv") << "income,year\n1,2026\n";
  const auto result = test::fingerpad("replay a.toml --out out", folder);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("was of another program"));
  EXPECT_EQ(bytes_of(folder / "out" / "summary.kept-1.csv"), "income,year\n1,2026\n");
}

}  // namespace
}  // namespace fingerpad::other_scene_test
