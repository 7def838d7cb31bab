#include "replay/run_lock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "support/paths.hpp"

namespace fingerpad::run_lock_test {
namespace {
namespace fs = std::filesystem;

TEST(RunLock, WhoseFolderHasBecomeAFileIsNoFaultOfTheCall) {
  const fs::path out = test::scratch_dir() / "out";
  std::ofstream(out) << "in the folder's place";
  try {
    const RunLock lock(out.string(), {"summary.csv"});
    FAIL() << "there is no folder to register in";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::fault);
    EXPECT_EQ(std::string(error.what()),
              out.string() + ": cannot be written: " + out.string() + " is a file, not a folder");
  }
}

/// As when it was found empty by a run that was refused, and that had made it.
TEST(RunLock, WhoseFolderHasJustBeenRemovedMakesItAgain) {
  const fs::path out = test::scratch_dir() / "new" / "out";
  const RunLock lock(out.string(), {"summary.csv"});
  EXPECT_TRUE(fs::exists(out / ".fingerpad" / "run-1.lock"));
}

TEST(RunLock, ThatEndsDoesNotMakeAFolderAgainThatWasRemoved) {
  const fs::path out = test::scratch_dir() / "out";
  {
    const RunLock lock(out.string(), {"summary.csv"});
    fs::remove_all(out);
  }
  EXPECT_FALSE(fs::exists(out));
}

/// Whoever has made the folders is refused, since another writes there; who ends last knows that they were
/// not there before.
TEST(RunLock, LeavesNoneOfTheFoldersThatAnotherMade) {
  for (const bool writes : {false, true}) {
    const fs::path scratch = test::scratch_dir(), out = scratch / "new" / "out";
    fs::create_directories(out);
    {
      const RunLock first(out.string(), {"summary.csv"});
      EXPECT_THROW(RunLock(out.string(), {"summary.csv"}, "", {}, 2), Error);
      if (writes) std::ofstream(out / "summary.csv") << "scene,job\n";
    }
    EXPECT_EQ(fs::exists(out), writes);
    EXPECT_EQ(fs::exists(scratch / "new"), writes);
    EXPECT_TRUE(fs::exists(scratch));
  }
}

/// Merged shards are the same files as one run's.
TEST(RunLock, LeavesNoWordOfWhoHasMadeAFolderThatStays) {
  const fs::path out = test::scratch_dir() / "out";
  {
    const RunLock lock(out.string(), {"summary.csv"}, "", {}, 1);
    std::ofstream(out / ".fingerpad" / "proof") << "of a trace";
  }
  EXPECT_TRUE(fs::is_empty(out / ".fingerpad" / "guard"));
}

TEST(RunLock, LeavesAFolderThatNoRunHasMade) {
  const fs::path out = test::scratch_dir() / "out";
  fs::create_directories(out);
  { const RunLock first(out.string(), {"summary.csv"}); }
  EXPECT_TRUE(fs::is_empty(out));
}

}  // namespace
}  // namespace fingerpad::run_lock_test
