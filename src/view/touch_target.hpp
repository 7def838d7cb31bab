#pragma once

#include <optional>

#include "motion/finger_path.hpp"
#include "touch/world.hpp"
#include "view/draw_space.hpp"

namespace fingerpad {

/// Where a pointer wants the finger: over a spot of a surface, hovering or pressed in.
class TouchTarget {
 public:
  /// @param hover_m  height above the surface while not pressing, > 0
  TouchTarget(std::shared_ptr<const World> world, const Scene& scene, double hover_m,
              const FingerSample& start);

  /// Over this spot of a surface.
  void point_at(const Vec3& point_W, const Vec3& normal_W, int surface);
  /// The same of a spot under a finger that is too large for what the pointer is over.
  void point_at_rim(const Vec3& point_W, const Vec3& normal_W, int surface);
  /// Over the surface from the present spot, by a step in space, as a ball of the finger's size rolls: round
  /// edges, and over slots that are too narrow for it. No step leads it farther than twice the step, but for
  /// the first out of a spot that it is too large for: there it begins where the finger is that has come as
  /// near as it can, else where one rests that comes down the eye's line.
  /// @param finger_W  where the finger is
  void move_by(const Vec3& step_W, const Vec3& towards_eye_W, const Vec3& finger_W);
  void press(bool on) { pressing_ = on; }
  /// The force aimed at, one step of about a quarter up or down; 0.05 to 20 N, and never more than the
  /// scene's `greatest_force_n`, for which the contact was chosen.
  void change_force(int steps);

  bool pressing() const noexcept { return pressing_; }
  double press_n() const noexcept { return press_n_; }
  const Vec3& normal_W() const noexcept { return normal_W_; }
  /// Where the finger is wanted: hovering, or just touching, and push_W_n what it presses with there.
  FingerSample sample() const;
  /// How far in that presses it.
  Vec3 pressed_W() const;
  /// Whether a finger that is there stays clear of what is pointed at, since it is too large for it.
  bool is_kept_from_spot(const Vec3& finger_W) const;

 private:
  Vec3 begin_roll_W(const Vec3& towards_eye_W, const Vec3& finger_W) const noexcept;
  bool rest_at(Vec3 centre_W, double reach_m) noexcept;

  std::shared_ptr<const World> world_;
  Normals normals_;
  double radius_m_, hover_m_;
  Vec3 direction_W_;
  Vec3 spot_W_, normal_W_ = Vec3::UnitZ();
  int surface_ = -1;  ///< -1: nothing pointed at yet
  double most_n_, least_n_, press_n_;
  bool pressing_ = false, on_rim_ = false;
};

}  // namespace fingerpad
