#include "device/pointer_lift.hpp"

#include <algorithm>

#include "device/pointer_limits.hpp"

namespace fingerpad {

using namespace pointer_limits;

void PointerLift::begin(const TickRecord& touched, double pressed_most_n) noexcept {
  // On the way out another wall may come to hold it, whose force counts too; no more than a press may have.
  constexpr double another_wall = 1.2;
  ticks_ = 0;
  most_n_ = std::min(another_wall * touched.normal_force_n, std::max(touched.normal_force_n, pressed_most_n));
}

bool PointerLift::is_over() const noexcept {
  return flight_.free_m() > 0.5 * flight_.soft_m() || ticks_ > most_lift_ticks;
}

void PointerLift::go_on(const TickRecord& touched, double fastest_m, double dt_s) noexcept {
  ++ticks_;
  if (touched.walls > 0) {
    // It may go up so for a while; between two walls it would without end.
    constexpr double eases = 0.9;
    const double now_n = touched.normal_force_n;
    const double most_n = ticks_ > most_lift_ticks ? eases * now_n : std::max(now_n, most_n_);
    if (steps_.go_shorter(fastest_m * out_W_, most_n, dt_s)) return;
    return steps_.give_way(touched, std::min(most_n, now_n), most_n, fastest_m, dt_s);
  }
  const Clearance clearance = around_.at(flight_.place_W(), flight_.soft_m());
  const double free_m = std::max(0.0, clearance.free_m);
  flight_.note_free(free_m);
  // Beside what was touched another wall may stand.
  const Vec3 way_W = out_W_ + clearance.away_W;
  const Vec3 step_W = std::min(lifting_m_per_s * dt_s, 0.5 * free_m + 1e-3 * flight_.soft_m()) * way_W /
                      std::max(1.0, way_W.norm());
  if (!steps_.go_shorter(step_W, 0, dt_s)) steps_.go(Vec3::Zero(), any_force_n, dt_s);
}

}  // namespace fingerpad
