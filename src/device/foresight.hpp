#pragma once

#include <memory>
#include <optional>

#include "contact/contact_method.hpp"
#include "contact/proxy.hpp"
#include "touch/contact_choice.hpp"
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
  ~Foresight();

  /// The normal force that a tick at p_W would give, after those that were gone. Any number of places may be
  /// tried; what a try gives may differ from what go() gives where two answers lie within rounding.
  /// noexcept, allocates nothing, as all here.
  double try_n(const Vec3& p_W, double dt_s) noexcept;
  /// Where the push of the last try would hold the finger's centre out; the tried place itself where it
  /// touched nothing.
  const Vec3& held_W() const noexcept { return held_W_; }
  /// The finger goes there. @returns the normal force that its tick will give
  double go_n(const Vec3& p_W, double dt_s) noexcept;
  /// Another way of touching, as it begins.
  class Method;
  static std::unique_ptr<Method> method_for(const World& world, const Scene& scene);
  /// The same surfaces, touched in another way or with other properties; they outlive this. What serves no
  /// longer is left in `method`. It goes on as Touch::take_over does.
  void change(const World& world, std::unique_ptr<Method>& method) noexcept;
  /// As if the last go_n() had not been.
  void take_back() noexcept;

 private:
  double normal_force_n(const Contact& contact, const Vec3& p_W, double dt_s) noexcept;
  double tried_n(const Contact& contact, const Vec3& p_W, double dt_s) noexcept;

  std::shared_ptr<const World> kept_;
  const World* world_;  ///< kept_, until its surfaces have other properties
  std::unique_ptr<Method> method_;
  ProxyState before_;           ///< of the proxy that goes, before its last step
  bool strayed_ = false;        ///< the one for trying stands elsewhere than the one that goes
  Vec3 held_W_ = Vec3::Zero();  ///< of the last try
  Vec3 tried_W_ = Vec3::Zero(), last_W_ = Vec3::Zero(), last_but_one_W_ = Vec3::Zero();
  Walls walls_;
};

/// A contact method as foresight needs it.
class Foresight::Method {
 public:
  Method(const World& world, const Scene& scene);

  ContactChoice kind;
  // Where the scene has a proxy: one that goes as the touch's does, its memory too, and one for trying.
  std::optional<Proxy> goes, tries;
  std::unique_ptr<ContactMethod> plain;  ///< where the scene has a method without memory
};

}  // namespace fingerpad
