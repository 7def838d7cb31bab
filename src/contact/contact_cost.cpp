#include "contact/contact_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace fingerpad {
namespace {

constexpr std::array cost_counts{256.0, 1024.0, 4096.0, 16384.0, 65536.0, 262144.0, 1048576.0};

struct CostRow {
  std::string_view method, normals;
  bool has_radius;
  std::array<double, cost_counts.size()> cost;  ///< at these counts
};

// Printed by bench_contact_cost: rubs over a torus, without friction, at 1 kHz and 0.1 m/s.
constexpr CostRow cost_table[] = {
    {"closest-point", "facet", false, {0.86, 1.00, 1.01, 1.04, 1.09, 1.23, 1.52}},
    {"closest-point", "smooth", false, {0.92, 1.18, 1.17, 1.20, 1.25, 1.40, 1.67}},
    {"closest-point", "curved", false, {2.37, 2.53, 2.56, 2.59, 2.61, 2.72, 2.93}},
    {"proxy", "facet", false, {0.33, 0.52, 0.66, 0.92, 1.34, 2.36, 4.11}},
    {"proxy", "smooth", false, {0.40, 0.67, 0.79, 1.06, 1.49, 2.39, 3.90}},
    {"proxy", "curved", false, {0.62, 1.20, 1.33, 1.61, 2.01, 2.95, 4.48}},
    {"closest-point", "facet", true, {1.03, 1.19, 1.26, 1.35, 1.51, 1.82, 2.46}},
    {"closest-point", "smooth", true, {1.07, 1.33, 1.39, 1.50, 1.66, 1.96, 2.60}},
    {"closest-point", "curved", true, {3.03, 3.12, 3.14, 3.20, 3.35, 3.65, 4.28}},
    {"proxy", "facet", true, {0.80, 1.38, 2.31, 4.20, 6.97, 10.19, 20.47}},
    {"proxy", "smooth", true, {0.84, 1.54, 2.49, 4.43, 7.25, 10.47, 20.45}},
    {"proxy", "curved", true, {1.00, 2.08, 3.02, 5.00, 7.78, 11.25, 21.02}},
};

/// Between the table's counts, in their logarithm.
double cost_at(const CostRow& row, double count) noexcept {
  if (!(count > cost_counts.front())) return row.cost.front();
  for (std::size_t i = 1; i < cost_counts.size(); ++i) {
    if (count > cost_counts[i]) continue;
    const double along = std::log(count / cost_counts[i - 1]) / std::log(cost_counts[i] / cost_counts[i - 1]);
    return row.cost[i - 1] + along * (row.cost[i] - row.cost[i - 1]);
  }
  return row.cost.back();
}

}  // namespace

std::optional<double> contact_cost(std::string_view method, std::string_view normals, int count,
                                   bool has_radius) noexcept {
  const auto* row = std::find_if(std::begin(cost_table), std::end(cost_table), [&](const CostRow& r) {
    return r.method == method && r.normals == normals && r.has_radius == has_radius;
  });
  if (row == std::end(cost_table)) return std::nullopt;
  return cost_at(*row, count);
}

}  // namespace fingerpad
