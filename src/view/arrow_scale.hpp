#pragma once

#include <span>
#include <vector>

#include "touch/tick_record.hpp"

namespace fingerpad {

/// The force for which force arrows have their full length. A spike makes them shorter while it is there;
/// then the scale comes back within seconds, down to what is usual, so that a blow does not leave the rest of
/// a touch with arrows too short to see.
class ArrowScale {
 public:
  /// @param rows  of the whole touch, where it is known; else it goes by what it is shown
  explicit ArrowScale(std::span<const TickRecord> rows);

  /// The moment shown, in any order for a known touch; later times come later in a live one.
  void see(const TickRecord& row) noexcept;
  /// > 0
  double force_n() const noexcept { return force_n_; }

 private:
  std::span<const TickRecord> rows_;
  std::vector<double> scale_n_;  ///< one a row of a known touch
  double usual_n_ = 1.5;         ///< of a live touch: what a person presses with, and a half
  double force_n_ = 1.5;
  double last_s_ = 0;
};

}  // namespace fingerpad
