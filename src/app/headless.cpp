#include "app/headless.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "app/standard_streams.hpp"
#include "device/terminal_keys.hpp"

namespace fingerpad {
namespace {

/// Waits for so many seconds, without end where none are given, until a signal asks to stop, or until
/// `is_over` says so, which is asked many times a second.
void wait_without_window(std::optional<double> seconds, const StopSignals& signals,
                         const std::function<bool()>& is_over) {
  using Clock = std::chrono::steady_clock;
  constexpr double look_s = 0.05;
  const Clock::time_point start = Clock::now();
  for (;;) {
    double wait_s = look_s;
    if (seconds) {
      const double left_s = *seconds - std::chrono::duration<double>(Clock::now() - start).count();
      if (left_s <= 0) return;
      wait_s = std::min(wait_s, left_s);
    }
    if (signals.wait(wait_s) || is_over()) return;
  }
}

/// Tells of a device's trouble in a line, and when it is over, once either has lasted: a device that is late
/// now and then would fill the terminal otherwise.
class TroubleLog {
 public:
  explicit TroubleLog(const std::string& name) : name_(name) {}

  void look(std::string now) {
    constexpr auto lasts = std::chrono::milliseconds(300);
    const auto time = std::chrono::steady_clock::now();
    if (now != seen_) {
      has_begun_ |= seen_ && seen_->empty();
      seen_ = std::move(now);
      since_ = time;
    }
    if (time - since_ < lasts || *seen_ == told_) return;
    told_ = *seen_;
    const char* well = has_begun_ ? "goes on" : "a device is heard";
    print_err("fingerpad: {}: {}\n", name_, told_.empty() ? well : told_);
  }

 private:
  const std::string& name_;
  std::optional<std::string> seen_;  // nothing before the first look
  std::string told_;
  bool has_begun_ = false;  // there was a time without trouble, however short
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

/// Tells of the emergency stop, whoever asked for it: a device tells its own stop anew with each packet, so
/// that what a key has taken back may be on again at once.
class StopLog {
 public:
  StopLog(const std::string& name, bool has_keys)
      : name_(name),
        words_(has_keys
                   ? "STOPPED: no force until g, and the device, release it"
                   : "STOPPED: no force until the end (g in a terminal, or in a window, gives it back)") {}

  /// A key has asked for it, or for its end: what came of that is told. Any thread.
  void ask() { asked_ = true; }

  void look(bool is_stopped) {
    constexpr auto settles = std::chrono::milliseconds(300);
    const auto time = std::chrono::steady_clock::now();
    if (asked_.exchange(false)) {
      answered_ = false;
      since_ = time;
    }
    const bool begins = is_stopped && !told_;
    if (!begins && (answered_ || time - since_ < settles)) return;
    told_ = is_stopped;
    answered_ = true;
    print_err("fingerpad: {}: {}\n", name_, is_stopped ? words_ : "goes on");
  }

 private:
  const std::string& name_;
  const char* words_;
  std::atomic<bool> asked_{false};
  bool told_ = false, answered_ = true;
  std::chrono::steady_clock::time_point since_{};
};

}  // namespace

void run_headless(std::optional<double> seconds, const std::string& name, LiveDevice& device,
                  const StopSignals& signals) {
  std::atomic<bool> quit{false};
  const bool has_keys = device.has_motors() && has_terminal_keys();
  StopLog stop(name, has_keys);
  std::optional<TerminalKeys> keys;
  if (has_keys) {
    print_err("fingerpad: {}: x: emergency stop; g: give the force back; q: end\n", name);
    keys.emplace([&](std::string_view key) {
      if (key == "q") quit = true;
      if (key != "x" && key != "g") return;
      device.set_emergency_stop(key == "x");
      stop.ask();
    });
  }
  TroubleLog trouble(name);
  trouble.look(device.trouble());
  wait_without_window(seconds, signals, [&] {
    trouble.look(device.trouble());
    stop.look(device.emergency_stopped());
    return quit || device.has_ended();
  });
}

}  // namespace fingerpad
