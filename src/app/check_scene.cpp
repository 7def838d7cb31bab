#include "app/check_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "app/check_mesh.hpp"
#include "app/check_motion.hpp"
#include "app/standard_streams.hpp"
#include "app/told_meshes.hpp"
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

/// A look at all that a scene file says, job by job.
class SceneLook {
 public:
  SceneLook(const std::string& path, bool as_json, Json& report)
      : path_(path), as_json_(as_json), report_(report), meshes_(as_json, report) {}

  bool go() {
    const SceneFile file = read_scene_file(path_);
    const auto is_good = [](const SceneJob& job) { return job.error.empty(); };
    if (std::none_of(file.jobs.begin(), file.jobs.end(), is_good))
      throw Error(ErrorKind::refused, "", file.jobs.front().error);
    is_set_ = file.jobs.size() > 1;
    if (is_set_)
      print_err("fingerpad: {}: a set of {} jobs: each mesh and each motion is looked at once\n", path_,
                file.jobs.size());
    for (const SceneJob& job : file.jobs) {
      if (is_good(job))
        look_at(job);
      else if (errors_.insert(job.error).second)
        refuse(job, fmt::format("{}: job {}: {}", path_, job.number, job.error));
    }
    if (is_set_)
      for (const SceneJob& job : file.jobs)
        if (is_good(job)) read_motion_of(job);
    return end();
  }

 private:
  void look_at(const SceneJob& job) {
    const std::size_t before = report_.size();
    const bool can_be_touched = meshes_.look_at(job.scene);
    for (std::size_t i = before; i < report_.size(); ++i)
      report_[i].update({{"overlaps", Json::array()}, {"motions", Json::array()}});
    if (!can_be_touched) return;
    std::optional<World> world;
    const bool is_first = !std::exchange(has_first_, true);
    if (is_first) {
      world = meshes_.world(job.scene);
      look_at_overlaps(job, *world);
    }
    look_at_finger(job);
    look_at_motion(job, is_first, std::move(world));
  }

  /// The first job whose parts can all be touched stands for the others.
  void look_at_overlaps(const SceneJob& job, const World& world) {
    if (as_json_) of_first_ = meshes_.objects(job.scene);
    Objects objects;
    if (as_json_ && of_first_.empty()) objects = {&own_};
    for (const std::size_t i : of_first_) objects.push_back(&report_[i]);
    tell_overlaps(job.scene, path_, world, objects);
  }

  /// One that is too large for the parts that it is to touch is refused, or told, as by replay.
  void look_at_finger(const SceneJob& job) {
    const std::string keys = fmt::format("{} {}", part_keys(job.scene), job.scene.finger.radius_m);
    if (!fingers_.insert(keys).second) return;
    const World world = meshes_.world_in_words(job.scene);
    try {
      refuse_huge_finger(world, job.scene);
    } catch (const Error& error) {
      if (!is_set_) throw;
      return refuse(job, error.what());
    }
    if (const std::string hint = finger_hint(world, job.scene); !hint.empty())
      print_err("fingerpad: warning: {}\n", hint);
  }

  void look_at_motion(const SceneJob& job, bool is_first, std::optional<World> world) {
    const bool is_given = job.scene.motion.given();
    if (!is_first && (!is_given || motions_.contains(motion_keys(job)))) return;
    motions_.insert(motion_keys(job));
    try {
      refuse_missing_inputs(job.scene);
      std::optional<LoadedMotion> motion;
      if (is_given) motion = load_motion(job.scene);
      if (is_first && !as_json_) tell_what_is_missing(job.scene);
      if (motion) tell_motion(job, *motion, world ? *world : meshes_.world(job.scene));
    } catch (const Error& error) {
      if (!is_set_) throw;
      refuse_motion(job, error.what());
    }
  }

  void tell_what_is_missing(const Scene& scene) const {
    if (scene.parts.empty())
      print_out("{}: can be touched\n  {} and no mesh: there is none to look at\n", path_,
                count_words(scene.planes.size(), "plane"));
    if (!scene.motion.given()) print_out("{}: has no [motion]: to touch and to view, not to replay\n", path_);
  }

  /// Of a motion all of whose jobs have a mesh that cannot be touched: whether it can be read.
  void read_motion_of(const SceneJob& job) {
    const Scene& scene = job.scene;
    if (!scene.motion.given() || scene.motion.laid || !motions_.insert(motion_keys(job)).second) return;
    try {
      const LoadedMotion motion = load_motion(scene);
      tell_reading(motion, scene);
      if (!as_json_)
        print_out("{}: can be read; no job that follows it has parts that can all be touched\n",
                  motion_words(path_, job));
      ++followed_;
      odd_ += motion.warnings.empty() ? 0 : 1;
      told_.push_back({{"name", motion_name(scene)}, {"warnings", motion.warnings}});
    } catch (const Error& error) {
      refuse_motion(job, error.what());
    }
  }

