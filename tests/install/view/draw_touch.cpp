// Draws a trace: draw_touch slide.h5 slide.png
#include <cstdio>
#include <fingerpad/fingerpad.hpp>

int main(int argc, char** argv) try {
  if (argc != 3)
    throw fingerpad::Error(fingerpad::ErrorKind::usage, "draw_touch", "name a trace and a picture");
  fingerpad::draw_trace(argv[1], argv[2], {.width = 640, .height = 400});
  return 0;
} catch (const fingerpad::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return static_cast<int>(error.kind());
}
