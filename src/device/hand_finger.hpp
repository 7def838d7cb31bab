#pragma once

#include "device/follower.hpp"
#include "device/hand_flight.hpp"
#include "device/hand_leash.hpp"
#include "device/latest.hpp"
#include "device/live_device.hpp"
#include "device/pointer_aim.hpp"
#include "motion/simulated_hand.hpp"

namespace fingerpad {

/// The simulated hand of the scene's [hand], or of its defaults, chasing the mouse: a mass on a spring that
/// the surface pushes back. What it does to the finger is what `replay` does with a motion and a [hand]: what
/// is felt is where the hand's encoders put the finger. Where it knows its world it hovers without touching,
/// comes down over the spot, and is drawn aside over it so gently that a wall that it meets stops it with
/// less than the scene's greatest force, along the axes that it moves along by itself. Where that leads no
/// nearer to the spot, it lifts and flies there.
class HandFinger final : public LiveDevice {
 public:
  HandFinger(const DeviceSetup& setup, double dt_s);

  FingerSample advance(double dt_s) noexcept override;
  void feel(const TickRecord& tick) noexcept override;
  SampleParts gives() const noexcept override { return {.pushes = true}; }
  std::optional<Vec3> true_place_W() const noexcept override { return place_W_; }
  void set_target(const FingerSample& target) override;
  std::unique_ptr<ChangeBeside> ready_for(const World& world, const Scene& scene) override;
  void look_from(const Vec3& towards_eye_W) override;
  std::string opening_words() const override;

 private:
  struct Change;

  double push_n() const noexcept { return seen_.finger.push_W_n.norm(); }
  bool leash_holds(const TickRecord& tick) noexcept;
  bool flies(const Vec3& goal_W, const TickRecord& tick) noexcept;
  Vec3 gently_W(const Vec3& intended_W, const TickRecord& tick) const noexcept;
  Vec3 next_intended_W(const Vec3& wanted_W, const TickRecord& tick) noexcept;

  HandSettings settings_;
  bool is_default_;                           ///< the scene has no [hand]
  double greatest_n_, stiffest_n_per_m_ = 0;  ///< of the scene, and of its surfaces
  SimulatedHand hand_;
  std::optional<HandFlight> flight_;  ///< none where it knows of no world
  HandLeash leash_{0};                ///< while it comes down and presses
  bool comes_down_ = false;           ///< else it flies, pressed or not, until it is over the spot
  Vec3 wants_W_;                      ///< where the hand wants to be now
  Follower intended_;                 ///< where the mouse goes, as a hand would follow it
  Follower landing_;                  ///< the same along the way down, while the hand lands
  bool lands_ = true;
  double landing_s_ = 0;  ///< so long it has touched meanwhile
  double free_s_ = 0;     ///< so long it has touched nothing
  double dt_s_;
  Vec3 place_W_;  ///< of the last advance()
  FingerSample finger_;
  PointerAim last_put_;      // the window's threads'
  Latest<PointerAim> aims_;  // to the servo
  PointerAim seen_;          // servo's thread
};

}  // namespace fingerpad
