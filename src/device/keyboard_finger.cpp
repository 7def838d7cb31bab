#include "device/keyboard_finger.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "device/device_table.hpp"
#include "device/reach.hpp"

namespace fingerpad {
namespace {

/// Makes of steps a motion, as a hand would.
constexpr double key_bandwidth_hz = 4;
constexpr double first_step_m = 5e-4, least_step_m = 1e-6, greatest_step_m = 0.1;

}  // namespace

KeyboardFinger::KeyboardFinger(const DeviceSetup& setup)
    : axes_W_(setup.scene.device.scale * setup.scene.device.rotation),
      finger_(setup.start),
      follower_(setup.start.p_WQ, key_bandwidth_hz),
      target_W_(setup.start.p_WQ),
      step_m_(first_step_m),
      seen_target_W_(setup.start.p_WQ),
      keys_([this](std::string_view key) { take(key); }) {}

void KeyboardFinger::take(std::string_view key) {
  constexpr std::pair<std::string_view, std::array<double, 3>> ways[] = {
      {"left", {-1, 0, 0}}, {"right", {1, 0, 0}},   {"down", {0, -1, 0}},
      {"up", {0, 1, 0}},    {"page up", {0, 0, 1}}, {"page down", {0, 0, -1}}};
  for (const auto& [name, way] : ways) {
    if (key != name) continue;
    target_W_ += step_m_ * (axes_W_ * Vec3(way[0], way[1], way[2]));
    target_W_ = target_W_.cwiseMax(-device_reach_m).cwiseMin(device_reach_m);
    wanted_.put(target_W_);
    return;
  }
  if (key == "+") step_m_ = std::min(2 * step_m_, greatest_step_m);
  if (key == "-") step_m_ = std::max(step_m_ / 2, least_step_m);
  if (key == "q") ended_.store(true, std::memory_order_relaxed);
}

FingerSample KeyboardFinger::advance(double dt_s) noexcept {
  wanted_.take(seen_target_W_);
  finger_.p_WQ = follower_.advance(seen_target_W_, dt_s);
  return finger_;
}

std::string KeyboardFinger::opening_words() const {
  return "arrow keys: along x and y; page keys: along z; + and -: longer and shorter steps (0.5 mm first); "
         "q: end";
}

DeviceEntry keyboard_device() noexcept {
  return {.name = "keyboard",
          .doc = "the keys of the terminal: arrows along x and y, page keys along z",
          .make = [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<KeyboardFinger>(setup);
          },
          .reads_settings = true,
          .refuse = [](const Scene&, const DeviceLink&) { need_terminal_keys(); }};
}

}  // namespace fingerpad
