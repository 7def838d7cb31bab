#pragma once

#include "friction/law_table.hpp"

namespace fingerpad {

/// Parameters that several laws share.
inline constexpr LawParameter v_min_parameter{
    "v_min_m_per_s", 0.1, 0, true,
    "speed at and below which slip gives way to stick [m/s]; the paper's is 0.1"};
inline constexpr LawParameter stiffness_per_newton_parameter{
    "stick_stiffness_per_m", 1000, 0, false,
    "k_f: tangential stiffness in stick per newton of normal force [1/m]; assumed, unused with a profile"};
inline constexpr LawParameter fixed_stiffness_parameter{
    "stick_stiffness_n_per_m", 1000, 0, false,
    "tangential stiffness in stick, whatever the load [N/m]; 1000 agrees with stick_stiffness_per_m at 1 N"};

inline constexpr LawParameter device_damping_parameter{
    "device_damping_n_s_per_m", 0.5, 0, true,
    "b: damping of hand and device, which holds a stick spring of up to 2 b/T; for a remedy [N s/m]"};

/// The choices of laws that rupture; of those that keep a StickRule.
inline constexpr std::string_view rupture_choices[] = {"events"};
inline constexpr std::string_view stick_rule_choices[] = {"restick", "remedy", "events"};

/// A parameter's value, kept within what the laws can compute with.
double bounded_number(const LawSettings& settings, const LawParameter& parameter);

struct StickRule;
/// The scene's rule and remedy; its law must have v_min_parameter and device_damping_parameter.
StickRule stick_rule_of(const LawSettings& settings);

/// v_min: the scene's key if given, else the profile's, else the paper's.
double v_min_m_per_s(const LawSettings& settings);

}  // namespace fingerpad
