#include "scene/scene_values.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <numbers>

#include "base/input_file.hpp"
#include "base/printable_text.hpp"
#include "base/unit.hpp"
#include "contact/normals.hpp"
#include "scene/pad_profile_file.hpp"
#include "scene/scene_key_makers.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

bool is_beyond_ascii(char c) {
  return static_cast<unsigned char>(c) >= 0x80;
}

/// Whether a file's name cannot hold this byte, or should not.
bool is_bad_in_name(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == '/' || c == '\\' || c == 0x7f;
}

void take_unit(Scene& scene, std::size_t word) {
  scene.parts.back().metres_per_unit = length_units[word].metres;
}

/// The rotation that stands at a key of a table.
/// @param rows  of its axis and angle
Mat3 rotation_of(const SceneKey& row, const TomlTable& owner, const SceneTable& rows, Scene& scene) {
  const TomlNode& value = *owner.value(row.key);
  if (!value.is(TomlNode::Type::table)) {
    throw owner.error(row.key, fmt::format("{} must be {{ axis = [x, y, z], angle_deg = a }}, not {}",
                                           owner.name(row.key), type_text(value.type)));
  }
  const TomlTable table = open_table(value, owner.file(), rows);
  read_keys(rows, table, scene);
  const Vec3 axis = table.direction("axis", Vec3::UnitZ());
  const double angle_deg = table.number("angle_deg", 0, scene_key(rows, "angle_deg").range);
  return Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180, axis).toRotationMatrix();
}

}  // namespace

std::string text_that_is_there(const SceneKey& row, const TomlTable& table) {
  std::string text = table.text(row.key, "");
  if (text.empty()) throw table.error(row.key, table.name(row.key) + " is empty");
  return text;
}

std::string resolved_path(const std::string& scene_path, const std::string& written) {
  if (written.empty()) return {};
  // A scene that comes as a stream has no folder: its paths start where the program was called.
  if (stream_descriptor(scene_path)) return written;
  return (fs::path(scene_path).parent_path() / written).string();
}

std::string name_of_file(const std::string& path) {
  std::string name;
  if (!stream_descriptor(path)) name = fs::path(path).stem().string();
  std::replace_if(name.begin(), name.end(), is_bad_in_name, '_');
  if (name.starts_with('-')) name.front() = '_';
  if (printable(name) != name) std::replace_if(name.begin(), name.end(), is_beyond_ascii, '_');
  return name.empty() ? "scene" : name;
}

void read_name(const SceneKey& row, const TomlTable& top, Scene& scene) {
  const std::string name = top.text(row.key, "");
  if (name.empty() || name.size() > 200 || name == "." || name == ".." || name.starts_with('-') ||
      printable(name) != name || std::any_of(name.begin(), name.end(), is_bad_in_name)) {
    throw top.error(
        row.key,
        "'name' names the files that replay writes: 1 to 200 bytes, no '/', no '\\', no '-' at its"
        " beginning, no control characters");
  }
  scene.name = name;
}

void read_mesh(const SceneKey& row, const TomlTable& part, Scene& scene) {
  PartEntry& entry = scene.parts.back();
  entry.mesh = text_that_is_there(row, part);
  entry.mesh_path = resolved_path(scene.path, entry.mesh);
}

void read_rotation(const SceneKey& row, const TomlTable& part, Scene& scene) {
  scene.parts.back().rotation = rotation_of(row, part, scene_table("part.rotation"), scene);
}

void read_motion_rotation(const SceneKey& row, const TomlTable& motion, Scene& scene) {
  scene.motion.placement.rotation = rotation_of(row, motion, scene_table("motion.rotation"), scene);
}

void read_device_rotation(const SceneKey& row, const TomlTable& device, Scene& scene) {
  scene.device.rotation = rotation_of(row, device, scene_table("device.rotation"), scene);
}

void read_vibration(const SceneKey& row, const TomlTable& friction, Scene& scene) {
  const TomlNode& value = *friction.value(row.key);
  if (value.is(TomlNode::Type::boolean) && !value.boolean) return;
  if (!value.is(TomlNode::Type::table)) {
    throw friction.error(row.key,
                         friction.name(row.key) + " must be false or a table such as { frequency_hz = 89 }");
  }
  const SceneTable& rows = scene_table("friction.vibration");
  scene.friction.vibration.emplace();
  read_keys(rows, open_table(value, friction.file(), rows), scene);
}

void read_profile_key(const SceneKey& row, const TomlTable& finger, Scene& scene) {
  scene.finger.profile = finger.text(row.key, "");
  if (scene.finger.profile.empty()) return;
  scene.finger.profile_path = resolved_path(scene.path, scene.finger.profile);
  if (const auto why = why_unreadable(scene.finger.profile_path, profile_file)) {
    throw finger.error(row.key, fmt::format("the profile {} {}", scene.finger.profile_path, *why));
  }
  scene.friction.settings.profile = read_profile(scene.finger.profile_path);
}

void read_axes(const SceneKey& row, const TomlTable& hand, Scene& scene) {
  auto& free_axis = scene.hand->free_axis;
  const std::string axes = hand.text(row.key, "");
  for (int i = 0; i < 3; ++i) free_axis[i] = axes.find("xyz"[i]) != std::string::npos;
  const auto given = static_cast<std::size_t>(free_axis[0] + free_axis[1] + free_axis[2]);
  if (axes.empty() || given != axes.size()) {
    throw hand.error(row.key,
                     hand.name(row.key) + " must name some of x, y and z, each once, such as \"xy\"");
  }
}

void take_method(Scene& scene, std::string_view word) {
  scene.contact.method = word;
}

void take_normals(Scene& scene, std::string_view word) {
  scene.contact.automatic_normals = word == automatic_method;
  if (const Normals* named = find_normals(word); named != nullptr) scene.contact.normals = *named;
}

SceneKey unit_key(std::string_view key) {
  return choice_key<take_unit>(key, length_unit_names(), "mm", "");
}

}  // namespace fingerpad
