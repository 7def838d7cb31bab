#include "device/terminal_keys.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace fingerpad::terminal_keys_test {
namespace {

std::vector<std::string> keys_of(std::string typed) {
  std::vector<std::string> keys;
  for (TypedKey key = first_key(typed); key.bytes > 0; key = first_key(typed)) {
    if (!key.name.empty()) keys.emplace_back(key.name);
    typed.erase(0, key.bytes);
  }
  if (!typed.empty()) keys.emplace_back("...");  // more must come
  return keys;
}

using Keys = std::vector<std::string>;

TEST(TerminalKeys, KnowsArrowsAndPageKeysOfBothModes) {
  EXPECT_EQ(keys_of("\x1b[A\x1b[B\x1b[C\x1b[D"), (Keys{"up", "down", "right", "left"}));
  EXPECT_EQ(keys_of("\x1bOA\x1bOD\x1b[5~\x1b[6~"), (Keys{"up", "left", "page up", "page down"}));
  EXPECT_EQ(keys_of("+q"), (Keys{"+", "q"}));
}

TEST(TerminalKeys, WaitsForTheRestOfASequenceAndPassesOverOthers) {
  EXPECT_EQ(keys_of("\x1b"), Keys{"..."});
  EXPECT_EQ(keys_of("\x1b["), Keys{"..."});
  EXPECT_EQ(keys_of("\x1b[6"), Keys{"..."});
  EXPECT_EQ(keys_of("\x1b[1;5C+"), Keys{"+"});  // with the control key
  EXPECT_EQ(keys_of("\x1b[3~+"), Keys{"+"});    // delete
  EXPECT_EQ(keys_of("\x1bx+"), (Keys{"x", "+"}));
}

TEST(TerminalKeys, TakesEveryByteOnceWhateverIsTyped) {
  std::mt19937 bits(3);
  for (int k = 0; k < 20000; ++k) {
    std::string typed;
    for (unsigned n = bits() % 40; n > 0; --n) typed += "\x1b[O~AD56;q+\x80"[bits() % 12];
    for (TypedKey key = first_key(typed); key.bytes > 0; key = first_key(typed)) {
      ASSERT_LE(key.bytes, typed.size());
      typed.erase(0, key.bytes);
    }
    ASSERT_LE(typed.size(), 16u) << "an unfinished sequence";
  }
}

}  // namespace
}  // namespace fingerpad::terminal_keys_test
