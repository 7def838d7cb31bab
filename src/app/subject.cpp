#include "app/subject.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>

#include "app/standard_streams.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "scene/scene_file.hpp"
#include "touch/unit_hints.hpp"
#include "touch/world.hpp"
#include "trace/trace.hpp"

namespace fingerpad {

SubjectKind subject_kind(const std::string& path) {
  if (path.ends_with(".toml") || path == "-") return SubjectKind::scene;
  refuse_false_hdf5(path);
  const bool is_csv = path.ends_with(".csv") || path.ends_with(".csv.part");  // one that was cut short
  if (is_csv || is_hdf5(path)) return SubjectKind::trace;
  return SubjectKind::mesh;
}

void refuse_unfit_subject(const std::string& path) {
  std::error_code none;
  if (stream_descriptor(path)) return;
  const bool is_toml = path.ends_with(".toml");
  // A pipe can be read once.
  if (is_toml && std::filesystem::is_regular_file(path, none)) {
    refuse_profile(path);
    single_scene(path);
  }
  if (std::filesystem::exists(path, none)) return;
  if (is_toml) read_scene_file(path);  // with the scene that is meant
  const InputFile refuses(path, {"a scene, mesh or trace", std::numeric_limits<std::uint64_t>::max()});
}

Scene single_scene(const std::string& path) {
  SceneFile file = read_scene_file(path);
  SceneJob& job = file.jobs.front();
  if (!job.error.empty()) throw Error(ErrorKind::refused, "", job.error);
  return std::move(job.scene);
}

void tell_choice(const World& world) {
  if (!world.contact) return;
  for (std::string reason : world.contact->reasons) {
    bool is_for_figures = false;
    for (const ContactLimit& limit : world.contact->limits) {
      if (limit.said.empty() || !reason.ends_with(limit.said + " (auto)")) continue;
      // A tolerance that a wider one would replace is for who computes with the forces: replay and study
      // tell it.
      is_for_figures = is_for_figures || std::isfinite(limit.kept_tolerance);
      // Why is told where the contact was chosen, a line before.
      if (const std::size_t why = reason.find(": " + limit.why + "; "); why != std::string::npos)
        reason.erase(why, limit.why.size() + 2);
      break;
    }
    if (!is_for_figures) print_err("fingerpad: {}\n", reason);
  }
}

void tell_unit_hints(const World& world, const Scene& scene) {
  for (const std::string& line : unit_hints(world, scene)) print_err("fingerpad: {}\n", line);
}

void tell_warnings(const World& world) {
  for (const Verdict& verdict : world.verdicts) {
    for (const std::string& warning : verdict.warnings) {
      print_err("fingerpad: warning: {}: {}\n", verdict.file, warning);
    }
  }
}

}  // namespace fingerpad
