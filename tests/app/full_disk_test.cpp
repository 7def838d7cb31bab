#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/calm_scene.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"

// A disk that is full, and folders and files that cannot be written: a line a job, and the reason.

namespace fingerpad::full_disk_test {
namespace {
namespace fs = std::filesystem;
using test::bytes_of;
using test::calm_scene;
using test::lines_of;
using test::ShellResult;
using testing::HasSubstr;

fs::path folder_with_scene() {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "calm.toml") << calm_scene("calm");
  return folder;
}

TEST(FullDisk, AFileTooLargeForTheLimitIsAFailedJobWithItsReason) {
  const fs::path folder = folder_with_scene();
  const std::string limit = "ulimit -f 8; ";
  const std::string call = limit + "'" + test::program().string() + "' replay --format csv ";
  const ShellResult one = test::shell(call + "calm.toml --out one", folder);
  EXPECT_EQ(one.exit_code, 1) << one.err;
  EXPECT_THAT(one.err, HasSubstr("fingerpad: error: one/calm.csv: cannot be written: File too large\n"));
  EXPECT_THAT(bytes_of(folder / "one" / "summary.csv"), HasSubstr("File too large"));
  std::ofstream(folder / "set.toml") << calm_scene("set") << "[[set]]\nseed = [1, 2, 3]\n";
  const ShellResult set = test::shell(call + "set.toml --out set --jobs 2", folder);
  EXPECT_EQ(set.exit_code, 4) << set.err;
  EXPECT_EQ(lines_of(set.err), 3) << "a line a job: " << set.err;
}

TEST(FullDisk, ASummaryThatCannotBeWrittenIsToldBesideTheFailedJobs) {
  const fs::path folder = folder_with_scene();
  fs::create_directories(folder / "o" / "summary.csv");
  const ShellResult good = test::fingerpad("replay calm.toml --out o", folder);
  EXPECT_EQ(good.exit_code, 1);
  EXPECT_EQ(good.err, "fingerpad: error: o/summary.csv: cannot be created: is a folder: name a file in it\n");
  EXPECT_TRUE(fs::exists(folder / "o" / "timing.csv")) << "the other table is written all the same";
  EXPECT_EQ(good.out, "1 of 1 job done, traces in o\n");
  const ShellResult bad = test::fingerpad("replay calm.toml absent.toml --out o", folder);
  EXPECT_EQ(bad.exit_code, 4);
  EXPECT_THAT(bad.err, HasSubstr("absent.toml: "));
  EXPECT_THAT(bad.err, HasSubstr("o/summary.csv: cannot be created: is a folder: name a file in it\n"));
  EXPECT_EQ(lines_of(bad.err), 2) << bad.err;
}

#ifdef FINGERPAD_VIEW
/// The program's own failure, exit code 1: neither the call nor an input is wrong.
TEST(FullDisk, AReportThatHasNoRoomEndsOneAndLeavesTheOldOne) {
  const fs::path folder = folder_with_scene();
  ASSERT_EQ(test::fingerpad("replay calm.toml --out o --quiet", folder).exit_code, 0);
  std::ofstream(folder / "o" / "report.html") << "the old one";
  const ShellResult full = test::shell("ulimit -f 800; '" + test::program().string() + "' report o", folder);
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_EQ(full.err, "fingerpad: error: o/report.html: cannot be written: File too large\n");
  EXPECT_EQ(bytes_of(folder / "o" / "report.html"), "the old one");
  EXPECT_FALSE(fs::exists(folder / "o" / "report.html.part"));
  const ShellResult device = test::fingerpad("report o --out /dev/full", folder);
  EXPECT_EQ(device.exit_code, 2) << device.err;  // by its name, which is no page's
}

/// The same with a file system of its own; where none can be mounted, the limit above has to do.
TEST(FullDisk, AReportOnASmallFileSystemSaysThatItIsFull) {
  const fs::path folder = folder_with_scene();
  ASSERT_EQ(test::fingerpad("replay calm.toml --out o --quiet", folder).exit_code, 0);
  fs::create_directory(folder / "small");
  const std::string mount =
      "unshare --mount --map-root-user sh -c \"mount -t tmpfs -o size=64k none small && ";
  if (test::shell(mount + "true\"", folder).exit_code != 0) GTEST_SKIP() << "no file system can be mounted";
  const ShellResult full =
      test::shell(mount + "'" + test::program().string() + "' report o --out small/r.html\"", folder);
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_EQ(full.err, "fingerpad: error: small/r.html: cannot be written: No space left on device\n");
}
#endif

TEST(FullDisk, AnOutputFolderThatIsAFileIsSaidSo) {
  const fs::path folder = folder_with_scene();
  std::ofstream(folder / "file") << "x";
  for (const char* out : {"file", "file/out"}) {
    const ShellResult result = test::fingerpad(std::string("replay calm.toml --out ") + out, folder);
    EXPECT_EQ(result.exit_code, 2) << "not a full disk: the call names no folder";
    EXPECT_THAT(result.err,
                testing::StartsWith(std::string("fingerpad: error: ") + out + ": cannot be made: "));
    EXPECT_THAT(result.err, HasSubstr("folder")) << "in words of its own";
    EXPECT_EQ(lines_of(result.err), 1);
  }
  EXPECT_EQ(bytes_of(folder / "file"), "x");
}

}  // namespace
}  // namespace fingerpad::full_disk_test
