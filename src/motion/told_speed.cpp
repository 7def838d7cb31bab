#include "motion/told_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fingerpad {

double speed_over_positions(std::span<const double> t_s, const Points& p_W,
                            std::span<const double> speed_m_per_s) {
  constexpr double piece_s = 0.05, far_share = 0.3;
  constexpr std::size_t fewest = 3;
  struct Piece {
    double way_m, told_m;
  };
  std::vector<Piece> pieces;
  double farthest_m = 0, told_m = 0;
  for (std::size_t from = 0, i = 1; i < t_s.size(); ++i) {
    told_m += 0.5 * (std::abs(speed_m_per_s[i]) + std::abs(speed_m_per_s[i - 1])) * (t_s[i] - t_s[i - 1]);
    if (t_s[i] - t_s[from] < piece_s) continue;
    const double way_m =
        (p_W.col(static_cast<Eigen::Index>(i)) - p_W.col(static_cast<Eigen::Index>(from))).norm();
    pieces.push_back({way_m, told_m});
    farthest_m = std::max(farthest_m, way_m);
    from = i;
    told_m = 0;
  }
  std::vector<double> ratios;
  for (const Piece& piece : pieces)
    if (piece.way_m > far_share * farthest_m) ratios.push_back(piece.told_m / piece.way_m);
  if (ratios.size() < fewest) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

}  // namespace fingerpad
