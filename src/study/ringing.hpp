#pragma once

namespace fingerpad {

/// Watches a signal of known length and says whether its ringing dies out: its spread about its own mean in
/// the last fifth of the run against that in the fifth around the middle.
class Ringing {
 public:
  explicit Ringing(long ticks) : ticks_(ticks) {}

  void observe(double value) noexcept;
  bool is_complete() const noexcept { return seen_ >= ticks_; }
  /// @pre is_complete()
  bool dies_out() const noexcept;
  double final_range() const noexcept { return late_.max - late_.min; }

 private:
  struct Window {
    long count = 0;
    double mean = 0, square = 0;  // Welford's running mean and sum of squared deviations
    double min = 0, max = 0;
    void take(double value) noexcept;
    double spread() const noexcept;
  };

  long ticks_, seen_ = 0;
  Window early_, middle_, late_;
};

}  // namespace fingerpad
