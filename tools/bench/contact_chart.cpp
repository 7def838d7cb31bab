// Draws what bench_contact measured, and prints it as a Markdown table.
//   build/bin/contact_chart contact.json CHART.svg
// The times of one run stand side by side; where its machine was busy, all of them are longer.

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "view/plot.hpp"

namespace fingerpad::bench {
namespace {

struct Method {
  const char* key;
  const char* name;
  CurveStyle style;
};

const Method methods[] = {
    {"fingerpad", "fingerpad", {0, Dash::solid, Marker::disc, 1.4}},
    {"one_by_one", "Embree, a primitive a triangle", {1, Dash::dashed, Marker::square}},
    {"wide_tree", "hand-written tree, same packets", {2, Dash::dash_dot, Marker::triangle}},
    {"cgal_hint", "CGAL AABB tree with hint", {3, Dash::dotted, Marker::diamond}},
    {"vtk_static", "vtkStaticCellLocator", {4, Dash::dashed, Marker::cross}},
};

/// A panel: which cases, and which figure of theirs.
struct Question {
  const char* title;
  const char* kind;
  const char* counter;  ///< null: the mean time of an iteration
};

const Question questions[] = {
    {"along a path: mean", "coherent", nullptr},
    {"along a path: 99th percentile", "coherent", "p99_ns"},
    {"random points: mean", "random", nullptr},
    {"caches emptied before each query: mean", "cold", "mean_ns"},
};

const std::string spheres[] = {"sphere_1k", "sphere_20k", "sphere_328k", "sphere_1311k"};
const std::map<std::string, double> triangle_counts = {{"sphere_1k", 1280},
                                                       {"sphere_20k", 20480},
                                                       {"sphere_328k", 327680},
                                                       {"sphere_1311k", 1310720},
                                                       {"drilled_plate", 52584}};

/// The benchmark's figures by case.
class Figures {
 public:
  explicit Figures(const nlohmann::json& file) {
    for (const auto& entry : file.at("benchmarks")) {
      // Case names go on with "/iterations:N" where that is fixed.
      std::string name = entry.at("name");
      name = name.substr(0, name.find("/iterations"));
      cases_[name] = entry;
    }
  }

  std::optional<double> find(const std::string& mesh, const std::string& method,
                             const Question& question) const {
    const auto found = cases_.find(mesh + "/" + question.kind + "/" + method);
    if (found == cases_.end()) return {};
    return found->second.at(question.counter == nullptr ? "cpu_time" : question.counter).get<double>();
  }

  /// How many times faster fingerpad is than a method, asked in turn.
  std::optional<double> paired(const std::string& mesh, const std::string& kind,
                               const std::string& method) const {
    const auto found = cases_.find(mesh + "/" + kind + "/paired_with_" + method);
    if (found == cases_.end()) return {};
    return found->second.at("times_faster").get<double>();
  }

 private:
  std::map<std::string, nlohmann::json> cases_;
};

ChartPanel panel_of(const Figures& figures, const Question& question) {
  ChartPanel panel{question.title, "triangles", "time of a query [ns]", true, true, {}, {}, false};
  for (const Method& method : methods) {
    ChartCurve line{method.name, method.style, {}, {}};
    for (const std::string& mesh : spheres) {
      if (const auto ns = figures.find(mesh, method.key, question)) {
        line.x.push_back(triangle_counts.at(mesh));
        line.y.push_back(*ns);
      }
    }
    if (!line.x.empty()) panel.curves.push_back(line);
    if (const auto ns = figures.find("drilled_plate", method.key, question)) {
      CurveStyle alone = method.style;
      alone.dash = Dash::none;
      panel.curves.push_back({method.name, alone, {triangle_counts.at("drilled_plate")}, {*ns}});
    }
  }
  return panel;
}

/// Where Embree's search costs over 1.3 times a hand-written tree's, and where not.
std::string embree_note(const Figures& figures) {
  const auto range = [&](const char* kind) {
    double least = HUGE_VAL, greatest = 0;
    for (const auto& [mesh, count] : triangle_counts) {
      if (const auto faster = figures.paired(mesh, kind, "wide_tree")) {
        least = std::min(least, 1 / *faster);
        greatest = std::max(greatest, 1 / *faster);
      }
    }
    return std::pair(least, greatest);
  };
  const auto [path_least, path_greatest] = range("coherent");
  const auto [random_least, random_greatest] = range("random");
  return fmt::format(
      "Against the hand-written tree fingerpad takes {:.2f} to {:.2f} times as long along a path, and {:.2f} "
      "to {:.2f} times at random points{}.",
      path_least, path_greatest, random_least, random_greatest,
      random_greatest > 1.3 ? ": over 1.3 times, Embree's price" : "");
}

void print_table(const Figures& figures) {
  fmt::print(
      "| mesh | ns a query | p99 | cold | a primitive a triangle | hand-written tree | CGAL | VTK |\n");
  fmt::print("|---|---|---|---|---|---|---|---|\n");
  const auto cell = [](const std::optional<double>& value, const char* form) {
    return value ? fmt::format(fmt::runtime(form), *value) : std::string("-");
  };
  for (const std::string kind : {"coherent", "random"}) {
    const bool coherent = kind == "coherent";
    for (const std::string& mesh :
         {spheres[0], spheres[1], spheres[2], spheres[3], std::string("drilled_plate")}) {
      fmt::print("| {}, {} | {} | {} | {} |", mesh, coherent ? "path" : "random",
                 cell(figures.find(mesh, "fingerpad", questions[coherent ? 0 : 2]), "{:.0f}"),
                 coherent ? cell(figures.find(mesh, "fingerpad", questions[1]), "{:.0f}") : "-",
                 coherent ? cell(figures.find(mesh, "fingerpad", questions[3]), "{:.0f}") : "-");
      for (std::size_t k = 1; k < std::size(methods); ++k)
        fmt::print(" {} |", cell(figures.paired(mesh, kind, methods[k].key), "{:.2g}x"));
      fmt::print("\n");
    }
  }
}

int run(const std::string& from, const std::string& chart_path) {
  std::ifstream file(from);
  if (!file) {
    std::cerr << from << ": cannot be read\n";
    return 1;
  }
  const Figures figures(nlohmann::json::parse(file));
  print_table(figures);
  Chart chart;
  chart.name = "contact_speed";
  chart.title = "Closest points: time of a query against size";
  chart.notes = {
      "Spheres of 1 m, joined; lone marks: a drilled plate of 52,584 slivers. A path goes 0.1 mm a query.",
      embree_note(figures)};
  chart.columns = 2;
  for (const Question& question : questions) chart.panels.push_back(panel_of(figures, question));
  write_chart(chart, chart_path);
  return 0;
}

}  // namespace
}  // namespace fingerpad::bench

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: contact_chart CONTACT.json CHART.svg\n";
    return 2;
  }
  try {
    return fingerpad::bench::run(argv[1], argv[2]);
  } catch (const std::exception& e) {
    std::cerr << argv[1] << ": " << e.what() << "\n";
    return 1;
  }
}
