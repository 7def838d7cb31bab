#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "support/paths.hpp"
#include "support/shell.hpp"

namespace fingerpad::help_test {
namespace {

using testing::HasSubstr;

std::vector<std::string> subcommands() {
  std::istringstream help(test::fingerpad("--help", test::scratch_dir()).out);
  std::vector<std::string> names;
  bool is_listed = false;
  for (std::string line; std::getline(help, line);) {
    if (is_listed && !names.empty() && line.empty()) break;
    if (is_listed && line.starts_with("  ") && line[2] != ' ')
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    is_listed |= line == "Subcommands:";
  }
  return names;
}

TEST(Help, HasNoLineThatATerminalBreaks) {
  const std::vector<std::string> names = subcommands();
  ASSERT_GE(names.size(), 8u);
  for (const std::string& name : names) {
    const auto result = test::fingerpad(name + " --help", test::scratch_dir());
    EXPECT_EQ(result.exit_code, 0) << name;
    EXPECT_THAT(result.out, HasSubstr("Usage: fingerpad " + name));
    std::istringstream help(result.out);
    for (std::string line; std::getline(help, line);) EXPECT_LE(line.size(), 100u) << name << ": " << line;
  }
}

TEST(Help, ARemarkThatIsBrokenGoesOnAsARemarkSoThatAScenesLinesCanBeCopied) {
  const std::string replay = test::fingerpad("replay --help", test::scratch_dir()).out;
  EXPECT_THAT(replay, HasSubstr("\nmethod = \"auto\"                # or closest-point, proxy; auto: the "
                                "cheapest that keeps the\n                               # tolerances\n"));
}

TEST(Help, SaysWhatAnOptionTakesItsRangeAndItsDefault) {
  const std::string replay = test::fingerpad("replay --help", test::scratch_dir()).out;
  EXPECT_THAT(replay, HasSubstr("  --out FOLDER              Folder for the traces"));
  EXPECT_THAT(replay,
              HasSubstr("  --format h5|csv|none      h5, csv, or none: summary.csv alone (default: h5)\n"));
  EXPECT_THAT(replay,
              HasSubstr("  --every N                 Write every N-th tick alone, and the last (from 1; "
                        "default: 1)\n"));
  EXPECT_THAT(replay, HasSubstr("  SCENE...                  Scene files"));
  const std::string fit = test::fingerpad("fit --help", test::scratch_dir()).out;
  EXPECT_THAT(fit, HasSubstr("--decimal .|, "));
  EXPECT_THAT(fit, HasSubstr("(one of comma, semicolon, tab, bar, blank)"));
  EXPECT_THAT(fit, HasSubstr("  --force-unit N|mN|kN|gf|kgf|cN|lbf\n                            Of forces"));
}

}  // namespace
}  // namespace fingerpad::help_test
