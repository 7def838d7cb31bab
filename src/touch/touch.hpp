#pragma once

#include <memory>
#include <optional>

#include "contact/contact_method.hpp"
#include "contact/looks.hpp"
#include "contact/taped_contact.hpp"
#include "fingerpad/finger_sample.hpp"
#include "friction/law.hpp"
#include "friction/slip_vibration.hpp"
#include "motion/velocity_estimator.hpp"
#include "touch/skin_motion.hpp"
#include "touch/tick_record.hpp"
#include "touch/wall_memory.hpp"
#include "touch/world.hpp"

namespace fingerpad {

struct ContactMethodEntry;
struct LawEntry;
struct Scene;

/// One finger in one world: the tick that live touch, replay and study share.
class Touch {
 public:
  /// @param world  as load_world(scene) made it, with the choice of what the scene leaves open
  /// @param scene  its contact, friction, finger and rate. Throws Error (refused) for a contact method or a
  /// law that no table has.
  /// @param wrap   what is made of its contact method; may be empty
  Touch(std::shared_ptr<const World> world, const Scene& scene, const ContactWrap& wrap = {});

  /// From now on no servo waits for a tick: a search whose answer no force depends on is never broken off, so
  /// that it finds the same whatever was remembered before.
  void take_your_time() noexcept { stick_centre_looks_ = Looks::unlimited; }

  /// sample -> contact -> friction -> force, at the scene's fixed tick 1/rate.
  /// noexcept, allocates nothing; no force is ever non-finite, whatever the sample (one that is not finite is
  /// free).
  TickRecord tick(const FingerSample& sample) noexcept;

  /// Asks each surface's search tree once, on the thread that will tick, so that its first tick is no first
  /// time. Changes no answer.
  void warm_up() const noexcept;

  /// Goes on from where another touch of the same surfaces stands, which is of no use afterwards: with its
  /// velocity estimate and last position, its contact method's place where method and normals are the same,
  /// its walls with their frames, their friction where the law is the same (a stick goes on, to its new
  /// limit; another law begins with the contact as if it had only now been touched), and its random stream.
  /// noexcept, allocates nothing.
  void take_over(Touch& before) noexcept;

  /// Forgets the contact and the last position, as before the first tick.
  void reset() noexcept;

 private:
  /// What the walls do together, in W.
  struct Forces {
    double pushed_n = 0;  ///< the sum of the normal forces' sizes
    Vec3 normal_W_n = Vec3::Zero(), slip_W_n = Vec3::Zero(), stick_W_n = Vec3::Zero();
    Vec3 slip_W_n_m = Vec3::Zero(), stick_W_n_m = Vec3::Zero();  ///< about the finger's centre
    bool any_slips = false;
  };

  SkinMotion skin_motion(const FingerSample& sample) noexcept;
  void answer(const Contact& contact, const FingerSample& sample, const SkinMotion& skin,
              TickRecord& record) noexcept;
  /// Gives each wall its normal force. @returns their sum [N]
  double push(const Vec3& velocity_W) noexcept;
  double press(double measured_n, double model_n) noexcept;
  Forces forces(const SkinMotion& skin, const FingerStand& finger, double pushed_n,
                TickRecord& record) noexcept;
  /// One wall's friction law, and the stick centre that it leaves.
  Friction rub(const Wall& wall, double share_of_push, double inclination_rad, const SkinMotion& skin,
               const FingerStand& finger, WallMemory& memory) noexcept;
  void vibrate(Forces& forces) noexcept;
  void release() noexcept;

  const Surface& surface_of(const Wall& wall) const noexcept {
    return world_->surfaces[static_cast<std::size_t>(wall.surface)];
  }

  std::shared_ptr<const World> world_;
  std::shared_ptr<const FrictionLaw> law_;
  Normals normals_;
  double radius_m_;
  double dt_s_;

  const ContactMethodEntry* method_row_;
  const LawEntry* law_row_;
  std::unique_ptr<ContactMethod> method_;
  VelocityEstimator velocity_;
  bool has_last_ = false;
  Vec3 last_W_ = Vec3::Zero();  ///< Q at the last tick
  FingerSample last_lay_;       ///< how the finger lay then; of a finger with a radius
  LastInclination inclination_;
  Walls walls_;  ///< of this tick
  WallMemories memories_;
  FacetsAtHand facets_;  ///< that stick centres came to lie on last
  long stick_centre_looks_ = StickCentre::servo_looks;

  bool unplaced_ = false;  // the last tick found no place where the finger fits

  /// Only where the scene asks for it: else no random number is drawn.
  std::optional<SlipVibration> vibration_;
  double vibration_amplitude_ = 0, vibration_normal_amplitude_ = 0;
};

}  // namespace fingerpad
