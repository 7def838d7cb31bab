#include "trace/trial.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include <unistd.h>

#include "base/error.hpp"
#include "support/effort.hpp"
#include "support/paths.hpp"
#include "trace/hdf5_trial.hpp"

namespace fingerpad::trial_test {
namespace {

constexpr TrialLimits roomy{.seconds = 5, .memory_bytes = std::uint64_t{1} << 30};

TrialOutcome outcome_of(const std::function<void()>& work, const TrialLimits& limits = roomy) {
  return Trial([&](const Trial::Say&) { work(); }, limits).end();
}

/// All that is said.
std::string heard(Trial& trial) {
  std::string all;
  for (char c = 0; trial.hear({&c, 1});) all += c;
  return all;
}

TEST(Trial, TellsHowTheChildEnded) {
  EXPECT_EQ(outcome_of([] {}).end, TrialOutcome::End::returned);
  const TrialOutcome threw = outcome_of([] { throw refused("a.h5", "is odd"); });
  EXPECT_EQ(threw.end, TrialOutcome::End::threw);
  EXPECT_EQ(threw.message, "a.h5: is odd");
  EXPECT_EQ(outcome_of([] { throw std::bad_alloc(); }).end, TrialOutcome::End::died);
  EXPECT_EQ(outcome_of([] { std::raise(SIGSEGV); }).end, TrialOutcome::End::died);
  EXPECT_EQ(outcome_of([] { std::abort(); }).end, TrialOutcome::End::died);
  EXPECT_EQ(outcome_of([] { _exit(0); }).end, TrialOutcome::End::died);
}

TEST(Trial, TellsItAlsoWhereChildrenLeaveNoStatus) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  EXPECT_EQ(outcome_of([] {}).end, TrialOutcome::End::returned);
  EXPECT_EQ(outcome_of([] { throw refused("", "odd"); }).end, TrialOutcome::End::threw);
  EXPECT_EQ(outcome_of([] { std::raise(SIGSEGV); }).end, TrialOutcome::End::died);
  std::signal(SIGCHLD, before);
}

TEST(Trial, HandsOverWhatTheChildSays) {
  Trial trial(
      [](const Trial::Say& say) {
        say("one ");
        say("two");
      },
      roomy);
  std::array<char, 3> word{};
  EXPECT_TRUE(trial.hear(word));
  EXPECT_EQ(std::string(word.data(), 3), "one");
  EXPECT_EQ(heard(trial), " two");
  EXPECT_FALSE(trial.hear(word));
  EXPECT_EQ(trial.end().end, TrialOutcome::End::returned);
}

TEST(Trial, HandsOverMoreThanAPipeHolds) {
  const auto talk = [](const Trial::Say& say) {
    for (int i = 0; i < 40; ++i) say(std::string(100000, static_cast<char>('a' + i % 26)));
  };
  Trial trial(talk, roomy);
  std::string all(4000000, '\0');
  ASSERT_TRUE(trial.hear(all));
  EXPECT_EQ(all[3999999], 'a' + 39 % 26);
  EXPECT_EQ(trial.end().end, TrialOutcome::End::returned);
  EXPECT_EQ(Trial(talk, roomy).end().end, TrialOutcome::End::returned);  // unheard
}

TEST(Trial, AChildThatNobodyHearsIsEnded) {
  volatile bool forever = true;
  Trial(
      [&](const Trial::Say& say) {
        while (forever) say("word");
      },
      roomy);
  Trial(
      [&](const Trial::Say&) {
        while (forever) std::this_thread::sleep_for(std::chrono::hours(1));
      },
      roomy);
}

TEST(Trial, EndsAChildThatHangs) {
  const auto start = std::chrono::steady_clock::now();
  volatile bool forever = true;
  const auto hang = [&] {
    while (forever) {
    }
  };
  EXPECT_EQ(outcome_of(hang, {.seconds = 1, .memory_bytes = roomy.memory_bytes}).end,
            TrialOutcome::End::died);
  // A second of the processor; the machine may have much else to do.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

TEST(Trial, EndsAChildThatWaitsForNothing) {
  const auto wait = [] {
    if (alarm(1) == 0) _exit(1);  // there was none
    while (true) pause();
  };
  EXPECT_EQ(outcome_of(wait).end, TrialOutcome::End::waited);
}

TEST(Trial, OfAnHdf5FileIsMadeAgainWhereAChildMayWaitForNobody) {
  const std::filesystem::path waited = test::scratch_dir() / "waited";
  const auto tell = [&](Teller& tell) {
    if (!std::filesystem::exists(waited)) {
      std::ofstream(waited) << "once";
      std::raise(SIGALRM);
    }
    tell(5);
    tell.flush();
  };
  const auto read = [&] {
    return read_in_trial("a.h5", roomy, 100, tell, [](Hearer& hear) { return hear.one<int>(); });
  };
  if (hdf5_trials() == 1) {
    try {
      read();
      ADD_FAILURE() << "not refused";
    } catch (const Error& error) {
      EXPECT_STREQ(
          error.what(),
          "a.h5: cannot be read: it was not read within 110 seconds; does the disk that it is on answer?");
    }
  }
  EXPECT_EQ(read(), 5);
}

TEST(Trial, EndsAChildThatEatsMemory) {
  const auto eat = [] {
    std::vector<std::vector<char>> eaten;
    eaten.reserve(64);
    for (int i = 0; i < 64; ++i) eaten.emplace_back(std::size_t{16} << 20, 'x');
  };
  EXPECT_EQ(outcome_of(eat, {.seconds = 20, .memory_bytes = std::uint64_t{4} << 30}).end,
            TrialOutcome::End::returned);
  EXPECT_EQ(outcome_of(eat, {.seconds = 20, .memory_bytes = std::uint64_t{64} << 20}).end,
            TrialOutcome::End::died);
}

TEST(Trial, LeavesNothingBehindInTheParent) {
  int touched = 0;
  outcome_of([&] { touched = 1; });
  EXPECT_EQ(touched, 0);
}

TEST(Trial, SeveralThreadsMayTryAtOnce) {
  if (!test::forks_beside_threads())
    GTEST_SKIP()
        << "the address sanitizer's allocator may be locked by another thread when a child is forked";
  std::vector<std::thread> threads;
  std::array<int, 4> good{};
  for (int& count : good) {
    threads.emplace_back([&count] {
      for (int round = 0; round < 50; ++round) {
        Trial trial(
            [](const Trial::Say& say) {
              const std::vector<std::string> texts(100,
                                                   std::string(1000, 'x'));  // malloc, amid other threads
              for (const std::string& text : texts) say(text);
            },
            roomy);
        std::string all(100000, '\0');
        count += static_cast<int>(trial.hear(all) && trial.end().end == TrialOutcome::End::returned);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(good, (std::array<int, 4>{50, 50, 50, 50}));
}

}  // namespace
}  // namespace fingerpad::trial_test
