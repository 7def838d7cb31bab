#include "touch/touch.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "app/commands.hpp"
#include "app/headless.hpp"
#include "app/live_window.hpp"
#include "app/number_option.hpp"
#include "app/output_name.hpp"
#include "app/progress_bar.hpp"
#include "app/standard_streams.hpp"
#include "app/stop_signals.hpp"
#include "app/subject.hpp"
#include "app/touch_recording.hpp"
#include "app/touch_subject.hpp"
#include "app/unit_option.hpp"
#include "base/error.hpp"
#include "base/kept_thread.hpp"
#include "base/nearest_word.hpp"
#include "device/device_table.hpp"
#include "touch/resting_finger.hpp"
#include "touch/servo_loop.hpp"
#include "touch/servo_words.hpp"

namespace fingerpad {
namespace {

/// Of the past that the window's charts may ask for.
constexpr double servo_history_s = 10;

LiveWindowChoice window_choice(const TouchOptions& options, const std::string& subject) {
  return {subject,         options.record,    options.size,
          options.seconds, options.real_time, find_device(options.device)->needs_window};
}

/// What was asked for that the device does not read.
void refuse_unread(const TouchOptions& options) {
  const DeviceEntry& device = *find_device(options.device);
  const auto refuse = [&](const char* option, const char* what) {
    throw Error(ErrorKind::usage, option, fmt::format("--device {} {}: leave it out", options.device, what));
  };
  if (options.link.port && !device.takes_port) refuse("--port", "is reached by no port");
  if (options.link.bind && !device.takes_bind) refuse("--bind", "listens on no address");
}

void tell_device(const TouchOptions& options, const std::string& words) {
  if (!words.empty()) print_err("fingerpad: {}: {}\n", options.device, words);
}

/// On a terminal in a line of its own: "^C" stands in the one before.
void tell_signal(const TouchOptions& options) {
  print_err("{}fingerpad: {}: told to end, by Ctrl-C or another signal\n", stderr_is_terminal() ? "\n" : "",
            options.device);
}

void tell_touch_end(const TouchOptions& options, const FeltSum& felt, const ServoLoop& servo,
                    double rate_hz) {
  const ServoTiming timing = servo.timing();
  write_stream(stdout, touch_end_words(felt, timing, rate_hz));
  const RealTime real_time = !options.real_time        ? RealTime::not_asked
                             : servo.refused().empty() ? RealTime::granted
                                                       : RealTime::refused;
  const std::string advice = late_advice(timing, rate_hz, real_time);
  if (!advice.empty()) print_err("fingerpad: warning: {}\n", advice);
  const std::string unsettled = live_unsettled_words(static_cast<double>(felt.unsettled));
  if (!unsettled.empty()) print_err("fingerpad: warning: {}\n", unsettled);
}

/// @param after_end  ticks between the end of what moves the finger and the loop's
void finish_recording(const TouchOptions& options, LiveRecorder& recorder, const ServoTiming& timing,
                      long after_end) {
  recorder.note_timing(timing);
  recorder.finish();
  print_out("{} ticks recorded in {}{}\n", recorder.recorded(), options.record,
            after_end > 0 ? fmt::format("; {} came after the end", after_end) : "");
  if (recorder.dropped() > 0) {
    print_err("fingerpad: warning: {}: {} ticks were lost because the disk was too slow\n", options.record,
              recorder.dropped());
  }
}

/// Loads what was dropped onto the window. @returns why it is not touched; empty where it is
std::string take_drop(const TouchOptions& options, const std::string& path, std::optional<Touched>& dropped) {
  if (!find_device(options.device)->needs_window)
    return fmt::format("--device {} stays with what it touches", options.device);
  try {
    TouchOptions unrecorded = options;
    unrecorded.record.clear();
    dropped = load_touched(unrecorded, path);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// Touches until the end.
/// @param kept  older than any window, whose own thread stands back for ever, with all that it begins
/// @param lost  the recording's error, where there was one
/// @returns what was dropped onto the window, to be touched next; empty: nothing
std::optional<Touched> touch_once(const TouchOptions& options, const Touched& touched, KeptThread& kept,
                                  std::exception_ptr& lost) {
  const Scene& scene = touched.scene;
  const auto& world = touched.world;
  const DeviceEntry& entry = *find_device(options.device);
  const StopSignals signals;  // before a device changes the terminal, or a record is begun
  const auto device = kept.run([&] {
    return entry.make({scene, world, resting_finger(*world, scene), options.link, touched.hand});
  });
  TouchSwap swap(world, scene);
  swap.change_too([&](const World& changed, const Scene& by) { return device->ready_for(changed, by); });
  swap.schedule(device->scene_changes());
  const auto recorder =
      kept.run([&] { return start_recording(options.record, scene, *world, *device, swap); });
  for (const std::string& words : device->warnings()) print_err("fingerpad: warning: {}\n", words);
  tell_device(options, device->opening_words());

  const double dt_s = 1 / scene.motion.rate_hz;
  FingerSample sample;  // the servo's, as is:
  FeltSum felt;
  long after_end = 0;
  const auto take = [&](double) { return sample = device->advance(dt_s); };
  const auto give = [&](const TickRecord& record) {
    device->feel(record);
    felt.note(record);
    if (device->has_ended()) ++after_end;
    if (recorder && !device->has_ended()) recorder->push(as_recorded(record, sample, *device));
  };
  const auto loop = kept.run([&] {
    return std::make_unique<ServoLoop>(Touch(world, scene), scene.motion.rate_hz, take, give, servo_history_s,
                                       options.real_time, &swap);
  });
  ServoLoop& servo = *loop;
  for (const std::string& line : servo.refused()) print_err("fingerpad: {}\n", line);
  std::optional<Touched> dropped;
  const auto on_drop = [&](const std::string& path) {
    return recorder && !recorder->failed() ? "this touch is recorded: close its window first"
                                           : take_drop(options, path, dropped);
  };
  const auto end = [&] {
    servo.stop();
    if (signals.has_come()) tell_signal(options);
    tell_device(options, device->closing_words());
    tell_touch_end(options, felt, servo, scene.motion.rate_hz);
    if (recorder) finish_recording(options, *recorder, servo.timing(), after_end);
  };
  // Nothing that draws can be ended any more: the program ends from here, as if its window had been closed.
  const auto on_loss = [&] {
    int status = 0;
    try {
      end();
    } catch (const Error& error) {
      print_err("fingerpad: {}\n", error.what());
      status = static_cast<int>(error.kind());
    } catch (const std::exception& error) {
      print_err("fingerpad: {}\n", error.what());
      status = static_cast<int>(ErrorKind::fault);
    }
    std::fflush(nullptr);
    std::_Exit(status);
  };
  if (options.headless) {
    run_headless(options.seconds, options.device, *device, signals);
  } else {
    run_live_window(window_choice(options, touched.subject),
                    {scene, world, *device, servo, swap, recorder.get(), on_drop, on_loss}, signals);
  }
  try {
    end();
  } catch (const Error&) {
    lost = std::current_exception();
  }
  return dropped;
}

void refuse_folder(const std::string& subject) {
  std::error_code none;
  if (std::filesystem::is_directory(subject, none))
    throw refused(subject, "is a folder, not a scene or a mesh: name a file in it");
}

int touch(const TouchOptions& options) {
  if (!options.record.empty() && options.record != "-")
    refuse_other_endings(options.record, "touch --record", {".h5", ".csv"});
  refuse_folder(options.subject);
  refuse_unfit_subject(options.subject);
  if (options.headless && find_device(options.device)->needs_window) {
    throw Error(ErrorKind::usage, "--headless",
                fmt::format("--device {} is moved in a window: choose another device", options.device));
  }
  refuse_unread(options);
  if (!options.headless) need_live_window(window_choice(options, options.subject));
  KeptThread kept;
  std::optional<Touched> next = load_touched(options, options.subject);
  TouchOptions now_with = options;
  std::exception_ptr lost;
  while (next) {
    const Touched now = std::move(*next);
    next = touch_once(now_with, now, kept, lost);
    now_with.record.clear();  // a drop is taken where nothing is recorded, or no longer
  }
  if (lost) std::rethrow_exception(lost);
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
  return unknown_word_text("device", name, "", names);
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
  command->add_flag("--force", options->force, "Let --record write over a file that exists");
  command->add_flag("--headless", options->headless,
                    "Without a window, for a rig or a robot; a signal ends it, its trace whole");
  command->add_option("--seconds", options->seconds, "End after so long [s]; default: when told to")
      ->check(number_in(0, 1e9, "seconds"));
  command
      ->add_option("--port", options->link.port,
                   "Port of a device outside of the program; 0: a free one; default: the device's")
      ->check(whole_number_in(0, 65535));
  refuse_empty(command->add_option("--bind", options->link.bind,
                                   "Address that is listened on; default: 127.0.0.1; another lets others in"),
               "ADDRESS");
  add_live_window_options(*command, options->size);
  command->add_option("--rate", options->rate_hz, "Ticks a second [Hz]; default: the scene's")
      ->check(number_in(1, 100000, "hertz"));
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
