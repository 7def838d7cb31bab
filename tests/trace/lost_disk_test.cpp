// What becomes of a trace when the disk it is written to fills up, refuses or goes away. Each case runs in a
// child process that ends through exit(), since HDF5 has tripped over failed files there too.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <csignal>
#include <functional>
#include <thread>

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/paths.hpp"
#include "trace/file_seal.hpp"
#include "trace/live_recorder.hpp"
#include "trace/output_file.hpp"
#include "trace_rows.hpp"

namespace fingerpad::lost_disk_test {
namespace {

using test::some_rows;
using testing::HasSubstr;
using testing::StartsWith;

constexpr int cannot_try = 77;

/// Exit status of a child that does `work` and ends through exit(); 128 and its signal if it crashed.
int status_of(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child == 0) std::exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Files may grow to this size, as on a disk with no more room.
void limit_files(rlim_t bytes) {
  signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_FSIZE, &limit);
}

/// What a writer says that should fail; "" if it does not, and "?" and its words if they are no line of ours.
std::string fault_of(const std::string& path, TraceFormat format, const std::vector<TickRecord>& rows,
                     ErrorKind kind = ErrorKind::fault) {
  try {
    test::write_trace(path, format, rows);
  } catch (const Error& error) {
    const std::string what = error.what();
    const bool ours = error.kind() == kind && what.starts_with(path + ": cannot be ") &&
                      what.find('\n') == std::string::npos;
    return ours ? what : "? " + what;
  }
  return "";
}

/// How many of 4 x `rounds` writers, in 4 threads at once, fail with a line of ours that ends in `reason`.
int failures_in_threads(const std::string& folder, int rounds, const std::string& reason,
                        ErrorKind kind = ErrorKind::fault) {
  const auto rows = some_rows(9000);
  std::atomic<int> failures{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int round = 0; round < rounds; ++round) {
        const std::string path = folder + "/" + std::to_string(t) + ".h5";
        const std::string said = fault_of(path, TraceFormat::hdf5, rows, kind);
        failures += static_cast<int>(said.starts_with(path) && said.ends_with(reason));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  return failures;
}

TEST(LostDisk, ManyWritersMayFailAtOnce) {
  const std::string folder = test::scratch_dir();
  // In the constructor, in the first rows, and later.
  for (const rlim_t limit : {0, 3000, 20000, 400000}) {
    EXPECT_EQ(status_of([&] {
                limit_files(limit);
                return failures_in_threads(folder, 25, "File too large");
              }),
              100)
        << limit;
  }
}

TEST(LostDisk, ManyWritersMayFindNoFolder) {
  EXPECT_EQ(status_of([] {
              return failures_in_threads("/no/such/folder", 25,
                                         "folder /no/such/folder is not there (only / is)", ErrorKind::usage);
            }),
            100);
}

/// Puts a file system of 2 MB on the folder, for this process alone; false if it may not.
bool mount_small_disk(const std::string& folder) {
  const uid_t user = geteuid(), group = getegid();
  if (unshare(user == 0 ? CLONE_NEWNS : CLONE_NEWNS | CLONE_NEWUSER) != 0) return false;
  if (user != 0) {
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
  }
  return mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         mount("none", folder.c_str(), "tmpfs", 0, "size=2m") == 0;
}

TEST(LostDisk, ASmallFullDiskIsOneLineAWriter) {
  const std::string folder = test::scratch_dir();
  const int status = status_of([&] {
    if (!mount_small_disk(folder)) return cannot_try;
    std::ofstream(folder + "/ballast") << std::string(2'000'000, 'x');
    return failures_in_threads(folder, 5, "No space left on device");
  });
  if (status == cannot_try) GTEST_SKIP() << "this process may not mount a file system";
  EXPECT_EQ(status, 20);
}

TEST(LostDisk, WhatWasFlushedBeforeTheDiskWasFullReads) {
  const std::string path = test::scratch_dir() / "t.h5";
  const auto rows = some_rows(9000);
  std::size_t read = 0;
  for (rlim_t limit = 500; limit < 1900000; limit = limit * 5 / 4) {
    EXPECT_EQ(status_of([&] {
                limit_files(limit);
                return fault_of(path, TraceFormat::hdf5, rows).ends_with(": File too large") ? 0 : 1;
              }),
              0)
        << limit;
    Trace trace;
    try {
      trace = read_trace(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused) << error.what();
      continue;
    }
    EXPECT_FALSE(trace.complete) << limit;
    ASSERT_LE(trace.rows.size(), rows.size());
    EXPECT_TRUE(
        test::same_rows(trace.rows, {rows.begin(), rows.begin() + static_cast<long>(trace.rows.size())}))
        << limit;
    read = std::max(read, trace.rows.size());
  }
  EXPECT_GE(read, 4096u);  // a block
}

TEST(LostDisk, ALiveRecordingTellsAFullDisk) {
  const std::string path = test::scratch_dir() / "t.h5";
  EXPECT_EQ(status_of([&] {
              limit_files(300000);
              LiveRecorder recorder(TraceWriter::create(path, TraceFormat::hdf5, test::some_info(), {}));
              for (const TickRecord& row : some_rows(20000)) recorder.push(row);
              try {
                recorder.finish();
              } catch (const Error& error) {
                return error.what() == path + ": cannot be written: File too large" ? 0 : 2;
              }
              return 1;
            }),
            0);
}

TEST(LostDisk, ARemovedFolderIsToldAtTheEnd) {
  for (const TraceFormat format : {TraceFormat::hdf5, TraceFormat::csv}) {
    const auto folder = test::scratch_dir() / "gone";
    std::filesystem::create_directory(folder);
    const std::string path = folder / "t";
    EXPECT_EQ(status_of([&] {
                const auto writer = TraceWriter::create(path, format, test::some_info(), {});
                writer->append(some_rows(5000));
                std::filesystem::remove_all(folder);
                writer->append(some_rows(5000));
                try {
                  writer->finish();
                } catch (const Error& error) {
                  const std::string what = error.what();
                  const bool told = what.starts_with(path + ": cannot be ") &&
                                    what.ends_with("its folder " + folder.string() + " is not there (only " +
                                                   folder.parent_path().string() + " is)");
                  return error.kind() == ErrorKind::fault && told ? 0 : 2;
                }
                return 1;
              }),
              0);
  }
}

TEST(LostDisk, AReadOnlyFolderIsTheCallersFault) {
  const auto folder = test::scratch_dir() / "closed";
  std::filesystem::create_directory(folder);
  std::filesystem::permissions(folder, std::filesystem::perms(0555));
  for (const TraceFormat format : {TraceFormat::hdf5, TraceFormat::csv}) {
    const std::string path = folder / "t";
    const int status = status_of([&] {
      if (geteuid() == 0 && setuid(65534) != 0) return cannot_try;
      const std::string said = fault_of(path, format, some_rows(10), ErrorKind::usage);
      return said == path + ": cannot be created: permission denied: you may not write into the folder " +
                         folder.string()
                 ? 0
                 : 1;
    });
    if (status == cannot_try) GTEST_SKIP() << "root may write anywhere, and may be nobody else here";
    EXPECT_EQ(status, 0);
  }
}

TEST(LostDisk, ASealThatDoesNotFitIsAFault) {
  const std::string path = test::scratch_dir() / "t";
  std::ofstream(path) << std::string(1000, 'x');
  EXPECT_EQ(status_of([&] {
              limit_files(1010);
              try {
                seal_file(path);
              } catch (const Error& error) {
                return error.what() == path + ": cannot be written: File too large" ? 0 : 2;
              }
              return 1;
            }),
            0);
  EXPECT_EQ(check_seal(path), Seal::none);
  EXPECT_EQ(std::filesystem::file_size(path), 1000u);  // no half of a seal either
}

TEST(LostDisk, ATextFileTellsAFullDevice) {
  for (const bool flushed : {true, false}) {
    OutputFile file("/dev/full");
    try {
      file.write("some text");
      if (flushed) file.flush();
      file.commit();
      FAIL();
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), "/dev/full: cannot be written: No space left on device");
    }
  }
}

}  // namespace
}  // namespace fingerpad::lost_disk_test
