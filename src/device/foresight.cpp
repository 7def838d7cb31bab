#include "device/foresight.hpp"

#include "contact/contact_method_table.hpp"
#include "contact/fast_proxy.hpp"
#include "scene/scene.hpp"

namespace fingerpad {

Foresight::Method::Method(const World& world, const Scene& scene) : kind(settled_contact(scene, world)) {
  const ContactMethodEntry* const entry = find_contact_method(kind.method);
  if (entry == nullptr) return;
  const double radius_m = scene.finger.radius_m;
  if (!entry->starts_outside) {
    plain = entry->make(placed_surfaces(world), radius_m, kind.normals);
    return;
  }
  goes = fast_proxy(placed_surfaces(world), radius_m, kind.normals);
  tries = fast_proxy(placed_surfaces(world), radius_m, kind.normals);
}

Foresight::Foresight(std::shared_ptr<const World> world, const Scene& scene)
    : kept_(std::move(world)), world_(kept_.get()), method_(method_for(*world_, scene)) {}

Foresight::~Foresight() = default;

std::unique_ptr<Foresight::Method> Foresight::method_for(const World& world, const Scene& scene) {
  return std::make_unique<Method>(world, scene);
}

void Foresight::change(const World& world, std::unique_ptr<Method>& method) noexcept {
  world_ = &world;
  if (method->kind.method == method_->kind.method && method->kind.normals == method_->kind.normals) return;
  std::swap(method, method_);
  strayed_ = true;
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

double Foresight::tried_n(const Contact& contact, const Vec3& p_W, double dt_s) noexcept {
  held_W_ = contact.hold_count > 0 ? Vec3(p_W + contact.depth_m * contact.normal_W) : p_W;
  return normal_force_n(contact, p_W, dt_s);
}

double Foresight::try_n(const Vec3& p_W, double dt_s) noexcept {
  if (method_->plain) return tried_n(method_->plain->touch(p_W, dt_s), p_W, dt_s);
  if (!method_->tries) return 0;
  if (strayed_) method_->tries->resume(method_->goes->state());
  strayed_ = true;
  tried_W_ = p_W;
  return tried_n(method_->tries->move(p_W, dt_s), p_W, dt_s);
}

double Foresight::go_n(const Vec3& p_W, double dt_s) noexcept {
  double felt_n = 0;
  if (method_->plain) {
    felt_n = normal_force_n(method_->plain->touch(p_W, dt_s), p_W, dt_s);
  } else if (method_->goes) {
    before_ = method_->goes->state();
    felt_n = normal_force_n(method_->goes->move(p_W, dt_s), p_W, dt_s);
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
  if (method_->goes) method_->goes->resume(before_);
}

}  // namespace fingerpad
