#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <thread>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "box_and_plane.hpp"
#include "support/paths.hpp"
#include "trace/trace_writer.hpp"
#include "trace_rows.hpp"

// What is left of a trace whose writer is killed, or whose disk is full.

namespace fingerpad::cut_short_trace_test {
namespace {

using test::box_and_plane;
using test::same_rows;
using test::some_rows;

/// Runs `work` in a child process that then ends as if killed: no destructor, no handler runs.
template <typename Work>
int in_killed_child(Work work) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      work();
    } catch (...) {
      _exit(9);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(TraceWriter, AKilledRecordingReadsUpToItsLastFlush) {
  const auto folder = test::scratch_dir();
  const auto rows = some_rows(6000);
  for (const long flushed : {0L, 100L, 4096L, 5000L}) {
    const std::string path = (folder / (std::to_string(flushed) + ".h5")).string();
    const World world = box_and_plane();
    const int status = in_killed_child([&] {
      const auto writer = TraceWriter::create(path, TraceFormat::hdf5, test::some_info(), world);
      for (long i = 0; i < flushed; i += 50) {
        writer->append(std::span(rows).subspan(static_cast<std::size_t>(i),
                                               static_cast<std::size_t>(std::min(50L, flushed - i))));
        if (i % 100 == 0) writer->flush();
      }
      writer->flush();
      writer->append(std::span(rows).subspan(static_cast<std::size_t>(flushed), 10));
      _exit(0);
    });
    ASSERT_EQ(status, 0);
    const Trace trace = read_trace(path);
    EXPECT_FALSE(trace.complete);
    EXPECT_EQ(trace.info.scene_name, "test");
    EXPECT_EQ(trace.rows.size(), static_cast<std::size_t>(flushed));
    EXPECT_TRUE(same_rows(trace.rows, std::vector(rows.begin(), rows.begin() + flushed)));
    ASSERT_TRUE(trace.world);
  }
}

TEST(TraceWriter, ARecordingKilledAtAnyMomentIsReadable) {
  const auto folder = test::scratch_dir();
  const auto rows = some_rows(20000);
  const std::string path = (folder / "t.h5").string();
  for (int round = 0; round < 12; ++round) {
    int begun[2];
    ASSERT_EQ(pipe(begun), 0);
    const pid_t child = fork();
    if (child == 0) {
      const auto writer = TraceWriter::create(path, TraceFormat::hdf5, test::some_info(), {});
      close(begun[1]);
      for (std::size_t i = 0;; i = (i + 100) % rows.size()) {
        writer->append(std::span(rows).subspan(i, 100));
        writer->flush();
      }
    }
    char end = 0;
    close(begun[1]);
    EXPECT_EQ(read(begun[0], &end, 1), 0);  // until the child has closed its end too
    close(begun[0]);
    std::this_thread::sleep_for(std::chrono::milliseconds(7 * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const Trace trace = read_trace(path);
    EXPECT_FALSE(trace.complete);
    for (std::size_t i = 0; i < trace.rows.size(); ++i) {
      ASSERT_TRUE(test::same_row(trace.rows[i], rows[i % rows.size()])) << "round " << round << " row " << i;
    }
  }
}

TEST(TraceWriter, AKilledCsvIsLeftAsAPartThatReads) {
  const auto folder = test::scratch_dir();
  const auto rows = some_rows(300);
  const std::string path = (folder / "t.csv").string();
  in_killed_child([&] {
    const auto writer = TraceWriter::create(path, TraceFormat::csv, {}, {});
    writer->append(std::span(rows).first(200));
    writer->flush();
    writer->append(std::span(rows).subspan(200));
    _exit(0);
  });
  EXPECT_FALSE(std::filesystem::exists(path));
  const Trace trace = read_trace(path + ".part");
  EXPECT_FALSE(trace.complete);
  EXPECT_TRUE(same_rows(trace.rows, std::vector(rows.begin(), rows.begin() + 200)));
}

TEST(TraceWriter, AnUnfinishedTraceIsMarkedSo) {
  const auto path = (test::scratch_dir() / "t.h5").string();
  TraceWriter::create(path, TraceFormat::hdf5, test::some_info(), {})->flush();
  EXPECT_FALSE(read_trace(path).complete);
}

/// How a child ends that writes a trace where files may grow to `limit_bytes`, which stands in for a full
/// disk: 0 if the fault was told and the library's own end ran without tripping over the failed file.
int status_with_full_disk(const std::string& path, TraceFormat format, rlim_t limit_bytes) {
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{limit_bytes, limit_bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
    int result = 1;
    try {
      test::write_trace(path, format, some_rows(20000));
    } catch (const Error& error) {
      const bool told = std::string(error.what()).find(path + ": cannot be written: File too large") == 0;
      result = error.kind() == ErrorKind::fault && told ? 0 : 2;
    }
    std::exit(result);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(TraceWriter, AFullDiskIsAFaultAndNoCrash) {
  const std::string path = (test::scratch_dir() / "full").string();
  EXPECT_EQ(status_with_full_disk(path, TraceFormat::csv, 200000), 0);
  // From a file that cannot even begin to one that fails in its rows.
  for (const rlim_t limit : {0, 100, 2000, 10000, 40000, 70000, 100000, 200000, 1000000}) {
    EXPECT_EQ(status_with_full_disk(path, TraceFormat::hdf5, limit), 0) << limit;
  }
}

}  // namespace
}  // namespace fingerpad::cut_short_trace_test
