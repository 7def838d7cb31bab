// Live touches without a window, by devices of this machine: each with a counterpart that is as real as can
// be.
#ifdef FINGERPAD_VIEW
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/mesh_files.hpp"
#include "support/paths.hpp"
#include "support/shell.hpp"
#include "trace/trace.hpp"

namespace fingerpad::live_devices_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

const std::string live_floor =
    "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\nstiffness_n_per_m = 1000\n";

std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

std::string fake(const char* name) {
  return quoted(test::source_dir() / "tests" / "support" / name);
}

TEST(LiveRecorded, FeelsWhatReplayWritesBitForBit) {
  const fs::path folder = test::scratch_dir();
  const std::string vibrating = live_floor + "[friction]\nvibration = { amplitude = 0.1 }\n";
  test::write_file(folder, "sine.toml",
                   vibrating +
                       "[motion]\nkind = \"sine\"\ncentre_m = [0, 0, -0.001]\ndirection = [1, 0, 0]\n"
                       "amplitude_m = 0.005\nfrequency_hz = 4\nduration_s = 0.3\nrate_hz = 500\n");
  test::write_file(folder, "m.csv",
                   "t_s,x_m,y_m,z_m\n0,0,0,0.001\n0.1,0.001,0,-0.001\n0.2,0.004,0,-0.002\n0.3,0,0,-0.001\n");
  test::write_file(folder, "table.toml", vibrating + "[motion]\nfile = \"m.csv\"\nrate_hz = 1000\n");
  test::write_file(folder, "own.toml", vibrating + "[motion]\nfile = \"m.csv\"\n");  // at the file's rate
  for (const std::string name : {"sine", "table", "own"}) {
    const auto replayed = test::fingerpad("replay " + name + ".toml --format csv --out r --quiet", folder);
    ASSERT_EQ(replayed.exit_code, 0) << replayed.err;
    const auto live = test::fingerpad(
        "touch " + name + ".toml --headless --device recorded --record " + name + ".csv", folder);
    ASSERT_EQ(live.exit_code, 0) << live.err;
    EXPECT_EQ(test::bytes_of(folder / (name + ".csv")), test::bytes_of(folder / "r" / (name + ".csv")));
  }
}

TEST(LiveRecorded, NeedsAMotion) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", live_floor);
  const auto told = test::fingerpad("touch floor.toml --headless --device recorded", folder);
  EXPECT_EQ(told.exit_code, 3);
  EXPECT_THAT(told.err, HasSubstr("motion"));
}

TEST(LiveDevices, AreRefusedBeforeAMeshIsLoaded) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "part.stl", "no mesh, which is told where it is loaded\n");
  const auto told = [&](const std::string& device, int code) {
    const auto result =
        test::shell(quoted(test::program()) + " touch part.stl --headless --device " + device, folder);
    EXPECT_EQ(result.exit_code, code) << device;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
  };
  EXPECT_THAT(told("network --bind tea", 2), HasSubstr("--bind tea: is no address"));
  EXPECT_THAT(told("keyboard", 2), HasSubstr("is no terminal of this program's"));
  EXPECT_THAT(told("haply --port 1", 2), HasSubstr("start Haply's Inverse Service"));
  EXPECT_THAT(told("recorded", 3), HasSubstr("part.stl: the scene has no motion to follow"));
}

TEST(LiveDevices, AFolderIsNothingToTouch) {
  const fs::path folder = test::scratch_dir();
  fs::create_directory(folder / "d");
  const auto told = test::fingerpad("touch d --headless --device recorded", folder);
  EXPECT_EQ(told.exit_code, 3);
  EXPECT_EQ(told.err, "fingerpad: error: d: is a folder, not a scene or a mesh: name a file in it\n");
}

