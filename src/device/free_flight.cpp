#include "device/free_flight.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

#include "device/pointer_limits.hpp"

namespace fingerpad {
namespace {

constexpr double without_end = std::numeric_limits<double>::infinity();
/// What the finger keeps from the parts where there is room, in their size, and the least of it.
constexpr double soft_share = 0.01, least_share = 0.3;
/// With no room at all it goes so far away from what it touches, in what it would keep.
constexpr double least_step_share = 1e-3;
/// Where so little of a step is left along a wall, the wall is in the way.
constexpr double blocked_share = 0.3;
/// How fast it goes over what is in the way [sizes of the parts a second].
constexpr double detour_per_s = 8;
/// After this time without coming nearer to the goal it looks for another way; nearer by a share at least of
/// what it could have gone.
constexpr double another_way_s = 0.1, least_progress = 0.02;

Vec3 step_W_of(const Vec3& way_W, double step_m) noexcept {
  const double length_m = way_W.norm();
  return length_m > 0 ? Vec3(way_W * (step_m / length_m)) : Vec3::Zero();
}

}  // namespace

FreeFlight::FreeFlight(Surroundings& around, const Vec3& start_W) noexcept
    : around_(around),
      soft_m_(soft_share * around.radius_m()),
      arrived_m_(0.1 * around.radius_m() + around.finger_radius_m()),
      ball_m_(1.1 * around.radius_m() + around.finger_radius_m()),
      speed_m_per_s_(detour_per_s * around.radius_m()),
      follower_(start_W, pointer_bandwidth_hz),
      trail_(0.5 * soft_m_),
      least_left_m_(without_end),
      goal_W_(start_W),
      tried_for_W_(start_W) {
  trail_.begin(start_W);
}

void FreeFlight::take(Way way) noexcept {
  way_ = way;
  least_left_m_ = without_end;
  delay_s_ = 0;
}

void FreeFlight::put(const Vec3& place_W, const Vec3& velocity_m_per_s) noexcept {
  follower_.put(place_W, velocity_m_per_s);
  take(Way::straight);
}

/// What of a step does not lead into the wall that is nearest; gently, up to the room that is to be kept.
Vec3 FreeFlight::along_walls(const Vec3& step_W) const noexcept {
  const double into_m = -step_W.dot(clearance_.away_W);
  const double allowed_m = std::max(0.0, 0.2 * (clearance_.free_m - soft_m_));
  return into_m > allowed_m ? Vec3(step_W + (into_m - allowed_m) * clearance_.away_W) : step_W;
}

/// One step over what is in the way: aside, towards the goal, where that is free, else up.
Vec3 FreeFlight::over_it(const Vec3& aside_W, const Vec3& towards_eye_W, double dt_s) const noexcept {
  const double step_m = std::min(speed_m_per_s_ * dt_s, 0.5 * aside_W.norm() + soft_m_);
  const Vec3 sideways_W = along_walls(step_W_of(aside_W, step_m));
  const double left = std::max(0.0, 1 - sideways_W.norm() / step_m);
  return sideways_W + left * along_walls(step_m * towards_eye_W);
}

/// One step back on the way by which it came.
Vec3 FreeFlight::out(double dt_s) noexcept {
  const Vec3 way_W = trail_.back_from(place_W()) - place_W();
  return step_W_of(way_W, std::min(speed_m_per_s_ * dt_s, way_W.norm()));
}

/// One step about the ball in which all parts are, to where the eye's line to the goal enters it.
Vec3 FreeFlight::round_all(const Vec3& goal_W, const Vec3& towards_eye_W, double dt_s) noexcept {
  const Vec3 goal = goal_W - around_.middle_W(), here = place_W() - around_.middle_W();
  const double up_m = goal.dot(towards_eye_W);
  const double inside2 = std::max(0.0, ball_m_ * ball_m_ - goal.squaredNorm() + up_m * up_m);
  const Vec3 gate = goal + (std::sqrt(inside2) - up_m) * towards_eye_W;
  const double step_m = speed_m_per_s_ * dt_s;
  const Vec3 outwards = here.normalized(), way_W = gate - here;
  const Vec3 about_W = way_W - way_W.dot(outwards) * outwards;
  const bool opposite = outwards.dot(gate) < 0 && about_W.norm() < 2 * step_m;
  if (!opposite && about_W.norm() < soft_m_ + 2 * step_m) take(Way::straight);
  const Vec3 ahead_W = opposite ? outwards.unitOrthogonal() : about_W;
  const double outwards_m = std::max(0.0, 1.05 * ball_m_ - here.norm());
  return along_walls(step_W_of(ahead_W, step_m) + std::min(step_m, outwards_m) * outwards);
}

/// As far of the step as is free. Where that is little it leads away from what is nearest, too.
Vec3 FreeFlight::within_room(const Vec3& step_W) const noexcept {
  const double least_m = least_share * soft_m_, free_m = std::max(0.0, clearance_.free_m);
  const bool tight = free_m < 1.2 * least_m;
  const double room_m = tight ? 0.3 * free_m : free_m - least_m, length_m = step_W.norm();
  const Vec3 step = length_m > room_m ? Vec3(step_W * (room_m / length_m)) : step_W;
  return tight ? Vec3(step + (0.4 * free_m + least_step_share * soft_m_) * clearance_.away_W) : step;
}

/// Whether it has come no nearer to the end of its way for a while.
bool FreeFlight::is_held_up(double left_m, double dt_s) noexcept {
  if (left_m < least_left_m_ - least_progress * another_way_s * speed_m_per_s_) {
    least_left_m_ = left_m;
    delay_s_ = 0;
  } else {
    delay_s_ += dt_s;
  }
  return delay_s_ >= another_way_s;
}

/// Which way next: straight on, over what is in the way, out and round, or none, where it is as near as it
/// can come.
void FreeFlight::choose_way(const Vec3& way_W, const Vec3& aside_W, const Vec3& towards_eye_W, bool blocked,
                            double dt_s) noexcept {
  if (way_ == Way::straight && blocked && !has_given_up_ && aside_W.norm() > arrived_m_) take(Way::over);
  if (way_ == Way::over && aside_W.norm() < soft_m_) take(Way::straight);
  const double left_m = way_W.norm(), over_m = aside_W.norm() + way_W.dot(towards_eye_W);
  const bool held_up = is_held_up(way_ == Way::over ? over_m : left_m, dt_s);
  // Where the finger has no room at the goal it rests beside it.
  const double lacks_m = held_up ? std::max(0.0, soft_m_ - around_.at(goal_W_, soft_m_).free_m) : 0.0;
  const bool near_enough = held_up && (has_given_up_ || left_m < soft_m_ + 3 * lacks_m);
  const bool rested = std::exchange(rests_, way_ == Way::straight && (left_m < 0.5 * soft_m_ || near_enough));
  // The clock of one that rested has run on: when its goal sets out, by however little at first, it begins
  // anew. Else a finger that hovers and is pressed would be taken for one to whose goal nothing leads.
  if (!held_up || rests_) return;
  if (rested) return take(Way::straight);
  // Once above all parts and down again is enough: it has come as near as it can.
  if (went_up_) return give_up();
  went_up_ = true;
  take(Way::up);
}

/// A goal that goes on is no way that leads nowhere; and one that has left for elsewhere, or is seen from
/// another side, is tried for anew when it is back.
void FreeFlight::note_goal(const Vec3& goal_W, const Vec3& towards_eye_W) noexcept {
  if ((goal_W - goal_W_).norm() > soft_m_) {
    goal_W_ = goal_W;
    least_left_m_ = without_end;
    delay_s_ = 0;
  }
  const bool is_seen_anew = (towards_eye_W - towards_eye_W_).norm() > pointer_limits::another_view;
  if (!is_seen_anew && (goal_W_ - tried_for_W_).norm() < 2 * soft_m_) return;
  tried_for_W_ = goal_W_;
  towards_eye_W_ = towards_eye_W;
  went_up_ = has_given_up_ = false;
}

void FreeFlight::give_up() noexcept {
  has_given_up_ = true;
  take(Way::straight);
}

/// One step up or out, from where a way round leads to every goal that is seen.
Vec3 FreeFlight::leave(const Vec3& here_W, const Vec3& towards_eye_W, double dt_s) noexcept {
  const bool up = way_ == Way::up;
  const Vec3 step_W = up ? along_walls(speed_m_per_s_ * dt_s * towards_eye_W) : out(dt_s);
  const double left_m = up ? -here_W.dot(towards_eye_W) : trail_.length_m(place_W());
  if (here_W.norm() > ball_m_) {
    take(Way::round);
  } else if (is_held_up(left_m, dt_s)) {
    up ? take(Way::out) : give_up();
  }
  return step_W;
}

Vec3 FreeFlight::next_step(const Vec3& goal_W, const Vec3& straight_W, const Vec3& towards_eye_W,
                           double dt_s) noexcept {
  const Vec3 from_W = place_W(), way_W = goal_W - from_W;
  const Vec3 aside_W = way_W - way_W.dot(towards_eye_W) * towards_eye_W;
  const Vec3 here_W = from_W - around_.middle_W();
  if (way_ == Way::up || way_ == Way::out) return leave(here_W, towards_eye_W, dt_s);
  if (way_ == Way::round) {
    const Vec3 step_W = round_all(goal_W, towards_eye_W, dt_s);
    if (way_ == Way::round && is_held_up(-here_W.normalized().dot(towards_eye_W) * ball_m_, dt_s)) give_up();
    return step_W;
  }
  const Vec3 free_W = along_walls(straight_W);
  choose_way(way_W, aside_W, towards_eye_W, free_W.norm() < blocked_share * straight_W.norm(), dt_s);
  return way_ == Way::over ? over_it(aside_W, towards_eye_W, dt_s) : free_W;
}

const Vec3& FreeFlight::advance(const Vec3& goal_W, const Vec3& towards_eye_W, double dt_s) noexcept {
  const Vec3 from_W = place_W();
  note_goal(goal_W, towards_eye_W);
  if ((from_W - around_.middle_W()).norm() > ball_m_) trail_.begin(from_W);
  if (way_ != Way::out) trail_.add(from_W);
  Follower straight = follower_;
  const Vec3 straight_W = straight.advance(goal_W, dt_s) - from_W;
  clearance_ = around_.at(from_W, 2 * soft_m_ + std::max(straight_W.norm(), speed_m_per_s_ * dt_s));
  Vec3 step_W = next_step(goal_W, straight_W, towards_eye_W, dt_s);
  // Softly away from what is nearer than it need be.
  const double close_m = soft_m_ - clearance_.free_m;
  if (close_m > 0) step_W += 0.1 * close_m * clearance_.away_W;
  step_W = within_room(step_W);
  clearance_.free_m -= step_W.norm();
  if (step_W != straight_W) straight.put(from_W + step_W, step_W / dt_s);
  follower_ = straight;
  return place_W();
}

}  // namespace fingerpad
