#pragma once

#include <optional>

#include "motion/finger_path.hpp"
#include "touch/touch.hpp"

namespace fingerpad {

/// Runs a scene's motion through its world tick by tick: the finger follows it exactly, or, where the scene
/// has a [hand], a simulated hand holds the finger, feels the force and closes the loop.
class ClosedLoop {
 public:
  ClosedLoop(std::shared_ptr<const World> world, const Scene& scene, FingerPath path);

  long tick_count() const noexcept { return path_.tick_count(); }
  /// The next tick. With a hand the record's position is the finger's true one; the touch saw the encoders'.
  /// @pre called at most tick_count() times
  TickRecord next() noexcept;

 private:
  TickRecord next_in_hand(const FingerSample& intended) noexcept;

  Touch touch_;
  FingerPath path_;
  std::optional<SimulatedHand> hand_;
  long tick_ = 0;
};

}  // namespace fingerpad