TEST(LiveDevices, ARecordingAsCsvSaysWhatItDoesNotKeep) {
  const fs::path folder = test::scratch_dir();
  test::write_file(
      folder, "floor.toml",
      std::string(live_floor) +
          "[motion]\nkind = \"line\"\nfrom_m = [0, 0, 0]\nto_m = [0.001, 0, 0]\nspeed_m_per_s = 1\n");
  const std::string touch = "touch floor.toml --headless --device recorded --record t.";
  EXPECT_THAT(test::fingerpad(touch + "csv", folder).err,
              HasSubstr("fingerpad: t.csv: a CSV recording keeps neither the parts nor the scene"));
  EXPECT_THAT(test::fingerpad(touch + "h5", folder).err, testing::Not(HasSubstr("keeps neither")));
}

TEST(LiveDevices, AreRefusedAfterAFaultOfTheScene) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "typo.toml", std::string(live_floor) + "[fnger]\n");
  const auto told = test::fingerpad("touch typo.toml --headless", folder);
  EXPECT_EQ(told.exit_code, 3);
  EXPECT_THAT(told.err, HasSubstr("did you mean 'finger'?"));
  test::write_file(folder, "floor.toml", live_floor);
  const auto sound = test::fingerpad("touch floor.toml --headless", folder);
  EXPECT_EQ(sound.exit_code, 2);
  EXPECT_THAT(sound.err, HasSubstr("--headless: --device mouse is moved in a window"));
}

TEST(LiveKeyboard, KeysOfATerminalMoveTheFingerAndEndTheTouch) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", live_floor);
  const auto typed =
      test::shell(fake("type_in_terminal") + " 'page keys' '+|\\x1b[C\\x1b[C\\x1b[C|\\x1b[A|\\x1b[6~|q' " +
                      quoted(test::program()) +
                      " touch floor.toml --headless --device keyboard --record t.csv --seconds 60",
                  folder);
  ASSERT_EQ(typed.exit_code, 0) << typed.out << typed.err;
  const Trace trace = read_trace((folder / "t.csv").string());
  ASSERT_FALSE(trace.rows.empty());
  const Vec3 start = trace.rows.front().p_WQ, way = trace.rows.back().p_WQ - start;
  EXPECT_GT(way.x(), 0);
  EXPECT_GT(way.y(), 0);
  EXPECT_LT(way.z(), 0);
  EXPECT_LE(way.x(), 0.003 + 1e-12);  // three keys of 1 mm
  const auto elsewhere = test::fingerpad("touch floor.toml --headless --device keyboard", folder);
  EXPECT_EQ(elsewhere.exit_code, 2);
  EXPECT_THAT(elsewhere.err, HasSubstr("is no terminal of this program's"));
}

/// The terminal of a windowed touch that Ctrl-C ends is as it was, and its trace is whole.
TEST(LiveKeyboard, CtrlCEndsAWindowTooTheTerminalAsItWasTheTraceWhole) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", live_floor);
  const auto typed = test::shell(
      "xvfb-run -a " + fake("type_in_terminal") +
          " 'page keys' '\\x1b[C|\\x03' sh -c 'trap : INT; stty -a >before; \"" + test::program().string() +
          "\" touch floor.toml --device keyboard --record t.h5 --seconds 20; stty -a >after; exit 0'",
      folder);
  ASSERT_EQ(typed.exit_code, 0) << typed.out << typed.err;
  EXPECT_EQ(test::bytes_of(folder / "before"), test::bytes_of(folder / "after"));
  const Trace trace = read_trace((folder / "t.h5").string());
  EXPECT_TRUE(trace.complete);
  EXPECT_LT(trace.rows.back().t_s, 15) << "it was not the seconds that ended it";
}

TEST(LiveKeyboard, ItsLastKeyEndsTheWindow) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", live_floor);
  const auto typed =
      test::shell("xvfb-run -a " + fake("type_in_terminal") + " 'page keys' 'q' " + quoted(test::program()) +
                      " touch floor.toml --device keyboard --seconds 20",
                  folder);
  EXPECT_EQ(typed.exit_code, 0) << typed.out << typed.err;
  long ticks = -1;
  const auto told = typed.out.find(" ticks at ");
  if (told != std::string::npos) ticks = std::stol(typed.out.substr(typed.out.rfind('\n', told) + 1));
  EXPECT_GT(ticks, 0);
  EXPECT_LT(ticks, 15'000) << "it was not the seconds that ended it";
}

