#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/entries.hpp"
#include "support/paths.hpp"

namespace fingerpad::corpus_test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class Corpus : public testing::TestWithParam<test::FuzzEntry> {};

TEST_P(Corpus, EverySeedAndEveryFoundCaseIsReadOrRefused) {
  const fs::path fuzz = test::source_dir() / "tests" / "fuzz";
  std::vector<fs::path> files = files_below(fuzz / "corpus" / GetParam().name);
  ASSERT_FALSE(files.empty()) << "a target without seeds";
  for (const fs::path& found : files_below(fuzz / "found" / GetParam().name)) files.push_back(found);
  for (const fs::path& path : files) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    EXPECT_NO_THROW(GetParam().run(bytes)) << path;
  }
}

TEST(CorpusFolders, AreThoseOfTheEntries) {
  std::vector<std::string> names;
  for (const test::FuzzEntry& entry : test::fuzz_entries()) names.push_back(entry.name);
  std::sort(names.begin(), names.end());
  std::vector<std::string> folders;
  for (const fs::path& folder : files_below(test::source_dir() / "tests" / "fuzz" / "corpus"))
    folders.push_back(folder.filename());
  EXPECT_EQ(folders, names);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus,
                         testing::ValuesIn(test::fuzz_entries().begin(), test::fuzz_entries().end()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace fingerpad::corpus_test
