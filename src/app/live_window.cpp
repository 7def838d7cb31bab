#include "app/live_window.hpp"

#include "app/size_option.hpp"
#include "view/screen.hpp"
#include "view/touch_window.hpp"

namespace fingerpad {
namespace {

/// What is to be seen in red: the device's trouble, and the trace's.
std::string alarm_words(const LiveTouch& touch) {
  std::string words = touch.device.trouble();
  if (touch.recorder == nullptr || !touch.recorder->failed()) return words;
  if (!words.empty()) words += "; ";
  return words + "NOT RECORDED any longer: " + touch.recorder->fault();
}

}  // namespace

void add_live_window_options(CLI::App& command, std::string& size) {
  add_size_option(command, size, "the window");
}

void need_live_window(const LiveWindowChoice& choice) {
  need_display(headless_instead);
  read_size(choice.size);
}

void run_live_window(const LiveWindowChoice& choice, const LiveTouch& touch, const StopSignals& signals) {
  LiveDevice& device = touch.device;
  TouchWindowInput input;
  input.view.title = touch.scene.name;
  input.view.file = choice.subject;
  input.view.world = touch.world;
  input.view.scene = touch.scene;
  input.set_target = [&](const FingerSample& target) { device.set_target(target); };
  input.look_from = [&](const Vec3& towards_eye_W) { device.look_from(towards_eye_W); };
  input.pointer_leads = choice.pointer_leads;
  input.swap = &touch.swap;
  input.latest = [&] { return touch.servo.latest(); };
  input.timing = [&] { return touch.servo.timing(); };
  input.recent = [&](double seconds) { return touch.servo.recent(seconds); };
  input.is_over = [&] { return signals.has_come() || device.has_ended(); };
  if (device.has_motors()) {
    input.set_stop = [&](bool on) { device.set_emergency_stop(on); };
    input.is_stopped = [&] { return device.emergency_stopped(); };
  }
  input.keeps_pace = choice.real_time && touch.servo.refused().empty();
  if (touch.recorder != nullptr) {
    input.note = [&touch, words = "recording " + choice.record] {
      return touch.recorder->failed() ? std::string() : words;
    };
    input.view.recording = choice.record;
  }
  input.alarm = [&] { return alarm_words(touch); };
  WindowOptions window;
  const PictureSize size = read_size(choice.size);
  window.width = size.width;
  window.height = size.height;
  window.on_drop = touch.on_drop;
  window.on_loss = touch.on_loss;
  if (choice.seconds) window.events = {{*choice.seconds, WindowEvent::Kind::key, "q"}};
  run_touch_window(input, window);
}

}  // namespace fingerpad
