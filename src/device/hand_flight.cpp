#include "device/hand_flight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fingerpad {
namespace {

/// So far from its flight the hand may be [sizes of the parts].
constexpr double margin_share = 0.025;
/// Steered no faster than a hand is, and than ticks let it be.
constexpr double most_hz = 30, most_per_tick = 0.1;
/// What it steers with, of the greatest force.
constexpr double steering_share = 0.5;
/// How fast it goes out of what it touches or is near to.
constexpr double out_m_per_s = 0.1;

}  // namespace

HandFlight::HandFlight(const std::shared_ptr<const World>& world, const Scene& scene,
                       const HandSettings& hand, double dt_s, const Vec3& start_W)
    : settings_(hand),
      dt_s_(dt_s),
      greatest_n_(steering_share * scene.contact.greatest_force_n),
      margin_m_(margin_share * ball_around(*world).radius_m),
      around_(world, scene, scene.finger.radius_m + margin_m_),
      omega_(std::min({2 * std::numbers::pi * most_hz, most_per_tick / dt_s,
                       std::sqrt(greatest_n_ / (hand.mass_kg * margin_m_))})),
      // Critically damped, a change of its flight's speed puts it off by that over e omega.
      most_m_per_s_(0.4 * std::numbers::e * omega_ * margin_m_),
      flight_(around_, start_W),
      goal_W_(start_W) {}

void HandFlight::lead_to(const Vec3& place_W) noexcept {
  flight_.put(place_W, Vec3::Zero());
  flight_.note_way(place_W);
}

void HandFlight::go_on(const Vec3& hand_W, const Vec3& goal_W, const Vec3& towards_eye_W,
                       const TickRecord& tick) noexcept {
  leads_no_nearer_ = false;
  goal_W_ = goal_W;
  const Vec3 from_W = flight_.place_W();
  off_m_ = (from_W - hand_W).norm();
  const double left = std::max(0.0, 1 - off_m_ / margin_m_);
  if (tick.walls > 0) {
    // The surface may push the hand out faster than that: the flight must not draw it back in.
    const double ahead_m = std::max(0.0, (hand_W - from_W).dot(tick.normal_W));
    return lead_to(from_W + (ahead_m + left * out_m_per_s * dt_s_) * tick.normal_W);
  }
  const Clearance clearance = around_.at(from_W, margin_m_);
  if (clearance.free_m < 0) return lead_to(from_W + left * out_m_per_s * dt_s_ * clearance.away_W);
  const double span_s = pace_ * left * dt_s_;
  if (!(span_s > 0)) return;
  const double own_m_per_s = (flight_.advance(goal_W, towards_eye_W, span_s) - from_W).norm() / span_s;
  leads_no_nearer_ = flight_.has_arrived();
  pace_ = std::min(1.0, most_m_per_s_ / std::max(own_m_per_s, most_m_per_s_));
}

/// So that spring and damper push the hand as a critically damped one would be that follows the flight.
Vec3 HandFlight::steered_W(const SimulatedHand& hand, const Vec3& from_W) const noexcept {
  const Vec3 to_W = flight_.place_W(), pace_W = (to_W - from_W) / dt_s_;
  const Vec3 off_W = to_W - hand.position_W(), slower_W = pace_W - hand.velocity_W();
  Vec3 push_W_n = settings_.mass_kg * omega_ * (omega_ * off_W + 2 * slower_W);
  push_W_n *= std::min(1.0, greatest_n_ / std::max(greatest_n_, push_W_n.norm()));
  push_W_n += hand.against_dry_friction_W_n(push_W_n);
  push_W_n += settings_.damping_n_s_per_m * hand.velocity_W();
  Vec3 wants_W = hand.position_W() + push_W_n / settings_.stiffness_n_per_m;
  for (int axis = 0; axis < 3; ++axis)
    if (!settings_.free_axis[axis]) wants_W[axis] = to_W[axis];
  return wants_W;
}

Vec3 HandFlight::wants_W(const SimulatedHand& hand, const Vec3& goal_W, const Vec3& towards_eye_W,
                         const TickRecord& tick) noexcept {
  const Vec3 from_W = flight_.place_W();
  go_on(hand.position_W(), goal_W, towards_eye_W, tick);
  return steered_W(hand, from_W);
}

}  // namespace fingerpad
