#include "device/pointer_finger.hpp"

#include <algorithm>
#include <cmath>

#include "device/device_table.hpp"
#include "device/pointer_limits.hpp"
#include "device/press_step.hpp"

namespace fingerpad {

using namespace pointer_limits;

PointerFinger::PointerFinger(const DeviceSetup& setup)
    : greatest_n_(setup.scene.contact.greatest_force_n),
      around_(setup.world, setup.scene),
      foresight_(setup.world, setup.scene),
      path_({setup.start, Vec3::UnitZ(), setup.start.p_WQ}),
      last_put_{setup.start, Vec3::UnitZ(), setup.start.p_WQ},
      aim_(last_put_),
      flight_(around_, setup.start.p_WQ),
      steps_(foresight_, flight_),
      lift_(around_, flight_, steps_),
      leash_(2 * flight_.soft_m(), leash_share * around_.radius_m(), setup.start.p_WQ),
      open_(*setup.world, around_, flight_.soft_m()),
      finger_(setup.start) {}

void PointerFinger::set_target(const FingerSample& target) {
  if (!last_put_.ask(target)) return;
  const double push_n = target.push_W_n.norm();
  if (push_n > 0) last_put_.spot_W += around_.finger_radius_m() / push_n * target.push_W_n;
  path_.put(last_put_);
}

void PointerFinger::look_from(const Vec3& towards_eye_W) {
  last_put_.look_from(towards_eye_W);
}

/// The hand goes by the method that the touch goes on with.
struct PointerFinger::Change final : ChangeBeside {
  Change(PointerFinger& whose, const World& on, const Scene& scene)
      : finger(whose), world(on), method(Foresight::method_for(on, scene)), choice(method->kind) {}
  void put_in() noexcept override {
    finger.around_.change(world, choice);
    finger.foresight_.change(world, method);
    finger.rest_.forget();
    finger.tap_.let_go();
  }

