#pragma once

#include "replay/pop_throughs.hpp"
#include "replay/residual_figures.hpp"

namespace fingerpad {

/// What is counted, summed up and greatest in a run: what the figures of its summary are made of. Each of
/// them says in its row (summary_column.cpp) how.
struct RunTotals {
  long ticks = 0, contact_ticks = 0, stick_ticks = 0, slip_ticks = 0, ruptures = 0;
  long pressed_slip_ticks = 0;  ///< in slip under a normal force
  long teeth = 0, coarse_teeth = 0;
  long remedied_ticks = 0, inside_starts = 0, nonfinite_ticks = 0, unsettled_ticks = 0;
  double max_depth_m = 0, max_normal_n = 0, max_friction_n = 0, max_mu = 0;
  double sum_normal_n = 0;  ///< over the ticks in contact
  double sum_slip_mu = 0;   ///< over the pressed ticks in slip
  double friction_work_j = 0, energy_made_j = 0;
  double max_step_n = 0, max_step_n_per_m = 0;
  PopThroughs pop_throughs;
  ResidualFigures residual;
};

}  // namespace fingerpad
