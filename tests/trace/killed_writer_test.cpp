// A writer that is killed at any of its writes, and amid them: what a test that kills by the clock meets once
// in two thousand times.
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>

#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/effort.hpp"
#include "support/paths.hpp"
#include "touch/world.hpp"
#include "trace/held_writes.hpp"
#include "trace/trace_writer.hpp"
#include "trace_rows.hpp"

namespace {

// What writes goes through here in this program; -1: nobody is killed.
long writes_left = -1;
bool dies_amid = false;

}  // namespace

/// Stands before the C library's. The process dies before the write that is one too many, or, as a killed one
/// may, at the end of the first page of it.
extern "C" ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) {
  constexpr size_t page_bytes = 4096;
  if (writes_left >= 0 && writes_left-- == 0) {
    const size_t to_end = page_bytes - static_cast<size_t>(at) % page_bytes;
    if (dies_amid && size > to_end) syscall(SYS_pwrite64, file, bytes, to_end, at);
    _exit(0);
  }
  return syscall(SYS_pwrite64, file, bytes, size, at);
}

namespace fingerpad::killed_writer_test {
namespace {

/// Writes rows until it dies at its n-th write after the beginning.
void write_and_die(const std::string& path, const TraceInfo& info, const std::vector<TickRecord>& rows,
                   std::size_t rows_a_flush, long n) {
  const pid_t child = fork();
  if (child == 0) {
    const auto writer = TraceWriter::create(path, TraceFormat::hdf5, info, World());
    writes_left = n;
    for (std::size_t first = 0; first < rows.size(); first += rows_a_flush) {
      writer->append(std::span(rows).subspan(first, rows_a_flush));
      writer->flush();
    }
    _exit(1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  ASSERT_EQ(status, 0) << "it had less to write";
}

/// Nothing that an earlier death left whole is missing after a later one, up to the rows that were under way.
/// @param grown_over  rows that there are less of at the first death, and more at the last
void expect_whole(const TraceInfo& info, std::size_t rows_a_flush, std::size_t grown_over, long from,
                  long to) {
  const std::string path = (test::scratch_dir() / "t.h5").string();
  const auto rows = test::some_rows(150 * static_cast<long>(rows_a_flush));
  for (const bool amid : {false, true}) {
    dies_amid = amid;
    std::size_t before = 0;
    for (long n = from; n < to; n += 10 / test::samples(10)) {
      SCOPED_TRACE(testing::Message() << "write " << n << (amid ? ", amid it" : ""));
      ASSERT_NO_FATAL_FAILURE(write_and_die(path, info, rows, rows_a_flush, n));
      const Trace trace = read_trace(path, TraceContents::some_rows);
      EXPECT_FALSE(trace.complete);
      ASSERT_GE(trace.rows.size(), before);
      EXPECT_TRUE(n > from || trace.rows.size() < grown_over) << trace.rows.size();
      before = trace.rows.size();
      for (std::size_t i = 0; i < before; ++i) {
        ASSERT_EQ(trace.rows[i].t_s, rows[i].t_s) << i;
        ASSERT_TRUE(!info.columns.empty() || test::same_row(trace.rows[i], rows[i])) << i;
      }
    }
    EXPECT_GT(before, grown_over);
  }
}

TEST(KilledWriter, LeavesAllThatWasFlushed) {
  expect_whole(test::some_info(), 100, 1, 0, 130);
}

/// The eleventh flush begins the second chunk of each column.
TEST(KilledWriter, LeavesItWhereAChunkIsAdded) {
  expect_whole(test::some_info(), 100, 1025, 430, 540);
}

/// HDF5's list of chunks has room for sixty-four; then it becomes a tree. Of one column, since all are alike.
TEST(KilledWriter, LeavesItWhereTheListOfChunksIsParted) {
  TraceInfo info = test::some_info();
  info.columns = {"t_s"};
  expect_whole(info, 1024, 64 * 1024, 250, 300);
}

/// Of the tree's last list, which is full again, the last chunk moves to a new one.
TEST(KilledWriter, LeavesItWhereAListOfTheTreeIsParted) {
  TraceInfo info = test::some_info();
  info.columns = {"t_s"};
  expect_whole(info, 1024, 126 * 1024, 500, 560);
}

TEST(HeldWrites, BeginWithTheStartGoOnWithWhatIsNewAndEndWithWhatWasThere) {
  HeldWrites held;
  std::vector<std::byte> bytes(10000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i * 7 % 251);
  const auto part = [&](std::size_t at, std::size_t size) { return std::span(bytes).subspan(at, size); };
  EXPECT_TRUE(held.hold(4000, part(4000, 5000)));
  EXPECT_TRUE(held.hold(100, part(100, 50)));
  EXPECT_TRUE(held.hold(9500, part(9500, 20)));
  EXPECT_TRUE(held.hold(0, part(0, 100)));
  EXPECT_FALSE(held.hold(149, part(149, 1))) << "it overlaps";
  EXPECT_TRUE(held.hold(150, part(150, 1)));
  std::vector<std::pair<std::uint64_t, std::size_t>> written;
  held.release(200, [&](std::uint64_t at, std::span<const std::byte> some) {
    EXPECT_TRUE(std::equal(some.begin(), some.end(), bytes.begin() + static_cast<long>(at)));
    written.emplace_back(at, some.size());
  });
  const decltype(written) expected = {{0, 100}, {4000, 5000}, {9500, 20}, {100, 50}, {150, 1}};
  EXPECT_EQ(written, expected);
  held.release(200, [](std::uint64_t, std::span<const std::byte>) { ADD_FAILURE() << "nothing is held"; });
}

}  // namespace
}  // namespace fingerpad::killed_writer_test
