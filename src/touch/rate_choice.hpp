#pragma once

#include <string>

namespace fingerpad {

class FingerPath;
struct Scene;

/// What `rate_hz = "auto"` chooses from, the lowest first [Hz].
inline constexpr double automatic_rates_hz[] = {250, 500, 1000, 2000, 4000, 10000};

/// A rate, and why.
struct RateChoice {
  double rate_hz = 1000;
  std::string reason;  ///< "rate_hz: 2000 Hz, the lowest ... (auto)"
};

/// The sawtooth that a slow finger draws with a scene's law on one of its surfaces.
struct Teeth {
  double height = 0;         ///< mu_s - mu_d; 0: the law or the scene has no teeth
  double mean = 0;           ///< (mu_s + mu_d)/2
  double rise_per_m = 0;     ///< by which the coefficient rises in stick, with the finger's travel
  double v_min_m_per_s = 0;  ///< above this it slips, without teeth; 0: the law knows no such speed
};

/// Mean square by which the coefficient is off that was given at the last tick and is held until the next,
/// where it rises by `rise` from tick to tick in teeth of this height: rise height/2 - rise^2/3, and
/// height^2/6 (two places of a sawtooth that have nothing to do with each other) where there is less than a
/// tick a tooth.
///
/// Derivation: after a while in which it would rise by d, a share 1 - d/h of all phases is off by d, and the
/// rest, which has broken away, by h - d: d (h - d) in the mean square. The while is even from 0 to the tick.
double held_teeth_square(double height, double rise) noexcept;

/// The teeth of the scene's surface that shows the highest, for their mean. Stiffnesses of a pad are those of
/// its short axis at 45 degrees; those that do not scale with the load are taken at 1 N.
Teeth teeth_of(const Scene& scene);

/// What a rate costs friction. Events are found between ticks, so that the teeth themselves are right at any
/// rate; what is left is what the ticks show of them, and turns of the motion within a tick.
struct ShownFriction {
  double held_share = 0;    ///< RMS error of a slow finger's coefficient held from tick to tick, of its mean
  double unseen_share = 0;  ///< of the teeth: those that last under two ticks, which no sampling shows
  double turn_share = 0;    ///< RMS error of friction's direction, of friction
};

/// Over the ticks in which the finger goes; of slow ones, not faster than v_min, the first two.
///   held_share   = sqrt(mean of held_teeth_square(h, rise_per_m |v| T)) / mean
///   unseen_share = sum of |v| where rise_per_m |v| T > h/2, over the sum of all |v|
///   turn_share   = sqrt(mean of |u - u_before|^2 / 3), u = v/|v|: somewhere within the tick friction turns
///                  round, and its ends are told apart by a part of it that is even from 0 to 1
/// Turns of a slow finger are no error: there the pad sticks, and its spring turns with the travel.
/// @param path  null: the finger is held live, goes straight, and all speeds up to v_min are as likely
ShownFriction shown_friction(const Teeth& teeth, const FingerPath* path, double rate_hz);

/// Why friction is not shown well enough, in words; empty where all shares are within mu_tolerance.
std::string friction_hidden_because(const ShownFriction& shown, double mu_tolerance, double rate_hz);

/// Why the loop of the scene's [hand] is not stable at this rate, in words; empty where it is, or the scene
/// has no hand: a finger that follows its motion whatever it feels closes no loop. What must be held: the
/// stiffest surface, and, without a remedy, the stick spring under greatest_force_n; both against half the
/// largest stiffness of the sampled loop (stable_stiffness, SCIENCE 4).
std::string unstable_because(const Scene& scene, double rate_hz);

/// The lowest of automatic_rates_hz that shows the teeth within the scene's mu_tolerance and at which the
/// loop is stable; the highest where none is, which the reason says.
RateChoice choose_rate(const Scene& scene, const FingerPath* path);

/// Gives a scene that is touched live its rate where it leaves it open. @returns the reason; empty: it did
/// not
std::string settle_live_rate(Scene& scene);

}  // namespace fingerpad
