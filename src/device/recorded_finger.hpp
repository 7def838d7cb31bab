#pragma once

#include <atomic>

#include "device/live_device.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad {

/// The finger of the scene's own motion, in real time: tick k of the touch is tick k of the motion, so that
/// it feels what `replay` writes.
class RecordedFinger final : public LiveDevice {
 public:
  /// Throws Error (refused) where the scene has no motion, or it cannot be read.
  explicit RecordedFinger(const DeviceSetup& setup);
  /// As above, of the scene's motion as it was read.
  RecordedFinger(const DeviceSetup& setup, const LoadedMotion& motion);

  /// The next tick of the motion; after its end the last one, at rest.
  FingerSample advance(double dt_s) noexcept override;
  SampleParts gives() const noexcept override;
  bool has_ended() const noexcept override { return ended_.load(std::memory_order_relaxed); }
  std::vector<SceneChange> scene_changes() const override { return changes_; }
  std::string opening_words() const override { return words_; }
  std::vector<std::string> warnings() const override { return warnings_; }

 private:
  FingerPath path_;
  std::vector<SceneChange> changes_;
  std::string words_;
  std::vector<std::string> warnings_;  // of its motion
  long next_ = 0;
  std::atomic<bool> ended_{false};
};

}  // namespace fingerpad
