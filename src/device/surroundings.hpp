#pragma once

#include <memory>
#include <vector>

#include "contact/closest_memory.hpp"
#include "touch/contact_choice.hpp"
#include "touch/parts_ball.hpp"
#include "touch/world.hpp"

namespace fingerpad {

struct Scene;

/// How much room the finger has at a place.
struct Clearance {
  double free_m = 0;           ///< so far it can go any way and touches nothing; no more than was asked for
  Vec3 away_W = Vec3::Zero();  ///< unit, from what is nearest; zero where nothing is within reach
};

/// A ball around all parts, and one of usual size where there are none.
Ball ball_around(const World& world);

/// What stands around a finger, for one who moves it. A ball that never goes farther than it is free
/// touches nothing, whatever the contact method.
class Surroundings {
 public:
  Surroundings(std::shared_ptr<const World> world, const Scene& scene);
  /// Around a finger of another radius than the scene's.
  Surroundings(std::shared_ptr<const World> world, const Scene& scene, double finger_radius_m);

  /// The room at a place.
  /// @param reach_m  look no farther. noexcept, allocates nothing.
  Clearance at(const Vec3& p_W, double reach_m) noexcept;

  /// The same surfaces, touched in another way or with other properties; they outlive this.
  void change(const World& world, const ContactChoice& choice) noexcept;
  const SurfaceProperties& properties(int surface) const noexcept {
    return world_->surfaces[static_cast<std::size_t>(surface)].properties;
  }
  /// The greatest force that a step of so many metres can add on a wall, per metre, over all surfaces.
  double stiffest_n_per_m(double dt_s) const noexcept;

  /// A ball around all parts.
  const Vec3& middle_W() const noexcept { return parts_.centre_W; }
  double radius_m() const noexcept { return parts_.radius_m; }
  double finger_radius_m() const noexcept { return finger_radius_m_; }

 private:
  void touch_by(const ContactChoice& choice) noexcept;

  std::shared_ptr<const World> kept_;
  const World* world_;  ///< kept_, until its surfaces have other properties
  Normals normals_;
  bool sided_ = false;  ///< the contact method takes all that is behind a facet for the part's inside
  double finger_radius_m_;
  std::vector<ClosestMemory> memories_;
  Ball parts_;
};

}  // namespace fingerpad
