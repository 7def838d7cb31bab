#pragma once

#include <atomic>
#include <thread>

#include "device/latest.hpp"
#include "device/live_device.hpp"
#include "device/wake_up.hpp"

namespace fingerpad {

/// A finger that a 6-D mouse drives, by its daemon (spacenavd): the farther the puck is pushed, the faster
/// the finger goes. It shows no force. [device] turns and scales its axes, x right, y up, z out of the desk
/// towards the person.
class SpacemouseFinger final : public LiveDevice {
 public:
  /// Throws Error (usage) where no daemon answers.
  explicit SpacemouseFinger(const DeviceSetup& setup);
  ~SpacemouseFinger() override;

  FingerSample advance(double dt_s) noexcept override;
  std::string opening_words() const override;
  std::string closing_words() override;

 private:
  void run();
  void stop();

  Mat3 axes_W_;  ///< columns: where a metre of each axis leads
  FingerSample finger_;
  Latest<Vec3> pushed_;            // to the servo, from -1 to 1
  Vec3 seen_push_ = Vec3::Zero();  // servo thread
  std::atomic<bool> daemon_gone_{false};
  WakeUp stop_;
  std::thread thread_;
};

}  // namespace fingerpad
