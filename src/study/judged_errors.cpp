#include "study/judged_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fingerpad {
namespace {

/// Facets that cut in, and patches that stand out, leave the greatest force no exact border.
constexpr double about_greatest = 1.03;

/// Of the larger of the true force and least_n.
double error_share(const Vec3& found_n, const Vec3& true_n, double least_n) {
  return (found_n - true_n).norm() / std::max(true_n.norm(), least_n);
}

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

}  // namespace

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

JudgedErrors judged_errors(const JudgedCase& one, const JudgedRun& run, const JudgedReference& reference,
                           const Promised& promised) {
  const std::vector<double> shares =
      error_shares(run.force_W_n, reference.force_W_n, promised, one.scene.contact.greatest_force_n / 10);
  return {quantile_99(shares), static_cast<long>(shares.size()),
          pop_throughs_in(one, run, reference, promised)};
}

}  // namespace fingerpad