TEST(LiveSpacemouse, ItsDaemonsEventsDriveTheFinger) {
  const fs::path folder = test::scratch_dir();
  test::write_file(folder, "floor.toml", live_floor);
  const std::string touch =
      "SPNAV_SOCKET=s.sock " + quoted(test::program()) + " touch floor.toml --headless --device spacemouse ";
  const auto nobody = test::shell(touch, folder);
  EXPECT_EQ(nobody.exit_code, 2);
  EXPECT_THAT(nobody.err, HasSubstr("install and start spacenavd"));
  const auto driven = test::shell(
      fake("fake_spacenavd") +
          " s.sock & daemon=$!\n"
          "until [ -S s.sock ]; do kill -0 $daemon || exit 99; sleep 0.02; done\n" +
          touch + "--record t.csv --seconds 1.2; code=$?\n" + "kill $daemon 2>/dev/null; exit $code",
      folder);
  ASSERT_EQ(driven.exit_code, 0) << driven.err;
  const Trace trace = read_trace((folder / "t.csv").string());
  const Vec3 way = trace.rows.back().p_WQ - trace.rows.front().p_WQ;
  EXPECT_GT(way.x(), 0.005);  // 100 mm/s for half a second, on a machine that is not too busy
  EXPECT_EQ(way.y(), 0);
  EXPECT_EQ(way.z(), 0);
}

/// A touch by the fake service of Haply's, and what the service was sent.
struct HaplyRun {
  fs::path folder = test::scratch_dir();
  test::ShellResult shell;
  std::vector<json> messages;

  /// Until the service has ended, and the touch has told that it is gone. `then` goes on in that shell:
  /// $port, and in `told` what the touch has said.
  void go(const std::string& service_options, const std::string& then = "") {
    test::write_file(folder, "floor.toml", live_floor);
    shell = test::shell(
        "wait_for() { until grep -q \"$1\" told; do kill -0 $touch || exit 98; sleep 0.02; done; }\n" +
            fake("fake_inverse_service") + " " + service_options +
            " >said & service=$!\n"
            "until port=$(head -n 1 said) && [ -n \"$port\" ]; do kill -0 $service || exit 99; "
            "sleep 0.02; done\n" +
            quoted(test::program()) +
            " touch floor.toml --headless --device haply --port $port --seconds 60 --record "
            "t.csv 2>told & touch=$!\n"
            "while kill -0 $service && kill -0 $touch; do sleep 0.02; done 2>/dev/null\n"
            "if kill -0 $touch 2>/dev/null; then wait_for 'Service is gone'\n" +
            then +
            "fi\n"
            "kill $touch $service 2>/dev/null; wait $touch; code=$?; wait $service; cat told >&2; "
            "exit $code",
        folder);
    std::istringstream lines(test::bytes_of(folder / "said"));
    std::string line;
    std::getline(lines, line);  // the port
    while (std::getline(lines, line)) messages.push_back(json::parse(line));
  }
  static double force_n(const json& message) {
    const json& f = message["inverse3"][0]["commands"]["set_cursor_force"]["vector"];
    return std::hypot(f["x"].get<double>(), f["y"].get<double>(), f["z"].get<double>());
  }
};

TEST(LiveHaply, SendsAForceForEveryStateItsNameOnceAndNeverMoreThanTheLimit) {
  HaplyRun run;
  run.go("--states 400 --noise");
  ASSERT_EQ(run.shell.exit_code, 0) << run.shell.err;
  EXPECT_THAT(run.shell.err, HasSubstr("fingerpad: haply: Inverse3 049D"));
  EXPECT_THAT(run.shell.err, HasSubstr("the Inverse Service ended before the touch did"));
  ASSERT_EQ(run.messages.size(), 400u);
  EXPECT_EQ(run.messages[0]["session"]["configure"]["profile"]["name"], "fingerpad");
  double most_n = 0;
  for (std::size_t k = 0; k < run.messages.size(); ++k) {
    EXPECT_EQ(run.messages[k].contains("session"), k == 0);
    EXPECT_EQ(run.messages[k]["inverse3"][0]["device_id"], "049D");
    most_n = std::max(most_n, HaplyRun::force_n(run.messages[k]));
  }
  EXPECT_EQ(HaplyRun::force_n(run.messages[0]), 0) << "nothing is known of the device yet";
  EXPECT_LE(most_n, 5);
  EXPECT_GT(most_n, 0.1);
  const Trace trace = read_trace((run.folder / "t.csv").string());
  EXPECT_TRUE(trace.info.sent);
}

