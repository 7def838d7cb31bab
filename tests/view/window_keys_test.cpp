#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "support/paths.hpp"
#include "support/shell.hpp"
#include "view/key_table.hpp"

namespace fingerpad::window_keys_test {
namespace {

TEST(KeyTable, NoKeyMeansTwoThingsInOneWindow) {
  for (const unsigned window :
       {windows::still, windows::trace, windows::touch, windows::touch | windows::motors}) {
    std::set<std::string_view> seen;
    for (const KeyRow& row : key_table()) {
      if ((row.in & window) == 0) continue;
      for (const BoundKey& key : row.keys) EXPECT_TRUE(seen.insert(key.symbol).second) << key.symbol;
    }
  }
}

TEST(KeyTable, TheHelpPageAndTheKeysAreItsRows) {
  EXPECT_EQ(action_of("space", windows::trace), KeyAction::play);
  EXPECT_EQ(action_of("space", windows::touch), KeyAction::press);
  EXPECT_EQ(action_of("space", windows::still), std::nullopt);
  EXPECT_EQ(action_of("x", windows::touch), std::nullopt) << "without motors there is nothing to stop";
  EXPECT_EQ(action_of("x", windows::touch | windows::motors), KeyAction::stop);
  EXPECT_EQ(action_of("X", windows::touch | windows::motors), KeyAction::give_back);
  const auto lines = help_lines(windows::touch);
  EXPECT_THAT(lines, testing::Contains("hold left button: press on the part"));
  EXPECT_THAT(lines, testing::Not(testing::Contains(testing::HasSubstr("emergency"))));
  for (const KeyRow& row : key_table()) EXPECT_FALSE(row.does.empty());
}

TEST(KeyTable, StandsInTheReadme) {
  const std::string readme = test::bytes_of(test::source_dir() / "README.md");
  EXPECT_NE(readme.find("\n" + key_table_text()), std::string::npos) << "put this there:\n"
                                                                     << key_table_text();
}

}  // namespace
}  // namespace fingerpad::window_keys_test
