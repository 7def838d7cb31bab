// What a recording holds when the program is killed, and what is told when the disk is full.
#ifdef FINGERPAD_VIEW
#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "device/device_packet.hpp"
#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"
#include "trace/trace.hpp"

namespace fingerpad::killed_recording_test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using testing::HasSubstr;

constexpr const char* rubbed_floor =
    "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[motion]\nrate_hz = 1000\n";

/// A tick is on the disk so long after its answer was sent: the recorder's tenth of a second, and four more
/// for a machine that is busy.
constexpr double safe_after_s = 0.5;

/// A touch that records, its device, and the end of both.
class RecordedTouch {
 public:
  RecordedTouch(const fs::path& folder, const std::string& trace) : told_(folder / (trace + ".told")) {
    child_ = fork();
    if (child_ != 0) return;
    const int told = open(told_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(told, STDERR_FILENO);
    dup2(told, STDOUT_FILENO);
    if (chdir(folder.c_str()) != 0) _exit(99);
    const std::string program = test::program().string();
    execl(program.c_str(), "fingerpad", "touch", "floor.toml", "--headless", "--device", "network", "--port",
          "0", "--record", trace.c_str(), nullptr);
    _exit(98);
  }
  ~RecordedTouch() { kill_now(); }
  RecordedTouch(const RecordedTouch&) = delete;
  RecordedTouch& operator=(const RecordedTouch&) = delete;

  /// Waits until it listens. @returns false where it never does
  bool connect() {
    for (int k = 0; k < 2000; ++k) {
      const std::string told = fs::exists(told_) ? test::bytes_of(told_) : "";
      const auto at = told.find("127.0.0.1:");
      if (at != std::string::npos && told.find(", UDP") != std::string::npos) {
        to_.sin_family = AF_INET;
        to_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        to_.sin_port = htons(static_cast<std::uint16_t>(std::stoi(told.substr(at + 10))));
        socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0);
        return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  /// Tells the next place, a micrometre on, and notes which have been answered when.
  void exchange() {
    DevicePacket packet;
    packet.sequence = ++sequence_;
    packet.position_m = Vec3(1e-6 * sequence_, 0, -0.001);
    const PacketBytes bytes = packet_of(packet);
    sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&to_), sizeof(to_));
    unsigned char buffer[128];
    for (ssize_t count; (count = recv(socket_, buffer, sizeof(buffer), 0)) > 0;) {
      AnswerPacket answer;
      if (read_answer({buffer, static_cast<std::size_t>(count)}, answer))
        answered_.push_back({Clock::now(), answer.accepted_sequence});
    }
  }

  void kill_now() {
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    killed_ = Clock::now();
    waitpid(child_, nullptr, 0);
    child_ = -1;
    if (socket_ >= 0) close(socket_);
  }

  /// How far the finger had come, by the answers that are old enough to be safe.
  double safe_m() const {
    double x_m = 0;
    for (const auto& [at, sequence] : answered_) {
      if (std::chrono::duration<double>(killed_ - at).count() > safe_after_s) x_m = 1e-6 * sequence;
    }
    return x_m;
  }

 private:
  fs::path told_;
  pid_t child_ = -1;
  int socket_ = -1;
  sockaddr_in to_{};
  std::uint32_t sequence_ = 0;
  std::vector<std::pair<Clock::time_point, std::uint32_t>> answered_;
  Clock::time_point killed_;
};

void expect_whole_rows(const Trace& trace, double safe_m) {
  EXPECT_FALSE(trace.complete);
  double x_m = 0;
  for (std::size_t k = 0; k < trace.rows.size(); ++k) {
    ASSERT_EQ(trace.rows[k].t_s, static_cast<double>(k) / 1000);
    ASSERT_TRUE(trace.rows[k].force_W_n.allFinite());
    x_m = std::max(x_m, trace.rows[k].p_WQ.x());
  }
  EXPECT_GE(x_m, safe_m);
}

// Ten moments, the first at once, each for both forms; half of them late enough for something to be safe.
TEST(KilledRecording, ReadsBackAtAnyMomentWithAllThatWasOlderThanHalfASecond) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", rubbed_floor);
  std::mt19937 bits(5);
  int safe = 0;
  for (int moment = 0; moment < 10; ++moment) {
    const double late_s = moment % 2 == 0 ? 0.0 : 0.55;
    const double end_s = moment == 0 ? 0 : late_s + 1e-4 * static_cast<double>(bits() % 3000);
    const std::string name = std::to_string(moment);
    RecordedTouch h5(folder, name + ".h5"), csv(folder, name + ".csv");
    ASSERT_TRUE(h5.connect() && csv.connect());
    const Clock::time_point start = Clock::now();
    while (std::chrono::duration<double>(Clock::now() - start).count() < end_s) {
      h5.exchange();
      csv.exchange();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    h5.kill_now();
    csv.kill_now();
    expect_whole_rows(read_trace((folder / (name + ".h5")).string()), h5.safe_m());
    expect_whole_rows(read_trace((folder / (name + ".csv.part")).string()), csv.safe_m());
    safe += (h5.safe_m() > 0 ? 1 : 0) + (csv.safe_m() > 0 ? 1 : 0);
  }
  EXPECT_GE(safe, 5) << "else little was asked of them";
}

TEST(FullDisk, IsToldAtOnceAndTheTouchGoesOn) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", rubbed_floor);
  for (const std::string trace : {"t.csv", "t.h5"}) {
    const auto run = test::shell(
        "rm -f told; ulimit -f 256; '" + test::program().string() +
            "' touch floor.toml --headless --device network --port 0 --seconds 60 --record " + trace +
            " 2>told & live=$!\n"
            "until grep -q 'recorded no longer' told; do kill -0 $live || exit 98; sleep 0.02; done\n"
            "sleep 0.1; kill -0 $live || exit 97; kill $live; wait $live; code=$?; cat told >&2; exit $code",
        folder);
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(trace + ": cannot be written: File too large; the touch goes on"));
  }
}

TEST(ExistingTrace, OfEitherFormIsKeptUnlessForced) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", rubbed_floor);
  for (const std::string trace : {"t.csv", "t.h5"}) {
    test::write_file(folder, trace, "precious");
    const std::string call =
        "touch floor.toml --headless --device network --port 0 --seconds 0.05 --record " + trace;
    const auto refused = test::fingerpad(call, folder);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr(trace + ": exists already; --force writes over it"));
    EXPECT_EQ(test::bytes_of(folder / trace), "precious");
    EXPECT_EQ(test::fingerpad(call + " --force", folder).exit_code, 0);
    EXPECT_FALSE(read_trace((folder / trace).string()).rows.empty());
  }
}

TEST(ExistingTrace, ThatWasCutShortIsKeptUnlessForced) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", rubbed_floor);
  test::write_file(folder, "t.csv.part", "precious");
  const std::string call =
      "touch floor.toml --headless --device network --port 0 --seconds 0.05 --record t.csv";
  const auto refused = test::fingerpad(call, folder);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("t.csv.part: is of a recording by that name that was cut short or is "
                                     "still being written; --force"));
  EXPECT_EQ(test::bytes_of(folder / "t.csv.part"), "precious");
  EXPECT_EQ(test::fingerpad(call + " --force", folder).exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "t.csv.part"));
}

}  // namespace
}  // namespace fingerpad::killed_recording_test
#endif
