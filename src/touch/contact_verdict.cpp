#include "touch/contact_verdict.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "scene/scene.hpp"

namespace fingerpad {
namespace {

constexpr double nothing_is_kept = std::numeric_limits<double>::infinity();

/// What is said instead of a tolerance leaves room for what reckoning may be off by: of 35 real parts that
/// were tried, by a quarter at most (auto_judged.csv).
constexpr double reckoning_margin = 4.0 / 3;
/// Beyond a third of the force reckoning says nothing, and an error of mu as large as mu is no tolerance.
constexpr double most_force_kept = 1.0 / 3, most_mu_kept = 1;
/// Where nothing keeps the tolerance, what costs less may miss it by so much more than the best.
constexpr double nearly_best = 1.1;

/// @param pairs  the most complete method's last
std::size_t best_of(const std::vector<ContactPair>& pairs, std::span<const ContactCase> cases) {
  const bool any_holds =
      std::any_of(pairs.begin(), pairs.end(), [](const ContactPair& pair) { return pair.holds(); });
  // Where none can do, the most complete lets no finger through.
  const auto may_be_taken = [&](const ContactPair& pair) {
    return any_holds ? pair.holds() : pair.method == pairs.back().method;
  };
  // Where none keeps them, light presses count as much as hard ones: under the hardest all may be off by the
  // whole force, and anything would do.
  double least = nothing_is_kept, least_missed = nothing_is_kept;
  for (const ContactPair& pair : pairs) {
    if (!may_be_taken(pair)) continue;
    least = std::min(least, pair.tolerances(cases));
    least_missed = std::min(least_missed, pair.misses(cases));
  }
  const auto is_good = [&](const ContactPair& pair) {
    return least <= 1 ? pair.tolerances(cases) <= 1 : pair.misses(cases) <= nearly_best * least_missed;
  };
  std::size_t best = pairs.size();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!may_be_taken(pairs[k]) || !is_good(pairs[k])) continue;
    if (best == pairs.size() || pairs[k].cost < pairs[best].cost) best = k;
  }
  return best;
}

}  // namespace

Unkept ContactVerdict::unkept_on(std::size_t i) const {
  const ContactCase& on = cases[i];
  const ReckonedError& error = chosen().errors[i];
  if (on.press.greatest_depth_m() > holds_deep_m(on)) return Unkept::grip;
  if (!chosen().fails[i].empty()) return Unkept::method;
  if (error.force_share > on.contact.force_tolerance) return Unkept::force;
  return error.mean_tilt_rad > on.mean_tilt_rad ? Unkept::friction : Unkept::nothing;
}

ContactVerdict reckon_verdict(const Scene& scene, std::span<const Surface> surfaces,
                              std::vector<ContactCase> cases, ErrorMemory& errors) {
  ContactVerdict verdict{
      std::move(cases), {}, 0, scene.contact.method == automatic_method, scene.contact.automatic_normals};
  verdict.all = contact_pairs(scene, surfaces, verdict.cases, errors);
  verdict.chosen_at = best_of(verdict.all, verdict.cases);
  return verdict;
}

double holds_deep_m(const ContactCase& on) noexcept {
  return std::min(on.across_m, on.press.finger_radius_m + on.contact.part.median_round_m);
}

bool falls_behind(const ContactCase& on, const ReckonedError& error) noexcept {
  return !on.contact.crowded.is_too_much() && error.behind_share > on.contact.force_tolerance;
}

bool is_of_digits(const ContactCase& on, const ReckonedError& error) noexcept {
  constexpr double promised_ticks = 0.99;
  return on.contact.part.untold_share > 1 - promised_ticks ||
         2 * rounding_share(on.press, on.contact.part.rounding_m) > error.force_share;
}

double kept_force_tolerance(double error) noexcept {
  const double kept = reckoning_margin * error;
  return kept > most_force_kept ? nothing_is_kept : kept;
}

double kept_mu_tolerance(double mu_tolerance, double times) noexcept {
  const double kept = reckoning_margin * mu_tolerance * times;
  return kept > most_mu_kept ? nothing_is_kept : kept;
}

}  // namespace fingerpad
