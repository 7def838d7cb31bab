#pragma once

#include "device/follower.hpp"
#include "device/latest.hpp"
#include "device/live_device.hpp"
#include "motion/simulated_hand.hpp"

namespace fingerpad {

/// The simulated hand of the scene's [hand], or of its defaults, chasing the mouse: a mass on a spring that
/// the surface pushes back. What it does to the finger is what `replay` does with a motion and a [hand]: what
/// is felt is where the hand's encoders put the finger.
class HandFinger final : public LiveDevice {
 public:
  HandFinger(const DeviceSetup& setup, double dt_s);

  FingerSample advance(double dt_s) noexcept override;
  void feel(const TickRecord& tick) noexcept override;
  SampleParts gives() const noexcept override { return {.pushes = true}; }
  std::optional<Vec3> true_place_W() const noexcept override { return place_W_; }
  void set_target(const FingerSample& target) override;

 private:
  Vec3 next_intended_W(const Vec3& wanted_W, const TickRecord& tick) noexcept;

  HandSettings settings_;
  SimulatedHand hand_;
  Follower intended_;  ///< where the mouse goes, as a hand would follow it
  Follower landing_;   ///< the same along the way down, while the hand lands
  bool lands_ = true;
  double landing_s_ = 0;  ///< so long it has touched meanwhile
  double free_s_ = 0;     ///< so long it has touched nothing
  double dt_s_;
  Vec3 place_W_;  ///< of the last advance()
  FingerSample finger_;
  Latest<FingerSample> targets_;  // to the servo
  FingerSample seen_target_;      // servo's thread
};

}  // namespace fingerpad
