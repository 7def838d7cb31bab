#include "device/hand_finger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "device/device_table.hpp"
#include "touch/world.hpp"

namespace fingerpad {
namespace {

constexpr double landing_bandwidth_hz = 1.5;

double stiffest_of(const World& world) {
  double stiffest = 0;
  for (const Surface& surface : world.surfaces)
    stiffest = std::max(stiffest, surface.properties.stiffness_n_per_m);
  return stiffest;
}

}  // namespace

HandFinger::HandFinger(const DeviceSetup& setup, double dt_s)
    : settings_(setup.hand.value_or(HandSettings{})),
      is_default_(!setup.hand),
      greatest_n_(setup.scene.contact.greatest_force_n),
      hand_(settings_, dt_s),
      wants_W_(setup.start.p_WQ),
      intended_(setup.start.p_WQ, pointer_bandwidth_hz),
      landing_(setup.start.p_WQ, landing_bandwidth_hz),
      dt_s_(dt_s),
      place_W_(setup.start.p_WQ),
      finger_(setup.start),
      last_put_{setup.start},
      seen_{setup.start} {
  hand_.start(setup.start.p_WQ);
  // Without a spring nothing draws it anywhere.
  if (!setup.world || !(settings_.stiffness_n_per_m > 0)) return;
  flight_.emplace(setup.world, setup.scene, settings_, dt_s, setup.start.p_WQ);
  leash_ = HandLeash(flight_->height_m());
  stiffest_n_per_m_ = stiffest_of(*setup.world);
}

void HandFinger::set_target(const FingerSample& target) {
  if (last_put_.ask(target)) aims_.put(last_put_);
}

void HandFinger::look_from(const Vec3& towards_eye_W) {
  last_put_.look_from(towards_eye_W);
}

std::string HandFinger::opening_words() const {
  if (!is_default_) return {};
  return fmt::format(
      "the scene has no [hand]: one of {} kg on {} N/m with {} N s/m, encoders of {} m, as by default",
      number_text(settings_.mass_kg), number_text(settings_.stiffness_n_per_m),
      number_text(settings_.damping_n_s_per_m), number_text(settings_.encoder_m));
}

struct HandFinger::Change final : ChangeBeside {
  Change(HandFinger& whose, const World& on, const ContactChoice& by)
      : finger(whose), world(on), choice(by), stiffest_n_per_m(stiffest_of(on)) {}
  void put_in() noexcept override {
    finger.stiffest_n_per_m_ = stiffest_n_per_m;
    if (finger.flight_) finger.flight_->change(world, choice);
  }
  HandFinger& finger;
  const World& world;
  ContactChoice choice;
  double stiffest_n_per_m;
};

std::unique_ptr<ChangeBeside> HandFinger::ready_for(const World& world, const Scene& scene) {
  return std::make_unique<Change>(*this, world, settled_contact(scene, world));
}

FingerSample HandFinger::advance(double) noexcept {
  aims_.take(seen_);
  place_W_ = hand_.position_W();
  finger_.p_WQ = hand_.encoded_W();
  finger_.push_W_n = hand_.push_W_n(wants_W_);
  finger_.direction_W = seen_.finger.direction_W;
  return finger_;
}

/// While it lands, the hand goes down more slowly than aside: a mass that comes down as fast as the mouse
/// clicks would meet the surface with more than it is to press with. So it does where it falls off a ledge.
Vec3 HandFinger::next_intended_W(const Vec3& wanted_W, const TickRecord& tick) noexcept {
  constexpr double most_landing_s = 0.6, near_share = 0.02, falls_s = 0.01;
  const double push_n = this->push_n();
  const double near_m = near_share * push_n / settings_.stiffness_n_per_m;
  const auto left_m = [&](const Vec3& from_W) {
    return (wanted_W - from_W).dot(seen_.finger.push_W_n) / push_n;
  };
  if (!(push_n > 0)) lands_ = true;
  free_s_ = tick.phase == Phase::free ? free_s_ + dt_s_ : 0;
  if (push_n > 0 && !lands_ && free_s_ > falls_s && left_m(intended_.place_m()) > near_m) {
    lands_ = true;
    landing_.put(intended_.place_m(), Vec3::Zero());
  }
  if (!(push_n > 0) || !lands_) {
    const Vec3 next_W = intended_.advance(wanted_W, dt_s_);
    landing_.put(next_W, intended_.velocity_m_per_s());
    landing_s_ = 0;
    return next_W;
  }
  const Vec3 down_W = seen_.finger.push_W_n / push_n;
  const auto down_of_second = [&](const Vec3& aside, const Vec3& down) {
    return Vec3(aside + (down - aside).dot(down_W) * down_W);
  };
  const Vec3 aside_W = intended_.advance(wanted_W, dt_s_), lower_W = landing_.advance(wanted_W, dt_s_);
  const Vec3 next_W = down_of_second(aside_W, lower_W);
  const Vec3 velocity = down_of_second(intended_.velocity_m_per_s(), landing_.velocity_m_per_s());
  intended_.put(next_W, velocity);
  landing_.put(next_W, velocity);
  if (tick.phase != Phase::free) landing_s_ += dt_s_;
  lands_ = landing_s_ < most_landing_s && left_m(next_W) > near_m;
  return next_W;
}

/// Whether it can stay on the surface for another tick, which its leash counts. @pre it presses
bool HandFinger::leash_holds(const TickRecord& tick) noexcept {
  const double off_m = std::max(0.0, (seen_.finger.p_WQ - hand_.position_W()).norm() - tick.depth_m);
  return leash_.holds(seen_.finger.p_WQ, off_m, dt_s_);
}

/// Until it is over the spot that is to be pressed it flies; and again once it is not to press, or is held up
/// on its way.
bool HandFinger::flies(const Vec3& goal_W, const TickRecord& tick) noexcept {
  if (!flight_) return false;
  const bool did = !comes_down_;
  const bool presses = push_n() > 0;
  if (presses && did && flight_->has_arrived(goal_W) && tick.walls == 0) {
    comes_down_ = lands_ = true;
    intended_.put(place_W_, Vec3::Zero());
    landing_.put(place_W_, Vec3::Zero());
    leash_.begin(seen_.finger.p_WQ);
  } else if (!presses || (!did && !leash_holds(tick))) {
    comes_down_ = false;
  }
  if (!comes_down_ && !did) flight_->put(place_W_);
  return !comes_down_;
}

/// Drawn with no more than the greatest force, and damped so that the hand's mass meets a wall slowly enough
/// to add hardly anything to that.
Vec3 HandFinger::gently_W(const Vec3& intended_W, const TickRecord& tick) const noexcept {
  constexpr double aside_share = 0.5, together_share = 0.9, least_share = 0.15, most_per_tick = 0.3;
  if (!flight_ || !(push_n() > 0)) return intended_W;
  const double k = settings_.stiffness_n_per_m, m = settings_.mass_kg;
  const double down_n = std::min(push_n(), together_share * greatest_n_);
  const double aside_n =
      greatest_n_ * std::clamp(together_share - down_n / greatest_n_, least_share, aside_share);
  const Vec3 down_W = seen_.finger.push_W_n / push_n(), pull_W = intended_W - hand_.position_W();
  const double along_m = std::clamp(pull_W.dot(down_W), -aside_n / k, down_n / k);
  Vec3 aside_W = pull_W - pull_W.dot(down_W) * down_W;
  aside_W *= std::min(1.0, aside_n / k / std::max(aside_n / k, aside_W.norm()));
  Vec3 drawn_W = along_m * down_W + aside_W;
  // Into what it touches, too, with no more than it is to press with: a spot round an edge lies on that way.
  if (tick.walls > 0) drawn_W += std::max(0.0, -drawn_W.dot(tick.normal_W) - down_n / k) * tick.normal_W;
  // Dry friction must not hold it up on its way; where it has come to rest on a surface, it may.
  const Vec3 starts_W = tick.walls > 0 ? Vec3::Zero() : drawn_W;
  const double critical = 2 * std::sqrt(m * std::max(k, stiffest_n_per_m_));
  const double lacks =
      std::max(0.0, std::min(critical, most_per_tick * m / dt_s_) - settings_.damping_n_s_per_m);
  Vec3 gently_W = hand_.position_W() + drawn_W - lacks / k * hand_.velocity_W();
  gently_W += hand_.against_dry_friction_W_n(starts_W) / k;
  for (int axis = 0; axis < 3; ++axis)
    if (!settings_.free_axis[axis]) gently_W[axis] = intended_W[axis];
  return gently_W;
}

/// The hand goes on under the force of this tick.
void HandFinger::feel(const TickRecord& tick) noexcept {
  // So deep its spring would push with what is asked for; as far as the surface gives way it pushes with
  // less.
  const Vec3& push_W_n = seen_.finger.push_W_n;
  const double k = settings_.stiffness_n_per_m;
  const Vec3 wanted_W = seen_.finger.p_WQ + (k > 0 ? Vec3(push_W_n / k) : Vec3::Zero());
  Vec3 next_W = wants_W_;
  const double height_m = flight_ ? flight_->height_m() : 0;
  const Vec3 up_W = push_n() > 0 ? Vec3(push_W_n * (-height_m / push_n())) : Vec3::Zero();
  const Vec3 goal_W = seen_.finger.p_WQ + up_W;
  if (flies(goal_W, tick)) {
    next_W = flight_->wants_W(hand_, goal_W.allFinite() ? goal_W : place_W_, seen_.towards_eye_W, tick);
  } else {
    next_W = gently_W(next_intended_W(wanted_W.allFinite() ? wanted_W : intended_.place_m(), tick), tick);
  }
  hand_.advance(wants_W_, next_W, tick.force_W_n);
  wants_W_ = next_W;
}

DeviceEntry hand_device() noexcept {
  return {.name = "hand",
          .doc = "a simulated hand (the scene's [hand]) that chases the mouse, in the window",
          .make = [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<HandFinger>(setup, 1 / setup.scene.motion.rate_hz);
          },
          .needs_window = true};
}

}  // namespace fingerpad
