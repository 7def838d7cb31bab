#include "replay/disk_room.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/statvfs.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "base/error.hpp"
#include "replay/batch.hpp"
#include "support/calm_scene.hpp"
#include "support/paths.hpp"

namespace fingerpad::disk_room_test {
namespace {

std::optional<std::uint64_t> told_room;

/// While it lives, this program is told that its disks have so many free bytes.
struct DiskOfRoom {
  explicit DiskOfRoom(std::uint64_t bytes) { told_room = bytes; }
  ~DiskOfRoom() { told_room.reset(); }
  DiskOfRoom(const DiskOfRoom&) = delete;
  DiskOfRoom& operator=(const DiskOfRoom&) = delete;
};

}  // namespace
}  // namespace fingerpad::disk_room_test

/// In the place of the C library's, for the whole of this program.
extern "C" int statvfs(const char* path, struct statvfs* disk) noexcept {
  static const auto own = reinterpret_cast<decltype(&statvfs)>(dlsym(RTLD_NEXT, "statvfs"));
  const int failure = own(path, disk);
  if (const auto room = fingerpad::disk_room_test::told_room; room && failure == 0) {
    disk->f_frsize = 1;
    disk->f_bavail = *room;
  }
  return failure;
}

namespace fingerpad::disk_room_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

std::string words_of(TraceFormat format, const TraceInfo& info, std::uint64_t rows) {
  try {
    refuse_full_disk((test::scratch_dir() / "long").string(), format, info, rows);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::fault);
    return error.what();
  }
  return "";
}

TEST(DiskRoom, ATraceThatTheDiskHasNoRoomForIsRefusedBeforeItIsWritten) {
  const std::uint64_t room = std::filesystem::space(test::scratch_dir()).available;
  for (const TraceFormat format : {TraceFormat::hdf5, TraceFormat::csv}) {
    EXPECT_EQ(words_of(format, {}, 1000), "");
    EXPECT_THAT(words_of(format, {}, room),
                AllOf(HasSubstr("long: its " + std::to_string(room) + " rows"),
                      HasSubstr("the disk has room for"), HasSubstr("--every N")));
  }
}

TEST(DiskRoom, FewerColumnsAndDeflatedOnesTakeLess) {
  // A time alone takes 8 bytes a row; a tenth where they are deflated.
  const std::uint64_t rows = std::filesystem::space(test::scratch_dir()).available / 12;
  TraceInfo info;
  EXPECT_NE(words_of(TraceFormat::hdf5, info, rows / 2), "");
  info.deflated = true;
  EXPECT_EQ(words_of(TraceFormat::hdf5, info, rows / 2), "");
  info.deflated = false;
  info.columns = {"t_s"};
  EXPECT_EQ(words_of(TraceFormat::hdf5, info, rows), "");
}

TEST(DiskRoom, AJobWhoseTraceTheDiskHasNoRoomForIsNotBegun) {
  const fs::path folder = test::scratch_dir();
  std::ofstream(folder / "calm.toml") << test::calm_scene("calm");
  BatchOptions options;
  options.out_dir = (folder / "out").string();
  options.version = "test";
  const auto run = [&] {
    auto jobs = batch_jobs({(folder / "calm.toml").string()});
    run_batch(jobs, options, {}, [](const BatchJob&) {});
    return jobs.at(0).status;
  };
  {
    const DiskOfRoom small(4096);
    EXPECT_THAT(run(), AllOf(HasSubstr("calm.h5: its "), HasSubstr(" rows take at least "),
                             HasSubstr("the disk has room for")));
    EXPECT_FALSE(fs::exists(folder / "out" / "calm.h5"));
  }
  EXPECT_EQ(run(), "ok");
  EXPECT_TRUE(fs::exists(folder / "out" / "calm.h5"));
}

}  // namespace
}  // namespace fingerpad::disk_room_test
