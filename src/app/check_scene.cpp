#include "app/check_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "app/check_mesh.hpp"
#include "app/check_motion.hpp"
#include "app/standard_streams.hpp"
#include "base/count_words.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/number_text.hpp"
#include "base/printable_text.hpp"
#include "contact/overlap.hpp"
#include "replay/missing_inputs.hpp"
#include "scene/scene_file.hpp"
#include "touch/unit_hints.hpp"
#include "touch/world.hpp"
#include "trace/motion_source.hpp"

namespace fingerpad {
namespace {

using Json = nlohmann::ordered_json;

/// What --json says of a scene or its parts; nothing of it where lines are printed.
using Objects = std::vector<Json*>;

/// On standard error, and in the objects of the parts that they are of.
/// @param objects  of the scene's parts, or its own where it has none
void tell_overlaps(const Scene& scene, const std::string& path, const World& world, const Objects& objects) {
  for (Json* object : objects) (*object)["overlaps"] = Json::array();
  for (const Overlap& overlap : overlaps(placed_surfaces(world))) {
    print_err("fingerpad: {}: {} and {} overlap by {} mm at ({}, {}, {}) m; is that meant?\n", path,
              counted_name(world, overlap.one), counted_name(world, overlap.other),
              rounded_text(1e3 * overlap.depth_m, 3), rounded_text(overlap.at_W.x(), 4),
              rounded_text(overlap.at_W.y(), 4), rounded_text(overlap.at_W.z(), 4));
    for (const auto& [of, with] : {std::pair(overlap.one, overlap.other), {overlap.other, overlap.one}}) {
      if (of >= std::min(objects.size(), scene.parts.size())) continue;  // a plane
      (*objects[of])["overlaps"].push_back({{"with", counted_name(world, with)},
                                            {"depth_m", overlap.depth_m},
                                            {"at_m", place_json(overlap.at_W)}});
    }
  }
}

/// What a scene's motions come to.
struct MotionSums {
  int followed = 0, odd = 0, refused = 0;
  Json told = Json::array();    ///< each motion
  Json wrong = Json::array();   ///< with the scene, or with a job of a set
  std::set<std::string> notes;  ///< told: what is true of many recordings is said once

