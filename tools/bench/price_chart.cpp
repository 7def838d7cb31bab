// Draws what `study scene` found for several scenes as one chart, a panel each, and prints it as a Markdown
// table.
//   build/bin/price_chart CHART.svg "Title of a panel" choices.csv ["Title" choices.csv]...

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

#include "study/contact_runs.hpp"
#include "view/plot.hpp"

namespace fingerpad::bench {
namespace {

/// A row of choices.csv by its columns' names.
using Row = std::map<std::string, std::string>;

/// A scene's choices, the model's the last.
struct Priced {
  std::string title;
  std::vector<Row> rows;
};

/// Cells of a line; the one that may hold commas, "loses", is the last and not needed.
std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream text(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

Priced read_choices(const std::string& title, const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error(path + ": cannot be read");
  const std::vector<std::string> names = cells_of(line);
  Priced priced{title, {}};
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cells_of(line);
    Row& row = priced.rows.emplace_back();
    for (std::size_t i = 0; i < std::min(names.size(), cells.size()); ++i) row[names[i]] = cells[i];
  }
  if (priced.rows.size() < 2) throw std::runtime_error(path + ": has no choices");
  return priced;
}

double number(const Row& row, const std::string& column) {
  return std::stod(row.at(column));
}

constexpr double least_drawn = 1e-4;  // so that a logarithmic axis can show what is exact

/// Processor time for a millisecond of touch [ns]: at 1 kHz that of a tick.
double cost_of(const Row& row) {
  return 1e-3 * number(row, "ns_per_tick") * number(row, "rate_hz");
}

double error_of(const Row& row) {
  return std::max(least_drawn, number(row, "force_rms_share"));
}

bool is_marked(const Row& row, const std::string& mark) {
  return row.at("mark").find(mark) != std::string::npos;
}

const Row* marked(const Priced& priced, const std::string& mark) {
  const auto found = std::find_if(priced.rows.begin(), priced.rows.end(),
                                  [&](const Row& row) { return is_marked(row, mark); });
  return found == priced.rows.end() ? nullptr : &*found;
}

/// One method with one kind of normals and one reading of events, from the slowest rate to the fastest.
ChartCurve curve_of(const Priced& priced, const ContactVariant& variant, const std::string& events) {
  ChartCurve curve{events == "exact" ? variant.name() : "", variant.style, {}, {}};
  if (events != "exact") curve.style.dash = Dash::dotted;
  for (const Row& row : priced.rows) {
    if (row.at("method") != variant.method_name || row.at("normals") != variant.normals_name ||
        row.at("events") != events || is_marked(row, "model"))
      continue;
    curve.x.push_back(cost_of(row));
    curve.y.push_back(error_of(row));
  }
  return curve;
}

ChartPanel panel_of(const Priced& priced) {
  ChartPanel panel{priced.title,
                   "processor time [ns per ms of touch]; at 1 kHz: of a tick",
                   "force error [share, RMS]",
                   true,
                   true,
                   {},
                   {}};
  std::vector<std::pair<double, double>> all;
  double most = least_drawn, least = 1;
  for (const char* events : {"exact", "tick"}) {
    for (const ContactVariant& variant : contact_variants()) {
      ChartCurve curve = curve_of(priced, variant, events);
      if (curve.x.empty()) continue;
      for (std::size_t i = 0; i < curve.x.size(); ++i) {
        all.emplace_back(curve.x[i], curve.y[i]);
        most = std::max(most, curve.y[i]);
        least = std::min(least, curve.y[i]);
      }
      panel.curves.push_back(std::move(curve));
    }
  }
  panel.pareto_front = pareto_front(std::move(all));
  if (const Row* automatic = marked(priced, "auto")) {
    panel.curves.push_back({"what auto chooses",
                            {palette::ink, Dash::none, Marker::ring, 2.6},
                            {cost_of(*automatic)},
                            {error_of(*automatic)}});
  }
  if (const Row* model = marked(priced, "model")) {
    const double ns = cost_of(*model);
    panel.curves.push_back({"the model, at 40 kHz",
                            {palette::grey, Dash::dashed, Marker::none, 1.4},
                            {ns, ns},
                            {least, 2 * most}});
  }
  return panel;
}

std::string choice_text(const Row& row) {
  return fmt::format("{}, {}, {} Hz", row.at("method"), row.at("normals"), row.at("rate_hz"));
}

void print_row(const Priced& priced) {
  const auto cells = [&](const std::string& mark) {
    const Row* row = marked(priced, mark);
    if (row == nullptr) return std::string("| - | - | - | - ");
    return fmt::format("| {} | {:.0f} | {:.2g} | {:.2g} ", choice_text(*row), number(*row, "ns_per_tick"),
                       100 * number(*row, "load_share"), 100 * number(*row, "force_rms_share"));
  };
  const Row& model = *marked(priced, "model");
  fmt::print("| {} {}{}| {:.0f} | {:.2g} |\n", priced.title, cells("auto"), cells("cheapest"),
             number(model, "ns_per_tick"), 100 * number(model, "load_share"));
}

int run(const std::vector<std::string>& words) {
  Chart chart{"prices",
              "The price of each promise",
              {"Each curve is one method with one kind of normals, from 250 Hz to 20 kHz, over the scene's "
               "own motion; "
               "dotted: events at ticks only.",
               "The model: proxy, curved normals, 40 kHz. Errors of the whole force, teeth and "
               "all; those "
               "under 1e-4 are drawn there. Times of one machine."},
              2,
              {}};
  fmt::print(
      "| scene | auto | ns a tick | % of a core | force error % | cheapest that keeps the tolerances | ns a "
      "tick "
      "| % of a core | force error % | model: ns a tick | % of a core |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (std::size_t i = 1; i + 1 < words.size(); i += 2) {
    const Priced priced = read_choices(words[i], words[i + 1]);
    chart.panels.push_back(panel_of(priced));
    print_row(priced);
  }
  write_chart(chart, words[0]);
  return 0;
}

}  // namespace
}  // namespace fingerpad::bench

int main(int argc, char** argv) {
  if (argc < 4 || argc % 2 != 0) {
    std::cerr << "usage: price_chart CHART.svg TITLE CHOICES.csv [TITLE CHOICES.csv]...\n";
    return 2;
  }
  try {
    return fingerpad::bench::run({argv + 1, argv + argc});
  } catch (const std::exception& e) {
    std::cerr << "price_chart: " << e.what() << "\n";
    return 1;
  }
}
