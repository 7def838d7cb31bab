#pragma once

#include <optional>

#include "contact/looks.hpp"
#include "device/pointer_path.hpp"
#include "device/surroundings.hpp"

namespace fingerpad {

/// Where a finger can be that is wanted at a spot. Where it has room there, that is the place that the
/// pointer asks for. Into a hole, a slot or a corner that is too narrow it cannot go; then it is where a
/// finger that comes down the eye's line to the spot is stopped: on the rim that is seen before the spot. One
/// that hovers is wanted where the pointer says, if a way leads there.
class OpenPlace {
 public:
  /// @param world   outlives this
  /// @param around  of that world; kept by reference
  /// @param soft_m  what a flight keeps from the parts
  OpenPlace(const World& world, const Surroundings& around, double soft_m) noexcept
      : world_(world), around_(around), soft_m_(soft_m) {}

  /// For this aim from now on. Looks around where it is another than the last, as far as a tick's
  /// looks go; where these have ended too early, the same aim is looked at further in the next ticks.
  /// noexcept, allocates nothing.
  void aim(const PointerAim& aim) noexcept;

  /// No way has led to the place that was asked for last. From the next aim() on it is as if the finger had
  /// no room there, until the pointer goes on.
  void give_up() noexcept;

  /// Whether the finger has room at the place that was asked for; one that hovers always, unless no way leads
  /// there.
  bool has_room() const noexcept { return has_room_; }
  const Vec3& place_W() const noexcept { return place_W_; }
  /// Where a finger that comes down is to press: at the place; where it has gone by what was to stop it,
  /// which is hardly in its way, beside itself on the way on to the spot.
  Vec3 place_below_W(const Vec3& finger_W) const noexcept;
  /// Along which it comes down there, unit; the eye's line where nothing is pressed.
  const Vec3& down_W() const noexcept { return down_W_; }
  /// How much nearer to what the pointer asks for a finger would be at this place [m].
  double gain_m(const Vec3& finger_W) const noexcept;

 private:
  void look() noexcept;
  bool is_given_up() const noexcept;
  bool seems_free(double least_m, Looks& looks) const noexcept;
  Vec3 stopped_W(Looks& looks) noexcept;
  void look_on() noexcept;

  const World& world_;
  const Surroundings& around_;
  double soft_m_;
  PointerAim aim_;
  bool has_aim_ = false, has_looked_ = false, has_room_ = true;
  Vec3 place_W_ = Vec3::Zero(), down_W_ = -Vec3::UnitZ();
  std::optional<PointerAim> given_up_;  ///< to this, and what is beside it, leads no way
  bool has_stopped_ = false;
  Vec3 stopped_at_W_, stopped_for_W_, stopped_by_W_;  ///< the last: where, for which spot, to which eye
  bool may_be_lower_ = false;                         ///< a tick's looks may have ended before it was stopped
};

}  // namespace fingerpad
