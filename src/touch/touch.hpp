#pragma once

#include <memory>

#include "base/random_stream.hpp"
#include "friction/law.hpp"
#include "touch/tick_record.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// One finger in one world: the tick that live touch, replay and study share.
class Touch {
 public:
  /// @param scene  its contact, friction, finger and rate; the world is loaded from it
  Touch(std::shared_ptr<const World> world, const Scene& scene);

  /// sample -> contact -> friction -> force, at the scene's fixed tick 1/rate.
  /// noexcept, allocates nothing; no force is ever non-finite, whatever the sample (one that is not finite is free).
  TickRecord tick(const FingerSample& sample) noexcept;

  /// Forgets the contact and the last position, as before the first tick.
  void reset() noexcept;

 private:
  struct Contact;
  Contact find_contact(const Vec3& p_WQ) noexcept;

  std::shared_ptr<const World> world_;
  std::shared_ptr<const FrictionLaw> law_;
};

}  // namespace fingerpad
