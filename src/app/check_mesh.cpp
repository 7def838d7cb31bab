#include "app/check_mesh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "app/progress_bar.hpp"
#include "app/standard_streams.hpp"
#include "base/number_text.hpp"
#include "contact/part_measures.hpp"
#include "part/unit_hint.hpp"

namespace fingerpad {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json verdict_json(const Verdict& verdict, double thinnest_wall_m) {
  return {
      {"file", verdict.file},
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
      {"bounds_m", {{"min", place_json(verdict.bounds_m.min)}, {"max", place_json(verdict.bounds_m.max)}}},
      {"weld_distance_m", number_or_null(verdict.weld_distance_m)},
      {"thinnest_wall_m", number_or_null(thinnest_wall_m)}};
}

/// What an overlap comes from, and what to do.
const char* overlap_words(const PartMeasures& measures, int components) {
  if (measures.open_edges > 0 || measures.contradicting_edges > 0)
    return "that may come from its holes or its winding, which are to be mended first";
  return components > 1 ? "its bodies lie in one another, and are felt as one solid; join them in CAD if "
                          "that is not meant"
                        : "its surface passes through itself; mend it in CAD if that is not meant";
}

}  // namespace

Json place_json(const Vec3& p) {
  return {number_or_null(p.x()), number_or_null(p.y()), number_or_null(p.z())};
}

CheckedMesh checked(const std::string& path, ImportOptions how) {
  LoadBar bar(stderr_is_terminal());
  const LoadProgress progress = bar.progress(path);
  how.stream = true;
  how.progress = step_of(progress, 0, 0.5);
  CheckedMesh mesh;
  mesh.metres_per_unit = how.metres_per_unit;
  mesh.imported = import_part(path, how);
  if (!mesh.imported.part) return mesh;
  tell(progress, "building the search tree", 0.5);
  mesh.tree = std::make_shared<TriangleTree>(mesh.imported.part);
  tell(progress, "measuring its walls", 0.85);
  const PartMeasures measures = measure_part(*mesh.imported.part, *mesh.tree);
  mesh.wall_m = told_wall_m(*mesh.imported.part, measures);
  if (measures.overlap_count > 0)
    mesh.imported.verdict.warnings.push_back(
        fmt::format("overlapping: at {} of {} places looked at something else of the part begins before the "
                    "wall ends: {}",
                    measures.overlap_count, measures.ray_count,
                    overlap_words(measures, mesh.imported.verdict.components)));
  return mesh;
}

bool tell_mesh(const CheckedMesh& mesh, bool as_json, Json& report) {
  const Verdict& verdict = mesh.imported.verdict;
  const std::string hint = unit_hint(verdict, mesh.metres_per_unit);
  if (as_json) {
    report.push_back(verdict_json(verdict, mesh.wall_m));
    report.back()["metres_per_unit"] = mesh.metres_per_unit;
    report.back()["hint"] = hint;
  } else if (!verdict.touchable) {
    print_out("{}: refused\n", verdict.file);  // the reason goes to standard error, once
  } else {
    write_stream(stdout, verdict_text(verdict));
    if (std::isfinite(mesh.wall_m)) print_out("  thinnest wall  {} mm\n", rounded_text(1e3 * mesh.wall_m, 4));
  }
  if (!hint.empty()) print_err("fingerpad: {}: {}\n", verdict.file, hint);
  if (!verdict.touchable) print_err("fingerpad: error: {}\n", refusal_text(verdict));
  return verdict.touchable;
}

}  // namespace fingerpad
