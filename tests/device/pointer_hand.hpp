#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/random_stream.hpp"
#include "contact/triangle_tree.hpp"
#include "device/pointer_finger.hpp"
#include "scene/scene.hpp"
#include "touch/finger_room.hpp"
#include "touch/touch.hpp"

namespace fingerpad::test {

/// A world, and what the window knows of it: a ball around the parts.
struct PointedWorld {
  std::string name;
  Scene scene;
  std::shared_ptr<const World> world;
  Vec3 middle_W = Vec3::Zero();
  double radius_m = 0.05;

  PointedWorld(std::string its_name, Scene its_scene, std::shared_ptr<const World> its_world)
      : name(std::move(its_name)), scene(std::move(its_scene)), world(std::move(its_world)) {
    const Surroundings around(world, scene);
    middle_W = around.middle_W();
    radius_m = around.radius_m();
  }
};

/// A surface under the mouse.
struct Spot {
  Vec3 point_W, normal_W;
  double along_m;
};

inline std::optional<double> meets(const Part& part, int t, const Vec3& from, const Vec3& way) {
  const Vec3 a = part.vertices.col(part.triangles(0, t));
  const Vec3 u = Vec3(part.vertices.col(part.triangles(1, t))) - a;
  const Vec3 v = Vec3(part.vertices.col(part.triangles(2, t))) - a;
  const Vec3 across = way.cross(v);
  const double det = u.dot(across);
  if (det == 0) return std::nullopt;
  const Vec3 to = from - a, other = to.cross(u);
  const double x = to.dot(across) / det, y = way.dot(other) / det, along = v.dot(other) / det;
  if (x < 0 || y < 0 || x + y > 1 || along < 0) return std::nullopt;
  return along;
}

/// Looks along `-towards_eye_W` as the window does, on parts seen from either side and on planes; on bars
/// before what is seen, where the finger is too large for their gaps.
inline std::optional<Spot> spot_under(const PointedWorld& pointed, const Vec3& from_W, const Vec3& way_W) {
  std::optional<Spot> found;
  const auto offer = [&](const Spot& spot) {
    if (found && found->along_m <= spot.along_m) return;
    found = spot;
    if (spot.normal_W.dot(way_W) > 0) found->normal_W = -spot.normal_W;
  };
  const double reach_m = 8 * pointed.radius_m;
  for (std::size_t i = 0; i < pointed.world->surfaces.size(); ++i) {
    const Surface& surface = pointed.world->surfaces[i];
    if (surface.is_plane()) {
      const double down = surface.plane_normal_W.dot(way_W);
      const double along_m = surface.plane_normal_W.dot(surface.plane_point_W - from_W) / down;
      if (down < -1e-9 && along_m > 0) offer({from_W + along_m * way_W, surface.plane_normal_W, along_m});
      continue;
    }
    const Part& part = *surface.part;
    const Vec3 from_P = surface.R_WP.transpose() * (from_W - surface.p_WP) - part.centre_P;
    const Vec3 way_P = surface.R_WP.transpose() * way_W;
    const auto offer_triangle = [&](int t, double along_m) {
      offer({from_W + along_m * way_W, surface.R_WP * part.facet_normals.col(t), along_m});
    };
    if (pointed.world->verdicts.size() > i && pointed.world->verdicts[i].closed) {
      const SegmentHit hit = surface.tree->first_crossing(from_P, from_P + reach_m * way_P);
      if (hit.triangle >= 0) offer_triangle(hit.triangle, hit.along * reach_m);
      continue;
    }
    for (int t = 0; t < part.triangle_count(); ++t) {
      if (const auto along_m = meets(part, t, from_P, way_P)) offer_triangle(t, *along_m);
    }
  }
  if (!found) return found;
  Looks looks(room_looks);
  const double radius_m = pointed.scene.finger.radius_m;
  const auto rim = rim_before(*pointed.world, from_W, found->point_W, found->normal_W, radius_m, looks);
  return rim ? Spot{rim->centre_W + radius_m * way_W, -way_W, 0} : found;
}

/// What a pointer on its way did to the finger.
struct PointerRun {
  double most_n = 0;             ///< normal force
  double most_drawn_off_m = -1;  ///< of the finger's skin from its contact, beyond the depth
  double last_n = 0;             ///< at rest
  double last_off_m = 0;         ///< of the finger from the spot, at rest
  bool ends_on_part = false;
  int touched = 0, ticks = 0;
  int harder = 0;                   ///< ticks that press harder than was asked for, by more than 6 %
  double most_step_m = 0;           ///< of a tick
  double most_touching_step_m = 0;  ///< of a tick after one that touched
};

/// A pointer that jumps, sweeps, trembles and leaves the part, seen from a direction of its own; it rests in
/// the end. A press of 0 N hovers.
class PointerWalk {
 public:
  /// @param lifts  off the part the press ends until the pointer is back, as of a button that is held
  PointerWalk(const PointedWorld& pointed, std::uint64_t seed, double press_n, bool lifts = false)
      : pointed_(pointed), random_(seed), press_n_(press_n), lifts_(lifts) {
    turn_camera();
  }

  PointerRun run(double seconds, double rest_s) {
    PointerFinger finger({pointed_.scene, pointed_.world, start()});
    return run(finger, seconds, rest_s);
  }

