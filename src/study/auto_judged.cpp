#include "study/auto_judged.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/contact_cost.hpp"
#include "part/in_parallel.hpp"
#include "study/judged_errors.hpp"
#include "study/promise_trial.hpp"

namespace fingerpad {
namespace {

constexpr double not_judged = std::numeric_limits<double>::infinity();

bool is_judged(const JudgedCase& one, const JudgedRow& row, std::size_t variant) {
  return one.judges_all_variants || variant == row.chosen || variant + 1 == contact_variants().size();
}

/// A trial of the promise, and what is true there.
struct Trial {
  JudgedCase on;
  JudgedReference reference;
  Promised promised;
};

/// At once, on what threads there are: nothing is timed in trials.
template <typename Work>
void for_each_at_once(std::size_t count, const Work& work) {
  in_parallel(
      static_cast<int>(count),
      [&](int first, int end) {
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) work(i);
      },
      1);
}

std::vector<Trial> trials_of(const JudgedCase& one) {
  std::vector<JudgedCase> cases = promise_trials(one);
  std::vector<Trial> trials(cases.size());
  for_each_at_once(trials.size(), [&](std::size_t i) {
    trials[i].on = std::move(cases[i]);
    trials[i].reference = judged_reference(trials[i].on);
    trials[i].promised = promised_of(trials[i].on, trials[i].reference);
  });
  return trials;
}

/// The run of a way to touch: the most complete one's is that which its trial's reference was told by.
JudgedRun run_of(const Trial& trial, std::size_t variant) {
  const bool is_reference = variant + 1 == contact_variants().size() && !trial.on.exact_force_n;
  return is_reference ? trial.reference.complete : judged_run(trial.on, contact_variants()[variant], 1);
}

/// So many trials are made before it is asked whether others are needed: the same on any number of threads,
/// and at least so many.
constexpr std::size_t trials_at_a_time = 8;

/// Fills in the worst of the promise's trials, by variant.
void try_promise(const JudgedCase& one, JudgedRow& row) {
  const std::vector<Trial> trials = trials_of(one);
  for (std::size_t v = 0; v < contact_variants().size(); ++v) {
    double& worst = row.trial_99.emplace_back(is_judged(one, row, v) ? 0 : not_judged);
    long& pop_throughs = row.trial_pop_throughs.emplace_back(0);
    if (!is_judged(one, row, v)) continue;
    const bool asks_for_all = v == row.chosen || v + 1 == contact_variants().size();
    for (std::size_t first = 0; first < trials.size(); first += trials_at_a_time) {
      const bool fails = std::max(worst, row.error_99[v]) > row.tolerance;
      if (first > 0 && fails && !asks_for_all) break;
      std::vector<JudgedErrors> some(std::min(trials_at_a_time, trials.size() - first));
      for_each_at_once(some.size(), [&](std::size_t i) {
        const Trial& trial = trials[first + i];
        some[i] = judged_errors(trial.on, run_of(trial, v), trial.reference, trial.promised);
      });
      for (const JudgedErrors& trial : some) {
        worst = std::max(worst, trial.share_99);
        pop_throughs += trial.pop_throughs;
      }
    }
  }
}

std::string said_by(const ContactChoice& choice) {
  std::string all;
  for (const ContactLimit& limit : choice.limits) {
    if (limit.said.empty() || all.find(limit.said) != std::string::npos) continue;
    all += (all.empty() ? "" : "; ") + limit.said;
  }
  return all;
}

}  // namespace

std::string to_string(JudgedWord word) {
  switch (word) {
    case JudgedWord::kept:
      return "kept";
    case JudgedWord::said:
      return "said that it cannot";
    case JudgedWord::needless:
      return "said so needlessly";
    case JudgedWord::broken:
      break;
  }
  return "broken";
}

namespace {

JudgedWord word_of(double error, bool pops, double promised, double tolerance) {
  if (pops || error > promised) return JudgedWord::broken;
  if (promised <= tolerance) return JudgedWord::kept;
  return error > tolerance ? JudgedWord::said : JudgedWord::needless;
}

}  // namespace

