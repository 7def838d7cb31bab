#include "trace/trial.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <vector>

#include <unistd.h>

#include "base/error.hpp"

namespace fingerpad {
namespace {

constexpr std::uint64_t roomy = std::uint64_t{1} << 30;

TEST(Trial, TellsHowTheChildEnded) {
  EXPECT_EQ(trial([] {}, 5, roomy).end, TrialOutcome::End::returned);
  const TrialOutcome threw = trial([] { throw refused("a.h5", "is odd"); }, 5, roomy);
  EXPECT_EQ(threw.end, TrialOutcome::End::threw);
  EXPECT_EQ(threw.message, "a.h5: is odd");
  EXPECT_EQ(trial([] { std::raise(SIGSEGV); }, 5, roomy).end, TrialOutcome::End::died);
  EXPECT_EQ(trial([] { std::abort(); }, 5, roomy).end, TrialOutcome::End::died);
  EXPECT_EQ(trial([] { _exit(7); }, 5, roomy).end, TrialOutcome::End::died);
}

TEST(Trial, EndsAChildThatHangs) {
  const auto start = std::chrono::steady_clock::now();
  volatile bool forever = true;
  EXPECT_EQ(trial(
                [&] {
                  while (forever) {
                  }
                },
                1, roomy)
                .end,
            TrialOutcome::End::died);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(15));  // 3 s, and a busy machine
}

TEST(Trial, EndsAChildThatEatsMemory) {
  const auto eat = [] {
    std::vector<std::vector<char>> eaten;
    eaten.reserve(64);
    for (int i = 0; i < 64; ++i) eaten.emplace_back(std::size_t{16} << 20, 'x');
  };
  EXPECT_EQ(trial(eat, 20, std::uint64_t{4} << 30).end, TrialOutcome::End::returned);
  EXPECT_NE(trial(eat, 20, std::uint64_t{64} << 20).end, TrialOutcome::End::returned);
}

TEST(Trial, LeavesNothingBehindInTheParent) {
  int touched = 0;
  trial([&] { touched = 1; }, 5, roomy);
  EXPECT_EQ(touched, 0);
}

}  // namespace
}  // namespace fingerpad
