#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/chart.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

/// What a history is drawn over. None of them ever goes back.
enum class Over {
  time,    ///< [s]
  travel,  ///< how far the finger has gone along the surface: its tangential speed, summed up [mm]
  turn     ///< by how much the surface's normal has turned under the finger, summed up [deg]
};

/// Of each tick.
std::vector<double> abscissa(std::span<const TickRecord> rows, Over over);

/// "travel along the surface [mm]".
std::string_view abscissa_label(Over over) noexcept;

/// What travel or turn of a run that lacks ticks is not.
/// @pre over is not time
std::string_view shortened_words(Over over) noexcept;

/// Throws Error (refused, at `where`) where a run does not go on over travel or turn, but for rounding
/// (least_span).
void refuse_standstill(const std::vector<double>& x, Over over, const std::string& where);

/// Draws a stacked chart, whose curves have a value for each tick, over something else than time.
void put_over(Chart& chart, const std::vector<double>& x, std::string_view label);

}  // namespace fingerpad
