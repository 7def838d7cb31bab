#include "creep_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/report.hpp"

namespace fingerpad::bench {
namespace {

/// Where the chart draws what is less or nothing, as a logarithmic axis has no place for it.
constexpr double least_m = 1e-6, least_m_per_s = 1e-10;
constexpr double shown_share = 0.9;
constexpr double table_shares[] = {0.5, 0.9, 0.99};

const HeldPush& at_share(const CreepFindings& one, double share) {
  return *std::find_if(one.held.begin(), one.held.end(),
                       [share](const HeldPush& held) { return held.share == share; });
}

ChartPanel travel_panel(const std::vector<CreepFindings>& findings) {
  ChartPanel panel{fmt::format("pushed with {} of mu n", shown_share),
                   "time since the push is full [s]",
                   "way since before the push [m]",
                   false,
                   true,
                   {},
                   {}};
  panel.levels.push_back({"", least_m});
  for (const CreepFindings& one : findings) {
    const HeldPush& held = at_share(one, shown_share);
    ChartCurve curve{one.program.name, one.program.style, {}, {}};
    curve.style.marker = Marker::none;
    for (std::size_t k = 0; k < held.t_s.size(); ++k) {
      if (held.t_s[k] < 0) continue;
      curve.x.push_back(held.t_s[k]);
      curve.y.push_back(std::max(std::abs(held.travelled_m[k]), least_m));
    }
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

ChartPanel speed_panel(const std::vector<CreepFindings>& findings) {
  ChartPanel panel{"mean speed over the last 2 of 10 s", "push [mu n]", "|creep| [m/s]", false, true, {}, {}};
  panel.levels.push_back({"", least_m_per_s});
  for (const CreepFindings& one : findings) {
    ChartCurve curve{one.program.name, one.program.style, {}, {}};
    for (const HeldPush& held : one.held) {
      curve.x.push_back(held.share);
      curve.y.push_back(std::max(std::abs(held.creep_m_per_s), least_m_per_s));
    }
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

std::string period_cell(const StickSlipCycle& cycle) {
  return cycle.cycles > 0 ? fmt::format("{:.4f}", cycle.period_s) : "none";
}

bool always_gives_way(const CreepFindings& one) {
  return std::all_of(one.held.begin(), one.held.end(), [](const HeldPush& held) { return held.gives_way; });
}

}  // namespace

Chart creep_chart(const std::vector<CreepFindings>& findings) {
  Chart chart;
  chart.name = "creep";
  chart.title = "A block pushed with less than friction holds: does it stand still?";
  chart.notes = {"1 kg on a plane, mu 0.3, 1 kHz; the push rises over 1 s and is held for 10 s.",
                 "On the dashed lines: 0, or less than 1e-10 m/s and 1e-6 m."};
  chart.columns = 2;
  chart.panels = {speed_panel(findings), travel_panel(findings)};
  return chart;
}

std::string creep_csv(const std::vector<CreepFindings>& findings) {
  StudyTable table{"creep", {"program"}, {}};
  for (const HeldPush& held : findings.front().held)
    table.columns.push_back(fmt::format("creep_at_{}_m_per_s", held.share));
  for (const char* column : {"gives_way_at_1.2", "undamped_period_s", "damped_period_s", "step_ns"})
    table.columns.emplace_back(column);
  for (const CreepFindings& one : findings) {
    std::vector<StudyTable::Cell> row{one.program.name};
    for (const HeldPush& held : one.held) row.emplace_back(held.creep_m_per_s);
    row.emplace_back(always_gives_way(one) ? "yes" : "no");
    row.emplace_back(one.undamped.period_s);
    row.emplace_back(one.damped.period_s);
    row.emplace_back(one.step_ns);
    table.rows.push_back(std::move(row));
  }
  return table.csv();
}

std::string creep_table(const std::vector<CreepFindings>& findings) {
  std::string table = fmt::format(
      "| program | creep at 0.5 mu n [mm/s] | at 0.9 | at 0.99 | slides at 1.2 | period, {:.4f} s | damped, "
      "{:.4f} s | "
      "a step [ns] |\n|---|---|---|---|---|---|---|---|\n",
      rigid_cycle(undamped_block).period_s, rigid_cycle(damped_block).period_s);
  for (const CreepFindings& one : findings) {
    table += fmt::format("| {} |", one.program.name);
    for (const double share : table_shares)
      table += fmt::format(" {:.2g} |", 1e3 * at_share(one, share).creep_m_per_s);
    table += fmt::format(" {} | {} | {} | {:.0f} |\n", always_gives_way(one) ? "yes" : "no",
                         period_cell(one.undamped), period_cell(one.damped), one.step_ns);
  }
  return table;
}

}  // namespace fingerpad::bench
