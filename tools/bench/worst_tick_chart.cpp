// Draws what bench_worst_tick measured.
//   build/bench/bin/worst_tick_chart WORST.json CHART.svg

#include <exception>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "view/plot.hpp"

namespace fingerpad::bench {
namespace {

struct Figure {
  const char *key, *name;
  CurveStyle style;
};
const Figure figures[] = {{"p50_us", "median", {0, Dash::none, Marker::disc}},
                          {"p999_us", "p99.9", {1, Dash::none, Marker::square}},
                          {"worst_us", "worst", {3, Dash::none, Marker::triangle}}};

struct Question {
  const char *kind, *title;
};
const Question questions[] = {{"tight", "parts that a ball fits tightly, and a fan of slivers"},
                              {"sphere", "spheres of 0.1 m, point and ball of 1 mm"},
                              {"mesh", "meshes: point and balls of 0.5 to 20 mm"}};

ChartPanel panel_of(const nlohmann::json& parts, const Question& question) {
  ChartPanel panel{question.title, "triangles", "time of a tick [us]", true, true, {}, {}, false};
  panel.levels.push_back({"a fifth of a servo's millisecond", 200});
  for (const Figure& figure : figures) {
    ChartCurve curve{figure.name, figure.style, {}, {}};
    for (const auto& part : parts) {
      if (part.at("kind") != question.kind) continue;
      curve.x.push_back(part.at("triangles"));
      curve.y.push_back(part.at(figure.key));
    }
    if (!curve.x.empty()) panel.curves.push_back(std::move(curve));
  }
  return panel;
}

int run(const std::string& from, const std::string& chart_path) {
  std::ifstream file(from);
  if (!file) {
    std::cerr << from << ": cannot be read\n";
    return 1;
  }
  const auto parts = nlohmann::json::parse(file);
  Chart chart;
  chart.name = "worst_ticks";
  chart.title = "A whole tick: proxy, smooth normals, finger pad";
  chart.notes = {
      "Rubbed, struck and jumped about at 1 kHz; the least of five times of each tick. Dashed: 200 us."};
  chart.columns = 2;
  for (const Question& question : questions) {
    ChartPanel panel = panel_of(parts, question);
    if (!panel.curves.empty()) chart.panels.push_back(std::move(panel));
  }
  write_chart(chart, chart_path);
  return 0;
}

}  // namespace
}  // namespace fingerpad::bench

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: worst_tick_chart WORST.json CHART.svg\n";
    return 2;
  }
  try {
    return fingerpad::bench::run(argv[1], argv[2]);
  } catch (const std::exception& e) {
    std::cerr << argv[1] << ": " << e.what() << "\n";
    return 1;
  }
}
