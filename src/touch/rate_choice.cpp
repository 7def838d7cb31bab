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

/// By how much the coefficient rises a metre in stick.
double rise_per_m(const Scene& scene, const LawEntry& law) {
  const LawSettings& settings = scene.friction.settings;
  if (law.rise_per_m != nullptr) return law.rise_per_m(settings);
  for (const LawParameter& stiffness : {stiffness_per_newton_parameter, fixed_stiffness_parameter}) {
    if (reads(law, stiffness)) return bounded_number(settings, stiffness);
  }
  return 0;
}

/// A tick in which the finger goes.
struct Going {
  double speed_m_per_s = 0;
  double turn_square = 0;  ///< |u - u_before|^2, of the directions in this tick and the one before
};

Vec3 velocity_at(const FingerPath& path, double t_s, double tick_s) {
  const FingerSample from = path.at_time(t_s);
  return from.velocity_W ? *from.velocity_W : Vec3((path.at_time(t_s + tick_s).p_WQ - from.p_WQ) / tick_s);
}

/// The ticks of a path in which the finger goes; of a long one so many, evenly spread.
std::vector<Going> ticks_along(const FingerPath& path, double tick_s) {
  constexpr long most_ticks_seen = 100000;
  const double whole_s = path.end_s() - path.start_s() - tick_s;
  const long ticks = std::clamp(std::lround(whole_s / tick_s), 1L, most_ticks_seen);
  std::vector<Going> going;
  for (long k = 0; k < ticks; ++k) {
    const double t_s =
        path.start_s() + std::max(0.0, whole_s) * static_cast<double>(k) / static_cast<double>(ticks);
    const Vec3 before = velocity_at(path, t_s, tick_s), now = velocity_at(path, t_s + tick_s, tick_s);
    if (!(now.norm() > 0)) continue;
    const bool both = before.norm() > 0;
    going.push_back({now.norm(), both ? (now.normalized() - before.normalized()).squaredNorm() : 0});
  }
  return going;
}

std::vector<Going> speeds_up_to(double v_min_m_per_s) {
  constexpr int steps = 100;
  std::vector<Going> going;
  for (int i = 1; i <= steps; ++i) going.push_back({v_min_m_per_s * i / steps, 0});
  return going;
}

std::string hand_text(const HandSettings& hand, double rate_hz) {
  return fmt::format("[hand] of {} kg and {} N s/m{} at {} Hz", rounded_text(hand.mass_kg, 4),
                     rounded_text(hand.damping_n_s_per_m, 4),
                     hand.delay_ticks > 0 ? fmt::format(", {} ticks late,", hand.delay_ticks) : "",
                     number_text(rate_hz));
}

/// Of 6 dB, as loops are given: at the border itself, or close to it, a hand rings for seconds.
constexpr double gain_margin = 2;

