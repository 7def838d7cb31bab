#pragma once

#include <memory>

#include "motion/finger_path.hpp"
#include "scene/scene.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

struct World;

/// What a live device is made from.
struct DeviceSetup {
  const Scene& scene;
  std::shared_ptr<const World> world;
  FingerSample start;  ///< where the finger is, at rest
};

/// What moves the finger live, and feels what it touches.
class LiveDevice {
 public:
  virtual ~LiveDevice() = default;

  /// The finger dt_s later. One thread, the servo's: allocates nothing, waits for nothing.
  virtual FingerSample advance(double dt_s) = 0;

  /// What the tick at the finger of the last advance() gave. Same thread, same rules.
  virtual void feel(const TickRecord& /*tick*/) noexcept {}

  /// Where the window's pointer would have the finger, and what to press with (push_W_n, zero: hover), at the
  /// time of its event (t_s, on a clock of the window's). One thread, the window's. A device with a place of
  /// its own does not listen.
  virtual void set_target(const FingerSample& /*target*/) {}

  /// From which side it looks, from the next set_target on. Same thread.
  virtual void look_from(const Vec3& /*towards_eye_W*/) {}
};

}  // namespace fingerpad
