#pragma once

#include <string>
#include <vector>

#include "friction/law_table.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

/// A block on a plane, pulled by a spring whose far end moves at constant speed: the textbook stick-slip
/// (SCIENCE 3). The hand is the block: its mass, its damper, its spring.
struct PulledBlock {
  double mass_kg = 1;
  double spring_n_per_m = 20;
  double damping_n_s_per_m = 2;
  double speed_m_per_s = 0.02;
  double normal_n = 10;
  double mu_static = 0.3, mu_dynamic = 0.2;

  double static_n() const { return mu_static * normal_n; }
  double dynamic_n() const { return mu_dynamic * normal_n; }
};

/// What repeats in stick-slip.
struct StickSlipCycle {
  double period_s = 0;
  double peak_n = 0;   ///< pull of the spring at which the block breaks away
  double least_n = 0;  ///< pull to which it falls
  int cycles = 0;      ///< whole ones seen; fewer than one: no stick-slip, and the rest is nan
};

/// Exact cycle where stick is rigid and slip is Coulomb's: slip solves m x'' + b x' + k (x - V t) + F_d = 0
/// from rest at a pull of F_s until x' = 0; then stick until the pull is F_s again.
/// @pre the slip is underdamped and comes to rest (F_s - F_d > b V)
StickSlipCycle rigid_cycle(const PulledBlock& block);

/// The spring's pull on the block, tick by tick, under a law in the closed loop (true position, no quantum).
std::vector<double> pull_of_block(const PulledBlock& block, const std::string& law,
                                  const LawSettings& settings, double rate_hz, double seconds);

/// The mean cycle of a pull sampled at a rate: a tooth ends where the pull has fallen by half of `tooth_n`;
/// the first tooth is left out.
StickSlipCycle cycle_of(const std::vector<double>& pull_n, double rate_hz, double tooth_n);

/// A law's settings for this block: a stick of 500 1/m (5000 N/m at 10 N) and v_min 0.002 m/s; bristles of
/// 5e5 N/m, damped at 0.7 of critical, with a Stribeck speed of 0.001 m/s; a viscous slip of 2 N s/m.
LawSettings block_settings(const std::string& law);

/// The exact cycle to hold a law against: rigid_cycle; where slip is viscous, that of the damper alone.
StickSlipCycle reference_cycle(const PulledBlock& block, const std::string& law);

/// The block's coefficients of friction as given to a law: contact-area's hold at 1 N and fall with the load,
/// so they are raised to give F_s and F_d at the block's.
PulledBlock block_for(const PulledBlock& block, const std::string& law);

/// Whether a law has a static limit above its sliding force, and so can stick and slip.
bool has_static_limit(const std::string& law);

}  // namespace fingerpad
