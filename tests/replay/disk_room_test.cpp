#include "replay/disk_room.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.hpp"
#include "support/paths.hpp"

namespace fingerpad {
namespace {

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

}  // namespace
}  // namespace fingerpad
