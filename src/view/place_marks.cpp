#include "view/place_marks.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"

namespace fingerpad {

std::string PlaceMarks::words() const {
  if (places_W_.empty()) return "";
  const Vec3 last_mm = 1e3 * places_W_.back();
  if (places_W_.size() < 2)
    return fmt::format("x {}, y {}, z {} mm", fixed_text(last_mm.x(), 3), fixed_text(last_mm.y(), 3),
                       fixed_text(last_mm.z(), 3));
  return fmt::format("{:.3f} mm", 1e3 * (places_W_[1] - places_W_[0]).norm());
}

}  // namespace fingerpad
