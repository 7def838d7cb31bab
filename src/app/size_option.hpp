#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "base/error.hpp"
#include "view/picture.hpp"

namespace fingerpad {

/// How large a window or a picture is.
struct PictureSize {
  int width = 0, height = 0;
};

/// Reads WxH. Throws Error (usage) for anything else and for what refuse_picture_size refuses.
inline PictureSize read_size(const std::string& text) {
  PictureSize size;
  char extra = 0;
  // Five digits, since more do not fit into an int and are too many in any case.
  if (std::sscanf(text.c_str(), "%5dx%5d%c", &size.width, &size.height, &extra) != 2)
    throw Error(ErrorKind::usage, "--size", "'" + text + "' is not WxH in pixels, as 1280x800");
  refuse_picture_size(size.width, size.height);
  return size;
}

inline void add_size_option(CLI::App& command, std::string& size, const std::string& what) {
  command
      .add_option("--size", size,
                  fmt::format("Size of {} in pixels: 200 to 8192 each way, 10 million in all (1 GB)", what))
      ->type_name("WxH")
      ->capture_default_str();
}

}  // namespace fingerpad
