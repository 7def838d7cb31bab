#include "app/touch_subject.hpp"

#include <utility>

#include "app/progress_bar.hpp"
#include "app/standard_streams.hpp"
#include "app/subject.hpp"
#include "app/touch_recording.hpp"
#include "app/unit_option.hpp"
#include "base/error.hpp"
#include "scene/scene_file.hpp"
#include "touch/contact_choice.hpp"
#include "touch/rate_choice.hpp"

namespace fingerpad {
namespace {

Scene touched_scene(const TouchOptions& options, const std::string& subject) {
  const SubjectKind kind = subject_kind(subject);
  if (kind == SubjectKind::trace) {
    throw Error(ErrorKind::usage, subject,
                "is a trace, or a table of numbers; touch a scene or a mesh, and view a trace");
  }
  Scene scene =
      kind == SubjectKind::scene ? single_scene(subject) : scene_of_mesh(subject, metres_of(options.unit));
  if (options.rate_hz) {
    scene.motion.rate_hz = *options.rate_hz;
    scene.motion.automatic_rate = false;
  } else if (const auto rate_hz = find_device(options.device)->rate_hz) {
    scene.motion.rate_hz = rate_hz(scene);
  }
  // Before the hand goes: the loop that it closes is what a person's own is taken for.
  const std::string reason = settle_live_rate(scene);
  if (!reason.empty()) print_err("fingerpad: {}: {}\n", scene.name, reason);
  return scene;
}

void warn_of_unread(const TouchOptions& options, const Scene& scene) {
  if (find_device(options.device)->reads_settings || scene.device == DeviceSettings{}) return;
  print_err(
      "fingerpad: warning: {}: [device] says how a device of its own lies in the world; --device {} does "
      "not read it\n",
      scene.name, options.device);
}

}  // namespace

Touched load_touched(const TouchOptions& options, const std::string& subject) {
  Touched touched{subject, touched_scene(options, subject), {}, {}};
  Scene& scene = touched.scene;
  warn_of_unread(options, scene);
  touched.hand = std::exchange(scene.hand, std::nullopt);
  if (!options.record.empty()) refuse_unrecordable(options.record, scene, options.force);
  const DeviceEntry& device = *find_device(options.device);
  if (device.refuse != nullptr) device.refuse(scene, options.link);
  LoadBar bar(stderr_is_terminal());
  touched.world = load_world(scene, bar.progress());
  bar.finish();
  tell_warnings(*touched.world);
  tell_unit_hints(*touched.world, scene);
  tell_choice(*touched.world);
  scene.contact.normals = settled_contact(scene, *touched.world).normals;  // for the window's own search
  return touched;
}

}  // namespace fingerpad
