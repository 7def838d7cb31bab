#include "replay/watched_rank.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "support/paths.hpp"

// A rank's two processes. Each test goes on in processes of its own.

namespace fingerpad::watched_rank_test {
namespace {

TEST(WatchedRank, EndsWithItsChildsCodeWhereWhoStartedItIgnoresTheEndOfChildren) {
  const std::string folder = test::scratch_dir().string();
  const auto act = [&] {
    alarm(30);  // of the one that watches: where it never ends, this does
    signal(SIGCHLD, SIG_IGN);
    RankLog log(folder, 0);
    const WatchedRank watched(log, Ranks{0, 2, "run", getppid()});
    _exit(7);
  };
  EXPECT_EXIT(act(), testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace fingerpad::watched_rank_test
