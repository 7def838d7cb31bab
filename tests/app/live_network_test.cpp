// A live touch without a window, moved over a real socket by the reference bridge (tools/device_bridge).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"
#include "trace/trace.hpp"

namespace fingerpad::live_network_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

enum Status { touching = 1, limited = 8, watchdog = 16, stopped = 32 };

constexpr const char* floor_scene =
    "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\nstiffness_n_per_m = 1000\n[motion]\nrate_hz = "
    "1000\n";

constexpr const char* ball_scene =
    "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\nstiffness_n_per_m = 1000\n[finger]\nradius_m = "
    "0.005\n[motion]\nrate_hz = 1000\n";

double norm_of(const json& force_n) {
  return std::hypot(force_n[0].get<double>(), force_n[1].get<double>(), force_n[2].get<double>());
}

/// Runs `touch` of floor.toml without a window, and the bridge until it ends; then asks `touch` to end.
struct LiveRun {
  fs::path folder = test::scratch_dir();
  std::string scene = floor_scene;
  test::ShellResult shell;
  std::vector<json> answers;

  void go(const std::string& bridge_options, const std::string& signal = "TERM") {
    test::write_file(folder, "floor.toml", scene);
    const std::string program = test::program().string();
    const std::string bridge = (test::source_dir() / "tools" / "device_bridge").string();
    // A shell's job in the background is started to ignore SIGINT.
    shell = test::shell("env --default-signal=INT '" + program +
                            "' touch floor.toml --headless --device network --port 0 --seconds 100 "
                            "--record t.csv 2>told & live=$!\n"
                            "until port=$(sed -n 's/.* 127.0.0.1:\\([0-9]*\\),.*/\\1/p' told); "
                            "[ -n \"$port\" ]; do kill -0 $live || exit 99; sleep 0.02; done\n"
                            "python3 '" +
                            bridge + "' $port --json " + bridge_options + " >answers || exit 98\n" +
                            "kill -" + signal + " $live; wait $live; code=$?; cat told >&2; exit $code",
                        folder);
    std::istringstream lines(test::bytes_of(folder / "answers"));
    for (std::string line; std::getline(lines, line);) answers.push_back(json::parse(line));
  }
};

TEST(LiveNetwork, ADeviceMovesTheFingerFeelsTheForceAndTheTraceHasBoth) {
  LiveRun run;
  run.go("--seconds 1 --pause-at 0.5 --press -0.002");
  ASSERT_EQ(run.shell.exit_code, 0) << run.shell.err;
  EXPECT_THAT(run.shell.err, HasSubstr("fingerpad: network: listening for a device on 127.0.0.1:"));
  EXPECT_THAT(run.shell.err, HasSubstr(" packets accepted, 0 dropped"));
  ASSERT_GT(run.answers.size(), 10u);
  bool touched = false, tripped = false;
  for (const json& answer : run.answers) {
    EXPECT_LE(norm_of(answer["force_n"]), 5);
    touched |= (answer["status"].get<int>() & touching) != 0 && norm_of(answer["force_n"]) > 0.1;
    tripped |= (answer["status"].get<int>() & watchdog) != 0;
  }
  EXPECT_TRUE(touched);
  EXPECT_TRUE(tripped) << "the device was silent for 0.2 s";
  const Trace trace = read_trace((run.folder / "t.csv").string());
  EXPECT_TRUE(trace.complete);
  EXPECT_TRUE(trace.info.sent);
  double pressed_n = 0;
  int same = 0;
  for (const TickRecord& row : trace.rows) {
    ASSERT_TRUE(row.sent_W_n.allFinite());
    pressed_n = std::max(pressed_n, row.force_W_n.norm());
    ASSERT_LE(row.sent_W_n.norm(), 5);
    // Once the limit has grown and the force goes on evenly, the model's force is let through.
    if (row.force_W_n.norm() > 1.5 && row.sent_W_n == row.force_W_n) ++same;
  }
  EXPECT_NEAR(pressed_n, 2, 0.3);  // 2 mm into 1000 N/m, and friction
  EXPECT_GT(same, 50);
}

TEST(LiveNetwork, ADeviceThatSendsTooSeldomIsToldSoAtOnceAndAtTheEnd) {
  LiveRun run;
  run.go("--seconds 1 --rate 40 --press 0.003");
  ASSERT_EQ(run.shell.exit_code, 0) << run.shell.err;
  EXPECT_THAT(run.shell.err,
              testing::ContainsRegex("fingerpad: network: no packet on .* for 20 ms: finger lifted, "
                                     "again and again\n"));
  EXPECT_THAT(run.shell.err, testing::ContainsRegex("for 20 ms lifted the finger [0-9]+ times: the device "
                                                    "sends too seldom"));
}

/// To the last bit.
std::vector<std::uint64_t> forces_of(const Trace& trace) {
  std::vector<std::uint64_t> forces;
  for (const TickRecord& row : trace.rows) {
    for (const double newtons : row.force_W_n) forces.push_back(std::bit_cast<std::uint64_t>(newtons));
  }
  return forces;
}

