#include "touch/contact_reasons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

/// What is said instead of the tolerance leaves room for a reckoning that is right to a sixth.
constexpr double reckoning_margin = 1.2;

/// Of a rounding's radius.
constexpr double deepest_share = 0.8;

/// Beyond a third of the force reckoning says nothing.
constexpr double most_kept = 1.0 / 3, nothing_kept = std::numeric_limits<double>::infinity();

/// "2.1 %", "0.05 %"; never less than it is.
std::string percent_words(double share) {
  const double percent = 100 * share,
               unit = percent > 0 ? std::pow(10, std::floor(std::log10(percent)) - 1) : 1;
  if (percent > 10) return fmt::format("{:.0f} %", std::ceil(percent));
  return fmt::format("{} %", rounded_text(std::ceil(percent / unit - 1e-9) * unit, 2));
}

/// Why the method is the chosen one on part i: what forbids another there, or on another part, or its cost.
std::string method_reason(const ContactVerdict& verdict, std::span<const ContactCase> cases, std::size_t i) {
  const ContactMethodEntry& chosen = *verdict.chosen.method;
  for (const ContactPair& other : verdict.all) {
    if (other.method == &chosen || other.holds()) continue;
    if (!other.fails[i].empty()) return other.fails[i];
    const auto by = std::find_if(other.fails.begin(), other.fails.end(),
                                 [](const std::string& why) { return !why.empty(); });
    return cases[static_cast<std::size_t>(by - other.fails.begin())].file + " needs it";
  }
  const std::string holds = chosen.holds_here == nullptr ? "" : chosen.holds_here(cases[i].contact);
  return holds.empty() ? "a tick costs less than with the others that would do" : holds;
}

bool is_flat(const ReckonedError& error) {
  return error.force_share < 1e-6;
}

/// Why the normals are the chosen ones on part i: how far the force is off with them, and with plainer ones.
std::string normals_reason(const ContactVerdict& verdict, std::span<const ContactCase> cases, std::size_t i) {
  const ContactPair& chosen = verdict.chosen;
  const ReckonedError& error = chosen.errors[i];
  const ContactPair* refused = nullptr;  // the last before the chosen one with the same method
  for (const ContactPair& other : verdict.all) {
    if (other.normals == chosen.normals) break;
    if (other.method == chosen.method) refused = &other;
  }
  if (refused == nullptr || is_flat(refused->errors[i]))
    return is_flat(error) ? "its faces are flat"
                          : "they keep the force to " + percent_words(error.force_share);
  const ReckonedError& other = refused->errors[i];
  const std::string than =
      fmt::format("they keep the force to {}, {} ones to {}", percent_words(error.force_share),
                  refused->normals->name, percent_words(other.force_share));
  const bool needs_here = refused->tolerances(cases, i) > 1 || cases.size() == 1;
  return needs_here ? than : than + ", and another part needs them";
}

/// Facets that stand for a smooth surface, in words.
std::string facets_words(const ContactCase& on, const ReckonedError& error) {
  const PartMeasures& part = on.contact.part;
  const double sag_share = part.largest_sag_m * on.press.stiffness_n_per_m / on.press.least_force_n();
  const std::string turn =
      fmt::format("turn by up to {} degrees where they stand for a smooth surface",
                  rounded_text(180 / std::numbers::pi * part.largest_smooth_turn_rad, 2));
  if (sag_share < error.force_share / 3) return "its facets " + turn;
  return fmt::format("its facets cut up to {} mm into a smooth surface and {}",
                     rounded_text(1e3 * part.largest_sag_m, 2), turn);
}

/// Whether a pair that touches a surface of its own could have been taken, and would keep it.
bool patches_would(const ContactVerdict& verdict, std::span<const ContactCase> cases) {
  return std::any_of(verdict.all.begin(), verdict.all.end(), [&](const ContactPair& pair) {
    return pair.touches_own_surface() && pair.holds() && pair.tolerances(cases) <= 1;
  });
}

/// A part so small, or so round, that a pressed finger slips round it; then nothing holds it.
std::string slips_round(const ContactCase& on) {
  const double depth_m = on.press.greatest_force_n / on.press.stiffness_n_per_m,
               inside_m = depth_m - on.press.finger_radius_m, round_m = on.contact.part.median_round_m;
  const std::string mend = ": a finger slips round it; a smaller greatest_force_n would";
  if (on.across_m < depth_m)
    return fmt::format("{}, and it is {} mm across{}", on.contact.press, rounded_text(1e3 * on.across_m, 2),
                       mend);
  if (round_m < inside_m)
    return fmt::format("{}, and it is rounded by {} mm{}", on.contact.press, rounded_text(1e3 * round_m, 2),
                       mend);
  return {};
}

/// Whether all that the chosen method cannot do on a part is to keep up with a ball.
bool falls_behind(const ContactCase& on, const ReckonedError& error) {
  return !on.contact.crowded.is_too_much() && error.behind_share > on.contact.force_tolerance;
}

