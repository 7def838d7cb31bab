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

}  // namespace
}  // namespace fingerpad::run_lock_test
