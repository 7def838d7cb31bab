#include "touch/contact_verdict.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "scene/scene.hpp"

namespace fingerpad {
namespace {

constexpr double nothing_is_kept = std::numeric_limits<double>::infinity();

/// What is said instead of a tolerance leaves room for what reckoning may be off by: of 35 real parts that
/// were tried, by a quarter at most (auto_judged.csv).
constexpr double reckoning_margin = 4.0 / 3;
/// Where nothing keeps the tolerance, what costs less may miss it by so much more than the best.
constexpr double nearly_best = 1.1;

using Candidates = std::vector<const ContactPair*>;

/// Leaves those that miss the tolerances by nearly as little as the best.
template <typename Misses>
void leave_nearly_best(Candidates& candidates, const Misses& misses) {
  double least = nothing_is_kept;
  for (const ContactPair* pair : candidates) least = std::min(least, misses(*pair));
  std::erase_if(candidates, [&](const ContactPair* pair) { return misses(*pair) > nearly_best * least; });
}

/// Where nothing keeps the tolerances. Light presses count as much as hard ones: under the hardest all may be
/// off by the whole force, and anything would do. First by what reckoning can say. Among equals facets on
/// which the proxy falls behind are left out: a finger gets through there.
void leave_least_bad(Candidates& candidates, std::span<const ContactCase> cases) {
  leave_nearly_best(candidates, [&](const ContactPair& pair) { return pair.told_misses(cases); });
  const auto gets_round = [&](const ContactPair* pair) { return pair->gets_round(cases); };
  if (std::ranges::any_of(candidates, gets_round)) std::erase_if(candidates, std::not_fn(gets_round));
  leave_nearly_best(candidates, [&](const ContactPair& pair) { return pair.misses(cases); });
}

/// @param pairs  the most complete method's last
std::size_t best_of(const std::vector<ContactPair>& pairs, std::span<const ContactCase> cases) {
  const bool any_holds = std::ranges::any_of(pairs, &ContactPair::holds);
  Candidates candidates;
  for (const ContactPair& pair : pairs) {
    // Where none can do, the most complete lets no finger through.
    if (any_holds ? pair.holds() : pair.method == pairs.back().method) candidates.push_back(&pair);
  }
  const auto keeps = [&](const ContactPair* pair) { return pair->tolerances(cases) <= 1; };
  if (std::ranges::any_of(candidates, keeps))
    std::erase_if(candidates, std::not_fn(keeps));
  else
    leave_least_bad(candidates, cases);
  const auto cheapest = std::ranges::min_element(candidates, {}, &ContactPair::cost);
  return cheapest == candidates.end() ? pairs.size() : static_cast<std::size_t>(*cheapest - pairs.data());
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