TEST(LiveHaply, ASilentServiceIsSentNoForce) {
  HaplyRun run;
  run.go("--states 400 --silent-at 350");
  ASSERT_EQ(run.shell.exit_code, 0) << run.shell.err;
  ASSERT_GT(run.messages.size(), 351u);
  double before_n = 0;  // not of the last alone: on a busy machine the service may have been late before
  for (std::size_t k = 200; k < 350; ++k) before_n = std::max(before_n, HaplyRun::force_n(run.messages[k]));
  EXPECT_GT(before_n, 0.1);
  EXPECT_EQ(HaplyRun::force_n(run.messages[350]), 0) << "sent while the answer to the 350th was late";
}

TEST(LiveHaply, AStateThatNeverComesIsAskedForAnewAndTold) {
  HaplyRun run;
  run.go("--states 500 --skip 300");
  ASSERT_EQ(run.shell.exit_code, 0) << run.shell.err;
  ASSERT_EQ(run.messages.size(), 500u);
  EXPECT_EQ(HaplyRun::force_n(run.messages[300]), 0) << "sent in the silence";
  double after_n = 0;  // the last ones: the limit grows anew, and softly
  for (std::size_t k = 400; k < 500; ++k) after_n = std::max(after_n, HaplyRun::force_n(run.messages[k]));
  EXPECT_GT(after_n, 0.1);
  EXPECT_THAT(run.shell.err, HasSubstr("; 1 answers of the service never came"));
}

TEST(LiveHaply, AServiceThatComesBackIsFoundAgainAndFeltSoftly) {
  HaplyRun run;
  // Gone before a trouble's least time is over: that it was there counts all the same.
  run.go("--states 150", fake("fake_inverse_service") +
                             " --states 400 --port $port >again & service=$!\n"
                             "wait_for 'haply: goes on'\nwait $service\n");
  ASSERT_EQ(run.shell.exit_code, 0) << run.shell.err;
  EXPECT_THAT(run.shell.err, HasSubstr("haply: the Inverse Service is gone: no force"));
  EXPECT_THAT(run.shell.err, HasSubstr("the Inverse Service was found again 1 times"));
  std::istringstream lines(test::bytes_of(run.folder / "again"));
  std::string line;
  std::getline(lines, line);  // the port
  std::vector<json> again;
  while (std::getline(lines, line)) again.push_back(json::parse(line));
  ASSERT_EQ(again.size(), 400u);
  EXPECT_EQ(again[0]["session"]["configure"]["profile"]["name"], "fingerpad") << "another session";
  EXPECT_EQ(HaplyRun::force_n(again[0]), 0);
  EXPECT_GT(HaplyRun::force_n(again[399]), 0.1);
  for (const json& message : again) EXPECT_LE(HaplyRun::force_n(message), 5);
}

TEST(LiveHaply, TellsWhatIsMissing) {
  HaplyRun run;
  run.go("--empty");
  EXPECT_EQ(run.shell.exit_code, 2);
  EXPECT_THAT(run.shell.err, HasSubstr("the Inverse Service has no Inverse3"));
  const auto nobody = test::fingerpad("touch floor.toml --headless --device haply --port 1", run.folder);
  EXPECT_EQ(nobody.exit_code, 2);
  EXPECT_THAT(nobody.err,
              testing::ContainsRegex("ws://localhost:1: no service answers there: .*; start Haply's "
                                     "Inverse Service on this machine first, or say its port "
                                     "with --port"));
}

}  // namespace
}  // namespace fingerpad::live_devices_test
#endif
