#pragma once

#include <vector>

#include "creep_block.hpp"
#include "study/pulled_block.hpp"

namespace fingerpad::bench {

/// A push below the limit of friction, held for 10 s: the block should stand still.
struct HeldPush {
  double share = 0;                 ///< of mu n
  double creep_m_per_s = 0;         ///< mean over the last 2 s of the hold; 0 where only rounding moves it
  bool gives_way = false;           ///< a push of 1.2 mu n after the hold moves the block
  std::vector<double> t_s;          ///< from the moment at which the push is full
  std::vector<double> travelled_m;  ///< since before the push
};
HeldPush hold(const Program& program, double share);

/// Pulled blocks whose period is known exactly, without a damper and with one.
inline constexpr PulledBlock undamped_block{.damping_n_s_per_m = 0, .speed_m_per_s = 0.05};
inline constexpr PulledBlock damped_block{.damping_n_s_per_m = 2, .speed_m_per_s = 0.02};

/// The block pulled by a spring whose far end moves on at constant speed.
/// @param rate_hz  steps a second
/// @returns        fewer than one cycle where it does not stick and slip
StickSlipCycle pull(const Program& program, const PulledBlock& block, double rate_hz);

/// Everything measured of a program.
struct CreepFindings {
  Program program;
  std::vector<HeldPush> held;       ///< a push each
  StickSlipCycle undamped, damped;  ///< of the pulled block, without and with its damper
  double step_ns = 0;
};

/// Time of a step of each program under 0.9 mu n [ns]: all in turn, the median of many rounds.
std::vector<double> step_times_ns(const std::vector<Program>& programs);

}  // namespace fingerpad::bench
