#include "trace/live_recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

#include <sys/wait.h>
#include <unistd.h>

#include "support/paths.hpp"
#include "trace_rows.hpp"

namespace fingerpad::live_recorder_test {
namespace {

using namespace std::chrono_literals;

/// Keeps rows in memory; may be slow, or refuse from some row on.
class FakeWriter final : public TraceWriter {
 public:
  struct Log {
    std::vector<TickRecord> rows;
    int flushes = 0;
    bool finished = false;
  };
  FakeWriter(Log& log, std::chrono::milliseconds delay, std::size_t refuse_after)
      : log_(log), delay_(delay), refuse_after_(refuse_after) {}
  void append(std::span<const TickRecord> rows) override {
    std::this_thread::sleep_for(delay_);
    if (log_.rows.size() + rows.size() > refuse_after_) throw Error(ErrorKind::fault, "disk", "is full");
    log_.rows.insert(log_.rows.end(), rows.begin(), rows.end());
  }
  void flush() override { ++log_.flushes; }
  FileSum finish() override {
    log_.finished = true;
    return {};
  }

 private:
  Log& log_;
  std::chrono::milliseconds delay_;
  std::size_t refuse_after_;
};

constexpr std::size_t never = 1000000;

TEST(LiveRecorder, WritesEveryTickInOrderAndFinishes) {
  const auto path = (test::scratch_dir() / "t.h5").string();
  const auto rows = test::some_rows(20000);
  LiveRecorder recorder(TraceWriter::create(path, TraceFormat::hdf5, test::some_info(), {}));
  for (const TickRecord& row : rows) recorder.push(row);
  recorder.finish();
  recorder.finish();
  EXPECT_EQ(recorder.dropped(), 0);
  EXPECT_EQ(recorder.recorded(), 20000);
  const Trace trace = read_trace(path);
  EXPECT_TRUE(trace.complete);
  EXPECT_TRUE(test::same_rows(trace.rows, rows));
}

TEST(LiveRecorder, FlushesWithinATenthOfASecond) {
  const auto path = (test::scratch_dir() / "t.h5").string();
  const auto rows = test::some_rows(30);
  const pid_t child = fork();
  if (child == 0) {
    LiveRecorder recorder(TraceWriter::create(path, TraceFormat::hdf5, test::some_info(), {}));
    for (const TickRecord& row : rows) recorder.push(row);
    // The contract's tenth of a second, and four more for a machine that is busy.
    std::this_thread::sleep_for(500ms);
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  const Trace trace = read_trace(path);
  EXPECT_FALSE(trace.complete);
  EXPECT_TRUE(test::same_rows(trace.rows, rows));
}

TEST(LiveRecorder, ASlowDiskDropsTicksAndCountsThem) {
  FakeWriter::Log log;
  const auto rows = test::some_rows(1000);
  LiveRecorder recorder(std::make_unique<FakeWriter>(log, 20ms, never), 64);
  for (const TickRecord& row : rows) recorder.push(row);
  recorder.finish();
  EXPECT_TRUE(log.finished);
  EXPECT_GT(recorder.dropped(), 0);
  EXPECT_EQ(static_cast<long>(log.rows.size()) + recorder.dropped(), 1000);
  EXPECT_EQ(recorder.recorded(), static_cast<long>(log.rows.size()));
  for (std::size_t i = 1; i < log.rows.size(); ++i) EXPECT_GT(log.rows[i].t_s, log.rows[i - 1].t_s);
}

/// Writes nothing until it is let.
class HeldWriter final : public TraceWriter {
 public:
  HeldWriter(std::atomic<bool>& begun, std::atomic<bool>& let) : begun_(begun), let_(let) {}
  void append(std::span<const TickRecord>) override {
    begun_ = true;
    begun_.notify_all();
    let_.wait(false);
  }
  void flush() override {}
  FileSum finish() override { return {}; }

 private:
  std::atomic<bool>&begun_, &let_;
};

TEST(LiveRecorder, PushNeverWaitsForTheDisk) {
  std::atomic<bool> begun{false}, let{false};
  LiveRecorder recorder(std::make_unique<HeldWriter>(begun, let), 64);
  const auto rows = test::some_rows(100000);
  recorder.push(rows[0]);
  begun.wait(false);
  for (const TickRecord& row : rows) recorder.push(row);  // does not end where it waits for the writer
  let = true;
  let.notify_all();
  recorder.finish();
  EXPECT_GT(recorder.dropped(), 0);
}

TEST(LiveRecorder, ARefusalOfTheDiskIsToldAtTheEnd) {
  FakeWriter::Log log;
  LiveRecorder recorder(std::make_unique<FakeWriter>(log, 0ms, 10), 64);
  for (const TickRecord& row : test::some_rows(40)) recorder.push(row);
  std::this_thread::sleep_for(120ms);
  EXPECT_TRUE(recorder.failed());
  for (const TickRecord& row : test::some_rows(40)) recorder.push(row);
  EXPECT_THROW(recorder.finish(), Error);
  EXPECT_FALSE(log.finished);
  EXPECT_NO_THROW(recorder.finish());
}

TEST(LiveRecorder, ItsEndFinishesTheTrace) {
  FakeWriter::Log log;
  {
    LiveRecorder recorder(std::make_unique<FakeWriter>(log, 0ms, never), 64);
    recorder.push(test::some_rows(1)[0]);
  }
  EXPECT_TRUE(log.finished);
  EXPECT_EQ(log.rows.size(), 1u);
}

}  // namespace
}  // namespace fingerpad::live_recorder_test
