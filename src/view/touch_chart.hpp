#pragma once

#include <span>
#include <vector>

#include "base/chart.hpp"
#include "view/mu_history.hpp"
#include "view/touch_series.hpp"
#include "view/view_input.hpp"

namespace fingerpad {

/// What a chart shows beside its rows: the levels of a scene, and whether ticks are missing between rows, so
/// that none shows where slip ended.
struct TouchLevels {
  std::vector<MuFrom> mu;    ///< steps where it was changed, or another surface is touched; empty: none
  double v_min_m_per_s = 0;  ///< 0: none
  bool thinned = false;
  /// Speeds are those over so long (net_speed), so that no encoder's steps show; 0: over a tick.
  double speed_span_s = 0;
};

/// Where the scene and its world are known.
TouchLevels touch_levels(const ViewInput& input);

/// The paper's figure layout (figs. 2 and 12): position along the main direction (slip solid, stick dotted,
/// stick centre dashed), tangential speed, forces, and coefficient of friction over one time axis, with a
/// band of phases.
Chart touch_chart(std::span<const TickRecord> rows, const Vec3& direction_W, const TouchLevels& levels);

/// How often charts that run are drawn anew [s]. They need not follow each frame, of which they would take
/// half the time without a graphics card.
inline constexpr double live_chart_period_s = 0.12;

/// Over how long speeds are told while a finger is live, and where an encoder's steps would fill the panel
/// [s].
inline constexpr double net_speed_span_s = 0.02;

/// As touch_chart for a finger that goes anywhere: position as x, y and z, and speeds as net_speed.
Chart live_chart(std::span<const TickRecord> rows, const TouchLevels& levels);

/// Power spectral density of tangential and normal force (paper, fig. 11). No panels if the rows are too few
/// for one. A last row that comes sooner than the others' distance, as a thinned trace's, is left out.
Chart spectrum_chart(const TouchSeries& series);

}  // namespace fingerpad
