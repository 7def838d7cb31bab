#include "study/press_corner.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <vector>

namespace fingerpad {
namespace {

/// The squares that the best parabola leaves.
double left_by_parabola(std::span<const double> force_n) {
  const auto count = static_cast<Eigen::Index>(force_n.size());
  Eigen::MatrixX3d powers(count, 3);
  powers.col(0).setOnes();
  powers.col(1).setLinSpaced(-1, 1);
  powers.col(2) = powers.col(1).cwiseAbs2();
  const Eigen::Map<const Eigen::VectorXd> force(force_n.data(), count);
  const Eigen::Vector3d best = powers.colPivHouseholderQr().solve(force);
  return (force - powers * best).squaredNorm();
}

/// The squares that the best level leaves on one side of its middle, with a ramp that begins no later than
/// `latest`: a straight one, or one that begins slowly, as a hand's does (half of a parabola).
/// @param side_n  from the middle on, outward
double left_by_ramp(std::span<const double> side_n, std::size_t latest) {
  constexpr std::size_t places = 16;
  const auto count = static_cast<double>(side_n.size());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t place = 0; place <= places; ++place) {
    const std::size_t begin = latest * place / places;
    for (const bool is_straight : {true, false}) {
      double x = 0, xx = 0, y = 0, xy = 0, yy = 0;
      for (std::size_t i = 0; i < side_n.size(); ++i) {
        const double way = i > begin ? static_cast<double>(i - begin) : 0;
        const double shape = is_straight ? way : way * way, off_n = side_n[i] - side_n[0];
        x += shape;
        xx += shape * shape;
        y += off_n;
        xy += shape * off_n;
        yy += off_n * off_n;
      }
      const double spread = xx - x * x / count, common = xy - x * y / count;
      least = std::min(least, yy - y * y / count - (spread > 0 ? common * common / spread : 0));
    }
  }
  return least;
}

}  // namespace

bool leaves_in_corners(std::span<const double> force_n, std::size_t from, std::size_t to, std::size_t reach) {
  constexpr double plainly_less = 0.95;
  const std::size_t middle = (from + to) / 2;
  const std::vector<double> before(force_n.rend() - static_cast<std::ptrdiff_t>(middle), force_n.rend());
  const double ramps =
      left_by_ramp(before, std::min(middle - from + reach, middle)) +
      left_by_ramp(force_n.subspan(middle), std::min(to - middle + reach, force_n.size() - middle));
  return ramps < plainly_less * left_by_parabola(force_n);
}

}  // namespace fingerpad
