#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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

/// Every entry of a folder; files with their bytes and the moment of their last change.
std::vector<std::string> state_of(const fs::path& folder) {
  std::vector<std::string> state;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    state.push_back(entry.path().string());
    if (entry.is_regular_file())
      state.back() +=
          std::to_string(fs::last_write_time(entry).time_since_epoch().count()) + bytes_of(entry.path());
  }
  std::sort(state.begin(), state.end());
  return state;
}

TEST(ASecondReplay, OfALoneSceneThatIsRefusedLeavesTheFolderAsItWas) {
  const fs::path folder = folder_with_scenes();
  std::ofstream(folder / "torn.stl") << "solid torn\nfacet";
  const std::string motion = bytes_of(folder / "a.toml").substr(bytes_of(folder / "a.toml").find("[motion]"));
  std::ofstream(folder / "mesh.toml") << "[[part]]\nmesh = \"torn.stl\"\n" << motion;
  std::ofstream(folder / "motion.toml")
      << "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nfile = \"none.csv\"\n";
  ASSERT_EQ(test::fingerpad("replay a.toml --quiet --out out", folder).exit_code, 0);
  const auto before = state_of(folder / "out");
  for (const std::string scene : {"mesh.toml", "motion.toml", "none.toml"}) {
    const auto refused = test::fingerpad("replay " + scene + " --out out", folder);
    EXPECT_EQ(refused.exit_code, 3) << refused.err;
    EXPECT_THAT(refused.err, testing::Not(HasSubstr("kept")));
    EXPECT_EQ(refused.out, scene == "none.toml" ? "" : "0 of 1 job done, nothing in out\n");
    EXPECT_TRUE(state_of(folder / "out") == before) << scene;
    EXPECT_EQ(test::fingerpad("replay " + scene + " --out new/er", folder).exit_code, 3);
    EXPECT_FALSE(fs::exists(folder / "new")) << scene;
  }
  // Nothing that was there goes with what was made, behind a dot or a link.
  for (const char* was_there : {"keep", "real/deep", "here/new/out"})
    fs::create_directories(folder / was_there);
  fs::create_directory_symlink("../real/deep", folder / "here/link");
  for (const char* out : {"keep/new/./out", "here/link/../new/out"})
    EXPECT_EQ(test::fingerpad(std::string("replay motion.toml --out ") + out, folder).exit_code, 3);
  for (const char* was_there : {"keep", "real/deep", "here/new/out"})
    EXPECT_TRUE(fs::exists(folder / was_there)) << was_there;
  for (const char* was_made : {"keep/new", "real/new"})
    EXPECT_FALSE(fs::exists(folder / was_made)) << was_made;
  // A batch tells of each of its jobs.
  EXPECT_EQ(test::fingerpad("replay mesh.toml motion.toml --quiet --out out", folder).exit_code, 4);
  EXPECT_TRUE(fs::exists(folder / "out" / "summary.kept-1.csv"));
}

TEST(ASecondReplay, OfWhichNoJobIsDoneKeepsTheSummaryOfJobsThatAre) {
  const fs::path folder = folder_with_scenes();
  const std::string scene = bytes_of(folder / "a.toml");
  const std::string set = "[[set]]\nseed = [1, 2]\n";
  std::ofstream(folder / "a.toml") << scene << set;
  const std::string call = "replay a.toml --out out";
  ASSERT_EQ(test::fingerpad(call, folder).exit_code, 0);
  const std::string summary = bytes_of(folder / "out" / "summary.csv");
  const std::string trace = bytes_of(folder / "out" / "a-0001.h5");
  std::ofstream(folder / "a.toml") << "[[part]]\nmesh = \"none.stl\"\n"
                                   << scene.substr(scene.find("[motion]")) << set;
  const auto refused = test::fingerpad(call, folder);
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_THAT(refused.err,
              HasSubstr("out/summary.csv: had jobs that are done, as none of this batch is, and is "
                        "kept as summary.kept-1.csv\n"));
  EXPECT_EQ(bytes_of(folder / "out" / "summary.kept-1.csv"), summary);
  EXPECT_THAT(bytes_of(folder / "out" / "summary.csv"), HasSubstr("none.stl"));
  EXPECT_TRUE(fs::exists(folder / "out" / "jobs.csv"));
  EXPECT_EQ(bytes_of(folder / "out" / "a-0001.h5"), trace);
  EXPECT_THAT(test::fingerpad(call, folder).err, testing::Not(HasSubstr("kept as")));
  EXPECT_FALSE(fs::exists(folder / "out" / "summary.kept-2.csv"))
      << "one without jobs that are done is replaced";
  std::ofstream(folder / "a.toml") << scene << set;
  EXPECT_THAT(test::fingerpad(call + " --resume", folder).out,
              HasSubstr("2 of 2 jobs done (2 kept from before)"));
  EXPECT_EQ(bytes_of(folder / "out" / "summary.csv"), summary);
  EXPECT_FALSE(fs::exists(folder / "out" / "summary.kept-2.csv"));
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
