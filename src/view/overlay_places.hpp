#pragma once

#include <optional>
#include <vector>

#include "view/layout.hpp"

namespace fingerpad {

enum class Corner { top_left, top_right, bottom_left, bottom_right };

/// A box that lies over the scene: how large it is, and which corners it likes, best first.
struct Placed {
  double width = 0, height = 0;  ///< [px]; 0: not there
  std::vector<Corner> liked;
};

/// Finds corners of the scene for the boxes over it, so that none hides the contact and none lies over
/// another. A box stays where it was until the contact is near it: a finger that goes along a border makes
/// nothing jump to and fro.
class OverlayPlaces {
 public:
  /// Boxes in order of rank; one that fits nowhere is left out (empty box).
  /// @param contact_px  what must stay in sight; none: nothing
  /// @param taken       boxes that stand already
  /// @param tips_px     what stays in sight where there is another corner for the box: ends of arrows
  std::vector<Box> place(const Layout& layout, const std::vector<Placed>& boxes,
                         const std::optional<Vec2>& contact_px, const std::vector<Box>& taken = {},
                         const std::vector<Vec2>& tips_px = {});

 private:
  template <class IsFree>
  Box choose(const Layout& layout, const Placed& box, std::optional<Corner>& before, const IsFree& is_free);

  std::vector<std::optional<Corner>> before_;
};

/// The middle of the line that tells of marks, which lies over none of them and over no box: above their
/// middle, else below it or beside it, else where there is room nearest to it, else above all.
/// @param marks_px  at least one
/// @param taken     boxes that stand already
Vec2 marks_words_place(const std::vector<Vec2>& marks_px, double width_px, const Layout& layout,
                       const std::vector<Box>& taken = {});

/// Room for words in the middle of the scene, clear of all boxes, and of a finger where that is possible:
/// usually above the scene's foot, else above that, else below a box. Where a box stands in the middle the
/// words stand beside it.
/// @param finger_px  none: the usual place
/// @param taken      boxes that stand already
/// @returns none where words of this size have no room
std::optional<Box> words_place(const Layout& layout, const Vec2& size_px,
                               const std::optional<Vec2>& finger_px, const std::vector<Box>& taken = {});

}  // namespace fingerpad
