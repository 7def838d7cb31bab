#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/output_name.hpp"
#include "app/progress_bar.hpp"
#include "app/standard_streams.hpp"
#include "app/unit_option.hpp"
#include "base/csv_columns.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/input_file.hpp"
#include "base/number_text.hpp"
#include "base/output_place.hpp"
#include "base/unit.hpp"
#include "contact/surface_point.hpp"
#include "contact/triangle_tree.hpp"
#include "part/import.hpp"
#include "part/mesh_format.hpp"
#include "part/unit_hint.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

struct QueryOptions {
  std::string mesh, points, out = "-";
  std::string unit = "mm";
};

constexpr const char* header = "distance_m,px_m,py_m,pz_m,nx,ny,nz,triangle\n";

void append_row(std::string& text, const SurfacePoint& near, const Part& part) {
  const Vec3& p = near.point_P;
  const Vec3& n = near.pseudonormal_P;
  for (const double value : {near.signed_distance_m, p.x(), p.y(), p.z(), n.x(), n.y(), n.z()}) {
    append_number(text, value);
    text += ',';
  }
  text += fmt::format("{}\n", part.file_triangle[static_cast<std::size_t>(near.triangle)]);
}

/// Writes the table in pieces, since it can be ten times as large as the points.
/// @returns how far the nearest point is from the surface [m]; infinite without one
double write_answers(const TriangleTree& tree, const CsvColumns& points,
                     const std::function<void(std::string_view)>& write) {
  constexpr std::size_t piece_bytes = std::size_t{1} << 20;
  std::string text = header;
  int seed = -1;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.lines.size(); ++i) {
    const Vec3 p(points.columns[0][i], points.columns[1][i], points.columns[2][i]);
    const SurfacePoint near =
        nearest_surface_point(tree, p, Normals::facet, seed, std::numeric_limits<double>::infinity());
    seed = near.triangle;
    least_m = std::min(least_m, std::abs(near.signed_distance_m));
    append_row(text, near, tree.part());
    if (text.size() < piece_bytes) continue;
    write(text);
    text.clear();
  }
  write(text);
  return least_m;
}

/// The units in which the points would lie about the part, the likeliest first: in which both are about as
/// large, and in none of which one is a hundred times the other.
std::string likelier_units(const Eigen::AlignedBox3d& part, const CsvColumns& points) {
  constexpr double most_unlike = 100;
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < points.lines.size(); ++i)
    box.extend(Vec3(points.columns[0][i], points.columns[1][i], points.columns[2][i]));
  std::vector<std::pair<double, std::string>> units;
  for (const LengthUnit& unit : length_units) {
    const Eigen::AlignedBox3d scaled(unit.metres * box.min(), unit.metres * box.max());
    if (unit.metres == 1 || part.exteriorDistance(scaled) > part.diagonal().norm()) continue;
    const double farthest_m = part.center().norm() + part.diagonal().norm() / 2,
                 reach_m = std::max(scaled.min().norm(), scaled.max().norm());
    const double times = reach_m / farthest_m;
    if (times < most_unlike && times > 1 / most_unlike)
      units.emplace_back(std::abs(std::log(times)), unit.name);
  }
  std::sort(units.begin(), units.end());
  std::string words;
  for (const auto& [unlike, name] : units) words += (words.empty() ? "" : " or ") + name;
  return words;
}

/// What to say of points that are all far away from the part, many times its size: mostly a unit.
void tell_far_points(const QueryOptions& options, const Part& part, const CsvColumns& points,
                     double least_m) {
  constexpr double far = 10;
  const Eigen::AlignedBox3d box(part.centre_P - part.half_extent, part.centre_P + part.half_extent);
  const double size_m = part.size_m();
  if (points.lines.empty() || !(least_m > far * size_m)) return;
  const std::string unit = likelier_units(box, points);
  print_err("fingerpad: {}: {} {} m or more from {}, which is {} m large; points are in metres{}\n",
            input_name(options.points),
            points.lines.size() == 1 ? "its point is" : fmt::format("all {} points are", points.lines.size()),
            rounded_text(least_m, 3), input_name(options.mesh), rounded_text(size_m, 3),
            unit.empty() ? " (is --unit that of the mesh?)" : fmt::format(": are these in {}?", unit));
}

/// A table without points has an answer: one without rows, which may look like nothing.
void tell_no_points(const QueryOptions& options, const CsvColumns& points) {
  if (points.lines.empty())
    print_err("fingerpad: {}: has a header and no point below it, so the answer is a header alone\n",
              input_name(options.points));
}

int query(const QueryOptions& options) {
  if (stream_descriptor(options.mesh) &&
      stream_descriptor(options.mesh) == stream_descriptor(options.points)) {
    throw Error(ErrorKind::usage, options.mesh, "cannot be both the mesh and the points");
  }
  refuse_overwriting(options.out, {options.mesh, options.points});
  refuse_unfit_name(options.out, "query", {".csv"});
  refuse_unwritable(options.out);
  const CsvColumns points =
      read_csv_columns(options.points, {"x_m", "y_m", "z_m"}, {}, TableSource::file_or_stream);
  LoadBar bar(stderr_is_terminal());
  const LoadProgress progress = bar.progress(options.mesh);
  ImportOptions how;
  how.metres_per_unit = metres_of(options.unit);
  how.stream = true;
  how.progress = step_of(progress, 0, 0.6);
  const ImportedPart imported = import_touchable(options.mesh, how);
  tell(progress, "building the search tree", 0.6);
  const TriangleTree tree(imported.part);
  bar.finish();
  for (const std::string& warning : imported.verdict.warnings) {
    print_err("fingerpad: warning: {}: {}\n", options.mesh, warning);
  }
  const std::string hint = unit_hint(imported.verdict, how.metres_per_unit);
  if (!hint.empty()) print_err("fingerpad: {}: {}\n", options.mesh, hint);
  tell_no_points(options, points);
  if (options.out == "-") {
    tell_far_points(options, tree.part(), points,
                    write_answers(tree, points, [](std::string_view text) { write_stream(stdout, text); }));
    return 0;
  }
  OutputFile file(options.out);
  const double least_m = write_answers(tree, points, [&file](std::string_view text) { file.write(text); });
  file.commit();
  tell_far_points(options, tree.part(), points, least_m);
  return 0;
}

}  // namespace

void add_query(CLI::App& program, Action& action) {
  auto options = std::make_shared<QueryOptions>();
  CLI::App* command = program.add_subcommand("query", "The closest surface point of each point in a table");
  command->add_option("MESH", options->mesh, mesh_format_names("or") + " file; - is standard input")
      ->required();
  command
      ->add_option("POINTS", options->points,
                   "CSV with columns x_m,y_m,z_m, in metres, in the file's own frame, up to 2 GiB and 50 "
                   "million rows; - is standard input")
      ->required();
  add_unit_option(*command, options->unit);
  refuse_empty(command->add_option(
      "--out", options->out, "CSV file to write; without it, or as -, the table goes to standard output"));
  command->footer(
      "Writes distance_m,px_m,py_m,pz_m,nx,ny,nz,triangle: the signed distance (negative inside), the "
      "surface point,\n"
      "the angle-weighted normal of the closest feature, and the triangle's number in the file, from 0.");
  command->callback([options, &action] { action = [options] { return query(*options); }; });
}

}  // namespace fingerpad
