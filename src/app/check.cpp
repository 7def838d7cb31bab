#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/commands.hpp"
#include "app/progress_bar.hpp"
#include "app/standard_streams.hpp"
#include "app/unit_option.hpp"
#include "base/number_text.hpp"
#include "contact/part_measures.hpp"
#include "contact/triangle_tree.hpp"
#include "part/import.hpp"
#include "part/mesh_format.hpp"
#include "part/unit_hint.hpp"

namespace fingerpad {
namespace {

struct CheckOptions {
  std::vector<std::string> meshes;
  std::string unit = "mm";
  bool json = false;
  bool repair = false;
};

using Json = nlohmann::ordered_json;

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json corner(const Vec3& p) {
  return {number_or_null(p.x()), number_or_null(p.y()), number_or_null(p.z())};
}

Json verdict_json(const Verdict& verdict, double thinnest_wall_m) {
  return {{"file", verdict.file},
          {"touchable", verdict.touchable},
          {"error", verdict.error},
          {"warnings", verdict.warnings},
          {"repaired", verdict.repaired},
          {"triangles", verdict.triangles},
          {"kept", verdict.kept},
          {"degenerate", verdict.degenerate},
          {"duplicate", verdict.duplicate},
          {"nonmanifold_edges", verdict.nonmanifold_edges},
          {"boundary_edges", verdict.boundary_edges},
          {"components", verdict.components},
          {"winding_consistent", verdict.winding_consistent},
          {"closed", verdict.closed},
          {"volume_m3", number_or_null(verdict.volume_m3)},
          {"bounds_m", {{"min", corner(verdict.bounds_m.min)}, {"max", corner(verdict.bounds_m.max)}}},
          {"weld_distance_m", number_or_null(verdict.weld_distance_m)},
          {"thinnest_wall_m", number_or_null(thinnest_wall_m)}};
}

/// In ASCII, so that no word of a file reaches a terminal's controls.
std::string json_text(const Json& report) {
  return report.dump(2, ' ', true, Json::error_handler_t::replace) + '\n';
}

/// A mesh's import and its thinnest wall.
std::pair<ImportedPart, double> checked(const std::string& path, const CheckOptions& options) {
  LoadBar bar(stderr_is_terminal());
  const LoadProgress progress = bar.progress(path);
  ImportOptions how;
  how.metres_per_unit = metres_of(options.unit);
  how.repair = options.repair;
  how.stream = true;
  how.progress = step_of(progress, 0, 0.5);
  ImportedPart imported = import_part(path, how);
  if (!imported.part) return {std::move(imported), std::nan("")};
  tell(progress, "building the search tree", 0.5);
  const TriangleTree tree(imported.part);
  tell(progress, "measuring its walls", 0.85);
  const double wall_m = told_wall_m(*imported.part, measure_part(*imported.part, tree));
  return {std::move(imported), wall_m};
}

int check(const CheckOptions& options) {
  bool all_touchable = true;
  Json report = Json::array();
  for (const std::string& path : options.meshes) {
    const auto [imported, wall_m] = checked(path, options);
    if (options.json) {
      report.push_back(verdict_json(imported.verdict, wall_m));
    } else if (!imported.verdict.touchable) {
      print_out("{}: refused\n", imported.verdict.file);  // the reason goes to standard error, once
    } else {
      write_stream(stdout, verdict_text(imported.verdict));
      if (std::isfinite(wall_m)) print_out("  thinnest wall  {} mm\n", rounded_text(1e3 * wall_m, 4));
    }
    const std::string hint = unit_hint(imported.verdict, metres_of(options.unit));
    if (!hint.empty()) print_err("fingerpad: {}: {}\n", imported.verdict.file, hint);
    if (!imported.verdict.touchable) {
      all_touchable = false;
      print_err("fingerpad: error: {}\n", refusal_text(imported.verdict));
    }
  }
  if (options.json) write_stream(stdout, json_text(report));
  return all_touchable ? 0 : 3;
}

}  // namespace

void add_check(CLI::App& program, Action& action) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
      program.add_subcommand("check", "The verdict on each mesh: can it be touched, and what is damaged");
  command->add_option("MESH", options->meshes, mesh_format_names("or") + " files; - is standard input")
      ->required();
  add_unit_option(*command, options->unit);
  command->add_flag("--json", options->json, "Print an array with an object for each mesh (lengths in m)");
  command->add_flag(
      "--repair", options->repair,
      "Say what `repair = true` in a scene's [[part]] would do: weld, drop degenerate and duplicate "
      "faces, make the winding right");
  command->footer("Ends 0 if every mesh can be touched, else 3.");
  command->callback([options, &action] { action = [options] { return check(*options); }; });
}

}  // namespace fingerpad
