#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "fuzz/dictionary_words.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"

namespace fingerpad::dictionary_test {
namespace {

using testing::Contains;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(SceneWords, AreAWellFormedDictionaryOfTheRows) {
  const auto words = lines_of(test::scene_words());
  const auto is_entry = testing::MatchesRegex(R"re("([^"\]|\\"|\\x[0-9a-f]{2})+")re");
  for (const std::string& word : words) EXPECT_THAT(word, is_entry);
  for (const char* word :
       {R"("mass_kg")", R"("angle_deg")", R"("elastic_share")", R"("\"karnopp\"")", R"("\"closest-point\"")",
        R"("\"circle\"")", R"("[[part]]\x0a")", R"("[hand]\x0a")"})
    EXPECT_THAT(words, Contains(word));
}

TEST(TraceWords, AreTheColumnsThatATraceMayHave) {
  const auto words = lines_of(test::trace_words());
  for (const char* word : {R"("t_s")", R"("angle_rad")", R"("ruptures")", R"("hz_n")", R"("rfz_n")"})
    EXPECT_THAT(words, Contains(word));
}

TEST(DictionaryWords, StandInNoFileBesides) {
  for (const std::string target : {"scene", "trace_csv"}) {
    const auto path = test::source_dir() / "tests" / "fuzz" / "dictionaries" / (target + ".dict");
    const auto written = lines_of(test::bytes_of(path));
    EXPECT_GT(written.size(), 10u);
    for (const std::string& word : lines_of(test::dictionary_words(target)))
      EXPECT_THAT(written, testing::Not(Contains(word))) << target;
  }
}

}  // namespace
}  // namespace fingerpad::dictionary_test
