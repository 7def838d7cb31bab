#include "view/screen.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "view/picture.hpp"
#include "view/rub.hpp"
#include "view/window.hpp"

namespace fingerpad::test {
namespace {

/// What a child process without a display and with this PATH ends with: the kind of Error thrown, 0 for none,
/// negative for a signal.
template <typename Act>
int kind_in_child(const char* path, const char* display, Act act) {
  const pid_t child = fork();
  if (child == 0) {
    setenv("PATH", path, 1);
    if (display != nullptr) {
      setenv("DISPLAY", display, 1);
    } else {
      unsetenv("DISPLAY");
    }
    int kind = 0;
    try {
      act();
    } catch (const Error& error) {
      kind = static_cast<int>(error.kind());
      if (std::string_view(error.what()).find('\n') != std::string_view::npos) kind = 100;
    }
    _exit(kind);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

void draw() {
  view_pixels(torus_rub(0.05), 300, 200, {}, {});
}

TEST(Screen, NoDisplayAndNoXvfbIsAUsageErrorOfOneLine) {
  EXPECT_EQ(kind_in_child("/nonexistent", nullptr, draw), 2);
}

TEST(Screen, ADisplayThatDoesNotAnswerIsNone) {
  EXPECT_EQ(kind_in_child("/nonexistent", ":98765", draw), 2);
}

TEST(Screen, AWindowWithoutDisplayIsAUsageError) {
  const auto open = [] { run_view_window(torus_rub(0.05), {}); };
  EXPECT_EQ(kind_in_child("/usr/bin:/bin", nullptr, open), 2);
}

TEST(Screen, AVirtualScreenAnswersAndEnds) {
  const char* before = std::getenv("DISPLAY");
  const std::string previous = before != nullptr ? before : "";
  std::string display;
  {
    const VirtualScreen screen;
    display = screen.display();
    EXPECT_TRUE(has_display());
    EXPECT_EQ(std::getenv("DISPLAY"), display);
  }
  const char* after = std::getenv("DISPLAY");
  EXPECT_EQ(after != nullptr ? after : "", previous);
  setenv("DISPLAY", display.c_str(), 1);
  EXPECT_FALSE(has_display());
  if (before != nullptr) {
    setenv("DISPLAY", previous.c_str(), 1);
  } else {
    unsetenv("DISPLAY");
  }
}

TEST(Screen, AVirtualScreenEndsWithItsProcess) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    const VirtualScreen screen;
    const std::string name = screen.display() + "\n";
    const auto written = write(ends[1], name.data(), name.size());
    raise(SIGKILL);
    _exit(static_cast<int>(written));
  }
  close(ends[1]);
  std::string display;
  for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) display += c;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  ASSERT_FALSE(display.empty());
  const char* before = std::getenv("DISPLAY");
  const std::string previous = before != nullptr ? before : "";
  setenv("DISPLAY", display.c_str(), 1);
  bool gone = false;
  for (int i = 0; i < 500 && !gone; ++i) {  // the kernel ends it within moments, 5 s on a loaded machine
    gone = !has_display();
    usleep(10'000);
  }
  EXPECT_TRUE(gone) << display;
  if (before != nullptr) {
    setenv("DISPLAY", previous.c_str(), 1);
  } else {
    unsetenv("DISPLAY");
  }
}

}  // namespace
}  // namespace fingerpad::test
