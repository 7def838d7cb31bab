#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/stop_signals.hpp"
#include "device/live_device.hpp"
#include "touch/servo_loop.hpp"
#include "trace/live_recorder.hpp"

namespace fingerpad {

/// What of the command line a live touch's window goes by.
struct LiveWindowChoice {
  std::string subject;                 ///< what is touched, as it was named
  std::string record;                  ///< the trace; empty: none
  std::string size;                    ///< "1280x800"
  std::optional<double> seconds = {};  ///< none: until it is closed
  bool real_time = false;
  bool pointer_leads = true;  ///< the device follows what is done in the window
};

/// A live touch under way.
struct LiveTouch {
  const Scene& scene;
  std::shared_ptr<const World> world;
  LiveDevice& device;
  ServoLoop& servo;
  TouchSwap& swap;
  const LiveRecorder* recorder;  ///< may be null
  /// A file was dropped onto the window. @returns why it cannot be touched; empty: the window closes for it
  std::function<std::string(const std::string& path)> on_drop;
  /// The window was taken away from outside: ends the touch and the program. Any thread.
  std::function<void()> on_loss;
};

/// The options of a window, where there can be one.
void add_live_window_options(CLI::App& command, std::string& size);

/// Before a long import: throws Error (usage) where no window, or none of that size, can be opened.
void need_live_window(const LiveWindowChoice& choice);

/// Opens the window of a touch and returns when it is closed, when its seconds or the device's motion are
/// over, or when a signal asks to stop.
void run_live_window(const LiveWindowChoice& choice, const LiveTouch& touch, const StopSignals& signals);

}  // namespace fingerpad
