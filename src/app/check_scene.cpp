#include "app/check_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "app/check_mesh.hpp"
#include "app/check_motion.hpp"
#include "app/standard_streams.hpp"
#include "base/count_words.hpp"
#include "base/error.hpp"
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
                                         {"at_m", place_json(overlap.at_W)}});
    }
  }
}

/// What a scene's motions come to.
struct MotionSums {
  int looked_at = 0, odd = 0, refused = 0;
  std::set<std::string> notes;  ///< told: what is true of many recordings is said once
};

/// On standard output, or in the objects, what there is to follow; how it was read, and what is odd about it,
/// goes to standard error.
/// @param whose  what is followed: the scene's motion, or one of its recordings
void tell_motion(const Scene& scene, const std::string& path, const std::string& whose,
                 const LoadedMotion& motion, const World& world, std::span<Json> objects, bool as_json,
                 MotionSums& sums) {
  const MotionCheck check = look_at_motion(scene, motion, world);
  if (!as_json) write_stream(stdout, motion_text(check, path));
  for (Json& object : objects) {
    object["motions"].push_back(motion_json(check, motion.warnings));
    if (!object.contains("motion")) object["motion"] = object["motions"].front();
  }
  for (const std::string& note : motion.notes) {
    const std::string what =
        note.starts_with(scene.motion.file) ? note.substr(scene.motion.file.size()) : note;
    if (sums.notes.insert(what).second) print_err("fingerpad: {}\n", note);
  }
  for (const std::string& warning : motion.warnings) print_err("fingerpad: warning: {}\n", warning);
  if (!check.hint.empty()) print_err("fingerpad: warning: {}: {}\n", whose, check.hint);
  ++sums.looked_at;
  sums.odd += motion.warnings.empty() && check.hint.empty() ? 0 : 1;
}

/// Of what a scene says beside its parts: refuses, or tells, what replay would before its first tick.
void look_at_finger_and_motion(const Scene& scene, const std::string& path, const std::string& whose,
                               const World& world, std::span<Json> objects, bool as_json, MotionSums& sums) {
  refuse_missing_inputs(scene);
  refuse_huge_finger(world, scene);
  std::optional<LoadedMotion> motion;
  if (scene.motion.given()) motion = load_motion(scene);
  if (scene.parts.empty() && !as_json)
    print_out("{}: can be touched\n  {} and no mesh: there is none to look at\n", path,
              count_words(scene.planes.size(), "plane"));
  if (motion)
    tell_motion(scene, path, whose, *motion, world, objects, as_json, sums);
  else if (!as_json)
    print_out("{}: has no [motion]: to touch and to view, not to replay\n", path);
  if (const std::string hint = finger_hint(world, scene); !hint.empty())
    print_err("fingerpad: warning: {}\n", hint);
}

/// "./m/a.csv" and "m/a.csv" are one.
std::string plain_path(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().string();
}

/// What a set says of a job's motion, by which its motions differ.
std::string motion_keys(const SceneJob& job) {
  std::string keys;
  for (const auto& [key, value] : job.set_keys) {
    if (key == "motion" || key == "motion.file")
      keys += plain_path(job.scene.motion.file) + "\n";
    else if (key.starts_with("motion."))
      keys += fmt::format("{} = {}\n", key, value);
  }
  return keys;
}

/// "s.toml: rub.csv" where a set has many motions.
std::string motion_words(const std::string& path, const SceneJob& job) {
  const std::string& file = job.scene.motion.file;
  return file.empty() || motion_keys(job).empty() ? path : path + ": " + printable(file);
}

/// What is wrong with one of a set's jobs does not keep the others from being told.
void refuse_job(const SceneJob& job, const std::string& error, std::span<Json> objects, MotionSums& sums) {
  ++sums.refused;
  print_err("fingerpad: error: {}\n", error);
  for (Json& object : objects)
    object["motions"].push_back({{"name", job.scene.motion.file}, {"error", error}});
}

/// Of a set's further jobs: those that are refused by what the scene says, and each motion once, as if what
/// `first` has were there to touch.
void look_at_further_jobs(const SceneFile& file, const SceneJob& first, const std::string& path,
                          const World& world, std::span<Json> objects, bool as_json, MotionSums& sums) {
  std::set<std::string> seen = {motion_keys(first)}, errors;
  for (const SceneJob& job : file.jobs) {
    if (!job.error.empty()) {
      if (errors.insert(job.error).second)
        refuse_job(job, fmt::format("{}: job {}: {}", path, job.number, job.error), objects, sums);
      continue;
    }
    if (!seen.insert(motion_keys(job)).second) continue;
    try {
      refuse_missing_inputs(job.scene);
      tell_motion(job.scene, path, motion_words(path, job), load_motion(job.scene), world, objects, as_json,
                  sums);
    } catch (const Error& error) {
      refuse_job(job, error.what(), objects, sums);
    }
  }
}

