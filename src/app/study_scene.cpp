#include "app/study_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/output_folder.hpp"
#include "app/progress_bar.hpp"
#include "app/standard_streams.hpp"
#include "app/study_output.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "replay/batch_files.hpp"
#include "scene/scene_file.hpp"
#include "study/scene_study.hpp"
#include "touch/closed_loop.hpp"
#include "touch/rate_choice.hpp"
#include "trace/motion_source.hpp"
#include "trace/output_file.hpp"

namespace fingerpad {
namespace {

/// The keys whose every value the study tries by itself.
constexpr std::array<std::string_view, 4> studied_keys{"contact.method", "contact.normals", "friction.events",
                                                       "motion.rate_hz"};

/// The scene of a file. A set that differs in nothing but what is studied is one scene too.
Scene studied_scene(const std::string& path) {
  SceneFile file = read_scene_file(path);
  SceneJob& job = file.jobs.front();
  for (const auto& [key, value] : job.set_keys) {
    if (std::find(studied_keys.begin(), studied_keys.end(), key) != studied_keys.end()) continue;
    throw refused(path,
                  fmt::format("is a set of {} jobs, which differ in '{}'; a study takes one scene: write the "
                              "one that you mean without [[set]]",
                              file.jobs.size(), key));
  }
  if (!job.error.empty()) throw refused("", job.error);
  return std::move(job.scene);
}

void refuse_lost_inputs(const Scene& scene, const std::string& out_dir) {
  for (const char* name : {"choices.csv", "choices.png", "choices.svg", "scene.toml"})
    refuse_overwriting(out_dir + "/" + name, input_files(scene));
}

/// What there is to choose, left open.
Scene all_automatic(Scene scene) {
  scene.contact.method = automatic_method;
  scene.contact.automatic_normals = true;
  return scene;
}

/// What `auto` takes for a scene: contact as load_world chose it, the rate by its own rule.
TouchChoice automatic_choice_of(const Scene& scene, const World& world, const FingerPath& path) {
  const ContactChoice contact = settled_contact(scene, world);
  TouchChoice choice = touch_choices(scene, world).front();  // of planes alone the one contact that they have
  if (method_in(world, contact.method) == contact.method) {
    choice.method = contact.method;
    choice.normals = contact.normals;
  }
  choice.rate_hz = choose_rate(scene, &path).rate_hz;
  return choice;
}

/// The way that a finger takes in the scene's hand, which the choices then follow exactly: two closed loops
/// part from one another, however little they differ, and could not be compared tick by tick.
FingerPath way_in_hand(const Scene& scene, const std::shared_ptr<const World>& world,
                       const FingerPath& path) {
  ClosedLoop loop(world, scene, path);
  Motion way;
  way.p_WQ.resize(3, loop.tick_count());
  if (path.turns()) way.direction_W.resize(3, loop.tick_count());
  for (long k = 0; k < loop.tick_count(); ++k) {
    const TickRecord record = loop.next();
    if (loop.has_diverged()) throw refused(scene.path, loop.divergence());
    way.t_s.push_back(record.t_s);
    way.p_WQ.col(k) = record.p_WQ;
    if (path.turns()) way.direction_W.col(k) = record.direction_W;
  }
  return {std::move(way), path.rate_hz(), scene.finger.direction};
}

void tell_how(const Scene& scene, const LoadedMotion& motion) {
  for (const std::string& note : motion.notes) print_err("fingerpad: {}\n", note);
  for (const std::string& warning : motion.warnings) print_err("fingerpad: warning: {}\n", warning);
  if (scene.hand) {
    print_err(
        "fingerpad: {}: the choices are compared along the way that the finger takes in its [hand] as the "
        "scene stands; whether a rate holds that hand stable is judged by SCIENCE's border\n",
        scene.name);
  }
  if (scene.friction.vibration)
    print_err("fingerpad: {}: compared without slip vibration, which is noise\n", scene.name);
}

void write_lines(const std::string& lines, const std::string& path) {
  OutputFile file(path);
  file.write(lines);
  file.commit();
}

}  // namespace

int study_one_scene(const std::string& scene_path, const std::string& out_dir) {
  const Scene as_written = studied_scene(scene_path);
  refuse_lost_inputs(as_written, out_dir);
  LoadedMotion motion = load_motion(as_written);
  const Scene scene = all_automatic(at_rate(as_written, motion.path));
  const OutputFolder folder(out_dir);  // before the work, which would be lost without it
  ProgressBar bar(stderr_is_terminal(), std::chrono::milliseconds(500), ProgressBar::End::wiped);
  const auto world = load_world(
      scene, [&bar](std::string_view stage, double done) { bar.show(0.1 * done, std::string(stage)); });
  if (scene.hand) motion.path = way_in_hand(at_rate(as_written, motion.path), world, motion.path);
  SceneStudyInput input{scene, world, motion.path};
  input.automatic = automatic_choice_of(scene, *world, motion.path);
  const SceneStudy study =
      study_scene(input, [&bar](double done, const std::string& what) { bar.show(0.1 + 0.9 * done, what); });
  const std::string written =
      write_study({{choices_table(input, study)}, {scene_chart(input, study)}}, out_dir);
  bar.finish();
  tell_how(as_written, motion);
  write_lines(scene_lines(input, study), out_dir + "/scene.toml");
  print_out("{}\n{}, and the lines to paste in {}/scene.toml\n", scene_verdict(input, study), written,
            out_dir);
  return 0;
}

}  // namespace fingerpad
