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
    {"closest-point", "facet", false, {0.76, 1.00, 1.01, 1.07, 1.22, 1.57, 2.47}},
    {"closest-point", "smooth", false, {0.81, 1.12, 1.12, 1.19, 1.32, 1.68, 2.59}},
    {"closest-point", "curved", false, {2.44, 2.64, 2.64, 2.67, 2.80, 3.11, 3.99}},
    {"proxy", "facet", false, {0.44, 0.69, 0.79, 0.98, 1.37, 2.30, 3.90}},
    {"proxy", "smooth", false, {0.50, 0.82, 0.91, 1.12, 1.49, 2.34, 3.83}},
    {"proxy", "curved", false, {0.78, 1.52, 1.61, 1.80, 2.18, 3.06, 4.52}},
    {"closest-point", "facet", true, {0.94, 1.14, 1.21, 1.40, 1.93, 3.49, 7.89}},
    {"closest-point", "smooth", true, {0.97, 1.25, 1.31, 1.50, 2.02, 3.59, 7.84}},
    {"closest-point", "curved", true, {3.09, 3.23, 3.23, 3.35, 3.87, 5.48, 9.69}},
    {"proxy", "facet", true, {1.03, 1.76, 2.63, 4.41, 7.10, 14.43, 36.68}},
    {"proxy", "smooth", true, {1.08, 1.92, 2.81, 4.64, 7.40, 14.88, 37.51}},
    {"proxy", "curved", true, {1.27, 2.61, 3.50, 5.33, 8.09, 15.60, 38.21}},
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
