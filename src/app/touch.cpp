#include "touch/touch.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>

#include "app/commands.hpp"
#include "app/output_name.hpp"
#include "app/progress_bar.hpp"
#include "app/standard_streams.hpp"
#include "app/subject.hpp"
#include "app/unit_option.hpp"
#include "base/error.hpp"
#include "base/file_identity.hpp"
#include "base/output_place.hpp"
#include "base/printable_text.hpp"
#include "device/device_table.hpp"
#include "replay/batch_files.hpp"
#include "replay/run_job.hpp"
#include "scene/scene_file.hpp"
#include "scene/toml_table.hpp"
#include "touch/rate_choice.hpp"
#include "touch/servo_loop.hpp"
#include "trace/live_recorder.hpp"
#include "view/screen.hpp"
#include "view/touch_window.hpp"

namespace fingerpad {
namespace {

/// Of the past that the window's charts may ask for.
constexpr double servo_history_s = 10;

struct TouchOptions {
  std::string subject, record;
  std::string device{device_table().front().name};
  std::string unit = "mm";
  std::optional<double> rate_hz;
  bool real_time = false;
};

Scene touched_scene(const TouchOptions& options) {
  const SubjectKind kind = subject_kind(options.subject);
  if (kind == SubjectKind::trace) {
    throw Error(ErrorKind::usage, options.subject, "is a trace; touch a scene or a mesh, and view a trace");
  }
  Scene scene = kind == SubjectKind::scene ? single_scene(options.subject)
                                           : scene_of_mesh(options.subject, metres_of(options.unit));
  if (options.rate_hz) {
    scene.motion.rate_hz = *options.rate_hz;
    scene.motion.automatic_rate = false;
  }
  // Before the hand goes: the loop that it closes is what a person's own is taken for.
  const std::string reason = settle_live_rate(scene);
  if (!reason.empty()) print_err("fingerpad: {}: {}\n", scene.name, reason);
  scene.hand.reset();  // a person holds the finger
  return scene;
}

std::unique_ptr<LiveRecorder> recorder_for(const TouchOptions& options, const Scene& scene,
                                           const World& world) {
  if (options.record.empty()) return nullptr;
  const TraceFormat format = options.record.ends_with(".csv") ? TraceFormat::csv : TraceFormat::hdf5;
  refuse_overwriting(options.record, input_files(scene));
  TraceInfo info = trace_info(scene, world, std::string(program_version));
  info.motion_file.clear();  // the person's, not the scene's
  info.motion_hash.clear();
  return std::make_unique<LiveRecorder>(TraceWriter::create(options.record, format, info, world));
}

/// Before the touch, whose record could not be made again.
void refuse_unrecordable(const std::string& path, const Scene& scene) {
  if (path == "-") throw Error(ErrorKind::usage, "--record", "a trace needs a file, not standard output");
  if (!is_utf8(scene.text))
    throw Error(ErrorKind::usage, scene.name, "its name is not UTF-8, as a trace's must be: rename it");
  refuse_unwritable(path);
}

void tell_timing(const ServoTiming& timing, double rate_hz) {
  print_out("{} ticks at {} Hz, {} of them late, the worst by {:.2g} ms\n", timing.ticks, rate_hz,
            timing.late_ticks, 1e3 * timing.worst_late_s);
  print_out("half of the ticks took up to {:.2g} us, 99.9 % up to {:.2g} us, the longest {:.2g} us\n",
            1e6 * timing.tick_times.quantile_s(0.5), 1e6 * timing.tick_times.quantile_s(0.999),
            1e6 * timing.worst_tick_s);
}

int touch(const TouchOptions& options) {
  if (!options.record.empty() && options.record != "-")
    refuse_other_endings(options.record, "touch --record", {".h5", ".csv"});
  need_display();  // before a long import
  Scene scene = touched_scene(options);
  if (!options.record.empty()) refuse_unrecordable(options.record, scene);
  LoadBar bar(stderr_is_terminal());
  const auto world = load_world(scene, bar.progress());
  bar.finish();
  tell_warnings(*world);
  tell_choice(*world);
  scene.contact.normals = settled_contact(scene, *world).normals;  // for the window's own search
  const auto recorder = recorder_for(options, scene, *world);
  const auto device = find_device(options.device)->make({scene, world, resting_finger(*world, scene)});

  const double dt_s = 1 / scene.motion.rate_hz;
  ServoLoop servo(
      Touch(world, scene), scene.motion.rate_hz, [&](double) { return device->advance(dt_s); },
      [&](const TickRecord& record) {
        device->feel(record);
        if (recorder) recorder->push(record);
      },
      servo_history_s, options.real_time);
  for (const std::string& line : servo.refused()) print_err("fingerpad: {}\n", line);
  TouchWindowInput input;
  input.view.title = scene.name;
  input.view.world = world;
  input.view.scene = scene;
  input.set_target = [&](const FingerSample& target) { device->set_target(target); };
  input.look_from = [&](const Vec3& towards_eye_W) { device->look_from(towards_eye_W); };
  input.latest = [&] { return servo.latest(); };
  input.timing = [&] { return servo.timing(); };
  input.recent = [&](double seconds) { return servo.recent(seconds); };
  if (recorder) input.note = "recording " + options.record;
  run_touch_window(input, WindowOptions{});

  servo.stop();
  const ServoTiming timing = servo.timing();
  tell_timing(timing, scene.motion.rate_hz);
  if (!recorder) return 0;
  recorder->note_timing(timing);
  recorder->finish();
  print_out("{} ticks recorded in {}\n", recorder->recorded(), options.record);
  if (recorder->dropped() > 0) {
    print_err("fingerpad: warning: {}: {} ticks were lost because the disk was too slow\n", options.record,
              recorder->dropped());
  }
  return 0;
}

/// What is wrong with a device's name; empty where there is such a device.
std::string why_no_device(const std::string& name) {
  if (find_device(name) != nullptr) return {};
  std::vector<std::string> names;
  for (const DeviceEntry& device : device_table()) {
    names.emplace_back(device.name);
    if (!device.also.empty()) names.emplace_back(device.also);
  }
  const std::string nearest = nearest_word(name, names);
  return fmt::format("unknown device '{}'{} (known: {})", name,
                     nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest), word_list(names));
}

}  // namespace

void add_touch(CLI::App& program, Action& action) {
  auto options = std::make_shared<TouchOptions>();
  CLI::App* command =
      program.add_subcommand("touch", "Touch a scene or a mesh live, with the finger under the mouse");
  command->add_option("SUBJECT", options->subject, "Scene (TOML) or mesh; - is a scene on standard input")
      ->required();
  command->add_option("--device", options->device, "What moves the finger, see below")
      ->check(CLI::Validator(why_no_device, "NAME"))
      ->capture_default_str();
  refuse_empty(command->add_option("--record", options->record, "Write a trace of the touch (.h5, or .csv)"));
  command->add_option("--rate", options->rate_hz, "Ticks a second [Hz]; default: the scene's")
      ->check(CLI::Range(1.0, 100000.0));
  command->add_flag("--realtime", options->real_time,
                    "Ask for SCHED_FIFO, a core and locked memory; goes on without what is not permitted");
  add_unit_option(*command, options->unit);
  command->footer(
      "Hold the left button (or space) to press; wheel, Page Up and Page Down change how hard; h shows all "
      "keys.\n"
      "The tick runs on a thread of its own and does not wait for the window.\n" +
      device_help_text());
  command->callback([options, &action] { action = [options] { return touch(*options); }; });
}

}  // namespace fingerpad
