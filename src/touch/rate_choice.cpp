#include "touch/rate_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/number_text.hpp"
#include "friction/law_parameters.hpp"
#include "motion/finger_path.hpp"
#include "motion/stable_stiffness.hpp"
#include "scene/scene.hpp"

namespace fingerpad {
namespace {

std::vector<SurfaceProperties> surfaces_of(const Scene& scene) {
  std::vector<SurfaceProperties> surfaces;
  for (const PartEntry& part : scene.parts) surfaces.push_back(part.surface);
  for (const PlaneEntry& plane : scene.planes) surfaces.push_back(plane.surface);
  return surfaces;
}

bool reads(const LawEntry& law, const LawParameter& parameter) {
  return std::any_of(law.parameters.begin(), law.parameters.end(),
                     [&](const LawParameter& own) { return own.key == parameter.key; });
}

bool chooses(const LawEntry& law, std::string_view key) {
  return std::find(law.choices.begin(), law.choices.end(), key) != law.choices.end();
}

/// By how much the coefficient rises a metre in stick. A pad's is that of its short axis at 45 degrees.
double rise_per_m(const Scene& scene, const LawEntry& law) {
  const LawSettings& settings = scene.friction.settings;
  if (!reads(law, stiffness_per_newton_parameter)) {
    return reads(law, fixed_stiffness_parameter) ? bounded_number(settings, fixed_stiffness_parameter) : 0;
  }
  const double stiffness_per_m = bounded_number(settings, stiffness_per_newton_parameter);
  if (law.name != "finger-pad") return stiffness_per_m;
  const PadProfile pad = settings.profile.value_or(assumed_profile(0.3, stiffness_per_m));
  return pad.mu_static / std::min(pad.lateral_axis_m, pad.longitudinal_axis_m);
}

/// The finger's speed now and then over a path, wherever it moves.
std::vector<double> speeds_along(const FingerPath& path) {
  constexpr double window_s = 1e-3;
  constexpr long most_windows = 100000;
  const double whole_s = path.end_s() - path.start_s();
  const long windows = std::clamp(std::lround(whole_s / window_s), 1L, most_windows);
  std::vector<double> speeds;
  for (long k = 0; k < windows; ++k) {
    const double t_s = path.start_s() + whole_s * static_cast<double>(k) / static_cast<double>(windows);
    const FingerSample from = path.at_time(t_s);
    const double speed = from.velocity_W ? from.velocity_W->norm()
                                         : (path.at_time(t_s + window_s).p_WQ - from.p_WQ).norm() / window_s;
    if (speed > 0) speeds.push_back(speed);
  }
  return speeds;
}

std::vector<double> speeds_up_to(double v_min_m_per_s) {
  constexpr int steps = 100;
  std::vector<double> speeds;
  for (int i = 1; i <= steps; ++i) speeds.push_back(v_min_m_per_s * i / steps);
  return speeds;
}

std::string hand_text(const HandSettings& hand, double rate_hz) {
  return fmt::format("[hand] of {:.4g} kg and {:.4g} N s/m{} at {} Hz", hand.mass_kg, hand.damping_n_s_per_m,
                     hand.delay_ticks > 0 ? fmt::format(", {} ticks late,", hand.delay_ticks) : "",
                     number_text(rate_hz));
}

/// "rate_hz: 2000 Hz", and for the highest that it is no more than that.
RateChoice told(double rate_hz, const std::string& why) {
  return {rate_hz, fmt::format("rate_hz: {} Hz, {} (auto)", number_text(rate_hz), why)};
}

}  // namespace

double held_teeth_square(double height, double rise) noexcept {
  return rise < height ? rise * height / 2 - rise * rise / 3 : height * height / 6;
}

Teeth teeth_of(const Scene& scene) {
  Teeth teeth;
  const LawEntry* law = find_law(scene.friction.law);
  const LawSettings& settings = scene.friction.settings;
  // A law that slips on after a slow rupture saws as little as one that never ruptures.
  const bool slips_on = law != nullptr && chooses(*law, "restick") && settings.restick == Restick::crossing;
  if (law == nullptr || !chooses(*law, "events") || slips_on) return teeth;
  teeth.rise_per_m = rise_per_m(scene, *law);
  teeth.v_min_m_per_s = reads(*law, v_min_parameter) ? v_min_m_per_s(settings) : HUGE_VAL;
  for (const SurfaceProperties& surface : surfaces_of(scene)) {
    const double height = surface.mu_static - surface.mu_dynamic,
                 mean = (surface.mu_static + surface.mu_dynamic) / 2;
    if (!(height * teeth.mean > teeth.height * mean) && teeth.height > 0) continue;
    if (height <= 0) continue;
    teeth.height = height;
    teeth.mean = mean;
  }
  return teeth;
}

ShownTeeth shown_teeth(const Teeth& teeth, const FingerPath* path, double rate_hz) {
  ShownTeeth shown;
  if (!(teeth.height > 0) || !(teeth.rise_per_m > 0)) return shown;
  const std::vector<double> speeds =
      path != nullptr ? speeds_along(*path) : speeds_up_to(teeth.v_min_m_per_s);
  double square = 0, slow = 0, travel = 0, unseen = 0;
  for (const double speed : speeds) {
    if (speed > teeth.v_min_m_per_s) continue;
    const double rise = teeth.rise_per_m * speed / rate_hz;
    square += held_teeth_square(teeth.height, rise);
    ++slow;
    travel += speed;
    if (rise > teeth.height / 2) unseen += speed;
  }
  if (slow == 0) return shown;
  return {std::sqrt(square / slow) / teeth.mean, unseen / travel};
}

std::string teeth_hidden_because(const ShownTeeth& shown, double mu_tolerance, double rate_hz) {
  if (shown.held_share > mu_tolerance) {
    return fmt::format(
        "held from tick to tick at {} Hz the coefficient of friction of a slow finger is off by "
        "{:.2g} % (RMS), where {:.3g} % is asked for",
        number_text(rate_hz), 100 * shown.held_share, 100 * mu_tolerance);
  }
  if (shown.unseen_share > mu_tolerance) {
    return fmt::format(
        "at {} Hz {:.3g} % of the stick-slip teeth last under two ticks, which nothing shows, where "
        "{:.3g} % are allowed",
        number_text(rate_hz), 100 * shown.unseen_share, 100 * mu_tolerance);
  }
  return {};
}

std::string unstable_because(const Scene& scene, double rate_hz) {
  if (!scene.hand) return {};
  const HandSettings& hand = *scene.hand;
  HeldWall wall{.mass_kg = hand.mass_kg,
                .damping_n_s_per_m = hand.damping_n_s_per_m,
                .tick_s = 1 / rate_hz,
                .delay_ticks = hand.delay_ticks};
  for (const SurfaceProperties& surface : surfaces_of(scene)) {
    wall.wall_damping_n_s_per_m = surface.damping_n_s_per_m;
    const double most = stable_stiffness(wall);
    if (surface.stiffness_n_per_m <= most) continue;
    return fmt::format("a {} holds no more than {:.4g} N/m, and a surface has {:.4g}",
                       hand_text(hand, rate_hz), most, surface.stiffness_n_per_m);
  }
  const LawEntry* law = find_law(scene.friction.law);
  if (law == nullptr || scene.friction.settings.remedy != Remedy::none) return {};
  const bool scales = reads(*law, stiffness_per_newton_parameter);
  const double load_n = scales ? scene.contact.greatest_force_n : 1;
  const double stick_n_per_m = rise_per_m(scene, *law) * load_n;
  wall.wall_damping_n_s_per_m = 0;
  const double most = stable_stiffness(wall);
  if (stick_n_per_m <= most) return {};
  return fmt::format("a {} holds no more than {:.4g} N/m, and the sticking pad has {:.4g}{}",
                     hand_text(hand, rate_hz), most, stick_n_per_m,
                     scales ? fmt::format(" under greatest_force_n, {:.3g} N", load_n) : "");
}

RateChoice choose_rate(const Scene& scene, const FingerPath* path) {
  const Teeth teeth = teeth_of(scene);
  std::string lower;  // why the rate below would not do
  for (const double rate_hz : automatic_rates_hz) {
    const ShownTeeth shown = shown_teeth(teeth, path, rate_hz);
    std::string broken = unstable_because(scene, rate_hz);
    if (broken.empty()) broken = teeth_hidden_because(shown, scene.contact.mu_tolerance, rate_hz);
    if (!broken.empty()) {
      lower = std::move(broken);
      continue;
    }
    if (!lower.empty()) return told(rate_hz, "because " + lower);
    return told(rate_hz,
                shown.held_share > 0
                    ? fmt::format("the lowest there is, which shows a slow finger's teeth within {:.2g} %",
                                  100 * shown.held_share)
                    : "the lowest there is: nothing in the scene saws or closes a loop");
  }
  return told(*std::rbegin(automatic_rates_hz), "the highest there is, though " + lower);
}

std::string settle_live_rate(Scene& scene) {
  if (!scene.motion.automatic_rate) return {};
  RateChoice choice = choose_rate(scene, nullptr);
  scene.motion.rate_hz = choice.rate_hz;
  scene.motion.automatic_rate = false;
  return std::move(choice.reason);
}

}  // namespace fingerpad
