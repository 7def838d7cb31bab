#include "public/finger_scene.hpp"

#include <fmt/format.h>

#include <string>

#include "scene/scene_file.hpp"
#include "scene/toml_tree.hpp"

namespace fingerpad {
namespace {

std::string quoted(const std::string& text) {
  return write_toml_value(toml_text(text));
}

/// A scene needs something to touch.
constexpr const char* any_plane = "[[plane]]\npoint_m = [0, 0, 0]\nnormal = [0, 0, 1]\n";

}  // namespace

Scene scene_of(const FingerOptions& options) {
  std::string text = any_plane;
  text +=
      fmt::format("[contact]\nmethod = {}\nnormals = {}\n[finger]\nradius_m = {}\n[motion]\nrate_hz = {}\n",
                  quoted(options.contact_method), quoted(options.normals), options.radius_m, options.rate_hz);
  text += fmt::format("[friction]\nlaw = {}\n", quoted(options.friction.law));
  for (const auto& [key, value] : options.friction.parameters)
    text += fmt::format("{} = {}\n", quoted(key), value);
  Scene scene = read_scene_text(text, "FingerOptions").scene;
  scene.planes.clear();
  scene.name.clear();
  scene.text.clear();  // of a world made in code no scene file tells
  return scene;
}

void refuse_impossible(const SurfaceProperties& properties) {
  read_scene_text(
      fmt::format("{}stiffness_n_per_m = {}\ndamping_n_s_per_m = {}\nmu_static = {}\nmu_dynamic = {}\n",
                  any_plane, properties.stiffness_n_per_m, properties.damping_n_s_per_m, properties.mu_static,
                  properties.mu_dynamic),
      "SurfaceProperties");
}

}  // namespace fingerpad
