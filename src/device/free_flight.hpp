#pragma once

#include "device/follower.hpp"
#include "device/surroundings.hpp"
#include "device/trail.hpp"

namespace fingerpad {

/// A finger on its way through free space. A step is no longer than the finger is free, so it touches
/// nothing, whatever the goal and the parts. (With no room at all, a step is a thousandth of the distance
/// that it would keep.) It tries these ways in turn, each where the one before leads nowhere:
/// - straight to the goal, along what is in the way;
/// - over what is in the way: aside towards the goal where it can, else up towards the eye;
/// - up, above all parts, and down to the goal; held up again after that, it rests where it is;
/// - out, back on the way by which it came, and round all parts to the eye's side. That is for when the view
///   was turned and nothing leads up.
class FreeFlight {
 public:
  /// @param around  kept by reference
  FreeFlight(Surroundings& around, const Vec3& start_W) noexcept;

  /// dt_s later. noexcept, allocates nothing.
  const Vec3& advance(const Vec3& goal_W, const Vec3& towards_eye_W, double dt_s) noexcept;

  /// The finger was led elsewhere, by its touch.
  void put(const Vec3& place_W, const Vec3& velocity_m_per_s) noexcept;
  /// So far it is free where it was led.
  void note_free(double free_m) noexcept { clearance_.free_m = free_m; }
  /// It was led along here, and could go back this way.
  void note_way(const Vec3& place_W) noexcept { trail_.add(place_W); }

  const Vec3& place_W() const noexcept { return follower_.place_m(); }
  /// Free space around the place that the last advance() found, at least.
  double free_m() const noexcept { return clearance_.free_m; }
  /// That it keeps from what it flies by, where there is room.
  double soft_m() const noexcept { return soft_m_; }
  /// So long it is behind a goal that goes on.
  double lag_s() const noexcept { return follower_.lag_s(); }
  /// Nothing leads nearer to the goal.
  bool has_arrived() const noexcept { return rests_; }
  /// No way led there.
  bool has_given_up() const noexcept { return has_given_up_; }

 private:
  enum class Way { straight, over, up, out, round };

  Vec3 along_walls(const Vec3& step_W) const noexcept;
  Vec3 next_step(const Vec3& goal_W, const Vec3& straight_W, const Vec3& towards_eye_W, double dt_s) noexcept;
  Vec3 over_it(const Vec3& aside_W, const Vec3& towards_eye_W, double dt_s) const noexcept;
  Vec3 out(double dt_s) noexcept;
  Vec3 leave(const Vec3& here_W, const Vec3& towards_eye_W, double dt_s) noexcept;
  Vec3 round_all(const Vec3& goal_W, const Vec3& towards_eye_W, double dt_s) noexcept;
  Vec3 within_room(const Vec3& step_W) const noexcept;
  void choose_way(const Vec3& way_W, const Vec3& aside_W, const Vec3& towards_eye_W, bool blocked,
                  double dt_s) noexcept;
  bool is_held_up(double left_m, double dt_s) noexcept;
  void note_goal(const Vec3& goal_W, const Vec3& towards_eye_W) noexcept;
  void give_up() noexcept;
  void take(Way way) noexcept;

  Surroundings& around_;
  double soft_m_, arrived_m_, ball_m_, speed_m_per_s_;
  Follower follower_;
  Clearance clearance_;
  Trail trail_;
  Way way_ = Way::straight;
  bool rests_ = false;
  double least_left_m_;  ///< how near the goal it has come on this way ...
  double delay_s_ = 0;   ///< ... and for how long no nearer
  Vec3 goal_W_;          ///< the last one
  Vec3 tried_for_W_;     ///< the goal that these are about, and from where it was seen:
  Vec3 towards_eye_W_ = Vec3::Zero();
  bool went_up_ = false;       ///< it was above all parts on its way there
  bool has_given_up_ = false;  ///< no way has led there
};

}  // namespace fingerpad