  /// Where a finger is at first.
  FingerSample start() const {
    FingerSample start;
    start.p_WQ =
        pointed_.middle_W + Vec3(0.35, -0.6, 0.72).normalized() * (1.2 * pointed_.radius_m + 2 * radius_m());
    return start;
  }

  PointerRun run(LiveDevice& finger, double seconds, double rest_s) {
    Touch touch(pointed_.world, pointed_.scene);
    const double dt_s = 1 / pointed_.scene.motion.rate_hz;
    PointerRun run;
    Vec3 last_W = start().p_WQ;
    bool touched = false;
    double next_event_s = 0.01;
    const int ticks = static_cast<int>((seconds + rest_s) / dt_s);
    for (int k = 0; k < ticks; ++k) {
      const double t_s = k * dt_s;
      if (t_s >= next_event_s && t_s < seconds) {
        next_event_s += 0.008;
        move();
        point(finger, t_s);
        // In the end it rests on the part.
        for (int tries = 0; next_event_s >= seconds && !ends_on_part_ && tries < 100; ++tries) {
          at_ = Eigen::Vector2d(random_.uniform(), random_.uniform()) * 2 - Eigen::Vector2d(1, 1);
          point(finger, t_s);
        }
      }
      FingerSample sample = finger.advance(dt_s);
      sample.t_s = t_s;
      const TickRecord row = touch.tick(sample);
      finger.feel(row);
      note(row, run);
      const double step_m = (sample.p_WQ - last_W).norm();
      run.most_step_m = std::max(run.most_step_m, step_m);
      if (touched) run.most_touching_step_m = std::max(run.most_touching_step_m, step_m);
      touched = row.walls > 0;
      last_W = sample.p_WQ;
    }
    run.ticks = ticks;
    run.ends_on_part = spot_.has_value() && ends_on_part_;
    if (spot_) {
      const double hover_m = press_n_ > 0 ? 0 : hover_share * pointed_.radius_m;
      run.last_off_m = (last_W - spot_->point_W - (radius_m() + hover_m) * spot_->normal_W).norm();
    }
    return run;
  }

 private:
  static constexpr double hover_share = 0.05;
  double radius_m() const { return pointed_.scene.finger.radius_m; }

  void turn_camera() {
    do towards_eye_W_ = Vec3(random_.normal(), random_.normal(), random_.normal());
    while (towards_eye_W_.norm() < 0.1);
    towards_eye_W_.normalize();
    right_W_ = towards_eye_W_.unitOrthogonal();
    up_W_ = towards_eye_W_.cross(right_W_);
  }

  void point(LiveDevice& finger, double t_s) {
    const Vec3 from_W =
        pointed_.middle_W + pointed_.radius_m * (4 * towards_eye_W_ + at_.x() * right_W_ + at_.y() * up_W_);
    const auto spot = spot_under(pointed_, from_W, -towards_eye_W_);
    ends_on_part_ = spot.has_value();
    if (spot) spot_ = spot;
    if (!spot_) return;
    FingerSample target;
    target.t_s = t_s;
    const bool presses = press_n_ > 0 && (spot || !lifts_);
    target.p_WQ =
        spot_->point_W + spot_->normal_W * (radius_m() + (presses ? 0 : hover_share * pointed_.radius_m));
    if (presses) target.push_W_n = -press_n_ * spot_->normal_W;
    finger.look_from(towards_eye_W_);
    finger.set_target(target);
  }

  /// The pointer's own way, in a window two parts wide.
  void move() {
    if (lifts_ && random_.uniform() < 0.04) jump();
    if (at_.x() > 1.1) return;  // it jumped off, and rests there
    if (random_.uniform() < 0.02) pace_ = Eigen::Vector2d(random_.normal(), random_.normal()) * 0.02;
    if (random_.uniform() < 0.01) pace_.setZero();
    if (random_.uniform() < 0.02)
      at_ = Eigen::Vector2d(random_.uniform(), random_.uniform()) * 2 - Eigen::Vector2d(1, 1);
    if (random_.uniform() < 0.003) turn_camera();
    at_ += pace_ + 0.001 * Eigen::Vector2d(random_.normal(), random_.normal());
    at_ = at_.cwiseMax(-1.1).cwiseMin(1.1);
  }

  /// Off the part, and back to where it was.
  void jump() {
    const bool is_off = at_.x() > 1.1;
    if (!is_off) back_x_ = at_.x();
    at_.x() = is_off ? back_x_ : 1.2;
  }

  void note(const TickRecord& row, PointerRun& run) const {
    run.most_n = std::max(run.most_n, row.normal_force_n);
    run.last_n = row.normal_force_n;
    run.harder += row.normal_force_n > 1.06 * press_n_ ? 1 : 0;
    if (row.walls == 0) return;
    ++run.touched;
    const double off_m = (row.p_WQ - row.contact_W).norm() - radius_m();
    run.most_drawn_off_m = std::max(run.most_drawn_off_m, off_m - row.depth_m);
  }

  const PointedWorld& pointed_;
  RandomStream random_;
  double press_n_;
  bool lifts_;
  double back_x_ = 0;  ///< from where the pointer jumped off the part
  Vec3 towards_eye_W_, right_W_, up_W_;
  Eigen::Vector2d at_ = Eigen::Vector2d::Zero(), pace_ = Eigen::Vector2d::Zero();
  std::optional<Spot> spot_;
  bool ends_on_part_ = false;
};

}  // namespace fingerpad::test