  bool are_good() const { return wrong.empty(); }
};

/// On standard output, or in JSON, what there is to follow; how it was read, and what is odd about it,
/// goes to standard error.
/// @param whose  what is followed: the scene's motion, or one of its recordings
void tell_motion(const Scene& scene, const std::string& path, const std::string& whose,
                 const LoadedMotion& motion, const World& world, bool as_json, MotionSums& sums) {
  const MotionCheck check = look_at_motion(scene, motion, world);
  if (!as_json) write_stream(stdout, motion_text(check, path));
  sums.told.push_back(motion_json(check, motion.warnings));
  for (const std::string& note : motion.notes) {
    const std::string what =
        note.starts_with(scene.motion.file) ? note.substr(scene.motion.file.size()) : note;
    if (sums.notes.insert(what).second) print_err("fingerpad: {}\n", note);
  }
  for (const std::string& warning : motion.warnings) print_err("fingerpad: warning: {}\n", warning);
  if (!check.hint.empty()) print_err("fingerpad: warning: {}: {}\n", whose, check.hint);
  ++sums.followed;
  sums.odd += motion.warnings.empty() && check.hint.empty() ? 0 : 1;
}

/// Refuses it, or tells of it, as replay would.
void look_at_finger(const Scene& scene, const World& world) {
  refuse_huge_finger(world, scene);
  if (const std::string hint = finger_hint(world, scene); !hint.empty())
    print_err("fingerpad: warning: {}\n", hint);
}

/// Refuses, or tells, what replay would before its first tick.
void look_at_motion_of(const Scene& scene, const std::string& path, const std::string& whose,
                       const World& world, bool as_json, MotionSums& sums) {
  refuse_missing_inputs(scene);
  std::optional<LoadedMotion> motion;
  if (scene.motion.given()) motion = load_motion(scene);
  if (scene.parts.empty() && !as_json)
    print_out("{}: can be touched\n  {} and no mesh: there is none to look at\n", path,
              count_words(scene.planes.size(), "plane"));
  if (motion)
    tell_motion(scene, path, whose, *motion, world, as_json, sums);
  else if (!as_json)
    print_out("{}: has no [motion]: to touch and to view, not to replay\n", path);
}

/// What tells a file from another, by whatever path; of one that is not there, the path.
std::string file_words(const std::string& path) {
  std::error_code failed;
  return file_identity(path).value_or(std::filesystem::weakly_canonical(path, failed).string());
}

/// Which mesh a part is, and how it is taken.
std::string mesh_keys(const PartEntry& entry) {
  return fmt::format("{}\n{} {} {}\n", file_words(entry.mesh_path), entry.metres_per_unit, entry.crease_deg,
                     entry.repair);
}

/// What a set says of a job's motion, by which its motions differ.
std::string motion_keys(const SceneJob& job) {
  const MotionSettings& motion = job.scene.motion;
  std::string keys = motion.file.empty() ? "" : file_words(motion.file_path) + "\n";
  if (motion.laid && !job.scene.parts.empty()) keys += mesh_keys(job.scene.parts.front());
  for (const auto& [key, value] : job.set_keys) {
    if (key.starts_with("motion.") && key != "motion.file") keys += fmt::format("{} = {}\n", key, value);
  }
  return keys;
}

/// "s.toml: rub.csv" where a set has many motions.
std::string motion_words(const std::string& path, const SceneJob& job) {
  const std::string& file = job.scene.motion.file;
  const bool is_of_set = std::any_of(job.set_keys.begin(), job.set_keys.end(), [](const auto& key) {
    return key.first == "motion" || key.first.starts_with("motion.");
  });
  return file.empty() || !is_of_set ? path : path + ": " + printable(file);
}

/// What is wrong with one of a set's jobs does not keep the others from being told.
void refuse_job(const SceneJob& job, const std::string& error, MotionSums& sums) {
  print_err("fingerpad: error: {}\n", error);
  sums.wrong.push_back({{"job", job.number}, {"error", error}});
}

void refuse_motion(const SceneJob& job, const std::string& error, MotionSums& sums) {
  ++sums.refused;
  refuse_job(job, error, sums);
  sums.told.push_back(
      {{"name", job.scene.motion.file}, {"job", job.number}, {"warnings", Json::array()}, {"error", error}});
}

/// The meshes of a set that were told: whether they can be touched, and which of the report's objects they
/// are.
struct ToldMesh {
  bool touchable;
  std::size_t object;
};
using ToldMeshes = std::map<std::string, ToldMesh>;

CheckedMesh checked(const PartEntry& entry) {
  ImportOptions how;
  how.metres_per_unit = entry.metres_per_unit;
  how.crease_rad = entry.crease_deg * std::numbers::pi / 180;
  how.repair = entry.repair;
  return checked(entry.mesh_path, how);
}

bool can_be_touched(const SceneJob& job, const ToldMeshes& told) {
  return std::all_of(job.scene.parts.begin(), job.scene.parts.end(), [&told](const PartEntry& entry) {
    const auto mesh = told.find(mesh_keys(entry));
    return mesh != told.end() && mesh->second.touchable;
  });
}

std::string part_keys(const SceneJob& job) {
  std::string keys;
  for (const PartEntry& entry : job.scene.parts) keys += mesh_keys(entry);
  return keys;
}

/// Of a set's further jobs: those that are refused by what the scene says, fingers that are too large for the
/// parts of `first`, and each motion once, as if these were there to touch.
void look_at_further_jobs(const SceneFile& file, const SceneJob& first, const std::string& path,
                          const World& world, const ToldMeshes& told, bool as_json, MotionSums& sums) {
  std::set<std::string> seen = {motion_keys(first)}, errors;
  std::set<double> radii = {first.scene.finger.radius_m};
  const std::string parts = part_keys(first);
  for (const SceneJob& job : file.jobs) {
    if (!job.error.empty()) {
      if (errors.insert(job.error).second)
        refuse_job(job, fmt::format("{}: job {}: {}", path, job.number, job.error), sums);
      continue;
    }
    if (!can_be_touched(job, told)) continue;
    try {
      if (part_keys(job) == parts && radii.insert(job.scene.finger.radius_m).second)
        look_at_finger(job.scene, world);
    } catch (const Error& error) {
      refuse_job(job, error.what(), sums);
    }
    if (!job.scene.motion.given() || !seen.insert(motion_keys(job)).second) continue;
    try {
      refuse_missing_inputs(job.scene);
      tell_motion(job.scene, path, motion_words(path, job), load_motion(job.scene), world, as_json, sums);
    } catch (const Error& error) {
      refuse_motion(job, error.what(), sums);
    }
  }
}

/// A scene's parts, each as the scene takes it and where it places it; tells those that no job before had.
/// @param objects  which of the report's are the parts'
/// @returns nothing where one cannot be touched
std::optional<World> look_at_parts(const Scene& scene, bool as_json, Json& report, ToldMeshes& told,
                                   std::vector<std::size_t>& objects) {
  const ToldMeshes before = told;
  bool all_touchable = true;
  World world;
  objects.clear();
  for (const PartEntry& entry : scene.parts) {
    const std::string keys = mesh_keys(entry);
    const auto known = before.find(keys);
    if (known != before.end() && !known->second.touchable) {
      all_touchable = false;
      continue;
    }
    const CheckedMesh mesh = checked(entry);
    if (known == before.end()) {
      const std::size_t object = report.size();
      told[keys] = {tell_mesh(mesh, as_json, report), object};
    }
    all_touchable &= told[keys].touchable;
    objects.push_back(told[keys].object);
    world.verdicts.push_back(mesh.imported.verdict);
    Surface& surface = world.surfaces.emplace_back();
    surface.mesh = entry.mesh;
    surface.part = mesh.imported.part;
    surface.tree = mesh.tree;
    surface.p_WP = entry.position_m;
    surface.R_WP = entry.rotation;
  }
  if (!all_touchable) return std::nullopt;
  for (const PlaneEntry& plane : scene.planes) {
    Surface& surface = world.surfaces.emplace_back();
    surface.plane_point_W = plane.point_m;
    surface.plane_normal_W = plane.normal;
  }
  return world;
}

/// Of a set: each mesh that no job before had.
void look_at_further_meshes(const SceneFile& file, bool as_json, Json& report, ToldMeshes& told) {
  for (const SceneJob& job : file.jobs) {
    for (const PartEntry& entry : job.scene.parts) {
      const std::string keys = mesh_keys(entry);
      if (!job.error.empty() || told.contains(keys)) continue;
      const std::size_t object = report.size();
      told[keys] = {tell_mesh(checked(entry), as_json, report), object};
    }
  }
}

/// What a set's jobs, and what they touch, come to.
void tell_sums(const std::string& path, const ToldMeshes& told, int refused_meshes, const MotionSums& sums) {
  const int meshes = static_cast<int>(told.size()), motions = sums.followed + sums.refused;
  if (meshes > 1)
    print_out("{}: {} meshes: {} can be touched, {} refused\n", path, meshes, meshes - refused_meshes,
              refused_meshes);
  if (motions > 1)
    print_out("{}: {} motions: {} can be followed, {} of these with a warning, {} refused\n", path, motions,
              sums.followed, sums.odd, sums.refused);
}

}  // namespace

bool check_scene(const std::string& path, bool as_json, Json& report) {
  const SceneFile file = read_scene_file(path);
  const auto is_good = [](const SceneJob& job) { return job.error.empty(); };
  if (std::none_of(file.jobs.begin(), file.jobs.end(), is_good))
    throw Error(ErrorKind::refused, "", file.jobs.front().error);
  const bool is_set = file.jobs.size() > 1;
  if (is_set)
    print_err("fingerpad: {}: a set of {} jobs: each mesh and each motion is looked at once\n", path,
              file.jobs.size());
  const std::size_t before = report.size();
  ToldMeshes told;
  std::vector<std::size_t> of_parts;
  std::optional<World> world;
  const SceneJob* first = nullptr;  // whose parts can all be touched
  for (const SceneJob& job : file.jobs) {
    if (world || !job.error.empty()) continue;
    first = &job;
    world = look_at_parts(job.scene, as_json, report, told, of_parts);
  }
  look_at_further_meshes(file, as_json, report, told);
  const auto refused_meshes = static_cast<int>(
      std::count_if(told.begin(), told.end(), [](const auto& mesh) { return !mesh.second.touchable; }));
  for (std::size_t i = before; i < report.size(); ++i) {
    report[i]["overlaps"] = Json::array();
    report[i]["motions"] = Json::array();
  }
  MotionSums sums;
  if (!world) {
    if (is_set)
      print_err("fingerpad: {}: no job's parts can be touched: its motions are not looked at\n", path);
    return false;
  }
  const Scene& scene = first->scene;
  // The parts' objects, or one for a scene of planes.
  Json own = {{"file", path},
              {"touchable", true},
              {"error", ""},
              {"warnings", Json::array()},
              {"overlaps", Json::array()},
              {"motions", Json::array()}};
  Objects objects;
  if (as_json && scene.parts.empty()) objects = {&own};
  if (as_json)
    for (const std::size_t i : of_parts) objects.push_back(&report[i]);
  tell_overlaps(scene, path, *world, objects);
  try {
    look_at_finger(scene, *world);
  } catch (const Error& error) {
    if (!is_set) throw;
    refuse_job(*first, error.what(), sums);
  }
  try {
    look_at_motion_of(scene, path, motion_words(path, *first), *world, as_json, sums);
  } catch (const Error& error) {
    if (!is_set) throw;
    refuse_motion(*first, error.what(), sums);
  }
  look_at_further_jobs(file, *first, path, *world, told, as_json, sums);
  for (Json* object : objects) {
    (*object)["motions"] = sums.told;
    const auto is_told = [](const Json& motion) { return !motion.contains("error"); };
    const auto one = std::find_if(sums.told.begin(), sums.told.end(), is_told);
    if (one != sums.told.end()) (*object)["motion"] = *one;
  }
  if (is_set && !as_json) tell_sums(path, told, refused_meshes, sums);
  const bool all_good = refused_meshes == 0 && sums.are_good();
  // What is wrong with a scene, beside its meshes.
  if (!all_good) {
    own["touchable"] = false;
    own["error"] = sums.are_good() ? "a mesh of its jobs is refused" : sums.wrong[0]["error"];
    own["refused"] = sums.wrong;
  }
  if (as_json && (scene.parts.empty() || !sums.are_good())) report.push_back(own);
  return all_good;
}

}  // namespace fingerpad
