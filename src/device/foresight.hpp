#pragma once

#include <memory>
#include <optional>

#include "contact/contact_method.hpp"
#include "contact/proxy.hpp"
#include "touch/wall.hpp"
#include "touch/world.hpp"

namespace fingerpad {

struct Scene;

/// What a finger's next tick will feel, before it is there. It has a contact method of its own, which goes
/// the finger's way tick by tick as the touch's does; so it knows what a step would meet, and a step that
/// would press too hard need not be made.
class Foresight {
 public:
  Foresight(std::shared_ptr<const World> world, const Scene& scene);

  /// The normal force that a tick at p_W would give, after those that were gone. Any number of places may be
  /// tried; what a try gives may differ from what go() gives where two answers lie within rounding.
  /// noexcept, allocates nothing, as all here.
  double try_n(const Vec3& p_W, double dt_s) noexcept;
  /// The finger goes there. @returns the normal force that its tick will give
  double go_n(const Vec3& p_W, double dt_s) noexcept;
  /// The same surfaces with other properties; they outlive this.
  void surfaces_changed(const World& world) noexcept { world_ = &world; }
  /// As if the last go_n() had not been.
  void take_back() noexcept;

 private:
  double normal_force_n(const Contact& contact, const Vec3& p_W, double dt_s) noexcept;

  std::shared_ptr<const World> kept_;
  const World* world_;  ///< kept_, until its surfaces have other properties
  // Where the scene has a proxy: one that goes as the touch's does, its memory too, and one for trying.
  std::optional<Proxy> goes_, tries_;
  ProxyState before_;                      ///< of the one that goes, before its last step
  std::unique_ptr<ContactMethod> method_;  ///< where the scene has a method without memory
  bool strayed_ = false;                   ///< the one for trying stands elsewhere than the one that goes
  Vec3 tried_W_ = Vec3::Zero(), last_W_ = Vec3::Zero(), last_but_one_W_ = Vec3::Zero();
  Walls walls_;
};

}  // namespace fingerpad
