#pragma once

#include <algorithm>

#include "device/foresight.hpp"
#include "device/free_flight.hpp"
#include "device/landing_way.hpp"
#include "device/live_device.hpp"
#include "device/open_place.hpp"
#include "device/pointer_leash.hpp"
#include "device/pointer_lift.hpp"
#include "device/pointer_limits.hpp"
#include "device/pointer_path.hpp"
#include "device/pointer_rest.hpp"
#include "device/pointer_tap.hpp"
#include "device/tried_steps.hpp"

namespace fingerpad {

/// A finger led by a pointer, as a hand of bounded force leads it. Hovering it flies round the parts and
/// touches nothing. Pressing it comes down on the spot, pushes in along the normal that it feels until the
/// normal force is the one asked for, and goes over the surface after the pointer. Where that leaves the
/// surface by more than the finger can follow, it lifts, goes over and lands. Where it is too large for the
/// spot, it presses on the rim that is before it.
///
/// The bound on the force does not rest on what the pointer does: a step is tried before it is made
/// (Foresight), and one that would press too hard is made shorter, or out of the surface instead. What it is
/// asked for, and no more than the scene's greatest force, is not exceeded where a surface is made stiffer
/// either.
class PointerFinger final : public LiveDevice {
 public:
  explicit PointerFinger(const DeviceSetup& setup);

  /// target.t_s is the time of the pointer's event; p_WQ where the finger hovers or, where push_W_n says how
  /// hard to press, where it just touches.
  void set_target(const FingerSample& target) override;
  void look_from(const Vec3& towards_eye_W) override;
  FingerSample advance(double dt_s) noexcept override;
  void feel(const TickRecord& tick) noexcept override;
  std::unique_ptr<ChangeBeside> ready_for(const World& world, const Scene& scene) override;

 private:
  struct Change;
  enum class Doing { flies, lands, presses, lifts };

  Doing next_doing(double dt_s) noexcept;
  Doing after_landing() const noexcept {
    return wanted_n_ > 0 && can_land(landing_goes_on) ? Doing::lands : Doing::flies;
  }
  bool is_touching() const noexcept { return touched_.walls > 0; }
  /// Where the push that was felt holds the finger's centre out.
  Vec3 held_W() const noexcept { return flight_.place_W() + touched_.depth_m * touched_.normal_W; }
  LandingWay landing_way() const noexcept;
  bool can_land(const LandingRoom& room) const noexcept;
  void fly(double dt_s) noexcept;
  void land(double dt_s) noexcept;
  bool turns_about_edge(const Vec3& aside_W) const noexcept;
  /// So far it goes in a tick, along a surface, into it, and out of it; farther out only where nothing else
  /// keeps the force.
  double fastest_m(double dt_s) const noexcept {
    const double along_m_per_s = pointer_limits::fastest_per_s * around_.radius_m();
    return std::max(pointer_limits::lifting_m_per_s, along_m_per_s) * dt_s;
  }
  void press(double dt_s) noexcept;
  double within(double share) const noexcept;
  Vec3 aside(double dt_s) const noexcept;

  const double greatest_n_;  // of the scene
  Surroundings around_;
  Foresight foresight_;
  PointerPath path_;
  PointerAim last_put_;  // the window's threads'
  // The servo's thread's.
  PointerTap tap_;
  PointerAim aim_;
  Vec3 pace_W_ = Vec3::Zero();  // of the pointer [m/s]
  PointerRest rest_;
  FreeFlight flight_;
  TriedSteps steps_;
  PointerLift lift_;
  PointerLeash leash_;
  OpenPlace open_;  // where the pointer wants it, as far as it has room there
  FingerSample finger_;
  Doing doing_ = Doing::flies;
  double wanted_n_ = 0;        // normal force; 0 to hover
  TickRecord touched_;         // what the last tick felt
  double pressed_most_n_ = 0;  // that the last press might have pressed with
};

}  // namespace fingerpad