/// @param what  "a surface"
std::string too_stiff_text(const HandSettings& hand, double rate_hz, double most_n_per_m,
                           std::string_view what, double stiffness_n_per_m) {
  return fmt::format("a {} holds up to {} N/m, half of which is kept in reserve, and {} has {}",
                     hand_text(hand, rate_hz), rounded_text(most_n_per_m, 4), what,
                     rounded_text(stiffness_n_per_m, 4));
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
  if (law == nullptr) return teeth;
  if (reads(*law, v_min_parameter)) teeth.v_min_m_per_s = v_min_m_per_s(settings);
  if (!chooses(*law, "events") || slips_on) return teeth;
  if (!reads(*law, v_min_parameter)) teeth.v_min_m_per_s = HUGE_VAL;  // it saws at any speed
  teeth.rise_per_m = rise_per_m(scene, *law);
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

ShownFriction shown_friction(const Teeth& teeth, const FingerPath* path, double rate_hz) {
  const std::vector<Going> ticks =
      path != nullptr ? ticks_along(*path, 1 / rate_hz) : speeds_up_to(teeth.v_min_m_per_s);
  const bool saws = teeth.height > 0 && teeth.rise_per_m > 0;
  double square = 0, slow = 0, travel = 0, unseen = 0, turned = 0;
  for (const Going& tick : ticks) {
    if (tick.speed_m_per_s > teeth.v_min_m_per_s) {
      turned += tick.turn_square;
      continue;
    }
    const double rise = teeth.rise_per_m * tick.speed_m_per_s / rate_hz;
    square += held_teeth_square(teeth.height, rise);
    ++slow;
    travel += tick.speed_m_per_s;
    if (rise > teeth.height / 2) unseen += tick.speed_m_per_s;
  }
  ShownFriction shown;
  if (!ticks.empty()) shown.turn_share = std::sqrt(turned / 3 / static_cast<double>(ticks.size()));
  if (slow == 0 || !saws) return shown;
  shown.held_share = std::sqrt(square / slow) / teeth.mean;
  shown.unseen_share = unseen / travel;
  return shown;
}

std::string friction_hidden_because(const ShownFriction& shown, double mu_tolerance, double rate_hz) {
  const std::string at = number_text(rate_hz) + " Hz";
  const std::string allowed = fmt::format("where {} % is asked for", rounded_text(100 * mu_tolerance, 3));
  if (shown.held_share > mu_tolerance) {
    return fmt::format(
        "held from tick to tick at {} the coefficient of friction of a slow finger is off by {} % "
        "(RMS), {}",
        at, rounded_text(100 * shown.held_share, 2), allowed);
  }
  if (shown.unseen_share > mu_tolerance) {
    return fmt::format("at {} {} % of the stick-slip teeth last under two ticks, which nothing shows, {}", at,
                       rounded_text(100 * shown.unseen_share, 3), allowed);
  }
  if (shown.turn_share > mu_tolerance) {
    return fmt::format("the motion turns so sharply that at {} friction is off by {} % (RMS), {}", at,
                       rounded_text(100 * shown.turn_share, 2), allowed);
  }
  return {};
}

std::string unstable_because(const Scene& scene, double rate_hz) {
  if (!scene.hand) return {};
  const HandSettings& hand = *scene.hand;
  HeldWall wall = wall_under(hand, rate_hz);
  for (const SurfaceProperties& surface : surfaces_of(scene)) {
    wall.wall_damping_n_s_per_m = surface.damping_n_s_per_m;
    const double most = stable_stiffness(wall);
    if (gain_margin * surface.stiffness_n_per_m <= most) continue;
    return too_stiff_text(hand, rate_hz, most, "a surface", surface.stiffness_n_per_m);
  }
  const LawEntry* law = find_law(scene.friction.law);
  if (law == nullptr || scene.friction.settings.remedy != Remedy::none) return {};
  const bool scales = law->rise_per_m != nullptr || reads(*law, stiffness_per_newton_parameter);
  const double load_n = scales ? scene.contact.greatest_force_n : 1;
  const double stick_n_per_m = rise_per_m(scene, *law) * load_n;
  wall.wall_damping_n_s_per_m = 0;
  const double most = stable_stiffness(wall);
  if (gain_margin * stick_n_per_m <= most) return {};
  return too_stiff_text(hand, rate_hz, most, "the sticking pad", stick_n_per_m) +
         (scales ? fmt::format(" under greatest_force_n, {} N", rounded_text(load_n, 3)) : "");
}

RateChoice choose_rate(const Scene& scene, const FingerPath* path) {
  const Teeth teeth = teeth_of(scene);
  const LawEntry* const law = find_law(scene.friction.law);
  const double tolerance = scene.contact.mu_tolerance;
  std::string lower;  // why the rate below would not do
  for (const double rate_hz : automatic_rates_hz) {
    const bool rubs = law == nullptr || law->rubs;
    const ShownFriction shown = rubs ? shown_friction(teeth, path, rate_hz) : ShownFriction();
    std::string broken = unstable_because(scene, rate_hz);
    if (broken.empty()) broken = friction_hidden_because(shown, tolerance, rate_hz);
    if (broken.empty()) {
      return told(rate_hz, !lower.empty() ? "because " + lower
                                          : fmt::format("the lowest there is: it shows friction within {} %",
                                                        rounded_text(100 * tolerance, 3)));
    }
    lower = std::move(broken);
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
