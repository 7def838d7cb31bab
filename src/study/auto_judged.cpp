#include "study/auto_judged.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/contact_cost.hpp"

namespace fingerpad {
namespace {

/// Of the larger of the true force and least_n, over the ticks on which either is felt; sorted.
std::vector<double> error_shares(const std::vector<Vec3>& found_n, const std::vector<Vec3>& true_n,
                                 double least_n) {
  std::vector<double> shares;
  for (std::size_t k = 0; k < true_n.size(); ++k) {
    const double force_n = true_n[k].norm();
    if (force_n == 0 && found_n[k].squaredNorm() == 0) continue;
    shares.push_back((found_n[k] - true_n[k]).norm() / std::max(force_n, least_n));
  }
  std::sort(shares.begin(), shares.end());
  return shares;
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

JudgedWord JudgedRow::word() const {
  const bool pops = pop_throughs[chosen] > pop_throughs.back();
  if (pops || error_99[chosen] > promised) return JudgedWord::broken;
  if (promised <= tolerance) return JudgedWord::kept;
  return error_99[chosen] > tolerance ? JudgedWord::said : JudgedWord::needless;
}

std::size_t JudgedRow::cheapest(const std::vector<double>& price) const {
  std::size_t best = price.size();
  for (std::size_t v = 0; v < price.size(); ++v) {
    const bool keeps = error_99[v] <= tolerance && pop_throughs[v] <= pop_throughs.back();
    if (keeps && (best == price.size() || price[v] < price[best])) best = v;
  }
  return best;
}

double JudgedRow::price_ratio(const std::vector<double>& price) const {
  const std::size_t best = cheapest(price);
  return best < price.size() ? price[chosen] / price[best] : std::numeric_limits<double>::quiet_NaN();
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
  for (const Surface& surface : one.world->surfaces)
    row.triangles += surface.part ? surface.part->triangle_count() : 0;
  const std::vector<Vec3> reference_n = reference_forces(one);
  for (std::size_t v = 0; v < contact_variants().size(); ++v) {
    const ContactVariant& variant = contact_variants()[v];
    const JudgedRun run = judged_run(one, variant, turns);
    const std::vector<double> shares =
        error_shares(run.force_W_n, reference_n, one.scene.contact.greatest_force_n / 10);
    const auto count = static_cast<double>(shares.size());
    row.ticks = static_cast<long>(shares.size());
    row.error_99.push_back(shares.empty() ? 0
                                          : shares[static_cast<std::size_t>(std::ceil(0.99 * count)) - 1]);
    row.tick_ns.push_back(run.tick_ns);
    row.pop_throughs.push_back(run.pop_throughs);
    row.cost.push_back(contact_cost(variant.method_name, variant.normals_name,
                                    static_cast<int>(row.triangles), row.radius_m > 0)
                           .value_or(std::numeric_limits<double>::infinity()));
    if (variant.method_name == choice.method && variant.normals == choice.normals) row.chosen = v;
  }
  return row;
}

}  // namespace fingerpad
