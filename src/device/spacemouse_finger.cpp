#include "device/spacemouse_finger.hpp"

#include <spnav.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>

#include "base/error.hpp"
#include "device/device_table.hpp"
#include "device/reach.hpp"

namespace fingerpad {
namespace {

/// What the daemon gives for a puck that is pushed as far as it goes, about.
constexpr double full_push = 350;
/// How fast the finger then goes.
constexpr double fastest_m_per_s = 0.1;

/// Spacenavd's axes: x right, y up, z towards the person.
Vec3 push_of(const spnav_event_motion& motion) noexcept {
  const Vec3 push = Vec3(motion.x, motion.y, motion.z) / full_push;
  return push.cwiseMax(-1).cwiseMin(1);
}

/// Whether nothing more will come: a signal amid a read, say, is no end.
bool has_hung_up(int descriptor) noexcept {
  char byte = 0;
  const ssize_t count = recv(descriptor, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  return count == 0 || (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
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
    const WakeUp::Woken woken = stop_.wait_with(spnav_fd());
    if (woken.by_wake) return;
    spnav_event event;
    bool any = false;
    while (!woken.broken && spnav_poll_event(&event) != 0) {
      any = true;
      if (event.type == SPNAV_EVENT_MOTION) pushed_.put(push_of(event.motion));
    }
    if (!any && (woken.broken || has_hung_up(spnav_fd()))) break;
  }
  daemon_gone_.store(true, std::memory_order_relaxed);
  pushed_.put(Vec3::Zero());
}

FingerSample SpacemouseFinger::advance(double dt_s) noexcept {
  pushed_.take(seen_push_);
  finger_.p_WQ += fastest_m_per_s * dt_s * (axes_W_ * seen_push_);
  finger_.p_WQ = finger_.p_WQ.cwiseMax(-device_reach_m).cwiseMin(device_reach_m);
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
          },
          .reads_settings = true};
}

}  // namespace fingerpad
