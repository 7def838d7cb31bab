#include "app/shown_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "app/standard_streams.hpp"
#include "app/subject.hpp"
#include "app/told_trace.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "replay/batch_files.hpp"
#include "replay/never_touches.hpp"
#include "scene/scene_file.hpp"
#include "touch/closed_loop.hpp"
#include "trace/motion_source.hpp"
#include "trace/trace.hpp"
#include "trace/trace_folder.hpp"

namespace fingerpad {
namespace {

std::vector<TickRecord> replayed(const Scene& scene, const std::shared_ptr<const World>& world,
                                 const LoadedMotion& motion) {
  const FingerPath& path = motion.path;
  ClosedLoop loop(world, scene, path, motion.changes);
  constexpr long most_rows = 20'000'000;  // some 6 GB
  if (loop.tick_count() > most_rows) {
    throw refused(scene.path,
                  fmt::format("its motion has {} ticks; at most {} are shown: make it shorter or lower "
                              "rate_hz",
                              loop.tick_count(), most_rows));
  }
  std::vector<TickRecord> rows;
  rows.reserve(static_cast<std::size_t>(loop.tick_count()));
  for (long k = 0; k < loop.tick_count() && !loop.has_diverged(); ++k) rows.push_back(loop.next());
  if (loop.has_diverged()) throw refused(scene.path, loop.divergence());
  const auto touches = [](const TickRecord& row) { return row.phase != Phase::free; };
  if (std::none_of(rows.begin(), rows.end(), touches)) {
    const std::string words =
        never_touches(*world, path, scene.finger.radius_m, !scene.motion.placement.is_world());
    if (!words.empty()) print_err("fingerpad: warning: {}: {}\n", scene.name, words);
  }
  return rows;
}

/// What a scene's finger follows, told as it is read; nothing where the scene has none.
std::optional<LoadedMotion> told_motion(const Scene& scene) {
  if (!scene.motion.given()) return std::nullopt;
  LoadedMotion motion = load_motion(scene);
  for (const std::string& note : motion.notes) print_err("fingerpad: {}\n", note);
  for (const std::string& warning : motion.warnings) print_err("fingerpad: warning: {}\n", warning);
  return motion;
}

ViewInput scene_subject(const std::string& path, LoadBar& bar) {
  ViewInput input;
  input.scene = single_scene(path);
  input.title = input.scene->name;
  input.file = path;
  const auto motion = told_motion(*input.scene);
  if (motion) input.scene = at_rate(*input.scene, motion->path);
  input.world = load_world(*input.scene, bar.progress());
  bar.finish();
  tell_warnings(*input.world);
  tell_unit_hints(*input.world, *input.scene);
  tell_choice(*input.world);
  if (!motion) return input;
  input.changes = motion->changes;
  input.rows = replayed(*input.scene, input.world, *motion);
  return input;
}

ViewInput mesh_subject(const std::string& path, double metres_per_unit, LoadBar& bar) {
  ViewInput input;
  input.title = std::filesystem::path(path).filename().string();
  input.file = path;
  Scene scene = scene_of_mesh(path, metres_per_unit);
  scene.contact.method = "closest-point";  // only looked at: nothing to measure it for
  input.world = load_world(scene, bar.progress());
  bar.finish();
  tell_warnings(*input.world);
  tell_unit_hints(*input.world, scene);
  return input;
}

}  // namespace

ViewInput load_subject(const std::string& path, double metres_per_unit, LoadBar& bar) {
  refuse_trace_folder(path, "a scene, mesh or trace");
  switch (subject_kind(path)) {
    case SubjectKind::scene:
      return scene_subject(path, bar);
    case SubjectKind::trace:
      return view_of_trace(read_told_trace(path, TraceContents::all), path);
    case SubjectKind::mesh:
      break;
  }
  return mesh_subject(path, metres_per_unit, bar);
}

std::vector<std::string> subject_files(const std::string& path) {
  if (stream_descriptor(path)) return {};  // what can be read once must be left to who shows it
  if (subject_kind(path) != SubjectKind::scene) return {path};
  return input_files(single_scene(path));
}

}  // namespace fingerpad