CheckedMesh checked(const PartEntry& entry) {
  ImportOptions how;
  how.metres_per_unit = entry.metres_per_unit;
  how.crease_rad = entry.crease_deg * std::numbers::pi / 180;
  how.repair = entry.repair;
  return checked(entry.mesh_path, how);
}

/// Which mesh a part is, and how it is taken.
std::string mesh_keys(const PartEntry& entry) {
  return fmt::format("{}\n{} {} {}", plain_path(entry.mesh_path), entry.metres_per_unit, entry.crease_deg,
                     entry.repair);
}

/// The parts of a scene, of a set those of its first job, each as the scene takes it and where it places it.
/// @returns nothing where one cannot be touched
std::optional<World> look_at_parts(const Scene& scene, bool as_json, Json& report) {
  bool all_touchable = true;
  World world;
  for (const PartEntry& entry : scene.parts) {
    const CheckedMesh mesh = checked(entry);
    all_touchable &= tell_mesh(mesh, as_json, report);
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

/// What a set's jobs touch beside what the first does: each mesh once.
/// @returns whether all can be touched
bool look_at_further_meshes(const SceneFile& file, const SceneJob& first, const std::string& path,
                            bool as_json, Json& report) {
  std::set<std::string> seen;
  for (const PartEntry& entry : first.scene.parts) seen.insert(mesh_keys(entry));
  const std::size_t before = seen.size();
  int refused = 0;
  for (const SceneJob& job : file.jobs) {
    for (const PartEntry& entry : job.scene.parts) {
      if (!job.error.empty() || !seen.insert(mesh_keys(entry)).second) continue;
      refused += tell_mesh(checked(entry), as_json, report) ? 0 : 1;
      if (as_json) report.back()["overlaps"] = report.back()["motions"] = Json::array();
    }
  }
  if (seen.size() > before && !as_json)
    print_out("{}: {} looked at that further jobs touch, {} refused\n", path,
              count_words(seen.size() - before, "mesh file"), refused);
  return refused == 0;
}

}  // namespace

bool check_scene(const std::string& path, bool as_json, Json& report) {
  const SceneFile file = read_scene_file(path);
  const auto is_good = [](const SceneJob& job) { return job.error.empty(); };
  const auto good = std::find_if(file.jobs.begin(), file.jobs.end(), is_good);
  if (good == file.jobs.end()) throw Error(ErrorKind::refused, "", file.jobs.front().error);
  const SceneJob& first = *good;
  if (file.jobs.size() > 1)
    print_err(
        "fingerpad: {}: a set of {} jobs: each mesh and each motion is looked at once, the motions with the "
        "parts of the first\n",
        path, file.jobs.size());
  const Scene& scene = first.scene;
  const std::optional<World> world = look_at_parts(scene, as_json, report);
  Json further = Json::array();  // behind the first job's
  const bool all_touchable = look_at_further_meshes(file, first, path, as_json, further);
  const auto tell_further = [&] { report.insert(report.end(), further.begin(), further.end()); };
  if (!world) {
    tell_further();
    return false;
  }
  // The parts' objects, or one for a scene of planes, which is told if it is not refused.
  Json planes = {{"file", path}, {"touchable", true}, {"error", ""}, {"warnings", Json::array()}};
  std::span<Json> objects;
  if (as_json && scene.parts.empty()) objects = std::span(&planes, 1);
  if (as_json && !scene.parts.empty())
    objects = std::span(report.get_ref<Json::array_t&>()).last(scene.parts.size());
  for (Json& object : objects) object["overlaps"] = object["motions"] = Json::array();
  tell_overlaps(scene, path, *world, objects);
  MotionSums sums;
  try {
    look_at_finger_and_motion(scene, path, motion_words(path, first), *world, objects, as_json, sums);
  } catch (const Error& error) {
    if (file.jobs.size() == 1) throw;
    refuse_job(first, error.what(), objects, sums);
  }
  look_at_further_jobs(file, first, path, *world, objects, as_json, sums);
  if (sums.looked_at + sums.refused > 1 && !as_json)
    print_out("{}: {} looked at, {} with a warning, {} refused\n", path,
              count_words(static_cast<std::size_t>(sums.looked_at), "motion"), sums.odd, sums.refused);
  if (sums.refused > 0) {
    planes["touchable"] = false;
    planes["error"] = fmt::format("{} of its jobs' motions and numbers refused", sums.refused);
  }
  if (as_json && scene.parts.empty()) report.push_back(planes);
  tell_further();
  return all_touchable && sums.refused == 0;
}

}  // namespace fingerpad
