#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "app/check_motion.hpp"
#include "app/commands.hpp"
#include "app/progress_bar.hpp"
#include "app/standard_streams.hpp"
#include "app/unit_option.hpp"
#include "base/count_words.hpp"
#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "contact/overlap.hpp"
#include "contact/part_measures.hpp"
#include "contact/triangle_tree.hpp"
#include "part/import.hpp"
#include "part/mesh_format.hpp"
#include "part/unit_hint.hpp"
#include "replay/missing_inputs.hpp"
#include "scene/scene_file.hpp"
#include "touch/unit_hints.hpp"
#include "touch/world.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad {
namespace {

struct CheckOptions {
  std::vector<std::string> meshes;
  std::string unit = "mm";
  bool json = false;
  bool repair = false;
  bool says_how = false;  ///< unit or repair are given, which a scene has for each of its parts
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

/// A mesh that was looked at, with its tree and its thinnest wall where it can be touched.
struct CheckedMesh {
  ImportedPart imported;
  std::shared_ptr<const TriangleTree> tree;
  double wall_m = std::nan("");
  double metres_per_unit = 1;
};

/// What an overlap comes from, and what to do.
const char* overlap_words(const PartMeasures& measures, int components) {
  if (measures.open_edges > 0 || measures.contradicting_edges > 0)
    return "that may come from its holes or its winding, which are to be mended first";
  return components > 1 ? "its bodies lie in one another, and are felt as one solid; join them in CAD if "
                          "that is not meant"
                        : "its surface passes through itself; mend it in CAD if that is not meant";
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

/// @returns whether it can be touched
bool tell_mesh(const CheckedMesh& mesh, bool as_json, Json& report) {
  const Verdict& verdict = mesh.imported.verdict;
  if (as_json) {
    report.push_back(verdict_json(verdict, mesh.wall_m));
  } else if (!verdict.touchable) {
    print_out("{}: refused\n", verdict.file);  // the reason goes to standard error, once
  } else {
    write_stream(stdout, verdict_text(verdict));
    if (std::isfinite(mesh.wall_m)) print_out("  thinnest wall  {} mm\n", rounded_text(1e3 * mesh.wall_m, 4));
  }
  const std::string hint = unit_hint(verdict, mesh.metres_per_unit);
  if (!hint.empty()) print_err("fingerpad: {}: {}\n", verdict.file, hint);
  if (!verdict.touchable) print_err("fingerpad: error: {}\n", refusal_text(verdict));
  return verdict.touchable;
}

/// "part 2 (knob.stl)", "plane 1".
std::string surface_words(const Scene& scene, std::size_t i) {
  if (i >= scene.parts.size()) return fmt::format("plane {}", i - scene.parts.size() + 1);
  return fmt::format("part {} ({})", i + 1, printable(scene.parts[i].mesh));
}

/// On standard error, and in the objects of the parts that they are of.
/// @param objects  of the scene's parts, or its own where it has none; or none at all
void tell_overlaps(const Scene& scene, const std::string& path, const World& world, std::span<Json> objects) {
  for (const Overlap& overlap : overlaps(placed_surfaces(world))) {
    print_err("fingerpad: {}: {} and {} overlap by {} mm at ({}, {}, {}) m; is that meant?\n", path,
              surface_words(scene, overlap.one), surface_words(scene, overlap.other),
              rounded_text(1e3 * overlap.depth_m, 3), rounded_text(overlap.at_W.x(), 4),
              rounded_text(overlap.at_W.y(), 4), rounded_text(overlap.at_W.z(), 4));
    for (const auto& [of, with] : {std::pair(overlap.one, overlap.other), {overlap.other, overlap.one}}) {
      if (of >= std::min(objects.size(), scene.parts.size())) continue;  // a plane
      objects[of]["overlaps"].push_back({{"with", surface_words(scene, with)},
                                         {"depth_m", overlap.depth_m},
                                         {"at_m", corner(overlap.at_W)}});
    }
  }
}

/// On standard output, or in the objects, what there is to follow; how it was read, and what is odd about it,
/// goes to standard error.
/// @param whose  what is odd: the scene, or one of its recordings
void tell_motion(const Scene& scene, const std::string& path, const std::string& whose,
                 const LoadedMotion& motion, const World& world, bool as_json, std::span<Json> objects) {
  const MotionCheck check = look_at_motion(scene, motion, world);
  if (!as_json) write_stream(stdout, motion_text(check, path));
  for (Json& object : objects) object["motions"].push_back(motion_json(check, motion.warnings));
  for (const std::string& note : motion.notes) print_err("fingerpad: {}\n", note);
  for (const std::string& warning : motion.warnings) print_err("fingerpad: warning: {}\n", warning);
  if (!check.hint.empty()) print_err("fingerpad: warning: {}: {}\n", whose, check.hint);
}

/// Of what a scene says beside its parts: refuses, or tells, what replay would before its first tick.
void look_at_finger_and_motion(const Scene& scene, const std::string& path, const World& world, bool as_json,
                               std::span<Json> objects) {
  refuse_missing_inputs(scene);
  refuse_huge_finger(world, scene);
  std::optional<LoadedMotion> motion;
  if (scene.motion.given()) motion = load_motion(scene);
  if (scene.parts.empty() && !as_json)
    print_out("{}: can be touched\n  {} and no mesh: there is none to look at\n", path,
              count_words(scene.planes.size(), "plane"));
  if (motion)
    tell_motion(scene, path, path, *motion, world, as_json, objects);
  else if (!as_json)
    print_out("{}: has no [motion]: to touch and to view, not to replay\n", path);
  if (const std::string hint = finger_hint(world, scene); !hint.empty())
    print_err("fingerpad: warning: {}\n", hint);
}

/// Of a set's other recordings, each once, as if all that its first job has were there to touch.
void look_at_further_recordings(const SceneFile& file, const std::string& path, const World& world,
                                bool as_json, std::span<Json> objects) {
  std::set<std::string> seen = {file.jobs.front().scene.motion.file, ""};
  for (const SceneJob& job : file.jobs) {
    if (!job.error.empty() || !seen.insert(job.scene.motion.file).second) continue;
    refuse_missing_inputs(job.scene);
    tell_motion(job.scene, path, path + ": " + printable(job.scene.motion.file), load_motion(job.scene),
                world, as_json, objects);
  }
}

/// The parts of a scene, of a set those of its first job, each as the scene takes it and where it places it.
bool check_scene(const std::string& path, bool as_json, Json& report) {
  const SceneFile file = read_scene_file(path);
  if (!file.jobs.front().error.empty()) throw Error(ErrorKind::refused, "", file.jobs.front().error);
  if (file.jobs.size() > 1)
    print_err("fingerpad: {}: looked at the first of its {} jobs, and at all recordings\n", path,
              file.jobs.size());
  const Scene& scene = file.jobs.front().scene;
  bool all_touchable = true;
  World world;
  for (const PartEntry& entry : scene.parts) {
    ImportOptions how;
    how.metres_per_unit = entry.metres_per_unit;
    how.crease_rad = entry.crease_deg * std::numbers::pi / 180;
    how.repair = entry.repair;
    const CheckedMesh mesh = checked(entry.mesh_path, how);
    all_touchable &= tell_mesh(mesh, as_json, report);
    world.verdicts.push_back(mesh.imported.verdict);
    Surface& surface = world.surfaces.emplace_back();
    surface.mesh = entry.mesh;
    surface.part = mesh.imported.part;
    surface.tree = mesh.tree;
    surface.p_WP = entry.position_m;
    surface.R_WP = entry.rotation;
  }
  if (!all_touchable) return false;
  for (const PlaneEntry& plane : scene.planes) {
    Surface& surface = world.surfaces.emplace_back();
    surface.plane_point_W = plane.point_m;
    surface.plane_normal_W = plane.normal;
  }
  std::span<Json> objects;
  if (as_json) {
    if (scene.parts.empty()) report.push_back({{"file", path}, {"touchable", true}, {"error", ""}});
    objects = std::span(report.get_ref<Json::array_t&>()).last(std::max<std::size_t>(1, scene.parts.size()));
  }
  for (Json& object : objects) {
    object["overlaps"] = Json::array();
    object["motions"] = Json::array();
  }
  tell_overlaps(scene, path, world, objects);
  look_at_finger_and_motion(scene, path, world, as_json, objects);
  look_at_further_recordings(file, path, world, as_json, objects);
  for (Json& object : objects) {
    if (!object["motions"].empty()) object["motion"] = object["motions"].front();
  }
  return all_touchable;
}

bool is_scene(const std::string& path) {
  return path.ends_with(".toml");
}

int check(const CheckOptions& options) {
  bool all_touchable = true;
  Json report = Json::array();
  ImportOptions how;
  how.metres_per_unit = metres_of(options.unit);
  how.repair = options.repair;
  for (const std::string& path : options.meshes) {
    if (options.says_how && is_scene(path))
      throw Error(
          ErrorKind::usage, path,
          "is a scene, which says `unit` and `repair` for each [[part]]: leave --unit and --repair out");
  }
  std::optional<Error> refused;
  for (const std::string& path : options.meshes) {
    if (!is_scene(path)) {
      all_touchable &= tell_mesh(checked(path, how), options.json, report);
      continue;
    }
    bool touchable = false;
    try {
      touchable = check_scene(path, options.json, report);
    } catch (const Error& error) {  // the others are looked at all the same
      if (options.json) report.push_back({{"file", path}, {"touchable", false}, {"error", error.what()}});
      if (refused) print_err("fingerpad: error: {}\n", refused->what());
      refused = error;
    }
    if (!touchable && !options.json) print_out("{}: refused\n", path);  // whatever was said of its meshes
    all_touchable &= touchable;
  }
  if (options.json) write_stream(stdout, json_text(report));
  if (refused) throw *refused;
  return all_touchable ? 0 : 3;
}

}  // namespace

void add_check(CLI::App& program, Action& action) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
      program.add_subcommand("check", "The verdict on each mesh: can it be touched, and what is damaged");
  command
      ->add_option(
          "MESH", options->meshes,
          mesh_format_names("or") +
              " files, - is standard input; or scenes (.toml), whose parts are taken in their "
              "units and looked at for overlaps, and whose motion and finger for what replay would refuse")
      ->required();
  add_unit_option(*command, options->unit);
  command->add_flag("--json", options->json, "Print an array with an object for each mesh (lengths in m)");
  command->add_flag("--repair", options->repair,
                    "Say what `repair = true` in a scene's [[part]] would do: weld, drop degenerate and "
                    "duplicate faces, make the winding right");
  command->footer("Ends 0 if every mesh can be touched and no scene is refused, else 3.");
  command->callback([options, command, &action] {
    options->says_how = command->count("--unit") > 0 || options->repair;
    action = [options] { return check(*options); };
  });
}

}  // namespace fingerpad
