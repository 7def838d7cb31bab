#pragma once

#include "contact/proxy_state.hpp"
#include "contact/worst_wall.hpp"

namespace fingerpad {

class ProxySight;

/// How far a look at every surface has come.
struct LookRound {
  std::size_t part = 0;  ///< of the world's parts, the planes after all of them
  std::size_t next = 0;  ///< of its triangles, in the order in which they are looked at
  WorstWall worst;
  /// @param breach_m  a wall blocks where it is breached by more than this
  explicit LookRound(double breach_m) noexcept : worst{std::nullopt, -breach_m} {}
};

/// A proxy's step in the making. Dual active-set method: the wall that blocks the way most is added until
/// none blocks it. All walls have the start in front of them, so the way to the projection onto them crosses
/// nothing, whenever it is stopped. Where the looks are spent within, it waits here for the next tick's.
class StepMaking {
 public:
  /// From where the sight looks around.
  /// @param most_m  the step ends there at the latest
  /// @param bent_m  how far it may go where it goes on along walls that bend
  void begin(const ProxySight& sight, const Vec3& goal_O, double most_m, double bent_m) noexcept;
  /// A wall to begin with, seen from there.
  /// @pre fewer than three
  void add(const ProxyWall& wall) noexcept {
    step_.walls[static_cast<std::size_t>(step_.wall_count++)] = wall;
  }
  /// The same of a wall that likely holds: let go where the step leads nowhere and the ball is far from it.
  void guess(const ProxyWall& wall) noexcept {
    add(wall);
    is_guessed_ = true;
  }
  /// To its end, or to where the looks are spent.
  ProxyStep go_on(ProxySight& sight) noexcept;
  /// Whether it waits for the next tick's looks.
  bool is_underway() const noexcept { return is_amid_round_; }
  void drop() noexcept { is_amid_round_ = false; }

 private:
  bool project(ProxySight& sight) noexcept;
  void go_on_along_bend(ProxySight& sight) noexcept;
  bool leads_nowhere(const ProxySight& sight) const noexcept;
  bool let_go_of_far_walls(ProxySight& sight) noexcept;
  ProxyStep stuck() noexcept;
  ProxyStep waiting() const noexcept;

  Vec3 goal_ = Vec3::Zero();  ///< relative to the place looked around from
  double slack_m_ = 0, breach_m_ = 0, most_m_ = 0, bent_m_ = 0;
  ProxyStep step_;  ///< the way to the projection onto the walls found so far
  int pass_ = 0;    ///< in each a wall is added
  LookRound round_{0};
  bool is_amid_round_ = false;
  bool is_guessed_ = false;        ///< walls may be among them that were guessed
  std::optional<ProxyStep> held_;  ///< what the step was before far walls were let go
};

}  // namespace fingerpad
