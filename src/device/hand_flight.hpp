#pragma once

#include "device/free_flight.hpp"
#include "device/surroundings.hpp"
#include "motion/simulated_hand.hpp"
#include "scene/scene.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

/// Leads a simulated hand through free space, so that it touches nothing. The hand is a mass on a soft spring
/// and swings by centimetres if it is drawn along; so it is steered: it wants to be where its spring and its
/// damper push it along a flight, which keeps so far from the parts as the hand may be off, goes no faster
/// than the hand can brake, and waits for it.
class HandFlight {
 public:
  /// @param start_W  where the hand is
  HandFlight(const std::shared_ptr<const World>& world, const Scene& scene, const HandSettings& hand,
             double dt_s, const Vec3& start_W);

  /// The hand was led elsewhere, by its touch.
  void put(const Vec3& place_W) noexcept { lead_to(place_W); }
  /// Where the hand is to want to be a tick later. noexcept, allocates nothing.
  /// @param tick  what it has just felt: it goes out of that first
  Vec3 wants_W(const SimulatedHand& hand, const Vec3& goal_W, const Vec3& towards_eye_W,
               const TickRecord& tick) noexcept;

  /// Nothing leads nearer to this goal, and the hand is there.
  bool has_arrived(const Vec3& goal_W) const noexcept {
    return leads_no_nearer_ && (goal_W - goal_W_).norm() < margin_m_ && off_m_ < 0.5 * margin_m_;
  }
  /// The same surfaces, touched in another way or with other properties; they outlive this.
  void change(const World& world, const ContactChoice& choice) noexcept { around_.change(world, choice); }
  /// So far from the parts a hand that hovers has room to begin its way down.
  double height_m() const noexcept { return 2 * margin_m_; }

 private:
  void lead_to(const Vec3& place_W) noexcept;
  void go_on(const Vec3& hand_W, const Vec3& goal_W, const Vec3& towards_eye_W,
             const TickRecord& tick) noexcept;
  Vec3 steered_W(const SimulatedHand& hand, const Vec3& from_W) const noexcept;

  HandSettings settings_;
  double dt_s_, greatest_n_;
  double margin_m_;  ///< so far the hand may be off its flight
  Surroundings around_;
  double omega_;         ///< [rad/s], with which it is steered
  double most_m_per_s_;  ///< from so fast it brakes within the margin
  FreeFlight flight_;
  double pace_ = 1;  ///< of the flight, as a share of its own
  double off_m_ = 0;
  bool leads_no_nearer_ = false;  ///< to the last goal
  Vec3 goal_W_;
};

}  // namespace fingerpad
