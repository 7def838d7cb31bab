#include "study/auto_judged.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/contact_cost.hpp"
#include "part/in_parallel.hpp"
#include "study/promise_trial.hpp"

namespace fingerpad {
namespace {

/// Facets that cut in, and patches that stand out, leave the greatest force no exact border.
constexpr double about_greatest = 1.03;

/// What of a case the promise speaks of: of ticks those until which, since the finger was last free, the true
/// force has not been beyond the greatest, nor the finger so deep in a rounding that it slips round (what a
/// proxy has been pressed through stays with it); of ways those of such ticks alone.
struct Promised {
  std::vector<bool> ticks, ways;
};

Promised promised_of(const JudgedCase& one, const JudgedReference& reference) {
  const double most_n = about_greatest * one.scene.contact.greatest_force_n;
  Promised promised;
  promised.ticks.reserve(reference.force_W_n.size());
  for (const FingerPath& way : one.ways) {
    bool was_over = false, is_whole = true;
    for (long k = 0; k < way.tick_count(); ++k) {
      const double force_n = reference.force_W_n[promised.ticks.size()].norm();
      const bool is_over = force_n > most_n || reference.slips[promised.ticks.size()];
      was_over = is_over || (was_over && force_n > 0);
      is_whole = is_whole && !was_over;
      promised.ticks.push_back(!was_over);
    }
    promised.ways.push_back(is_whole);
  }
  return promised;
}

/// Of the larger of the true force and least_n.
double error_share(const Vec3& found_n, const Vec3& true_n, double least_n) {
  return (found_n - true_n).norm() / std::max(true_n.norm(), least_n);
}

/// On the ways that the promise speaks of, and on which the force is anywhere off by half: else what was
/// crossed unfelt is a facet that stands out over the surface.
long pop_throughs_in(const JudgedCase& one, const JudgedRun& run, const JudgedReference& reference,
                     const Promised& promised) {
  long sum = 0;
  std::size_t k = 0;
  for (std::size_t way = 0; way < one.ways.size(); ++way) {
    double worst = 0;
    for (const std::size_t end = k + static_cast<std::size_t>(one.ways[way].tick_count()); k < end; ++k)
      worst = std::max(worst, error_share(run.force_W_n[k], reference.force_W_n[k],
                                          one.scene.contact.greatest_force_n / 10));
    if (promised.ways[way] && worst > 0.5) sum += run.pop_throughs[way];
  }
  return sum;
}

/// Over the ticks on which either is felt; sorted.
std::vector<double> error_shares(const std::vector<Vec3>& found_n, const std::vector<Vec3>& true_n,
                                 const Promised& promised, double least_n) {
  std::vector<double> shares;
  for (std::size_t k = 0; k < true_n.size(); ++k) {
    const double force_n = true_n[k].norm();
    if (!promised.ticks[k] || (force_n == 0 && found_n[k].squaredNorm() == 0)) continue;
    shares.push_back(error_share(found_n[k], true_n[k], least_n));
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

double quantile_99(const std::vector<double>& sorted) {
  if (sorted.empty()) return 0;
  return sorted[static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(sorted.size()))) - 1];
}

constexpr double not_judged = std::numeric_limits<double>::infinity();

bool is_judged(const JudgedCase& one, const JudgedRow& row, std::size_t variant) {
  return one.judges_all_variants || variant == row.chosen || variant + 1 == contact_variants().size();
}

/// What came of a trial, by variant.
struct Tried {
  std::vector<double> error_99;
  std::vector<long> pop_throughs;
};

Tried tried(const JudgedCase& one, const JudgedRow& row, const JudgedCase& trial) {
  const JudgedReference reference = judged_reference(trial);
  const Promised promised = promised_of(trial, reference);
  const std::size_t count = contact_variants().size();
  Tried found{std::vector<double>(count, not_judged), std::vector<long>(count, 0)};
  for (std::size_t v = 0; v < count; ++v) {
    if (!is_judged(one, row, v)) continue;
    const JudgedRun run = judged_run(trial, contact_variants()[v], 1);
    found.error_99[v] = quantile_99(
        error_shares(run.force_W_n, reference.force_W_n, promised, one.scene.contact.greatest_force_n / 10));
    found.pop_throughs[v] = pop_throughs_in(trial, run, reference, promised);
  }
  return found;
}

/// The worst of the promise's trials, by variant. On all threads: nothing is timed here.
void try_promise(const JudgedCase& one, JudgedRow& row) {
  for (std::size_t v = 0; v < contact_variants().size(); ++v)
    row.trial_99.push_back(is_judged(one, row, v) ? 0 : not_judged);
  const std::vector<JudgedCase> trials = promise_trials(one);
  std::vector<Tried> all(trials.size());
  in_parallel(
      static_cast<int>(trials.size()),
      [&](int first, int end) {
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i)
          all[i] = tried(one, row, trials[i]);
      },
      1);
  for (const Tried& trial : all) {
    for (std::size_t v = 0; v < contact_variants().size(); ++v) {
      row.trial_99[v] = std::max(row.trial_99[v], trial.error_99[v]);
      row.pop_throughs[v] += trial.pop_throughs[v];
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

JudgedWord JudgedRow::word() const {
  return word_of(std::max(error_99[chosen], trial_99[chosen]), pop_throughs[chosen] > pop_throughs.back(),
                 promised, tolerance);
}

JudgedWord JudgedRow::word_of_motion() const {
  return word_of(error_99[chosen], pop_throughs[chosen] > pop_throughs.back(), promised, tolerance);
}

std::size_t JudgedRow::cheapest(const std::vector<double>& price, bool of_promise) const {
  std::size_t best = price.size();
  for (std::size_t v = 0; v < price.size(); ++v) {
    const bool keeps = error_99[v] <= tolerance && (!of_promise || trial_99[v] <= tolerance) &&
                       pop_throughs[v] <= pop_throughs.back();
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
    const std::vector<double> shares =
        error_shares(run.force_W_n, reference.force_W_n, promised, one.scene.contact.greatest_force_n / 10);
    row.ticks = static_cast<long>(shares.size());
    row.error_99.push_back(quantile_99(shares));
    row.tick_ns.push_back(run.tick_ns);
    row.pop_throughs.push_back(pop_throughs_in(one, run, reference, promised));
  }
  try_promise(one, row);
  return row;
}

}  // namespace fingerpad
