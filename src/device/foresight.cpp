#include "device/foresight.hpp"

#include "contact/contact_method_table.hpp"
#include "scene/scene.hpp"

namespace fingerpad {

Foresight::Foresight(std::shared_ptr<const World> world, const Scene& scene)
    : kept_(std::move(world)), world_(kept_.get()) {
  const ContactChoice choice = settled_contact(scene, *world_);
  const ContactMethodEntry* const entry = find_contact_method(choice.method);
  if (entry == nullptr) return;
  if (!entry->starts_outside) {
    method_ = entry->make(placed_surfaces(*world_), scene.finger.radius_m, choice.normals);
    return;
  }
  goes_ = fast_proxy(placed_surfaces(*world_), scene.finger.radius_m, choice.normals);
  tries_ = fast_proxy(placed_surfaces(*world_), scene.finger.radius_m, choice.normals);
}

/// As Touch tells it, of a finger whose velocity is not known otherwise.
double Foresight::normal_force_n(const Contact& contact, const Vec3& p_W, double dt_s) noexcept {
  if (contact.hold_count == 0) return 0;
  find_walls(contact, walls_);
  const Vec3 velocity_W = (p_W - last_W_) / dt_s;
  double sum_n = 0;
  for (const Wall& wall : walls_) {
    const auto surface = static_cast<std::size_t>(wall.surface);
    sum_n += spring_force_n(wall, walls_[0], world_->surfaces[surface].properties, velocity_W);
  }
  return sum_n;
}

double Foresight::try_n(const Vec3& p_W, double dt_s) noexcept {
  if (method_) return normal_force_n(method_->touch(p_W, dt_s), p_W, dt_s);
  if (!tries_) return 0;
  if (strayed_) tries_->resume(goes_->state());
  strayed_ = true;
  tried_W_ = p_W;
  return normal_force_n(tries_->move(p_W, dt_s), p_W, dt_s);
}

double Foresight::go_n(const Vec3& p_W, double dt_s) noexcept {
  double felt_n = 0;
  if (method_) {
    felt_n = normal_force_n(method_->touch(p_W, dt_s), p_W, dt_s);
  } else if (goes_) {
    before_ = goes_->state();
    felt_n = normal_force_n(goes_->move(p_W, dt_s), p_W, dt_s);
    // The one that tries has come along, memory and all, where the last try was this.
    strayed_ = !(strayed_ && tried_W_ == p_W);
  }
  last_but_one_W_ = last_W_;
  last_W_ = p_W;
  return felt_n;
}

void Foresight::take_back() noexcept {
  last_W_ = last_but_one_W_;
  strayed_ = true;
  if (goes_) goes_->resume(before_);
}

}  // namespace fingerpad
