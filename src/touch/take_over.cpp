#include <utility>

#include "touch/touch.hpp"

namespace fingerpad {

void Touch::take_over(Touch& before) noexcept {
  velocity_ = before.velocity_;
  has_last_ = before.has_last_;
  last_W_ = before.last_W_;
  last_lay_ = before.last_lay_;
  // A proxy stands where it stood; another method, or other normals, finds its own place at its first tick.
  if (method_row_ == before.method_row_ && normals_ == before.normals_) {
    std::swap(method_, before.method_);
    unplaced_ = before.unplaced_;
  }
  stick_centre_looks_ = before.stick_centre_looks_;
  memories_ = before.memories_;
  // What one law remembers (a bristle's bend, a spring's stretch) means something else to another.
  if (law_row_ != before.law_row_) {
    for (int i = 0; i < memories_.count(); ++i) {
      memories_[i].friction = {};
      memories_[i].centre.forget();
    }
  }
  if (vibration_ && before.vibration_) vibration_ = before.vibration_;
}

}  // namespace fingerpad
