#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/paths.hpp"
#include "support/shell.hpp"

// How much compare says of a job, and what first.

namespace fingerpad::compare_words_test {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using testing::HasSubstr;
using testing::Not;

/// Two folders, a and b, with the trace of a rub over a plane; for the second the scene has `others` in the
/// place of `words`.
fs::path folder_with_two(const std::string& words, const std::string& others) {
  const fs::path folder = test::scratch_dir();
  std::string scene =
      "name = \"s\"\n[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\nmu_dynamic = 0.2\n[motion]\nkind = "
      "\"line\"\nfrom_m = [0, 0, -0.001]\nto_m = [0.02, 0, -0.001]\nspeed_m_per_s = 0.2\n";
  for (const char* out : {"a", "b"}) {
    std::ofstream(folder / "s.toml") << scene;
    EXPECT_EQ(test::fingerpad(std::string("replay s.toml --quiet --out ") + out, folder).exit_code, 0);
    if (const std::size_t at = scene.find(words); at != std::string::npos)
      scene.replace(at, words.size(), others);
  }
  return folder;
}

TEST(CompareWords, TellsAJobInALineAndItsOtherColumnsInShort) {
  const fs::path folder = folder_with_two("mu_dynamic = 0.2", "mu_dynamic = 0.1");
  const auto found = test::fingerpad("compare a b --out all.csv", folder);
  EXPECT_THAT(found.out,
              testing::MatchesRegex(
                  "s.h5: ffx_n differs by up to 0.1 N at t = [0-9.]+ s, in [0-9]+ of 101 "
                  "ticks; [^;\n]*mu by 0.1[^;\n]*\n1 of 1 trace changed from a to b\nwrote all.csv .*\n"));
  const std::string rows = bytes_of(folder / "all.csv");
  EXPECT_THAT(rows, HasSubstr("\ns.h5,mu,0.1,,"));
}

TEST(CompareWords, SaysFirstWhereTheMotionIsAnother) {
  const fs::path folder = folder_with_two("to_m = [0.02, 0, -0.001]", "to_m = [0.02, 0.001, -0.001]");
  const auto found = test::fingerpad("compare a b", folder);
  EXPECT_EQ(found.exit_code, 4);
  const auto told = found.out.find("s.h5: the motions are not the same: y_m differs by up to 0.00");
  EXPECT_EQ(told, 0u) << found.out;
  EXPECT_THAT(found.out.substr(1), HasSubstr("s.h5: f")) << "then what was felt";
  EXPECT_THAT(found.out, Not(HasSubstr(" y_m by"))) << "that is the motion's";
}

TEST(CompareWords, NameWhatIsPassedOver) {
  const fs::path folder = folder_with_two("", "");
  for (const char* name : {"a/junk.h5", "b/junk.h5", "b/k1.csv", "b/k2.h5", "b/k3.h5", "b/notes.txt"})
    std::ofstream(folder / name) << "junk\n";
  fs::create_directory(folder / "b/older");
  const auto found = test::fingerpad("compare a b", folder);
  EXPECT_EQ(found.exit_code, 0) << found.err;
  EXPECT_EQ(found.out,
            "a: 1 file with a trace's ending but no trace in it is passed over: junk.h5\n"
            "b: 4 files with a trace's ending but no trace in it are passed over: junk.h5, k1.csv, k2.h5 and "
            "1 more\n"
            "b: 2 other files are passed over: notes.txt, older/\n"
            "0 of 1 trace changed from a to b\n")
      << "tables, proofs and the page of a report are known";
  EXPECT_EQ(test::fingerpad("compare a b --quiet", folder).out, "");
}

TEST(CompareWords, OfAJobsTraceThatIsNoneOnBothSidesSayThatItIsNotCompared) {
  const fs::path folder = folder_with_two("", "");
  for (const std::string words : {"junk\n", ""}) {
    for (const char* name : {"a/s.h5", "b/s.h5"}) std::ofstream(folder / name) << words;
    const auto found = test::fingerpad("compare a b", folder);
    EXPECT_EQ(found.exit_code, 4) << found.out;
    EXPECT_THAT(found.out, HasSubstr("s.h5: cannot be compared: a/s.h5"));
    EXPECT_THAT(found.out, HasSubstr("1 of 1 trace changed"));
    EXPECT_THAT(found.err, HasSubstr("fingerpad: error: b/s.h5"));
  }
}

}  // namespace
}  // namespace fingerpad::compare_words_test
