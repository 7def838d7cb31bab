#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fingerpad/types.hpp"

namespace fingerpad {

/// Up to two places that somebody marked on the parts, and their distance.
class PlaceMarks {
 public:
  /// A third place begins anew; none takes the marks away.
  /// @returns whether there is a place
  template <class Hit>
  bool mark(const std::optional<Hit>& hit) {
    if (places_W_.size() == 2 || !hit) places_W_.clear();
    if (hit) places_W_.push_back(hit->point_W);
    return hit.has_value();
  }

  const std::vector<Vec3>& places_W() const { return places_W_; }

  /// Where the one is, or how far the two are apart; empty without any.
  std::string words() const;

 private:
  std::vector<Vec3> places_W_;
};

}  // namespace fingerpad
