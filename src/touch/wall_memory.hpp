#pragma once

#include "friction/law.hpp"
#include "touch/stick_centre.hpp"
#include "touch/wall.hpp"

namespace fingerpad {

/// What is remembered of one wall for as long as it holds.
struct WallMemory {
  int surface = -1;
  Mat3 frame_WC = Mat3::Identity();  ///< Cx, Cy, and Cz the wall's normal; transported as that turns
  FrictionState friction;            ///< free: the wall has only now been touched
  StickCentre centre;
};

/// The memories of the walls that hold a finger, in the walls' order.
class WallMemories {
 public:
  void forget() noexcept { count_ = 0; }
  int count() const noexcept { return count_; }
  WallMemory& operator[](int i) noexcept { return memories_[static_cast<std::size_t>(i)]; }

  /// Hands each wall of this tick the memory of the wall of the last tick that it goes on from, its frame
  /// transported; one that begins is empty, its frame along the finger's direction.
  ///
  /// A wall goes on from the one of its surface whose normal is nearest, within 45 degrees; else from one of
  /// another surface that is flush with it, within 30 degrees. Where one wall follows one wall it goes on
  /// whatever the turn: the finger has gone over an edge without letting go.
  void follow(const Walls& walls, const Vec3& direction_W) noexcept;

 private:
  int predecessor(const Wall& wall, int walls_now) const noexcept;

  std::array<WallMemory, 3> memories_, before_;
  int count_ = 0;
};

}  // namespace fingerpad
