#include "app/headless.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>

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
      seen_ = std::move(now);
      since_ = time;
    }
    if (seen_ == told_ || time - since_ < lasts) return;
    told_ = seen_;
    print_err("fingerpad: {}: {}\n", name_, told_.empty() ? "goes on" : told_);
  }

 private:
  const std::string& name_;
  std::string seen_, told_;
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

}  // namespace

void run_headless(std::optional<double> seconds, const std::string& name, LiveDevice& device,
                  const StopSignals& signals) {
  std::atomic<bool> quit{false};
  std::optional<TerminalKeys> keys;
  if (device.has_motors() && has_terminal_keys()) {
    print_err("fingerpad: {}: x: emergency stop; g: give the force back; q: end\n", name);
    keys.emplace([&](std::string_view key) {
      if (key == "q") quit = true;
      if (key != "x" && key != "g") return;
      device.set_emergency_stop(key == "x");
      print_err("fingerpad: {}: {}\n", name, key == "x" ? "STOPPED, g gives the force back" : "goes on");
    });
  }
  TroubleLog trouble(name);
  wait_without_window(seconds, signals, [&] {
    trouble.look(device.trouble());
    return quit || device.has_ended();
  });
}

}  // namespace fingerpad