  PointerFinger& finger;
  const World& world;
  std::unique_ptr<Foresight::Method> method;
  ContactChoice choice;
};

std::unique_ptr<ChangeBeside> PointerFinger::ready_for(const World& world, const Scene& scene) {
  return std::make_unique<Change>(*this, world, scene);
}

void PointerFinger::feel(const TickRecord& tick) noexcept {
  touched_ = tick;
  lift_.feel(tick);
}

FingerSample PointerFinger::advance(double dt_s) noexcept {
  const PointerAim last_aim = aim_;
  aim_ = tap_.lead(path_.advance(dt_s), touched_.normal_force_n, dt_s);
  pace_W_ += (1 - std::exp(-dt_s / pace_s)) * ((aim_.finger.p_WQ - last_aim.finger.p_WQ) / dt_s - pace_W_);
  rest_.note(last_aim, aim_, dt_s);
  wanted_n_ = aim_.finger.push_W_n.norm();
  // What the flight says is about the last aim.
  const bool leads_nowhere = doing_ == Doing::flies && flight_.has_given_up() && flight_.has_arrived();
  if (open_.has_room() && leads_nowhere) open_.give_up();
  open_.aim(aim_);
  doing_ = next_doing(dt_s);
  if (doing_ == Doing::flies) {
    fly(dt_s);
  } else if (doing_ == Doing::lands) {
    land(dt_s);
  } else if (doing_ == Doing::presses) {
    press(dt_s);
  } else {
    lift_.go_on(touched_, fastest_m(dt_s), dt_s);
  }
  // Rarely, between two answers that lie within rounding, the step is not what it was when it was tried.
  const Vec3 from_W = finger_.p_WQ;
  const double lifts_n = doing_ == Doing::lifts ? lift_.most_n() : 0;
  const double allowed_n = std::max({within(surely_share), touched_.normal_force_n, lifts_n});
  if (foresight_.go_n(flight_.place_W(), dt_s) > allowed_n) {
    foresight_.take_back();
    flight_.put(from_W, Vec3::Zero());
    steps_.give_way(touched_, within(tried_share), doing_ == Doing::lifts ? allowed_n : any_force_n,
                    fastest_m(dt_s), dt_s);
    foresight_.go_n(flight_.place_W(), dt_s);
  }
  finger_.p_WQ = flight_.place_W();
  finger_.direction_W = aim_.finger.direction_W;
  return finger_;
}

PointerFinger::Doing PointerFinger::next_doing(double dt_s) noexcept {
  const bool wants = wanted_n_ > 0;
  if (is_touching()) {
    const bool stays =
        wants && (doing_ == Doing::lands || doing_ == Doing::presses) && leash_.holds(open_, held_W(), dt_s);
    if (!stays && doing_ != Doing::lifts) lift_.begin(touched_, pressed_most_n_);
    return stays ? Doing::presses : Doing::lifts;
  }
  if (doing_ == Doing::presses) {  // it fell off an edge
    lift_.begin(touched_, pressed_most_n_);
    return Doing::lifts;
  }
  if (doing_ == Doing::lifts) return lift_.is_over() ? Doing::flies : Doing::lifts;
  if (doing_ == Doing::lands) return after_landing();
  if (!wants || !can_land(landing_begins)) return Doing::flies;
  leash_.begin();
  return Doing::lands;
}

LandingWay PointerFinger::landing_way() const noexcept {
  const double soft_m = flight_.soft_m();
  return {open_.place_below_W(flight_.place_W()) - flight_.place_W(), open_.down_W(), soft_m,
          std::min(1.0, flight_.lag_s() * pace_W_.norm() / soft_m)};
}

/// Whether a finger that comes down meets the place to press on, or, where it has no room there, what is
/// beside it. @pre wanted_n_ > 0
bool PointerFinger::can_land(const LandingRoom& room) const noexcept {
  const LandingWay way = landing_way();
  const double beside_m = 10 * flight_.soft_m() + around_.finger_radius_m();
  if (flight_.has_arrived() && way.there_W.norm() < beside_m) return way.is_in_front();
  return way.meets_place(room);
}

void PointerFinger::fly(double dt_s) noexcept {
  const Vec3 from_W = flight_.place_W();
  Vec3 goal_W = open_.place_W();
  if (wanted_n_ > 0) {
    // Over where the pointer will be: what follows it lags, and would never land.
    const double most_m = most_lead_share * around_.radius_m(), lead_m = flight_.lag_s() * pace_W_.norm();
    goal_W += flight_.lag_s() * pace_W_ * std::min(1.0, most_m / std::max(lead_m, most_m));
    goal_W -= 1.5 * flight_.soft_m() * open_.down_W();
  }
  const double left = rest_.flying_left();
  if (left > 0) flight_.advance(goal_W, aim_.towards_eye_W, left * dt_s);
  if (!(foresight_.try_n(flight_.place_W(), dt_s) > 0)) return;
  // A contact method without memory feels walls where there are none: behind the border of an open part.
  flight_.put(from_W, Vec3::Zero());
  foresight_.try_n(from_W, dt_s);
}

/// Comes down: never farther than it is free and a small step more.
void PointerFinger::land(double dt_s) noexcept {
  const double far_m = landing_m_per_s * dt_s;
  const double free_m = std::max(0.0, around_.at(flight_.place_W(), far_m).free_m);
  const double into_m = press_step_share * wanted_n_ / around_.stiffest_n_per_m(dt_s);
  leash_.land_for(open_.place_W());
  const Vec3 step_W = std::min(far_m, 0.5 * free_m + into_m) * landing_way().unit_W();
  if (!steps_.go_shorter(step_W, within(tried_share), dt_s)) steps_.go(Vec3::Zero(), any_force_n, dt_s);
}

/// Along the surface after the pointer; slowly where that has led no nearer for a while, and ever less after
/// one that rests. Where it has no room at its place it goes as near to the spot as it can.
Vec3 PointerFinger::aside(double dt_s) const noexcept {
  if (touched_.normal_force_n > press_too_hard * wanted_n_) return Vec3::Zero();
  const Vec3& normal_W = touched_.normal_W;
  const Vec3 way_W =
      open_.has_room() ? Vec3(aim_.finger.p_WQ - flight_.place_W()) : Vec3(aim_.spot_W - held_W());
  const Vec3 along_W = way_W - way_W.dot(normal_W) * normal_W;
  const double pull = rest_.pressing_left() * (leash_.is_held_up() ? slow_share : 1);
  const double share = pull * (1 - std::exp(-aside_per_s * dt_s)), length_m = along_W.norm();
  const double most_m = pull * fastest_m(dt_s);
  return length_m * share > most_m ? Vec3(along_W * (most_m / length_m)) : Vec3(along_W * share);
}

/// Whether the step aside that was tried takes the finger's skin the other way: pressed in deeper than its
/// radius over an edge, the finger turns about it as a lever. Steps that follow the pointer would swing it to
/// and fro without end.
bool PointerFinger::turns_about_edge(const Vec3& aside_W) const noexcept {
  constexpr double rounding = 1e-6;
  return (foresight_.held_W() - held_W()).dot(aside_W) < -rounding * aside_W.squaredNorm();
}

/// The longest step aside that keeps the force that is asked for; where none does, the longest that leaves it
/// within what a step may.
void PointerFinger::press(double dt_s) noexcept {
  flight_.note_way(held_W() + flight_.soft_m() * touched_.normal_W);
  const SurfaceProperties& surface = around_.properties(std::max(touched_.surface, 0));
  const double tolerated = rest_.gone_m() > gone_share * flight_.soft_m() ? force_tolerated : 0;
  const double in_m =
      std::clamp(deeper_m(touched_, wanted_n_, surface, rest_.pressing_left(), tolerated, dt_s),
                 -fastest_m(dt_s), fastest_m(dt_s));
  rest_.press(std::abs(in_m), dt_s);
  pressed_most_n_ = within(tried_share);
  // Asked for less than it presses with it goes out in many ticks, and presses no harder meanwhile.
  const double most_n = std::max(pressed_most_n_, touched_.normal_force_n);
  const double gentle_n = std::min(most_n, std::max(gentle_share * wanted_n_, touched_.normal_force_n));
  Vec3 aside_W = aside(dt_s);
  std::optional<Vec3> harder_W;  // the longest that presses harder than that
  for (int i = 0; i <= most_halvings; ++i, aside_W /= 2) {
    const Vec3 step_W = aside_W - in_m * touched_.normal_W;
    const double felt_n = foresight_.try_n(flight_.place_W() + step_W, dt_s);
    if (i == 0 && felt_n > 0 && turns_about_edge(aside_W)) {
      aside_W.setZero();
      continue;
    }
    if (felt_n <= gentle_n) return flight_.put(flight_.place_W() + step_W, step_W / dt_s);
    if (felt_n <= most_n && !harder_W) harder_W = step_W;
    if (aside_W.isZero(0)) break;
  }
  if (harder_W) return flight_.put(flight_.place_W() + *harder_W, *harder_W / dt_s);
  steps_.give_way(touched_, most_n, any_force_n, fastest_m(dt_s), dt_s);
}

/// So many times what is asked for, but hardly more than the scene's greatest force where no more is asked
/// for. (Asked for that itself, a finger that gave way to every facet would judder.)
double PointerFinger::within(double share) const noexcept {
  constexpr double hardly_more = 1.01;
  return wanted_n_ > greatest_n_ ? share * wanted_n_ : std::min(share * wanted_n_, hardly_more * greatest_n_);
}

DeviceEntry pointer_device() noexcept {
  return {.name = "mouse",
          .doc = "the mouse and the keyboard, in the window: a hand of bounded force",
          .make = [](const DeviceSetup& setup) -> std::unique_ptr<LiveDevice> {
            return std::make_unique<PointerFinger>(setup);
          },
          .also = "pointer",
          .needs_window = true};
}

}  // namespace fingerpad