  /// On standard output, or in JSON, what there is to follow; how it was read, and what is odd about it,
  /// goes to standard error.
  void tell_motion(const SceneJob& job, const LoadedMotion& motion, const World& world) {
    const MotionCheck check = fingerpad::look_at_motion(job.scene, motion, world);
    if (!as_json_) write_stream(stdout, motion_text(check, path_));
    told_.push_back(motion_json(check, motion.warnings));
    tell_reading(motion, job.scene);
    if (!check.hint.empty()) print_err("fingerpad: warning: {}: {}\n", motion_words(path_, job), check.hint);
    ++followed_;
    odd_ += motion.warnings.empty() && check.hint.empty() ? 0 : 1;
  }

  /// What is true of many recordings is said once.
  void tell_reading(const LoadedMotion& motion, const Scene& scene) {
    for (const std::string& note : motion.notes) {
      const std::string what =
          note.starts_with(scene.motion.file) ? note.substr(scene.motion.file.size()) : note;
      if (notes_.insert(what).second) print_err("fingerpad: {}\n", note);
    }
    for (const std::string& warning : motion.warnings) print_err("fingerpad: warning: {}\n", warning);
  }

  /// What is wrong with one of a set's jobs does not keep the others from being told.
  void refuse(const SceneJob& job, const std::string& error) {
    print_err("fingerpad: error: {}\n", error);
    wrong_.push_back({{"job", job.number}, {"error", error}});
  }

  void refuse_motion(const SceneJob& job, const std::string& error) {
    ++refused_motions_;
    refuse(job, error);
    told_.push_back({{"name", motion_name(job.scene)},
                     {"job", job.number},
                     {"warnings", Json::array()},
                     {"error", error}});
  }

  /// Tells what all came to; whether nothing was refused.
  bool end() {
    const bool is_good = wrong_.empty(), all_good = is_good && meshes_.refused() == 0;
    Objects objects;
    for (const std::size_t i : of_first_) objects.push_back(&report_[i]);
    const bool is_of_planes = has_first_ && of_first_.empty();
    if (is_of_planes) objects = {&own_};
    for (Json* object : objects) {
      (*object)["motions"] = told_;
      const auto is_followed = [](const Json& motion) { return !motion.contains("error"); };
      const auto one = std::find_if(told_.begin(), told_.end(), is_followed);
      if (one != told_.end()) (*object)["motion"] = *one;
    }
    if (!has_first_) own_["motions"] = told_;
    if (is_set_ && !as_json_) tell_sums();
    if (!all_good) {
      own_["touchable"] = false;
      own_["error"] = is_good ? "a mesh of its jobs is refused" : wrong_[0]["error"];
      own_["refused"] = wrong_;
    }
    const bool is_told_here = is_of_planes || !is_good || (!has_first_ && !told_.empty());
    if (as_json_ && is_told_here) report_.push_back(own_);
    return all_good;
  }

  void tell_sums() const {
    const int motions = followed_ + refused_motions_;
    if (meshes_.count() > 1)
      print_out("{}: {} meshes: {} can be touched, {} refused\n", path_, meshes_.count(),
                meshes_.count() - meshes_.refused(), meshes_.refused());
    if (motions > 1)
      print_out("{}: {} motions: {} can be followed, {} of these with a warning, {} refused\n", path_,
                motions, followed_, odd_, refused_motions_);
  }

  std::string path_;
  bool as_json_, is_set_ = false, has_first_ = false;
  Json& report_;
  ToldMeshes meshes_;
  std::vector<std::size_t> of_first_;                 ///< the report's objects of the first job's parts
  std::set<std::string> errors_, fingers_, motions_;  ///< that were looked at
  std::set<std::string> notes_;                       ///< that were told
  int followed_ = 0, odd_ = 0, refused_motions_ = 0;
  Json told_ = Json::array();   ///< each motion
  Json wrong_ = Json::array();  ///< beside a mesh, with the scene or with a job of a set
  /// The scene's own object: of one that has planes alone, or with which something is wrong beside a mesh.
  Json own_ = {{"file", path_},
               {"touchable", true},
               {"error", ""},
               {"warnings", Json::array()},
               {"overlaps", Json::array()},
               {"motions", Json::array()}};
};

}  // namespace

bool check_scene(const std::string& path, bool as_json, Json& report) {
  return SceneLook(path, as_json, report).go();
}

}  // namespace fingerpad
