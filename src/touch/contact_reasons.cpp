#include "touch/contact_reasons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/number_text.hpp"

namespace fingerpad {
namespace {

/// Of a rounding's radius.
constexpr double deepest_share = 0.8;

constexpr double nothing_kept = std::numeric_limits<double>::infinity();

/// "2.1 %", "0.05 %"; never less than it is.
std::string percent_words(double share) {
  const double percent = 100 * share,
               unit = percent > 0 ? std::pow(10, std::floor(std::log10(percent)) - 1) : 1;
  if (percent > 10) return fmt::format("{:.0f} %", std::ceil(percent));
  return fmt::format("{} %", rounded_text(std::ceil(percent / unit - 1e-9) * unit, 2));
}

/// Why the method is the chosen one on part i: what forbids another there, or on another part, or its cost.
std::string method_reason(const ContactVerdict& verdict, std::size_t i) {
  const ContactMethodEntry& chosen = *verdict.chosen().method;
  for (const ContactPair& other : verdict.all) {
    if (other.method == &chosen || other.holds()) continue;
    if (!other.fails[i].empty()) return other.fails[i];
    const auto by = std::find_if(other.fails.begin(), other.fails.end(),
                                 [](const std::string& why) { return !why.empty(); });
    return verdict.cases[static_cast<std::size_t>(by - other.fails.begin())].file + " needs it";
  }
  const std::string holds = chosen.holds_here == nullptr ? "" : chosen.holds_here(verdict.cases[i].contact);
  return holds.empty() ? "a tick costs less than with the others that would do" : holds;
}

bool is_flat(const ReckonedError& error) {
  return error.force_share < 1e-6;
}

/// "keep the force to 2.1 %", as far as reckoning goes.
std::string keeps_words(const ReckonedError& error) {
  return std::isfinite(kept_force_tolerance(error.force_share))
             ? "keep the force to " + percent_words(error.force_share)
             : "do not keep the force";
}

/// Why the normals are the chosen ones on part i: how far the force is off with them, and with plainer ones.
std::string normals_reason(const ContactVerdict& verdict, std::size_t i, double kept_tolerance) {
  const ContactPair& chosen = verdict.chosen();
  const ReckonedError& error = chosen.errors[i];
  const ContactPair* refused = nullptr;  // the last before the chosen one with the same method
  for (const ContactPair& other : verdict.all) {
    if (other.normals == chosen.normals) break;
    if (other.method == chosen.method) refused = &other;
  }
  if (is_flat(error) && (refused == nullptr || is_flat(refused->errors[i]))) return "its faces are flat";
  // What cannot be promised, or is not the normals' to keep, gets no figure.
  if (!std::isfinite(kept_tolerance) || !chosen.fails[i].empty()) return "no others do clearly better";
  if (refused == nullptr || is_flat(refused->errors[i])) return "they " + keeps_words(error);
  const std::string than = fmt::format("they {}, {} ones {}", keeps_words(error), refused->normals->name,
                                       keeps_words(refused->errors[i]));
  const bool needs_here = refused->tolerances(verdict.cases, i) > 1 || verdict.cases.size() == 1;
  return needs_here ? than : than + ", and another part needs them";
}

/// Facets that stand for a smooth surface, or have too few digits, in words.
std::string facets_words(const ContactCase& on, const ReckonedError& error) {
  const PartMeasures& part = on.contact.part;
  if (is_of_digits(on, error))
    return fmt::format("it stands so far from its file's origin that its vertices are rounded by up to {} mm",
                       rounded_text(1e3 * part.rounding_m, 2));
  const double sag_share = part.largest_sag_m * on.press.stiffness_n_per_m / on.press.least_force_n();
  const std::string turn =
      fmt::format("turn by up to {} degrees where they stand for a smooth surface",
                  rounded_text(180 / std::numbers::pi * part.largest_smooth_turn_rad, 2));
  if (sag_share < error.force_share / 3) return "its facets " + turn;
  return fmt::format("its facets cut up to {} mm into a smooth surface and {}",
                     rounded_text(1e3 * part.largest_sag_m, 2), turn);
}

/// A part so small, or so round, that a pressed finger slips round it; then nothing holds it.
std::string slips_round(const ContactCase& on) {
  const bool is_small = on.across_m < on.press.greatest_depth_m();
  const double size_m = is_small ? on.across_m : on.contact.part.median_round_m;
  return fmt::format("{}, and it is {}{} mm{}: a finger slips round it", on.contact.press,
                     is_small ? "" : "rounded by ", rounded_text(1e3 * size_m, 2), is_small ? " across" : "");
}

std::string instead_words(double kept) {
  return std::isfinite(kept) ? fmt::format(", {} can", rounded_text(kept, 2)) : ", nor anything like it";
}

/// Roundings tighter than this are too tight to be pressed so deep: near their middle the least that facets
/// are off by turns the force, and beyond it the finger slips off [m].
double slips_under_m(const ContactCase& on) {
  return (on.press.greatest_depth_m() - on.press.finger_radius_m) / deepest_share;
}

/// Whether more than a hundredth of any region is rounded tighter.
bool is_rounded_tighter(std::span<const SurfacePlace> places, double slips_m) {
  const auto is_tighter = [slips_m](const SurfacePlace& place) {
    return place.curvature_per_m * slips_m > 1;
  };
  bool any = false;
  each_region(places, [&](std::span<const SurfacePlace> region) {
    const auto tighter = std::count_if(region.begin(), region.end(), is_tighter);
    any = any || 100 * static_cast<std::size_t>(tighter) > region.size();
  });
  return any;
}

std::string slips_words(double slips_m) {
  return fmt::format(" but where it is rounded by less than {} mm", rounded_text(1e3 * slips_m, 2));
}

/// "mu_tolerance 0.1 cannot be kept, 0.35 can"; empty where it is kept.
std::string friction_words(const ContactVerdict& verdict, std::size_t i) {
  const ContactCase& on = verdict.cases[i];
  const double times = verdict.chosen().errors[i].mean_tilt_rad / on.mean_tilt_rad;
  if (!(times > 1)) return {};
  return fmt::format("mu_tolerance {} cannot be kept{}", rounded_text(on.mu_tolerance, 3),
                     instead_words(kept_mu_tolerance(on.mu_tolerance, times)));
}

}  // namespace

std::string reason_of(const ContactVerdict& verdict, std::size_t i, double kept_tolerance) {
  std::string line = verdict.cases[i].file + ": ";
  if (verdict.method_open)
    line += fmt::format("{}, because {}", verdict.chosen().method->name, method_reason(verdict, i));
  if (verdict.method_open && verdict.normals_open) line += "; ";
  if (verdict.normals_open)
    line += fmt::format("{} normals, because {}", verdict.chosen().normals->name,
                        normals_reason(verdict, i, kept_tolerance));
  return line + " (auto)";
}

ContactLimit limit_of(const ContactVerdict& verdict, std::size_t i, const std::string& mend) {
  const ContactPair& chosen = verdict.chosen();
  const ContactCase& on = verdict.cases[i];
  const ReckonedError& error = chosen.errors[i];
  const double tolerance = on.contact.force_tolerance;
  ContactLimit limit{tolerance, {}, {}};
  const std::string cannot = fmt::format("force_tolerance {} cannot be kept", rounded_text(tolerance, 3));
  std::string what = cannot;
  bool tells_instead = false;
  switch (verdict.unkept_on(i)) {
    case Unkept::nothing:
      return limit;
    case Unkept::grip:
      limit.kept_tolerance = nothing_kept;
      limit.why = slips_round(on);
      break;
    case Unkept::method: {
      const bool lags = falls_behind(on, error);
      limit.kept_tolerance =
          lags ? kept_force_tolerance(error.force_share + error.behind_share) : nothing_kept;
      tells_instead = std::isfinite(limit.kept_tolerance);
      what += fmt::format(" by {}{}", chosen.method->name, lags ? instead_words(limit.kept_tolerance) : "");
      limit.why = chosen.fails[i];
      break;
    }
    case Unkept::force: {
      const double kept = kept_force_tolerance(error.force_share), slips_m = slips_under_m(on);
      const bool slips_off =
          slips_m > 0 && std::isfinite(kept) && is_rounded_tighter(on.contact.part.places, slips_m);
      limit.kept_tolerance = slips_off ? nothing_kept : kept;
      tells_instead = std::isfinite(kept);
      what += instead_words(kept) + (slips_off ? slips_words(slips_m) : "");
      limit.why = facets_words(on, error);
      break;
    }
    case Unkept::friction:
      what = friction_words(verdict, i);
      limit.why = facets_words(on, error);
      break;
  }
  limit.said = fmt::format("{}: {}; {}", what, limit.why, mend);
  // Whoever takes what can be kept of the force is not to find then that mu is not kept either.
  if (const std::string friction = friction_words(verdict, i); tells_instead && !friction.empty())
    limit.said += "; " + friction;
  return limit;
}

}  // namespace fingerpad
