#include "touch/touch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/tangent_frame.hpp"
#include "contact/contact_method_table.hpp"
#include "friction/law_table.hpp"
#include "part/part.hpp"
#include "scene/scene.hpp"
#include "touch/inside_start.hpp"

namespace fingerpad {
namespace {

/// Beyond this a position (in m), velocity or force is a broken input, not a finger: products of a few such
/// numbers must stay far from overflow.
constexpr double largest_meaningful = 1e60;

bool meaningful(const Vec3& v) noexcept {
  return v.cwiseAbs().maxCoeff() <= largest_meaningful && v.allFinite();
}

/// The sample with a unit direction (straight down the normal where its own is unusable) and a finite push.
FingerSample usable(FingerSample sample, const Vec3& normal_W) noexcept {
  const double length = sample.direction_W.norm();
  sample.direction_W =
      std::isfinite(length) && length > 0 ? Vec3(sample.direction_W / length) : Vec3(-normal_W);
  if (!meaningful(sample.push_W_n)) sample.push_W_n.setZero();
  return sample;
}

std::unique_ptr<ContactMethod> make_contact_method(const Scene& scene, const World& world) {
  const ContactChoice contact = settled_contact(scene, world);
  const ContactMethodEntry* entry = find_contact_method(contact.method);
  if (entry == nullptr) throw refused(scene.path, fmt::format("unknown contact method '{}'", contact.method));
  return entry->make(placed_surfaces(world), scene.finger.radius_m, contact.normals);
}

}  // namespace

Touch::Touch(std::shared_ptr<const World> world, const Scene& scene)
    : world_(std::move(world)),
      normals_(settled_contact(scene, *world_).normals),
      dt_s_(1 / scene.motion.rate_hz),
      method_(make_contact_method(scene, *world_)),
      velocity_(scene.hand ? scene.hand->encoder_m : 0, dt_s_) {
  const LawEntry* entry = find_law(scene.friction.law);
  if (entry == nullptr)
    throw refused(scene.path, fmt::format("unknown friction law '{}'", scene.friction.law));
  law_ = entry->make(scene.friction.settings);
  if (!scene.friction.vibration) return;
  const VibrationSettings& vibration = *scene.friction.vibration;
  vibration_amplitude_ = vibration.amplitude;
  vibration_normal_amplitude_ = vibration.normal_amplitude;
  vibration_.emplace(vibration.frequency_hz, vibration.bandwidth_hz, dt_s_, RandomStream(scene.seed));
}

void Touch::reset() noexcept {
  velocity_.reset();
  method_->reset();
  unplaced_ = false;
  release();
}

void Touch::release() noexcept {
  in_contact_ = false;
  friction_ = {};
  centre_.forget();
  if (vibration_) vibration_->rest();
}

void Touch::turn_frame(const Contact& contact, const Vec3& direction_W) noexcept {
  last_frame_WC_ = frame_WC_;
  frame_WC_ =
      in_contact_ ? transported(frame_WC_, contact.normal_W) : tangent_frame(contact.normal_W, direction_W);
}

TangentialMotion Touch::tangential_motion(const Contact& contact, double normal_force_n,
                                          const Vec3& velocity_W, const FingerSample& sample) const noexcept {
  const auto in_plane = [this](const Vec3& v) {
    return Vec2(frame_WC_.col(0).dot(v), frame_WC_.col(1).dot(v));
  };
  const SurfaceProperties& properties =
      world_->surfaces[static_cast<std::size_t>(contact.holds[0].surface)].properties;
  const Vec3& normal_W = frame_WC_.col(2);

  TangentialMotion motion;
  motion.dt_s = dt_s_;
  motion.normal_force_n = normal_force_n;
  motion.mu_static = properties.mu_static;
  motion.mu_dynamic = properties.mu_dynamic;
  motion.surface_stiffness_n_per_m = properties.stiffness_n_per_m;
  motion.velocity_m_per_s = in_plane(velocity_W);
  if (in_contact_ && law_->reads_step()) {
    motion.step_m =
        in_plane(surface_displacement(last_contact_W_, last_frame_WC_.col(2), contact.point_W, normal_W));
  }
  motion.from_centre_m = centre_.displacement(contact.point_W, frame_WC_);
  motion.inclination_rad = std::asin(std::min(1.0, std::abs(sample.direction_W.dot(normal_W))));
  motion.applied_force_n = in_plane(sample.push_W_n);
  const Vec2 longitudinal = in_plane(sample.direction_W);
  const double length = longitudinal.norm();
  // A finger straight along the normal names no axis in the plane: the transported frame serves.
  motion.longitudinal = length > 1e-9 ? Vec2(longitudinal / length) : Vec2(0, 1);
  return motion;
}

void Touch::answer(const Contact& contact, const FingerSample& given, const Vec3& velocity_W,
                   TickRecord& record) noexcept {
  const ContactHold& hold = contact.holds[0];  // the greatest stands for all
  const Surface& surface = world_->surfaces[static_cast<std::size_t>(hold.surface)];
  const FingerSample sample = usable(given, contact.normal_W);
  turn_frame(contact, sample.direction_W);
  const Vec3& normal_W = frame_WC_.col(2);

  // The damper may soften the surface's push, never pull the finger in.
  double normal_force_n = std::max(0.0, surface.properties.stiffness_n_per_m * contact.depth_m -
                                            surface.properties.damping_n_s_per_m * normal_W.dot(velocity_W));
  const TangentialMotion motion = tangential_motion(contact, normal_force_n, velocity_W, sample);
  const bool was_stuck = friction_.phase == Phase::stick;
  Friction friction = law_->tick(motion, friction_);
  vibrate(friction, normal_force_n);
  if (friction.centre_moved) {
    // Sought on the surface where stick begins; a centre that a law drags along tick by tick needs no search.
    centre_.place(surface, contact.point_W, frame_WC_, friction.from_centre_m, normals_,
                  friction.phase == Phase::stick && !was_stuck, hold.triangle);
  }

  record.phase = friction.phase;
  record.remedied = friction.remedied;
  record.depth_m = contact.depth_m;
  record.contact_W = contact.point_W;
  record.normal_W = normal_W;
  record.normal_force_n = normal_force_n;
  // Adding zero turns a minus zero, which a trace would show as "-0", into a plain one.
  record.friction_W_n = frame_WC_.leftCols<2>() * friction.force_n + Vec3::Zero();
  record.force_W_n = normal_force_n * normal_W + record.friction_W_n;
  record.mu = normal_force_n > 0 ? friction.force_n.norm() / normal_force_n : 0.0;
  record.inclination_rad = motion.inclination_rad;
  record.surface = hold.surface;
  record.triangle =
      hold.triangle < 0 ? -1 : surface.part->file_triangle[static_cast<std::size_t>(hold.triangle)];
  if (friction.phase == Phase::stick) {
    record.stick_centre_W = centre_.is_set()
                                ? centre_.point_W()
                                : Vec3(contact.point_W - frame_WC_.leftCols<2>() * friction.from_centre_m);
  }
  in_contact_ = true;
  last_contact_W_ = contact.point_W;
}

/// Paper, figs. 10-11: the slipping pad's vibration shows in the tangential and in the normal force.
void Touch::vibrate(Friction& friction, double& normal_force_n) noexcept {
  if (!vibration_) return;
  if (friction.phase != Phase::slip) {
    vibration_->rest();
    return;
  }
  const double signal = vibration_->next();
  const double scale = vibration_force_scale(vibration_amplitude_, signal);
  friction.force_n *= scale;
  friction_.slip_force_scale = scale;
  normal_force_n = std::max(0.0, normal_force_n * (1 + vibration_normal_amplitude_ * signal));
}

TickRecord Touch::tick(const FingerSample& sample) noexcept {
  TickRecord record;
  record.t_s = sample.t_s;
  record.p_WQ = sample.p_WQ;
  if (!meaningful(sample.p_WQ)) {
    reset();
    return record;
  }
  const Vec3 velocity_W = velocity_.next(sample.p_WQ);
  const Contact& contact = method_->touch(sample.p_WQ, dt_s_);
  const bool unplaced_before = std::exchange(unplaced_, !contact.placed);
  record.started_inside = unplaced_ && !unplaced_before;
  if (contact.hold_count == 0) {
    release();
    return record;
  }
  answer(contact, sample, velocity_W, record);
  record.started_inside |= contact.started && !unplaced_before && is_inside_part(record, *world_);
  if (meaningful(record.force_W_n)) return record;
  reset();  // a force that overflowed is no force to give to a person's hand
  TickRecord lost;
  lost.t_s = sample.t_s;
  lost.p_WQ = sample.p_WQ;
  return lost;
}

}  // namespace fingerpad