bool JudgedRow::pops(std::size_t variant, bool in_trials_too) const {
  return pop_throughs[variant] > pop_throughs.back() ||
         (in_trials_too && trial_pop_throughs[variant] > trial_pop_throughs.back());
}

JudgedWord JudgedRow::word() const {
  return word_of(std::max(error_99[chosen], trial_99[chosen]), pops(chosen, true), promised, tolerance);
}

JudgedWord JudgedRow::word_of_motion() const {
  return word_of(error_99[chosen], pops(chosen, false), promised, tolerance);
}

std::size_t JudgedRow::cheapest(const std::vector<double>& price, bool of_promise) const {
  std::size_t best = price.size();
  for (std::size_t v = 0; v < price.size(); ++v) {
    const bool keeps =
        error_99[v] <= tolerance && (!of_promise || trial_99[v] <= tolerance) && !pops(v, of_promise);
    if (keeps && (best == price.size() || price[v] < price[best])) best = v;
  }
  return best;
}

double JudgedRow::price_ratio(const std::vector<double>& price, bool of_promise) const {
  const std::size_t best = cheapest(price, of_promise);
  return best < price.size() ? price[chosen] / price[best] : std::numeric_limits<double>::quiet_NaN();
}

JudgedCount count_words(std::span<const JudgedRow> rows, bool of_promise) {
  constexpr double near_share = 1.2;
  JudgedCount count;
  for (const JudgedRow& row : rows) {
    const JudgedWord word = of_promise ? row.word() : row.word_of_motion();
    ++count.cases;
    count.kept += word == JudgedWord::kept ? 1 : 0;
    count.said += word == JudgedWord::said ? 1 : 0;
    count.needless += word == JudgedWord::needless ? 1 : 0;
    count.broken += word == JudgedWord::broken ? 1 : 0;
    const bool is_near = row.price_ratio(row.cost, of_promise) <= near_share;
    count.near_cheapest += word == JudgedWord::kept && is_near ? 1 : 0;
  }
  return count;
}

JudgedRow judged(const JudgedCase& one, int turns) {
  const ContactChoice& choice = *one.world->contact;
  JudgedRow row;
  row.name = one.name;
  row.said = said_by(choice);
  row.radius_m = one.scene.finger.radius_m;
  row.promised = row.tolerance = one.scene.contact.force_tolerance;
  row.is_exact = static_cast<bool>(one.exact_force_n);
  for (const ContactLimit& limit : choice.limits) row.promised = std::max(row.promised, limit.kept_tolerance);
  row.triangles = triangles_of(one.world->surfaces);
  const JudgedReference reference = judged_reference(one);
  const Promised promised = promised_of(one, reference);
  const auto is_chosen = [&](const ContactVariant& variant) {
    return variant.method_name == choice.method && variant.normals == choice.normals;
  };
  row.chosen = static_cast<std::size_t>(std::ranges::find_if(contact_variants(), is_chosen) -
                                        contact_variants().begin());
  for (std::size_t v = 0; v < contact_variants().size(); ++v) {
    const ContactVariant& variant = contact_variants()[v];
    row.cost.push_back(contact_cost(variant.method_name, variant.normals_name,
                                    static_cast<int>(row.triangles), row.radius_m > 0)
                           .value_or(std::numeric_limits<double>::infinity()));
    if (!is_judged(one, row, v)) {
      row.error_99.push_back(not_judged);
      row.tick_ns.push_back(not_judged);
      row.pop_throughs.push_back(0);
      continue;
    }
    const JudgedRun run = judged_run(one, variant, turns);
    const JudgedErrors errors = judged_errors(one, run, reference, promised);
    row.ticks = errors.ticks;
    row.error_99.push_back(errors.share_99);
    row.tick_ns.push_back(run.tick_ns);
    row.pop_throughs.push_back(errors.pop_throughs);
  }
  try_promise(one, row);
  return row;
}

}  // namespace fingerpad
