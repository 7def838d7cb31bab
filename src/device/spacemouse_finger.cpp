#include "device/spacemouse_finger.hpp"

#include <poll.h>
#include <spnav.h>

#include <algorithm>
#include <cstdlib>

#include "base/error.hpp"
#include "device/device_table.hpp"

namespace fingerpad {
namespace {

/// What the daemon gives for a puck that is pushed as far as it goes, about.
constexpr double full_push = 350;
/// How fast the finger then goes.
constexpr double fastest_m_per_s = 0.1;
constexpr double farthest_puck_m = 1e3;

/// Spacenavd's axes: x right, y up, z towards the person.
Vec3 push_of(const spnav_event_motion& motion) noexcept {
  const Vec3 push = Vec3(motion.x, motion.y, motion.z) / full_push;
  return push.cwiseMax(-1).cwiseMin(1);
}

}  // namespace

SpacemouseFinger::SpacemouseFinger(const DeviceSetup& setup)
    : axes_W_(setup.scene.device.scale * setup.scene.device.rotation), finger_(setup.start) {
  if (spnav_open() != 0) {
    const char* named = std::getenv("SPNAV_SOCKET");
    throw Error(
        ErrorKind::usage, named != nullptr ? named : "/var/run/spnav.sock",
        "no daemon of a space mouse answers there: install and start spacenavd, or name its socket in "
        "SPNAV_SOCKET");
  }
  thread_ = std::thread([this] { run(); });
}

SpacemouseFinger::~SpacemouseFinger() {
  stop();
}

void SpacemouseFinger::stop() {
  if (!thread_.joinable()) return;
  stop_.wake();
  thread_.join();
  spnav_close();
}

void SpacemouseFinger::run() {
  for (;;) {
    pollfd ready[] = {{spnav_fd(), POLLIN, 0}, {stop_.descriptor(), POLLIN, 0}};
    if (poll(ready, 2, -1) < 0) continue;  // a signal
    if (ready[1].revents != 0) return;
    spnav_event event;
    bool any = false;
    while (spnav_poll_event(&event) != 0) {
      any = true;
      if (event.type == SPNAV_EVENT_MOTION) pushed_.put(push_of(event.motion));
    }
    if (!any) break;  // readable, and nothing to read: the daemon has ended
  }
  daemon_gone_.store(true, std::memory_order_relaxed);
  pushed_.put(Vec3::Zero());
}

FingerSample SpacemouseFinger::advance(double dt_s) {
  pushed_.take(seen_push_);
  finger_.p_WQ += fastest_m_per_s * dt_s * (axes_W_ * seen_push_);
  finger_.p_WQ = finger_.p_WQ.cwiseMax(-farthest_puck_m).cwiseMin(farthest_puck_m);
  return finger_;
}

std::string SpacemouseFinger::opening_words() const {
  return "the puck drives the finger, at up to 100 mm/s; it shows no force";
}

std::string SpacemouseFinger::closing_words() {
  stop();
  return daemon_gone_ ? "spacenavd ended before the touch did" : "";
}

DeviceEntry spacemouse_device() noexcept {
  return {.name = "spacemouse",
          .doc = "a 6-D mouse by its daemon, spacenavd; it shows no force",
          .make = [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<SpacemouseFinger>(setup);
          }};
}

}  // namespace fingerpad
