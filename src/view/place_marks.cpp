#include "view/place_marks.hpp"

#include <fmt/format.h>

namespace fingerpad {

std::string PlaceMarks::words() const {
  if (places_W_.empty()) return "";
  const Vec3 last_mm = 1e3 * places_W_.back();
  if (places_W_.size() < 2)
    return fmt::format("x {:.3f}, y {:.3f}, z {:.3f} mm", last_mm.x(), last_mm.y(), last_mm.z());
  return fmt::format("{:.3f} mm", 1e3 * (places_W_[1] - places_W_[0]).norm());
}

}  // namespace fingerpad
