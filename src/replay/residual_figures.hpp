#pragma once

#include <array>
#include <cstddef>

#include "touch/tick_record.hpp"

namespace fingerpad {

/// How a model's force and the one that was measured at the same ticks differ: by how much, by a constant (a
/// sensor that was not tared), and in time (a recorder that is late). Gathered tick by tick, in memory of one
/// size.
class ResidualFigures {
 public:
  /// Fewer ticks without contact say nothing of a sensor's zero.
  static constexpr long least_free_ticks = 20;

  /// @pre record.residual_W_n is finite; records come in the order of their time, evenly apart
  void observe(const TickRecord& record) noexcept;

  /// Root mean square of the residual [N]; nan where nothing was compared.
  double rms_n() const noexcept;
  /// How many times as hard as the model's the measured force presses along the normal, on average in
  /// contact: below 0 the other way. nan where nothing was compared, and where the model hardly presses.
  double scale() const noexcept;
  /// Length of the mean residual [N]: over the ticks without contact, where the model's force is zero and the
  /// measured one should be, else, where there are hardly any, over all; nan where nothing was compared.
  double bias_n() const noexcept;
  /// How much later than the model's the measured force comes [s], below 0 where it comes earlier: the shift
  /// at which they are correlated most. 0 where no shift leaves clearly less unexplained than none; nan
  /// where that cannot be told: in a short run, and where more than 50 ms (or
  /// ticks, where those are longer) would fit better still.
  double lag_s() const noexcept;

 private:
  static constexpr int most_steps = 50;  ///< of a shift, to either side
  static constexpr double least_step_s = 1e-3;
  static constexpr std::size_t ring_size = 64;
  static_assert(ring_size > most_steps);

  /// The two forces at one shift: what their correlation takes.
  struct Shift {
    Vec3 model_n = Vec3::Zero(), measured_n = Vec3::Zero();
    double model_n2 = 0, measured_n2 = 0, product_n2 = 0;
    long count = 0;
    void add(const Vec3& model, const Vec3& measured) noexcept;
    /// The share of the measured force's variance that the model's does not explain, whatever its strength.
    double unexplained() const noexcept;
  };

  void compare_shifts(const Vec3& model_n, const Vec3& measured_n) noexcept;
  const Shift& shifted(int steps) const noexcept {
    const int place = most_steps + steps;
    return shifts_[static_cast<std::size_t>(place)];
  }

  long ticks_ = 0, free_ticks_ = 0;
  double squares_n2_ = 0;
  double pressed_n_ = 0, measured_press_n_ = 0;  ///< sums over the ticks in contact
  Vec3 sum_n_ = Vec3::Zero(), free_sum_n_ = Vec3::Zero();
  // Shifts are tried at every so manieth tick, a millisecond apart or a tick.
  double first_s_ = 0, step_s_ = 0;
  long stride_ = 1;
  std::size_t steps_ = 0;
  std::array<Vec3, ring_size> model_n_, measured_n_;
  std::array<Shift, 2 * most_steps + 1> shifts_;  ///< by how many steps the measured force is later
};

}  // namespace fingerpad
