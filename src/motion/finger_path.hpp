#pragma once

#include <memory>
#include <variant>

#include "fingerpad/finger_sample.hpp"
#include "motion/motion.hpp"
#include "motion/scripted_motion.hpp"

namespace fingerpad {

/// More ticks are not run: at 1 kHz they last 24 days and fill 400 GB of trace.
inline constexpr double most_ticks = 2147483648.0;

/// The ticks of a motion that lasts so long. Throws Error (refused) for more than are run.
long tick_count(double duration_s, double rate_hz);

/// A motion seen at the tick rate: tick k is at t0 + k/rate, k = 0 .. floor((t_end - t0) rate + 1e-6);
/// recorded positions, forces and velocities are interpolated linearly, directions linearly and made unit
/// again, attitudes along the shortest turn. Where a motion has attitudes and no directions, the scene's
/// direction turns with the finger.
class FingerPath {
 public:
  /// @param direction_W  unit; used where the motion has no directions
  /// Throws Error (refused) for more than 2^31 ticks.
  FingerPath(Motion motion, double rate_hz, const Vec3& direction_W);
  FingerPath(const ScriptedMotion& motion, double rate_hz, const Vec3& direction_W);

  /// The same motion at another rate. Throws as above.
  FingerPath with_rate(double rate_hz) const;

  long tick_count() const noexcept { return tick_count_; }
  double rate_hz() const noexcept { return rate_hz_; }
  /// Of the first tick, and of the motion's end.
  double start_s() const noexcept { return t0_s_; }
  double end_s() const noexcept { return end_s_; }
  /// That its recording takes, shared by its copies.
  std::size_t memory_bytes() const noexcept;
  /// Whether the finger's place is the same at every tick, to the bit; no where only looking at each tells.
  bool goes_as(const FingerPath& other) const noexcept;
  /// No coordinate of the path is larger [m].
  double farthest_m() const noexcept;
  /// Whether the finger is turned otherwise at some ticks than at others.
  bool turns() const noexcept;
  /// Whether the positions are those of a hand's encoders, with what the hand pushed with.
  bool was_in_hand() const noexcept;
  /// Whether it knows the finger's attitude, and its velocity better than by differences of positions.
  bool has_attitudes() const noexcept;
  bool has_velocity() const noexcept;
  /// @pre 0 <= k < tick_count()
  FingerSample at(long k) const noexcept;
  /// Between the ticks too: where the finger is at this time of the motion's own clock.
  FingerSample at_time(double t_s) const noexcept;
  /// Whether the force on the finger was measured, and what it was at tick k.
  bool has_measured_force() const noexcept;
  /// @pre has_measured_force(), 0 <= k < tick_count()
  Vec3 measured_force_W_n(long k) const noexcept;

  /// Null for a motion made from a formula.
  const Motion* recording() const noexcept;

 private:
  std::variant<std::shared_ptr<const Motion>, ScriptedMotion> motion_;  // copies of a path share a recording
  double rate_hz_;
  Vec3 direction_W_;
  double t0_s_ = 0, end_s_ = 0;
  double samples_per_s_ = 0;  // of a recording, on average
  long tick_count_ = 0;
};

}  // namespace fingerpad
