#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/finger_path.hpp"
#include "motion/simulated_hand.hpp"
#include "touch/touch.hpp"
#include "touch/touch_swap.hpp"

namespace fingerpad {

/// The scene with the rate at which its motion is followed: a recording's own where the scene has none.
Scene at_rate(Scene scene, const FingerPath& path);

/// Runs a scene's motion through its world tick by tick: the finger follows it exactly, or, where the scene
/// has a [hand], a simulated hand holds the finger, feels the force and closes the loop.
class ClosedLoop {
 public:
  /// @param changes  of the scene on the way, as a recording has them. Throws Error (refused) for one that
  /// the scene cannot have.
  /// @param wrap     as Touch's
  ClosedLoop(std::shared_ptr<const World> world, const Scene& scene, FingerPath path,
             const std::vector<SceneChange>& changes = {}, const ContactWrap& wrap = {});

  long tick_count() const noexcept { return path_.tick_count(); }
  /// The next tick. With a hand the record's position is the finger's true one; the touch saw the encoders'.
  /// @pre called at most tick_count() times
  TickRecord next() noexcept;

  /// Whether a hand has been thrown so far from its motion, a thousand times the scene's own size, that no
  /// spring of a hand explains it: the loop gains energy on every tick. What next() gives from then on is
  /// finite still, but says nothing.
  bool has_diverged() const noexcept { return diverged_; }
  /// Why, for people, with the largest stiffness that the hand would have held stable (SCIENCE 4).
  /// @pre has_diverged()
  std::string divergence() const;

 private:
  TickRecord next_in_hand(const FingerSample& intended) noexcept;

  std::shared_ptr<const World> world_;
  Touch touch_;
  std::unique_ptr<TouchSwap> swap_;  ///< where there are changes
  FingerPath path_;
  std::optional<SimulatedHand> hand_;
  HandSettings hand_settings_;
  bool turns_ = false, was_in_hand_ = false, is_measured_ = false;  ///< the path's
  long tick_ = 0;
  double leash_m_ = 0;     ///< farther from its motion no hand goes by itself
  int last_surface_ = -1;  ///< touched
  bool diverged_ = false;
};

}  // namespace fingerpad
