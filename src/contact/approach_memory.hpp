#pragma once

#include <array>
#include <new>

#include "contact/triangle_approach.hpp"

namespace fingerpad {

/// The last answers to how a place stands before a triangle: a proxy that lies on an edge asks the same
/// several times a tick. For speed alone; for one thread at a time.
class ApproachMemory {
 public:
  /// @param tell  the answer to a question that is not kept
  /// @returns good until the next question
  template <class Tell>
  const TriangleApproach& find_or_keep(int surface, int triangle, const Vec3& place_O, Tell tell) noexcept {
    for (const Told& told : told_) {
      if (told.triangle == triangle && told.surface == surface && told.place_O == place_O)
        return told.approach;
    }
    Told& told = told_[next_];
    next_ = (next_ + 1) % told_.size();
    told.surface = surface;
    told.triangle = triangle;
    told.place_O = place_O;
    new (&told.approach) TriangleApproach(tell());  // no copy
    return told.approach;
  }

 private:
  struct Told {
    int surface = -1, triangle = -1;
    Vec3 place_O = Vec3::Zero();
    TriangleApproach approach;
  };

  std::array<Told, 4> told_;
  std::size_t next_ = 0;  // which of them is told anew next
};

}  // namespace fingerpad
