#pragma once

#include <memory>
#include <optional>

#include "contact/contact_method.hpp"
#include "fingerpad/finger_sample.hpp"
#include "friction/law.hpp"
#include "friction/slip_vibration.hpp"
#include "motion/velocity_estimator.hpp"
#include "touch/stick_centre.hpp"
#include "touch/tick_record.hpp"
#include "touch/world.hpp"

namespace fingerpad {

struct Scene;

/// One finger in one world: the tick that live touch, replay and study share.
class Touch {
 public:
  /// @param world  as load_world(scene) made it, with the choice of what the scene leaves open
  /// @param scene  its contact, friction, finger and rate. Throws Error (refused) for a contact method or a
  /// law that no table has.
  Touch(std::shared_ptr<const World> world, const Scene& scene);

  /// sample -> contact -> friction -> force, at the scene's fixed tick 1/rate.
  /// noexcept, allocates nothing; no force is ever non-finite, whatever the sample (one that is not finite is
  /// free).
  TickRecord tick(const FingerSample& sample) noexcept;

  /// Forgets the contact and the last position, as before the first tick.
  void reset() noexcept;

 private:
  void turn_frame(const Contact& contact, const Vec3& direction_W) noexcept;
  TangentialMotion tangential_motion(const Contact& contact, double normal_force_n, const Vec3& velocity_W,
                                     const FingerSample& sample) const noexcept;
  void answer(const Contact& contact, const FingerSample& given, const Vec3& velocity_W,
              TickRecord& record) noexcept;
  void vibrate(Friction& friction, double& normal_force_n) noexcept;
  void release() noexcept;

  std::shared_ptr<const World> world_;
  std::shared_ptr<const FrictionLaw> law_;
  Normals normals_;
  double dt_s_;

  std::unique_ptr<ContactMethod> method_;
  VelocityEstimator velocity_;

  bool unplaced_ = false;  // the last tick found no place where the finger fits
  bool in_contact_ = false;
  Vec3 last_contact_W_ = Vec3::Zero();
  Mat3 last_frame_WC_ = Mat3::Identity();
  Mat3 frame_WC_ = Mat3::Identity();  ///< of the contact: Cx, Cy, and Cz the normal
  FrictionState friction_;
  StickCentre centre_;

  std::optional<SlipVibration>
      vibration_;  ///< only where the scene asks for it: else no random number is drawn
  double vibration_amplitude_ = 0, vibration_normal_amplitude_ = 0;
};

}  // namespace fingerpad
