#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.hpp"
#include "scene/scene_file.hpp"

namespace fingerpad::test {

/// A scene that needs no file.
inline const std::string plane_scene =
    "name = \"plane\"\n"
    "[[plane]]\n"
    "point_m = [0, 0, 0]\n"
    "normal = [0, 0, 1]\n";

inline Scene read_scene(const std::string& text) {
  return read_scene_text(text, "s.toml").scene;
}

/// The message of the refusal; empty if the text is accepted.
inline std::string refusal(const std::string& text, const std::string& path = "s.toml") {
  try {
    read_scene_text(text, path);
  } catch (const Error& error) {
    return error.kind() == ErrorKind::refused ? error.what()
                                              : "not refused but failed: " + std::string(error.what());
  }
  return {};
}

inline void write_file(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace fingerpad::test
