#pragma once

#include <memory>
#include <optional>
#include <string>

#include "motion/finger_path.hpp"
#include "scene/scene.hpp"
#include "scene/scene_change.hpp"
#include "touch/tick_record.hpp"
#include "touch/touch_swap.hpp"

namespace fingerpad {

struct World;

/// How a device outside of the program is reached.
struct DeviceLink {
  std::optional<std::string> bind{};  ///< address that is listened on; none: 127.0.0.1
  std::optional<int> port{};          ///< none: the device's usual one
};

/// What a live device is made from.
struct DeviceSetup {
  const Scene& scene;
  std::shared_ptr<const World> world;
  FingerSample start;  ///< where the finger is, at rest
  DeviceLink link{};
  std::optional<HandSettings> hand{};  ///< the scene's [hand]: a person takes its place in the scene
};

/// What a device's samples say beyond the finger's place and may change from tick to tick. A trace keeps it,
/// so that the same touch can be made again from it.
struct SampleParts {
  bool directions = false, attitudes = false, velocities = false, pushes = false;
};

/// What moves the finger live, and feels what it touches.
class LiveDevice {
 public:
  virtual ~LiveDevice() = default;

  /// The finger dt_s later. One thread, the servo's: allocates nothing, waits for nothing.
  virtual FingerSample advance(double dt_s) noexcept = 0;
  virtual SampleParts gives() const noexcept { return {}; }
  /// Where the finger was at the last advance(), where its sample was what encoders make of that. The same
  /// thread.
  virtual std::optional<Vec3> true_place_W() const noexcept { return std::nullopt; }

  /// Whether it shows forces to a person. Then sent_W_n() is what its limits left of the last tick's force,
  /// in the world's axes; the servo's thread.
  virtual bool has_motors() const noexcept { return false; }
  virtual Vec3 sent_W_n() const noexcept { return Vec3::Zero(); }
  /// Holds the device's force at 0 until it is taken back. Any thread.
  virtual void set_emergency_stop(bool /*on*/) noexcept {}
  virtual bool emergency_stopped() const noexcept { return false; }

  /// Whether its motion is over: the tick of the last advance() is no more of it. Any thread.
  virtual bool has_ended() const noexcept { return false; }

  /// What is wrong with it now, to be told at once; empty: nothing. Any thread.
  virtual std::string trouble() const { return {}; }

  /// What to tell before the touch, such as where it listens, and after it. May be empty. The second ends the
  /// device's own work: neither advance() nor feel() is called any more.
  virtual std::string opening_words() const { return {}; }
  virtual std::string closing_words() { return {}; }

  /// What is odd in what it will do, each to be told as a warning before the touch.
  virtual std::vector<std::string> warnings() const { return {}; }

  /// What the tick at the finger of the last advance() gave. Same thread, same rules.
  virtual void feel(const TickRecord& /*tick*/) noexcept {}

  /// What the device itself needs where the touch goes on with other properties of its surfaces, or with
  /// another method; put in on the servo's thread, before an advance(). Both outlive the device's work. Null:
  /// nothing. Any thread but the servo's.
  virtual std::unique_ptr<ChangeBeside> ready_for(const World& /*world*/, const Scene& /*scene*/) {
    return nullptr;
  }
  /// What its motion changes in the scene on the way, as it was recorded. Before the first advance().
  virtual std::vector<SceneChange> scene_changes() const { return {}; }

  /// Where the window's pointer would have the finger, and what to press with (push_W_n, zero: hover), at the
  /// time of its event (t_s, on a clock of the window's). One thread at a time, of the window's. A device
  /// with a place of its own does not listen.
  virtual void set_target(const FingerSample& /*target*/) {}

  /// From which side it looks, from the next set_target on. Same thread.
  virtual void look_from(const Vec3& /*towards_eye_W*/) {}
};

}  // namespace fingerpad
