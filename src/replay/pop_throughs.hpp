#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "contact/proxy.hpp"
#include "touch/tick_record.hpp"
#include "touch/world.hpp"

namespace fingerpad {

/// Counts the ticks on which a surface stops holding the finger on the side that it came from. From the last
/// tick to this one
///   - the finger's way crosses a wall, but there is contact at neither end: nothing was felt at all; or
///   - a first touch pushes it on in the direction of its motion (within 60 degrees), where the surface would
///     not have let it come to; or
///   - in unbroken contact the normal turns by more than 120 degrees although the finger cannot have left one
///     surface for another: it moved by less than what pushes it out (depth times normal) changed by, which
///     no place outside of what is convex does, such as a narrow groove of two planes; or one wall of a part
///     holds it at either end and its way stays inside that part; or
///   - contact is lost although it moved by less than a third of its depth (a proxy lets go within a motion).
/// The last two do not count of a proxy on its way to a place that the ticks before had not the time to find.
/// The same for every contact method: all is seen from the finger's way, the parts and what was felt.
///
/// What crosses a wall and what only grazes a convex corner, whose faces are one side, is told by a guide: a
/// proxy of the finger's size, with facets as they are, that is taken along the straight way from outside in
/// small steps. If it is still held back at the way's end, or pushed elsewhere than the finger, this has got
/// to where a surface would not have let it. So a plate counts however thin it is and however near to its
/// rim, unless the way leads out over the rim, and so does a hole in it that is smaller than the finger; and
/// a blade clipped near its edge counts where the finger stops so close behind it that it would still be
/// held.
class PopThroughs {
 public:
  /// Without a world, ways are not held against parts.
  PopThroughs() = default;
  /// @param radius_m  the finger's
  PopThroughs(std::shared_ptr<const World> world, double radius_m);

  /// noexcept; one segment query a part on a tick that is free like the last; where a part is in the way
  /// then, and of a first touch that pushes on, the guide's steps (the first time, memory for it).
  void observe(const TickRecord& record) noexcept;
  long count() const noexcept { return count_; }

 private:
  /// What the next tick asks of the last one: a whole record is far longer to copy.
  struct Seen {
    Vec3 p_WQ = Vec3::Zero(), contact_W = Vec3::Zero(), normal_W = Vec3::Zero();
    double depth_m = 0;
    Phase phase = Phase::free;
    bool is_catching_up = false;  ///< a proxy that this tick, or the one before, left unsettled
    bool by_one_wall = false;     ///< of a part

    Vec3 push_m() const noexcept { return depth_m * normal_W; }
    bool is_inside_one_wall() const noexcept { return by_one_wall && (p_WQ - contact_W).dot(normal_W) < 0; }
  };

  /// From which sides a part is a wall: one with a border is one from behind too. Looked up when first asked
  /// for, which takes a look at every triangle.
  enum class Sides : char { unknown, outside, both };

  bool is_open(std::size_t surface) noexcept;
  bool way_enters_a_part(const Vec3& to_W) noexcept;
  const ProxyContact* guided(const Vec3& to_W) noexcept;
  bool is_held_back(const Vec3& to_W) noexcept;
  bool is_led_round(const Seen& now) noexcept;
  bool popped(const Seen& now) noexcept;
  bool is_by_one_wall(const TickRecord& record) const noexcept;

  std::shared_ptr<const World> world_;
  double radius_m_ = 0;
  std::vector<Sides> sides_;  ///< per surface
  std::optional<Proxy> guide_;
  Seen last_;
  bool any_ = false, was_unsettled_ = false;
  long count_ = 0;
};

}  // namespace fingerpad
