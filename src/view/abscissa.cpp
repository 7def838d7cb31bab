#include "view/abscissa.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "view/axis.hpp"
#include "view/touch_series.hpp"

namespace fingerpad {
namespace {

/// The angle between two unit vectors [deg], exact for small ones too.
double angle_deg(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

double advance(const TickRecord& before, const TickRecord& row, Over over) {
  if (over == Over::travel) {
    const double speed_m_per_s = tangential_speed(before, row);
    return std::isfinite(speed_m_per_s) ? 1e3 * speed_m_per_s * (row.t_s - before.t_s) : 0;
  }
  if (before.phase == Phase::free || row.phase == Phase::free) return 0;
  return angle_deg(before.normal_W, row.normal_W);
}

}  // namespace

std::vector<double> abscissa(std::span<const TickRecord> rows, Over over) {
  std::vector<double> x;
  x.reserve(rows.size());
  double sum = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && over != Over::time) sum += advance(rows[i - 1], rows[i], over);
    x.push_back(over == Over::time ? rows[i].t_s : sum);
  }
  return x;
}

std::string_view abscissa_label(Over over) noexcept {
  switch (over) {
    case Over::travel:
      return "travel along the surface [mm]";
    case Over::turn:
      return "turn of the surface under the finger [deg]";
    case Over::time:
      break;
  }
  return "time [s]";
}

std::string_view shortened_words(Over over) noexcept {
  return over == Over::travel
             ? "travel: summed from each tick that is here to the next; with those between it is longer"
             : "turn: summed from each tick that is here to the next; with those between it is larger";
}

void refuse_standstill(const std::vector<double>& x, Over over, const std::string& where) {
  if (over == Over::time) return;
  if (!x.empty() && x.back() - x.front() > least_span(abscissa_label(over))) return;
  throw refused(where, over == Over::travel
                           ? "never slides along a surface: nothing to plot over its travel"
                           : "stays where the surface does not turn: nothing to plot over its turn");
}

void put_over(Chart& chart, const std::vector<double>& x, std::string_view label) {
  for (ChartPanel& panel : chart.panels) {
    panel.x_label = label;
    for (ChartCurve& curve : panel.curves) curve.x = x;
  }
  if (chart.band) chart.band->x = x;
}

}  // namespace fingerpad
