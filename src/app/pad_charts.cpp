#include "app/pad_charts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "base/tangent_frame.hpp"
#include "view/stick_region.hpp"

namespace fingerpad {
namespace {

/// A tick of stick in the pad's own axes: x lateral, y longitudinal.
struct PadTick {
  Vec2 displacement_m, friction_n;
  double angle_deg = 0;
  std::optional<StickAxes> axes;
  std::size_t row = 0;  ///< of the trace
  bool first = false;   ///< of its stick phase
};

/// Whether a pad that stuck about one place in a row sticks about another one in the next: slip came and went
/// between them, within a tick or among ticks that were left out, or another wall holds the finger more.
bool sticks_elsewhere(const Vec3& before_W, const Vec3& centre_W, const std::optional<StickAxes>& axes) {
  // The place is put on the surface anew at each tick: it may tremble by a little of what the pad gives way.
  constexpr double still_share = 0.01, still_m = 1e-6;
  const double still = axes ? still_share * std::max(axes->lateral_m, axes->longitudinal_m) : still_m;
  return (centre_W - before_W).norm() > still;
}

/// The chord stands for the way along the surface: exact on a plane, off by (way/radius)^2/24 on a curve.
std::vector<PadTick> stick_ticks(const ViewInput& input) {
  if (!input.scene || !input.world) {
    throw refused(input.title, "holds no scene, so the finger's axes are not known; record it as HDF5");
  }
  std::vector<PadTick> ticks;
  bool first = true;
  Vec3 centre_W = Vec3::Zero();
  for (std::size_t i = 0; i < input.rows.size(); ++i) {
    const TickRecord& row = input.rows[i];
    if (row.phase != Phase::stick || !row.stick_centre_W.allFinite()) {
      first = true;
      continue;
    }
    const Mat3 frame = tangent_frame(row.normal_W, input.scene->finger.direction);
    const auto in_pad = [&](const Vec3& v) -> Vec2 { return {frame.col(0).dot(v), frame.col(1).dot(v)}; };
    const SurfaceProperties& surface =
        input.world->surfaces[static_cast<std::size_t>(row.surface)].properties;
    const auto axes = stick_axes(input.scene->friction, surface, row.inclination_rad);
    if (sticks_elsewhere(std::exchange(centre_W, row.stick_centre_W), row.stick_centre_W, axes)) first = true;
    ticks.push_back({in_pad(row.contact_W - row.stick_centre_W), in_pad(row.friction_W_n),
                     row.inclination_rad * 180 / std::numbers::pi, axes, i, std::exchange(first, false)});
  }
  if (ticks.empty()) throw refused(input.title, "holds no tick of stick");
  return ticks;
}

/// Ticks by inclination: each whole degree where there are few of them, else steps of 15 degrees.
std::map<int, std::vector<const PadTick*>> by_angle(const std::vector<PadTick>& ticks) {
  constexpr std::size_t most = 7;
  std::map<int, std::vector<const PadTick*>> groups;
  for (const int step_deg : {1, 15}) {
    groups.clear();
    for (const PadTick& tick : ticks) {
      groups[static_cast<int>(std::lround(tick.angle_deg / step_deg)) * step_deg].push_back(&tick);
    }
    if (groups.size() <= most) break;
  }
  return groups;
}

/// A curve over a group's ticks with a gap between stick phases, and where ticks of one are another group's:
/// over a part that curves the finger's angle leaves its group and comes back.
template <typename X, typename Y>
ChartCurve curve_over(const std::vector<const PadTick*>& group, std::string name, const CurveStyle& style,
                      X x, Y y) {
  ChartCurve series{std::move(name), style, {}, {}};
  for (std::size_t i = 0; i < group.size(); ++i) {
    const PadTick* const tick = group[i];
    if (tick->first || (i > 0 && tick->row != group[i - 1]->row + 1)) {
      series.x.push_back(TickRecord::nan);
      series.y.push_back(TickRecord::nan);
    }
    series.x.push_back(x(*tick));
    series.y.push_back(y(*tick));
  }
  return series;
}

ChartCurve rim(const StickAxes& axes, const CurveStyle& style) {
  constexpr int points = 120;
  ChartCurve series{"the law's region", style, {}, {}};
  for (int i = 0; i <= points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    series.x.push_back(1e3 * axes.lateral_m * std::cos(angle));
    series.y.push_back(1e3 * axes.longitudinal_m * std::sin(angle));
  }
  return series;
}

}  // namespace

Chart stick_region_chart(const ViewInput& input) {
  const std::vector<PadTick> ticks = stick_ticks(input);
  ChartPanel panel;
  panel.title = "where the pad stuck";
  panel.x_label = "lateral displacement from the stick centre [mm]";
  panel.y_label = "longitudinal displacement [mm]";
  panel.equal_scales = true;
  int colour = 0;
  for (const auto& [angle_deg, group] : by_angle(ticks)) {
    const CurveStyle solid{colour, Dash::solid, Marker::none, 1.3};
    panel.curves.push_back(curve_over(
        group, fmt::format("finger at {} deg", angle_deg), solid,
        [](const PadTick& tick) { return 1e3 * tick.displacement_m.x(); },
        [](const PadTick& tick) { return 1e3 * tick.displacement_m.y(); }));
    if (const auto& axes = group[group.size() / 2]->axes) {
      panel.curves.push_back(rim(*axes, {colour, Dash::dashed, Marker::none, 0.8}));
    }
    ++colour;
  }
  Chart chart{"", input.title + ": stick region by the finger's angle", {}, 1, {std::move(panel)}};
  return chart;
}

Chart force_displacement_chart(const ViewInput& input) {
  const std::vector<PadTick> ticks = stick_ticks(input);
  Chart chart{"", input.title + ": friction against displacement in stick", {}, 2, {}};
  const char* names[] = {"lateral", "longitudinal"};
  for (int axis = 0; axis < 2; ++axis) {
    ChartPanel panel;
    panel.title = names[axis];
    panel.x_label = "displacement from the stick centre [mm]";
    panel.y_label = "friction on the finger [N]";
    int colour = 0;
    for (const auto& [angle_deg, group] : by_angle(ticks)) {
      const CurveStyle style{colour++, Dash::solid, Marker::none, 1.3};
      panel.curves.push_back(curve_over(
          group, fmt::format("finger at {} deg", angle_deg), style,
          [axis](const PadTick& tick) { return 1e3 * tick.displacement_m[axis]; },
          [axis](const PadTick& tick) { return tick.friction_n[axis]; }));
    }
    chart.panels.push_back(std::move(panel));
  }
  return chart;
}

}  // namespace fingerpad
