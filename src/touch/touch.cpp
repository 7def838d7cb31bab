#include "touch/touch.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "contact/contact_method_table.hpp"
#include "contact/triangle_tree.hpp"
#include "friction/law_table.hpp"
#include "part/part.hpp"
#include "scene/scene.hpp"
#include "touch/finger_turn.hpp"
#include "touch/inside_start.hpp"
#include "touch/usable_sample.hpp"

namespace fingerpad {
namespace {

/// Whether a finger without an attitude has the direction it had: mostly, and then nothing need be told.
bool lies_plainly_alike(const FingerSample& before, const FingerSample& now) noexcept {
  return !before.attitude && !now.attitude && before.direction_W == now.direction_W;
}

std::unique_ptr<ContactMethod> make_contact_method(const Scene& scene, const World& world) {
  const ContactChoice contact = settled_contact(scene, world);
  const ContactMethodEntry* entry = find_contact_method(contact.method);
  if (entry == nullptr) throw refused(scene.path, fmt::format("unknown contact method '{}'", contact.method));
  return entry->make(placed_surfaces(world), scene.finger.radius_m, contact.normals);
}

}  // namespace

Touch::Touch(std::shared_ptr<const World> world, const Scene& scene, const ContactWrap& wrap)
    : world_(std::move(world)),
      normals_(settled_contact(scene, *world_).normals),
      radius_m_(scene.finger.radius_m),
      dt_s_(1 / scene.motion.rate_hz),
      method_row_(find_contact_method(settled_contact(scene, *world_).method)),
      law_row_(find_law(scene.friction.law)),
      method_(make_contact_method(scene, *world_)),
      velocity_(scene.hand ? scene.hand->encoder_m : 0, dt_s_) {
  if (law_row_ == nullptr)
    throw refused(scene.path, fmt::format("unknown friction law '{}'", scene.friction.law));
  law_ = law_row_->make(scene.friction.settings);
  if (wrap) method_ = wrap(std::move(method_), placed_surfaces(*world_));
  if (!scene.friction.vibration) return;
  const VibrationSettings& vibration = *scene.friction.vibration;
  vibration_amplitude_ = vibration.amplitude;
  vibration_normal_amplitude_ = vibration.normal_amplitude;
  vibration_.emplace(vibration.frequency_hz, vibration.bandwidth_hz, dt_s_, RandomStream(scene.seed));
}

void Touch::warm_up() const noexcept {
  for (const Surface& surface : world_->surfaces) {
    if (surface.tree) surface.tree->warm_up();
  }
}

void Touch::reset() noexcept {
  velocity_.reset();
  method_->reset();
  facets_ = {};
  unplaced_ = false;
  has_last_ = false;
  release();
}

void Touch::release() noexcept {
  memories_.forget();
  if (vibration_) vibration_->rest();
}

SkinMotion Touch::skin_motion(const FingerSample& sample) noexcept {
  SkinMotion skin;
  skin.dt_s = dt_s_;
  skin.velocity_W = velocity_of(sample, velocity_.next(sample.p_WQ));
  if (has_last_) skin.displacement_W = sample.p_WQ - last_W_;
  if (radius_m_ > 0 && !(has_last_ && lies_plainly_alike(last_lay_, sample))) {
    if (has_last_) skin.turn_W = finger_turn(last_lay_, sample);
    skin.turns = skin.turn_W != Vec3::Zero();
    last_lay_ = sample;
  }
  last_W_ = sample.p_WQ;
  has_last_ = true;
  return skin;
}

double Touch::push(const Vec3& velocity_W) noexcept {
  double sum_n = 0;
  for (Wall& wall : walls_) {
    wall.normal_force_n = spring_force_n(wall, walls_[0], surface_of(wall).properties, velocity_W);
    sum_n += wall.normal_force_n;
  }
  return sum_n;
}

/// Makes the walls' normal forces sum up to the one that was measured; where the model has none, by their
/// shares of the depth.
double Touch::press(double measured_n, double model_n) noexcept {
  double depth_m = 0;
  for (const Wall& wall : walls_) depth_m += wall.share_m;
  for (Wall& wall : walls_) {
    const double share = model_n > 0 ? wall.normal_force_n / model_n : wall.share_m / depth_m;
    wall.normal_force_n = walls_.count == 1 ? measured_n : measured_n * share;
  }
  return measured_n;
}

Friction Touch::rub(const Wall& wall, double share_of_push, double inclination_rad, const SkinMotion& skin,
                    const FingerStand& finger, WallMemory& memory) noexcept {
  const Phase before = memory.friction.phase;
  TangentialMotion motion = tangential_motion(skin, finger, wall, surface_of(wall).properties,
                                              memory.frame_WC, inclination_rad, before == Phase::free);
  motion.normal_force_n = wall.normal_force_n;
  motion.applied_force_n *= share_of_push;
  const Friction friction = law_->tick(motion, memory.friction);
  if (!friction.centre_moved) return friction;
  const Vec3 stretch_W = memory.frame_WC.leftCols<2>() * friction.stretch_m;
  // Put on the surface where stick begins; a centre that a law drags along tick by tick needs no search.
  if (before != Phase::stick || friction.ruptures > 0) {
    memory.centre.place(surface_of(wall), wall.point_W, stretch_W, normals_, wall.triangle, facets_,
                        {stick_centre_looks_, method_->memory_of(wall.surface)});
  } else {
    memory.centre.drag(wall.point_W - stretch_W);
  }
  return friction;
}

Touch::Forces Touch::forces(const SkinMotion& skin, const FingerStand& finger, double pushed_n,
                            TickRecord& record) noexcept {
  Forces forces;
  forces.pushed_n = pushed_n;
  for (int i = 0; i < walls_.count; ++i) {
    const Wall& wall = walls_[i];
    WallMemory& memory = memories_[i];
    // What pushes the finger along the walls is held by all of them, each by its part.
    const bool alone = walls_.count == 1;
    const double share_of_push = !alone && pushed_n > 0 ? wall.normal_force_n / pushed_n : 1;
    const double inclined_rad =
        alone ? record.inclination_rad : inclination_rad(finger.direction_W, wall.normal_W);
    const Friction friction = rub(wall, share_of_push, inclined_rad, skin, finger, memory);
    const bool slips = friction.phase == Phase::slip;
    const Vec3 friction_W_n = memory.frame_WC.leftCols<2>() * friction.force_n;
    (slips ? forces.slip_W_n : forces.stick_W_n) += friction_W_n;
    // By the arm with which turning rolls the skin (tangential_motion): F . v + torque . turn is then the
    // power that friction takes.
    if (radius_m_ > 0)
      (slips ? forces.slip_W_n_m : forces.stick_W_n_m) += (wall.point_W - finger.p_WQ).cross(friction_W_n);
    forces.any_slips |= slips;
    forces.normal_W_n += (wall.normal_force_n / wall.share_m) * wall.push_m;
    record.ruptures += friction.ruptures;
    record.remedied |= friction.remedied;
    if (i > 0) continue;
    record.phase = friction.phase;
    if (friction.phase == Phase::stick) record.stick_centre_W = memory.centre.point_W();
  }
  return forces;
}

/// Paper, figs. 10-11: the slipping pad's vibration shows in the tangential and in the normal force.
void Touch::vibrate(Forces& forces) noexcept {
  if (!forces.any_slips) {
    vibration_->rest();
    return;
  }
  const double signal = vibration_->next();
  const double scale = vibration_force_scale(vibration_amplitude_, signal);
  forces.slip_W_n *= scale;
  forces.slip_W_n_m *= scale;
  for (int i = 0; i < memories_.count(); ++i) {
    FrictionState& friction = memories_[i].friction;
    if (friction.phase == Phase::slip) friction.slip_force_scale = scale;
  }
  const double pressed = std::max(0.0, 1 + vibration_normal_amplitude_ * signal);
  forces.pushed_n *= pressed;
  forces.normal_W_n *= pressed;
}

void Touch::answer(const Contact& contact, const FingerSample& sample, const SkinMotion& skin,
                   TickRecord& record) noexcept {
  const FingerStand finger = stand_of(sample, contact.normal_W);
  find_walls(contact, walls_);
  memories_.follow(walls_, finger.direction_W);
  double pushed_n = push(skin.velocity_W);
  if (sample.normal_force_n) pushed_n = press(usable_force_n(*sample.normal_force_n), pushed_n);
  record.inclination_rad = inclination_.of(finger.direction_W, contact.normal_W);
  Forces sum = forces(skin, finger, pushed_n, record);
  if (vibration_) vibrate(sum);

  record.depth_m = contact.depth_m;
  record.contact_W = contact.point_W;
  record.normal_W = contact.normal_W;
  record.normal_force_n = sum.pushed_n;
  // Adding zero turns a minus zero, which a trace would show as "-0", into a plain one.
  record.friction_W_n = sum.slip_W_n + sum.stick_W_n + Vec3::Zero();
  record.force_W_n = sum.normal_W_n + record.friction_W_n;
  record.torque_W_n_m = sum.slip_W_n_m + sum.stick_W_n_m;
  record.mu = sum.pushed_n > 0 ? record.friction_W_n.norm() / sum.pushed_n : 0.0;
  record.walls = walls_.count;
  const Wall& greatest = walls_[0];
  record.surface = greatest.surface;
  record.triangle =
      greatest.triangle < 0
          ? -1
          : surface_of(greatest).part->file_triangle[static_cast<std::size_t>(greatest.triangle)];
}

TickRecord Touch::tick(const FingerSample& sample) noexcept {
  TickRecord record;
  record.t_s = sample.t_s;
  record.p_WQ = sample.p_WQ;
  if (!meaningful(sample.p_WQ)) {
    reset();
    return record;
  }
  const bool is_first = !has_last_;
  const SkinMotion skin = skin_motion(sample);
  record.velocity_W = skin.velocity_W;
  record.turn_W = skin.turn_W;
  const Contact& contact = method_->touch(sample.p_WQ, dt_s_);
  record.unsettled = contact.behind;
  // A search for a place that goes on with the next tick has not found that there is none.
  const bool unplaced_before = unplaced_;
  unplaced_ = !contact.placed && (unplaced_before || !contact.broken_off);
  record.started_inside = unplaced_ && !unplaced_before;
  if (contact.hold_count == 0) {
    release();
    return record;
  }
  answer(contact, sample, skin, record);
  record.started_inside |=
      (contact.started || is_first) && !unplaced_before && is_inside_part(record, *world_);
  if (meaningful(record.force_W_n)) return record;
  reset();  // a force that overflowed is no force to give to a person's hand
  record = {};
  record.t_s = sample.t_s;
  record.p_WQ = sample.p_WQ;
  return record;  // the one record that this function returns: made in the caller's place, never copied
}

}  // namespace fingerpad
