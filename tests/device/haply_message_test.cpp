#include "device/haply_message.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "device/remote_finger.hpp"
#include "support/effort.hpp"

namespace fingerpad::haply_message_test {
namespace {

using nlohmann::json;

const std::string inventory =
    R"({"session_id":7,"inverse3":[{"device_id":"049D","config":{"type":"inverse3","port":"COM12",)"
    R"("handedness":"right"},"state":{"cursor_position":{"x":0.01,"y":-0.125,"z":0.15},)"
    R"("cursor_velocity":{"x":0.0,"y":0.0,"z":0.0},"control_mode":"idle"},"status":{"ready":true}}],)"
    R"("verse_grip":[{"device_id":"61548","state":{"buttons":{"a":true,"b":false,"c":false},"hall":0,)"
    R"("orientation":{"x":0.5,"y":0.5,"z":-0.5,"w":0.5}}}]})";

TEST(HaplyMessage, ReadsTheFirstDeviceAndItsGrip) {
  const auto frame = read_haply_frame(inventory);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->device_id, "049D");
  EXPECT_EQ(frame->place.p_D, Vec3(0.01, -0.125, 0.15));
  ASSERT_TRUE(frame->place.attitude_D);
  EXPECT_EQ(frame->place.attitude_D->z(), -0.5);
  EXPECT_TRUE(frame->place.clutch);
}

TEST(HaplyMessage, ADeviceWithoutAGripIsNotTurned) {
  json text = json::parse(inventory);
  text["verse_grip"] = json::array();
  const auto frame = read_haply_frame(text.dump());
  ASSERT_TRUE(frame);
  EXPECT_FALSE(frame->place.attitude_D);
  EXPECT_FALSE(frame->place.clutch);
  text["inverse3"] = json::array();
  EXPECT_EQ(read_haply_frame(text.dump())->device_id, "");
}

TEST(HaplyMessage, RefusesWhatIsNoPlace) {
  const auto with = [](const char* pointer, const json& value) {
    json text = json::parse(inventory);
    text[json::json_pointer(pointer)] = value;
    return read_haply_frame(text.dump()).has_value();
  };
  EXPECT_TRUE(with("/inverse3/0/state/cursor_position/x", 1000));
  EXPECT_FALSE(with("/inverse3/0/state/cursor_position/x", 1001));
  EXPECT_FALSE(with("/inverse3/0/state/cursor_position/x", "0.1"));
  EXPECT_FALSE(with("/inverse3/0/state/cursor_position", json::array({1, 2, 3})));
  EXPECT_FALSE(with("/inverse3/0/device_id", 7));
  EXPECT_FALSE(with("/inverse3/0", 7));
  EXPECT_FALSE(with("/verse_grip/0/state/orientation/w", 0.6));
  for (const char* text : {"", "[]", "7", "null", "{", R"({"inverse3":[{"state":{}}]})"}) {
    EXPECT_FALSE(read_haply_frame(text)) << text;
  }
  std::string infinite = inventory;
  infinite.replace(infinite.find("-0.125"), 6, "-1e999");
  EXPECT_FALSE(read_haply_frame(infinite));
}

TEST(HaplyMessage, SaysTheForceAlsoWhereItIsZeroAndItsNameOnce) {
  const json first = json::parse(haply_message("049D", Vec3(0.5, 0, -1), "fingerpad"));
  EXPECT_EQ(first, json::parse(R"({"session":{"configure":{"profile":{"name":"fingerpad"}}},)"
                               R"("inverse3":[{"device_id":"049D","commands":{"set_cursor_force":)"
                               R"({"vector":{"x":0.5,"y":0.0,"z":-1.0}}}}]})"));
  const json next = json::parse(haply_message("049D", Vec3::Zero(), ""));
  EXPECT_FALSE(next.contains("session"));
  EXPECT_EQ(next["inverse3"][0]["commands"]["set_cursor_force"]["vector"]["z"], 0.0);
}

/// A frame of which some bytes are others, or are not there.
std::string damaged(std::string text, std::mt19937& bits) {
  const std::string letters = "{}[]\":,0e9-+.\\xt\x80";
  for (unsigned n = bits() % 6; n > 0; --n) {
    const std::size_t at = bits() % text.size();
    if (bits() % 4 == 0) {
      text.erase(at, bits() % 30);
    } else {
      text[at] = letters[bits() % letters.size()];
    }
    if (text.empty()) return text;
  }
  return text;
}

TEST(HaplyMessage, AHundredThousandHostileFramesGiveNoForceThatIsNotFiniteOrAboveTheLimit) {
  std::mt19937 bits(11);
  RemoteFinger finger(DeviceSettings{}, {0, Vec3(0, 0, 1), Vec3::UnitY()});
  std::int64_t now_ns = 0;
  DeviceReading reading;
  long read = 0, silent = 0;
  const int frames = test::samples(100'000);
  for (int k = 0; k < frames; ++k, now_ns += 1'000'000) {
    if (const auto frame = read_haply_frame(damaged(inventory, bits))) {
      reading.place = frame->place;
      reading.arrived_ns = now_ns;
      ++reading.accepted;
      finger.hear(reading);
      ++read;
    }
    if (k % 5000 == 4999) now_ns += 19'000'000;  // and so nothing has come for 20 ms, or just did
    TickRecord tick;
    tick.p_WQ = finger.advance(now_ns, 1e-3).p_WQ;
    ASSERT_TRUE(tick.p_WQ.allFinite());
    tick.phase = tick.p_WQ.z() < 0.2 ? Phase::slip : Phase::free;
    tick.normal_W = Vec3::UnitZ();
    tick.force_W_n = Vec3(0.3, 0, 1) * 1e4 * (0.2 - tick.p_WQ.z());
    const DeviceAnswer answer = finger.feel(tick, now_ns, true);
    ASSERT_TRUE(answer.force_D_n.allFinite() && answer.torque_D_n_m.allFinite());
    ASSERT_LE(answer.force_D_n.norm(), 5);
    if (now_ns - reading.arrived_ns < 20'000'000) continue;
    ASSERT_EQ(answer.force_D_n, Vec3::Zero());
    ++silent;
  }
  EXPECT_GT(silent, 0);
  EXPECT_GT(read, frames / 10);
  EXPECT_LT(read, frames * 9 / 10);
}

}  // namespace
}  // namespace fingerpad::haply_message_test
