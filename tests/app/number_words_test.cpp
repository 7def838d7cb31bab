#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"

// Numbers of the command line that are none, or out of range, are told with what is asked for.

namespace fingerpad::number_words_test {
namespace {

using testing::HasSubstr;

/// The line of an error of usage.
std::string told(const std::string& call) {
  const auto result = test::fingerpad(call, test::scratch_dir());
  EXPECT_EQ(result.exit_code, 2) << call;
  EXPECT_EQ(result.out, "") << call;
  return result.err.substr(0, result.err.find('\n'));
}

TEST(NumberWords, NameTheOptionWhatWasGivenAndWhatIsAllowed) {
  EXPECT_EQ(
      told("replay s.toml --out o --jobs zwei"),
      "fingerpad: error: --jobs: 'zwei' is no whole number; a whole number from 1 to 1024 is asked for");
  EXPECT_EQ(told("replay s.toml --out o --jobs 0"),
            "fingerpad: error: --jobs: '0' is out of range; a whole number from 1 to 1024 is asked for");
  EXPECT_EQ(told("replay s.toml --out o --jobs 1.5"),
            "fingerpad: error: --jobs: '1.5' is no whole number; a whole number from 1 to 1024 is asked for");
  EXPECT_EQ(
      told("replay s.toml --out o --every -3"),
      "fingerpad: error: --every: '-3' is out of range; a whole number from 1 to 1000000000 is asked for");
  EXPECT_EQ(
      told("replay s.toml --out o --progress nan"),
      "fingerpad: error: --progress: 'nan' is no number; a number of seconds from 0 to 1e+06 is asked for");
  EXPECT_EQ(
      told("touch s.toml --rate 1e9"),
      "fingerpad: error: --rate: '1e9' is out of range; a number of hertz from 1 to 100000 is asked for");
  EXPECT_EQ(
      told("touch s.toml --port http"),
      "fingerpad: error: --port: 'http' is no whole number; a whole number from 0 to 65535 is asked for");
  EXPECT_EQ(told("compare a b --most few"), "fingerpad: error: --most: 'few' is no whole number from 0");
  EXPECT_EQ(told("compare a b --tolerance wide"), "fingerpad: error: --tolerance: 'wide' is no number");
}

TEST(NumberWords, SayWhatUnitANumberIsInWhereOneIsWrittenBehindIt) {
  EXPECT_EQ(told("touch s.toml --seconds '2 s'"),
            "fingerpad: error: --seconds: '2 s' is no number; a number of seconds from 0 to 1e+09 is asked "
            "for, without a unit");
  EXPECT_EQ(told("replay s.toml --out o --progress 2min"),
            "fingerpad: error: --progress: '2min' is no number; a number of seconds from 0 to 1e+06 is asked "
            "for, without a unit");
  EXPECT_EQ(told("compare a b --tolerance 1N"),
            "fingerpad: error: --tolerance: '1N' is no number; it is written without a unit");
  EXPECT_EQ(told("compare a b --tolerance 1,5"), "fingerpad: error: --tolerance: '1,5' is no number");
#ifdef FINGERPAD_VIEW
  EXPECT_EQ(told("plot a.h5 --out p.png --from '2 s'"),
            "fingerpad: error: --from: '2 s' is no number; it is in seconds, without a unit");
  EXPECT_EQ(told("view a.h5 --png p.png --at 2s"),
            "fingerpad: error: --at: '2s' is no number; it is in seconds, without a unit");
#endif
}

TEST(NumberWords, OfAQuantityTellTheNumberAsItWasGiven) {
  EXPECT_EQ(told("fit m.csv --out p.toml --fill '2 s'"),
            "fingerpad: error: --fill: '2 s' is out of range; 0 to 1000 ms is asked for");
  EXPECT_EQ(told("fit m.csv --out p.toml --fill 2000"),
            "fingerpad: error: --fill: '2000' is out of range; 0 to 1000 ms is asked for");
  EXPECT_EQ(told("fit m.csv --out p.toml --fill '2 m'"),
            "fingerpad: error: --fill: '2 m' is no number, nor one of ms, us, s");
}

TEST(NumberWords, OfMemoryNameASize) {
  for (const char* word :
       {"viel", "4X", "1.5G", "-1M", "99999999999999999999G", "-3", "0", "K", "99999999999999999999"}) {
    EXPECT_EQ(told("replay s.toml --out o --memory " + std::string(word)),
              "fingerpad: error: --memory: '" + std::string(word) +
                  "' is no size of memory; 500M or 4G is one: a whole number with K, M, G or T behind it");
  }
}

TEST(NumberWords, OfHelpKeepTheirRange) {
  const auto help = test::fingerpad("replay --help", test::scratch_dir());
  EXPECT_THAT(help.out, HasSubstr("1 to 1024"));
}

}  // namespace
}  // namespace fingerpad::number_words_test