/// What would help where the chosen method cannot do.
std::string mend_of_method(const ContactVerdict& verdict, const ContactCase& on, const ReckonedError& error) {
  if (falls_behind(on, error)) {
    // No deeper than half of the ball's radius it keeps up round anything.
    const double most_n = on.press.stiffness_n_per_m * on.press.finger_radius_m / 2;
    return fmt::format("a greatest_force_n of {}", rounded_text(0.95 * most_n, 2));
  }
  return verdict.method_open ? "a coarser mesh there or another finger radius" : "method = \"auto\"";
}

/// What can be kept in the tolerance's place where the force is off by so much.
double instead(double error) {
  const double kept = reckoning_margin * error;
  return kept > most_kept ? nothing_kept : kept;
}

std::string instead_words(double kept) {
  return kept > most_kept ? ", nor anything like it" : fmt::format(", {} can", rounded_text(kept, 2));
}

/// Roundings tighter than this are too tight to be pressed so deep: near their middle the least that facets
/// are off by turns the force, and beyond it the finger slips off [m].
double slips_under_m(const ContactCase& on) {
  return (on.press.greatest_force_n / on.press.stiffness_n_per_m - on.press.finger_radius_m) / deepest_share;
}

/// Whether more than a hundredth of any region is rounded tighter.
bool is_rounded_tighter(std::span<const SurfacePlace> places, double slips_m) {
  const auto is_tighter = [slips_m](const SurfacePlace& place) {
    return place.curvature_per_m * slips_m > 1;
  };
  for (auto first = places.begin(), end = first; first != places.end(); first = end) {
    end = std::find_if(first, places.end(),
                       [&](const SurfacePlace& place) { return place.region != first->region; });
    if (100 * std::count_if(first, end, is_tighter) > end - first) return true;
  }
  return false;
}

std::string slips_words(double slips_m) {
  return fmt::format(" but where it is rounded by less than {} mm", rounded_text(1e3 * slips_m, 2));
}

std::string mend_words(const ContactVerdict& verdict, std::span<const ContactCase> cases) {
  if (!verdict.normals_open && !patches_would(verdict, cases) &&
      verdict.chosen.normals != normals_table().back())
    return "a finer mesh, a STEP file or normals = \"auto\" would do better";
  return "a finer mesh or a STEP file would";
}

}  // namespace

std::string reason_of(const ContactVerdict& verdict, std::span<const ContactCase> cases, std::size_t i) {
  std::string line = cases[i].file + ": ";
  if (verdict.method_open)
    line += fmt::format("{}, because {}", verdict.chosen.method->name, method_reason(verdict, cases, i));
  if (verdict.method_open && verdict.normals_open) line += "; ";
  if (verdict.normals_open)
    line += fmt::format("{} normals, because {}", verdict.chosen.normals->name,
                        normals_reason(verdict, cases, i));
  return line + " (auto)";
}

ContactLimit limit_of(const ContactVerdict& verdict, std::span<const ContactCase> cases, std::size_t i) {
  const ContactPair& chosen = verdict.chosen;
  const ContactCase& on = cases[i];
  const ReckonedError& error = chosen.errors[i];
  const double tolerance = on.contact.force_tolerance;
  ContactLimit limit{tolerance, {}};
  const std::string slips = slips_round(on);
  if (!slips.empty()) {
    limit.kept_tolerance = nothing_kept;
    limit.said = fmt::format("force_tolerance {} cannot be kept: {}", rounded_text(tolerance, 3), slips);
  } else if (!chosen.fails[i].empty()) {
    const bool lags = falls_behind(on, error);
    limit.kept_tolerance = lags ? instead(error.force_share + error.behind_share) : nothing_kept;
    limit.said =
        fmt::format("force_tolerance {} cannot be kept by {}{}: {}; {} would", rounded_text(tolerance, 3),
                    chosen.method->name, lags ? instead_words(limit.kept_tolerance) : "", chosen.fails[i],
                    mend_of_method(verdict, on, error));
  } else if (error.force_share > tolerance) {
    const double kept = instead(error.force_share), slips_m = slips_under_m(on);
    const bool slips_off =
        slips_m > 0 && kept <= most_kept && is_rounded_tighter(on.contact.part.places, slips_m);
    limit.kept_tolerance = slips_off ? nothing_kept : kept;
    limit.said = fmt::format("force_tolerance {} cannot be kept{}{}: {}; {}", rounded_text(tolerance, 3),
                             instead_words(kept), slips_off ? slips_words(slips_m) : "",
                             facets_words(on, error), mend_words(verdict, cases));
  } else if (error.mean_tilt_rad > on.mean_tilt_rad) {
    limit.said = fmt::format("mu_tolerance cannot be kept: {}; {}", facets_words(on, error),
                             mend_words(verdict, cases));
  }
  return limit;
}

}  // namespace fingerpad
