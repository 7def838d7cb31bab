// The [motion] table: a file, or a motion made from a formula.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "motion/finger_path.hpp"
#include "scene/key_ranges.hpp"
#include "scene/scene_keys.hpp"
#include "scene/scene_reader.hpp"
#include "scene/toml_table.hpp"

namespace fingerpad {
namespace {

const std::vector<std::string> kinds = {"line", "sine", "circle"};

/// The keys of [motion] that a kind has.
std::vector<std::string> keys_of_kind(const std::string& kind) {
  if (kind == "line") return {"from_m", "to_m", "speed_m_per_s"};
  if (kind == "sine") return {"centre_m", "direction", "amplitude_m", "frequency_hz", "duration_s"};
  if (kind == "circle") return {"centre_m", "normal", "direction", "radius_m", "frequency_hz", "duration_s"};
  return {};
}

/// Refuses keys of scripted motions that do not go with this kind ("" for a file).
void refuse_foreign_keys(const TomlTable& table, const std::string& kind) {
  const std::vector<std::string> own = keys_of_kind(kind);
  for (const std::string& other_kind : kinds) {
    for (const std::string& key : keys_of_kind(other_kind)) {
      if (!table.has(key) || std::find(own.begin(), own.end(), key) != own.end()) continue;
      if (kind.empty())
        throw table.error(key, fmt::format("{} needs kind = \"{}\"", table.name(key), other_kind));
      throw table.error(key, fmt::format("{} does not go with kind = \"{}\" (its keys: {})", table.name(key),
                                         kind, word_list(own)));
    }
  }
}

ScriptedMotion read_line(const TomlTable& table) {
  for (const char* key : {"from_m", "to_m", "speed_m_per_s"}) table.require(key);
  ScriptedMotion motion;
  motion.kind = ScriptedMotion::Kind::line;
  motion.from_m = table.vector("from_m", motion.from_m);
  motion.to_m = table.vector("to_m", motion.to_m);
  motion.speed_m_per_s = table.number("speed_m_per_s", 0, key_range("motion.speed_m_per_s"));
  motion.duration_s = (motion.to_m - motion.from_m).norm() / motion.speed_m_per_s;
  return motion;
}

ScriptedMotion read_sine(const TomlTable& table) {
  for (const char* key : {"centre_m", "amplitude_m", "frequency_hz", "duration_s"}) table.require(key);
  ScriptedMotion motion;
  motion.kind = ScriptedMotion::Kind::sine;
  motion.centre_m = table.vector("centre_m", motion.centre_m);
  motion.direction = table.direction("direction", motion.direction);
  motion.amplitude_m = table.number("amplitude_m", 0, key_range("motion.amplitude_m"));
  motion.frequency_hz = table.number("frequency_hz", 0, key_range("motion.frequency_hz"));
  motion.duration_s = table.number("duration_s", 0, key_range("motion.duration_s"));
  return motion;
}

ScriptedMotion read_circle(const TomlTable& table) {
  for (const char* key : {"centre_m", "radius_m", "frequency_hz", "duration_s"}) table.require(key);
  ScriptedMotion motion;
  motion.kind = ScriptedMotion::Kind::circle;
  motion.centre_m = table.vector("centre_m", motion.centre_m);
  motion.normal = table.direction("normal", motion.normal);
  // Any direction across the normal will do where none is given: that of the axis least along it.
  Eigen::Index least = 0;
  motion.normal.cwiseAbs().minCoeff(&least);
  const Vec3 start = table.direction("direction", Vec3::Unit(least));
  const Vec3 across = start - start.dot(motion.normal) * motion.normal;
  if (!(across.norm() > 1e-6)) {
    throw table.error("direction",
                      table.name("direction") + " is along 'normal'; the circle starts across it");
  }
  motion.direction = across.normalized();
  motion.amplitude_m = table.number("radius_m", 0, key_range("motion.radius_m"));
  motion.frequency_hz = table.number("frequency_hz", 0, key_range("motion.frequency_hz"));
  motion.duration_s = table.number("duration_s", 0, key_range("motion.duration_s"));
  return motion;
}

/// So long a motion would fill every disk.
void refuse_too_many_ticks(const TomlTable& table, const ScriptedMotion& motion, double rate_hz) {
  const double ticks = motion.duration_s * rate_hz;
  if (ticks <= most_ticks) return;
  const char* key = motion.kind == ScriptedMotion::Kind::line ? "speed_m_per_s" : "duration_s";
  throw table.error(key,
                    fmt::format("the motion lasts {} s, which is {:.3g} ticks at {} Hz; at most {:.0f} are "
                                "run: make it shorter or lower rate_hz",
                                number_text(motion.duration_s), ticks, number_text(rate_hz), most_ticks));
}

}  // namespace

MotionSettings read_motion_settings(const TomlNode& node, const std::string& path) {
  const TomlTable table(node, path, "[motion]", scene_keys("motion"));
  MotionSettings motion;
  motion.rate_hz = table.number("rate_hz", motion.rate_hz, key_range("motion.rate_hz"));
  if (table.has("file") && table.has("kind")) {
    throw table.error("kind", "[motion] has both 'file' and 'kind'; it takes one of them");
  }
  if (table.has("kind")) {
    const std::string& kind = kinds[table.choice("kind", 0, kinds)];
    refuse_foreign_keys(table, kind);
    motion.scripted = kind == "line"   ? read_line(table)
                      : kind == "sine" ? read_sine(table)
                                       : read_circle(table);
    refuse_too_many_ticks(table, *motion.scripted, motion.rate_hz);
    return motion;
  }
  refuse_foreign_keys(table, "");
  if (!table.has("file")) return motion;
  motion.file = table.text("file", "");
  if (motion.file.empty()) throw table.error("file", table.name("file") + " is empty");
  motion.file_path = resolved_path(path, motion.file);
  return motion;
}

}  // namespace fingerpad