TEST(LiveNetwork, TheTraceOfAFingerThatIsTurnedGivesTheSameForcesAgainBitForBit) {
  LiveRun run;
  run.scene = ball_scene;
  run.go("--seconds 0.8 --press 0.003 --turn 3");
  ASSERT_EQ(run.shell.exit_code, 0) << run.shell.err;
  const Trace live = read_trace((run.folder / "t.csv").string());
  EXPECT_TRUE(live.info.turning);
  EXPECT_TRUE(live.info.attitudes);
  double rubbed_n = 0, turned = 0;
  for (const TickRecord& row : live.rows) {
    rubbed_n = std::max(rubbed_n, row.friction_W_n.norm());
    turned = std::max(turned, std::abs(row.attitude[1]));
  }
  EXPECT_GT(rubbed_n, 0.1);
  EXPECT_GT(turned, 0.5);
  test::write_file(run.folder, "again.toml", run.scene + "file = \"t.csv\"\n");
  const auto replayed = test::fingerpad("replay again.toml --out r --quiet", run.folder);
  ASSERT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_EQ(forces_of(read_trace((run.folder / "r" / "again.h5").string())), forces_of(live));
  for (const char* ending : {"csv", "h5"}) {
    const auto felt = test::fingerpad(
        std::string("touch again.toml --headless --device recorded --record again.") + ending, run.folder);
    ASSERT_EQ(felt.exit_code, 0) << felt.err;
    EXPECT_EQ(forces_of(read_trace((run.folder / (std::string("again.") + ending)).string())),
              forces_of(live));
  }
}

TEST(LiveNetwork, AnEmergencyStopHoldsTheForceAtZeroAndALimitIsKept) {
  LiveRun run;
  run.go("--seconds 0.9 --press -0.02 --stop-at 0.7", "INT");
  ASSERT_EQ(run.shell.exit_code, 0) << run.shell.err;
  bool was_limited = false, was_stopped = false;
  for (const json& answer : run.answers) {
    const int status = answer["status"].get<int>();
    was_limited |= (status & limited) != 0;
    was_stopped |= (status & stopped) != 0;
    EXPECT_EQ(was_stopped, (status & stopped) != 0) << "nobody takes it back";
    EXPECT_LE(norm_of(answer["force_n"]), was_stopped ? 0 : 5);
  }
  EXPECT_THAT(run.shell.err, HasSubstr("fingerpad: network: told to end, by Ctrl-C or another signal\n"));
  EXPECT_TRUE(was_limited) << "20 mm into 1000 N/m are 20 N";
  EXPECT_TRUE(was_stopped);
  EXPECT_THAT(run.shell.err, HasSubstr("fingerpad: network: STOPPED: no force until the end "));
  EXPECT_THAT(run.shell.err, HasSubstr("; the emergency stop was on at the end: no force\n"));
}

/// The bridge holds its stop from its first packet on; `g` is typed against it.
TEST(LiveNetwork, AKeyGivesNoForceBackThatTheDeviceItselfHoldsStopped) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", std::string(floor_scene) + "[device]\nwatchdog_s = 1\n");
  const std::string tools = (test::source_dir() / "tests" / "support" / "type_in_terminal").string();
  const std::string bridge = (test::source_dir() / "tools" / "device_bridge").string();
  const auto run =
      test::shell("'" + tools + "' STOPPED 'g|g' '" + test::program().string() +
                      "' touch floor.toml --headless --device network --port 0 --seconds 60 >told & live=$!\n"
                      "until grep -q 'no device yet' told && port=$(sed -n 's/.* "
                      "127.0.0.1:\\([0-9]*\\),.*/\\1/p' told); [ -n \"$port\" ]; "
                      "do kill -0 $live || exit 99; sleep 0.02; done\n"
                      "python3 '" +
                      bridge +
                      "' $port --json --seconds 30 --stop-at 0 >answers & bridge=$!\n"
                      "until [ $(grep -c 'STOPPED\\|network: goes on' told) -gt 1 ] && grep -q 'is heard' "
                      "told; do kill -0 $bridge || exit 98; "
                      "sleep 0.02; done\n"
                      "kill $bridge $live; wait $live; true",
                  folder);
  const std::string told = test::bytes_of(folder / "told");
  ASSERT_EQ(run.exit_code, 0) << run.err << told;
  EXPECT_THAT(
      told, testing::ContainsRegex("STOPPED: no force until g, and the device, release it(.|\r|\n)*STOPPED"));
  EXPECT_THAT(told, testing::Not(HasSubstr("network: goes on")));
}

