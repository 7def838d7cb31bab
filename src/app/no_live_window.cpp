// In place of live_window.cpp in a program without VTK, as a servo process on a robot or a rig has it.
#ifndef FINGERPAD_VIEW
#include "app/live_window.hpp"
#include "base/error.hpp"

namespace fingerpad {

void add_live_window_options(CLI::App&, std::string&) {}

void need_live_window(const LiveWindowChoice&) {
  throw Error(ErrorKind::usage, "touch",
              "this program was built without a window (FINGERPAD_VIEW=OFF): add --headless");
}

void run_live_window(const LiveWindowChoice& choice, const LiveTouch&, const StopSignals&) {
  need_live_window(choice);
}

}  // namespace fingerpad
#endif
