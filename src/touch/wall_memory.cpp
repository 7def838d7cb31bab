#include "touch/wall_memory.hpp"

#include "base/tangent_frame.hpp"

namespace fingerpad {

int WallMemories::predecessor(const Wall& wall, int walls_now) const noexcept {
  constexpr double cos_goes_on = 0.7071067811865476, cos_flush = 0.8660254037844387;
  int same = -1, flush = -1;
  double same_cosine = cos_goes_on, flush_cosine = cos_flush;
  for (int i = 0; i < count_; ++i) {
    const WallMemory& memory = memories_[static_cast<std::size_t>(i)];
    const double cosine = memory.frame_WC.col(2).dot(wall.normal_W);
    if (memory.surface == wall.surface && cosine >= same_cosine) {
      same = i;
      same_cosine = cosine;
    } else if (memory.surface != wall.surface && cosine >= flush_cosine) {
      flush = i;
      flush_cosine = cosine;
    }
  }
  if (same >= 0) return same;
  if (flush >= 0) return flush;
  return walls_now == 1 && count_ == 1 ? 0 : -1;
}

void WallMemories::follow(const Walls& walls, const Vec3& direction_W) noexcept {
  if (walls.count == 1 && count_ == 1) {  // mostly: nothing to choose, nothing to move
    memories_[0].surface = walls.walls[0].surface;
    memories_[0].frame_WC = transported(memories_[0].frame_WC, walls.walls[0].normal_W);
    return;
  }
  std::array<int, 3> from{};
  for (int i = 0; i < walls.count; ++i)
    from[static_cast<std::size_t>(i)] = predecessor(walls.walls[static_cast<std::size_t>(i)], walls.count);
  before_ = memories_;
  count_ = walls.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
    const Wall& wall = walls.walls[i];
    WallMemory& memory = memories_[i];
    if (from[i] >= 0) {
      memory = before_[static_cast<std::size_t>(from[i])];
      memory.frame_WC = transported(memory.frame_WC, wall.normal_W);
    } else {
      memory = {};
      memory.frame_WC = tangent_frame(wall.normal_W, direction_W);
    }
    memory.surface = wall.surface;
  }
}

}  // namespace fingerpad