TEST(LiveNetwork, AKeyOfTheTerminalStopsTheForce) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", floor_scene);
  const std::string tools = (test::source_dir() / "tests" / "support" / "type_in_terminal").string();
  const std::string bridge = (test::source_dir() / "tools" / "device_bridge").string();
  const auto run = test::shell(
      "'" + tools + "' 'emergency stop' 'x|x' '" + test::program().string() +
          "' touch floor.toml --headless --device network --port 0 --seconds 60 >told & live=$!\n"
          "until grep -q STOPPED told; do kill -0 $live || exit 99; sleep 0.02; done\n"
          "python3 '" +
          bridge +
          "' $(sed -n 's/.* 127.0.0.1:\\([0-9]*\\),.*/\\1/p' told) --json --seconds 0.6 >answers || exit 98\n"
          "kill $live; wait $live; true",
      folder);
  ASSERT_EQ(run.exit_code, 0) << run.err << test::bytes_of(folder / "told");
  std::istringstream lines(test::bytes_of(folder / "answers"));
  long answers = 0;
  for (std::string line; std::getline(lines, line); ++answers) {
    const json answer = json::parse(line);
    EXPECT_NE(answer["status"].get<int>() & stopped, 0);
    EXPECT_EQ(norm_of(answer["force_n"]), 0);
  }
  EXPECT_GT(answers, 10);
}

TEST(LiveNetwork, ARemovedFolderIsToldAtOnceAndTheTouchGoesOn) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", floor_scene);
  for (const std::string trace : {"t.csv", "t.h5"}) {
    const auto run =
        test::shell("rm -f told; mkdir r; '" + test::program().string() +
                        "' touch floor.toml --headless --device network --port 0 --seconds 60 "
                        "--record r/" +
                        trace +
                        " 2>told & live=$!\n"
                        "until grep -q listening told; do kill -0 $live || exit 99; sleep 0.02; done\n"
                        "rm -r r\n"
                        "until grep -q 'recorded no longer' told; do kill -0 $live || exit 98; "
                        "sleep 0.02; done\n"
                        "kill -0 $live || exit 97; kill $live; wait $live; code=$?; cat told >&2; "
                        "exit $code",
                    folder);
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_THAT(run.err,
                HasSubstr("r/" + trace + ": the file, or its folder, was removed; the touch goes on"));
  }
}

TEST(LiveNetwork, EndsAfterItsSecondsAndOverwritesNoTraceUnasked) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", floor_scene);
  const std::string call =
      "touch floor.toml --headless --device network --port 0 --seconds 0.05 --record t.h5";
  const auto first = test::fingerpad(call, folder);
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr(" ticks recorded in t.h5\n"));
  const std::string bytes = test::bytes_of(folder / "t.h5");
  const auto second = test::fingerpad(call, folder);
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_THAT(second.err, HasSubstr("t.h5: exists already; --force writes over it"));
  EXPECT_EQ(test::bytes_of(folder / "t.h5"), bytes);
  EXPECT_EQ(test::fingerpad(call + " --force", folder).exit_code, 0);
}

TEST(LiveNetwork, TellsWhoReadsNoDeviceTable) {
  const fs::path folder = test::scratch_dir();
  test::write_file(
      folder, "s.toml",
      "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n[device]\nscale = 2\n[motion]\nkind = "
      "\"line\"\nfrom_m = [0, 0, 1]\nto_m = [0, 0, 1.01]\nspeed_m_per_s = 1\n");
  const auto recorded = test::fingerpad("touch s.toml --headless --device recorded", folder);
  EXPECT_EQ(recorded.exit_code, 0) << recorded.err;
  EXPECT_THAT(recorded.err, HasSubstr("--device recorded does not read it"));
  const auto network =
      test::fingerpad("touch s.toml --headless --device network --port 0 --seconds 0.01", folder);
  EXPECT_THAT(network.err, testing::Not(HasSubstr("does not read it")));
}

TEST(LiveNetwork, TellsWhatCannotBe) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", floor_scene);
  const auto windowless = test::fingerpad("touch floor.toml --headless --seconds 1", folder);
  EXPECT_EQ(windowless.exit_code, 2);
  EXPECT_THAT(windowless.err, HasSubstr("is moved in a window: choose another device"));
  const auto elsewhere =
      test::fingerpad("touch floor.toml --headless --device network --bind 203.0.113.7 --port 0", folder);
  EXPECT_EQ(elsewhere.exit_code, 2);
  EXPECT_THAT(elsewhere.err, HasSubstr("203.0.113.7 port 0: cannot be listened on"));
  for (const std::string unread :
       {"recorded --port 5", "keyboard --bind 127.0.0.1", "haply --bind 127.0.0.1"}) {
    const auto told = test::fingerpad("touch floor.toml --headless --seconds 1 --device " + unread, folder);
    EXPECT_EQ(told.exit_code, 2) << unread;
    EXPECT_THAT(told.err, HasSubstr(": leave it out"));
  }
}

#ifndef FINGERPAD_VIEW
TEST(LiveNetwork, NeedsNoWindowWhereThereIsNone) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", floor_scene);
  const auto told = test::fingerpad("touch floor.toml --device network --port 0", folder);
  EXPECT_EQ(told.exit_code, 2);
  EXPECT_THAT(told.err,
              HasSubstr("this program was built without a window (FINGERPAD_VIEW=OFF): add --headless"));
}
#endif

}  // namespace
}  // namespace fingerpad::live_network_test
