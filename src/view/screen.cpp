#include "view/screen.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>

#include "base/error.hpp"
#include "view/find_program.hpp"

namespace fingerpad {
namespace {

constexpr int start_timeout_ms = 20'000;  // Xvfb needs a tenth of a second; a loaded machine may take long

/// In the child, between fork and exec: only calls that are safe there.
[[noreturn]] void become_xvfb(const char* program, int number_pipe, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  setsid();  // Ctrl-C is for the program, which then ends this one
  const int null = open("/dev/null", O_RDWR);
  dup2(null, STDIN_FILENO);
  dup2(null, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
  if (number_pipe == 3) {
    fcntl(3, F_SETFD, 0);
  } else {
    dup2(number_pipe, 3);
  }
  execl(program, "Xvfb", "-displayfd", "3", "-screen", "0", "2560x1600x24", "-nolisten", "tcp", "-noreset",
        nullptr);
  _exit(127);
}

/// The display's number, which Xvfb writes when it is ready; empty if it does not come.
std::string read_number(int pipe) {
  std::string number;
  for (char c = 0;;) {
    pollfd waiting{pipe, POLLIN, 0};
    const int ready = poll(&waiting, 1, start_timeout_ms);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0 || read(pipe, &c, 1) != 1) return "";
    if (c == '\n') return number;
    number += c;
  }
}

void end_process(int process) {
  kill(process, SIGTERM);
  for (int i = 0; i < 200; ++i) {
    if (waitpid(process, nullptr, WNOHANG) != 0) return;
    usleep(10'000);
  }
  kill(process, SIGKILL);
  waitpid(process, nullptr, 0);
}

}  // namespace

bool has_display() {
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') return false;
  // Loaded by hand, so that programs that never draw need no X library.
  void* library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) return false;
  const auto open_display = reinterpret_cast<void* (*)(const char*)>(dlsym(library, "XOpenDisplay"));
  // Never closed: an X server may reset when its last client leaves and turn the next one away meanwhile, and
  // that next one would be VTK, which aborts.
  return open_display != nullptr && open_display(nullptr) != nullptr;
}

VirtualScreen::VirtualScreen() {
  const std::string program = find_program("Xvfb");
  if (program.empty()) {
    throw Error(ErrorKind::usage, "no display",
                "nothing can be drawn: set DISPLAY, or install a virtual screen (apt-get install xvfb)");
  }
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error(ErrorKind::fault, "Xvfb", "no pipe to it can be made");
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) become_xvfb(program.c_str(), ends[1], parent);
  close(ends[1]);
  const std::string number = process_ > 0 ? read_number(ends[0]) : "";
  close(ends[0]);
  if (number.empty()) {
    if (process_ > 0) end_process(process_);
    throw Error(ErrorKind::fault, program, "did not start; set DISPLAY to a screen that works");
  }
  display_ = ":" + number;
  const char* previous = std::getenv("DISPLAY");
  had_display_ = previous != nullptr;
  if (had_display_) previous_display_ = previous;
  setenv("DISPLAY", display_.c_str(), 1);
}

VirtualScreen::~VirtualScreen() {
  if (had_display_) {
    setenv("DISPLAY", previous_display_.c_str(), 1);
  } else {
    unsetenv("DISPLAY");
  }
  end_process(process_);
}

std::unique_ptr<VirtualScreen> screen_to_draw_on() {
  return has_display() ? nullptr : std::make_unique<VirtualScreen>();
}

void need_display(std::string_view instead) {
  if (has_display()) return;
  throw Error(ErrorKind::usage, "no display",
              fmt::format("a window needs a screen: set DISPLAY, or {}", instead));
}

}  // namespace fingerpad
