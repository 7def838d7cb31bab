// The [motion] table: a file, or a motion made from a formula.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"
#include "motion/finger_path.hpp"
#include "scene/motion_values.hpp"
#include "scene/scene_key.hpp"
#include "scene/scene_reader.hpp"
#include "scene/toml_table.hpp"

namespace fingerpad {
namespace {

/// Refuses keys of scripted motions that do not go with this kind ("" for a file).
void refuse_foreign_keys(const SceneTable& rows, const TomlTable& table, const std::string& kind) {
  std::vector<std::string> own;
  for (const SceneKey& row : rows.keys) {
    if (!row.only_with.empty() && goes_with(row, kind)) own.emplace_back(row.key);
  }
  for (const SceneKey& row : rows.keys) {
    if (!table.has(row.key) || goes_with(row, kind)) continue;
    if (kind.empty())
      throw table.error(row.key,
                        fmt::format("{} needs kind = \"{}\"", table.name(row.key), row.only_with.front()));
    throw table.error(row.key, fmt::format("{} does not go with kind = \"{}\" (its keys: {})",
                                           table.name(row.key), kind, word_list(own)));
  }
}

/// Refuses what says more of a file where the motion is made from a formula. Without either it stands: a set
/// may put the file in.
void refuse_keys_of_a_file(const SceneTable& rows, const TomlTable& table) {
  if (!table.has("kind")) return;
  for (const SceneKey& row : rows.keys) {
    if (row.beside.empty() || !table.has(row.key)) continue;
    throw table.error(row.key, fmt::format("{} goes with '{}', and the motion is made from its 'kind'",
                                           table.name(row.key), row.beside));
  }
}

/// One mark cannot both part cells and be within their numbers.
void refuse_one_mark(const TomlTable& table, const CsvDialect& dialect) {
  if (dialect.separator != dialect.decimal) return;
  throw table.error("separator",
                    fmt::format("{} and 'decimal' are both '{}'", table.name("separator"), dialect.decimal));
}

/// A key by which a table is read, if one stands there.
std::string first_table_key(const TomlTable& table) {
  for (const char* key : {"columns", "unit", "time_unit", "force_unit", "separator", "decimal", "format",
                          "positions", "force_on", "subject", "trial"}) {
    if (table.has(key)) return key;
  }
  return {};
}

/// The circle's start is across its normal.
void settle_circle(const TomlTable& table, ScriptedMotion& motion) {
  if (!table.has("direction")) {
    // Any direction across the normal will do: that of the axis least along it.
    Eigen::Index least = 0;
    motion.normal.cwiseAbs().minCoeff(&least);
    motion.direction = Vec3::Unit(least);
  }
  const Vec3 across = motion.direction - motion.direction.dot(motion.normal) * motion.normal;
  if (!(across.norm() > 1e-6)) {
    throw table.error("direction",
                      table.name("direction") + " is along 'normal'; the circle starts across it");
  }
  motion.direction = across.normalized();
}

/// So long a motion would fill every disk.
void refuse_too_many_ticks(const TomlTable& table, const char* key, double duration_s, double rate_hz) {
  const double ticks = duration_s * rate_hz;
  if (ticks <= most_ticks) return;
  throw table.error(
      key, fmt::format("the motion lasts {} s, which is {} ticks at {} Hz; at most {:.0f} are "
                       "run: make it shorter or lower rate_hz",
                       number_text(duration_s), rounded_text(ticks, 3), number_text(rate_hz), most_ticks));
}

/// A motion on a surface is placed by that, and pressed in by one of its two keys.
void settle_laid(const TomlTable& table, Scene& scene) {
  SurfaceMotion& rub = *scene.motion.laid;
  for (const char* key : {"frame", "position_m", "rotation"}) {
    if (table.has(key))
      throw table.error(
          key, table.name(key) + " does not go with kind = \"on_surface\", whose 'place' says where");
  }
  if ((rub.depth_m > 0) == (rub.normal_force_n > 0))
    throw table.error(
        table.has("depth_m") ? "depth_m" : "kind",
        "a motion on a surface is pressed in by 'depth_m' or by 'normal_force_n': give one of them");
  if (scene.parts.empty()) return;  // a set may still give it; read_scene asks
  if (!scene.motion.is_rate_open())
    refuse_too_many_ticks(table, "speed_m_per_s", duration_s(rub, pressed_depth_m(scene)),
                          scene.motion.rate_hz);
}

}  // namespace

double pressed_depth_m(const Scene& scene) {
  const SurfaceMotion& rub = *scene.motion.laid;
  if (rub.depth_m > 0) return rub.depth_m;
  return rub.normal_force_n / scene.parts.front().surface.stiffness_n_per_m;
}

void read_motion_settings(const TomlNode& node, Scene& scene) {
  const SceneTable& rows = scene_table("motion");
  const TomlTable table = open_table(node, scene.path, rows);
  if (table.has("file") && table.has("kind"))
    throw table.error("kind", "[motion] has both 'file' and 'kind'; it takes one of them");
  const SceneKey& kind_row = scene_key(rows, "kind");
  std::string kind;
  if (table.has("kind")) kind = kind_row.words[table.choice("kind", 0, kind_row.words)];
  refuse_foreign_keys(rows, table, kind);
  refuse_keys_of_a_file(rows, table);
  read_keys(rows, table, scene, kind);
  refuse_one_mark(table, scene.motion.format.dialect);
  scene.motion.table_key = first_table_key(table);
  if (scene.motion.laid) settle_laid(table, scene);
  if (!scene.motion.scripted) return;
  ScriptedMotion& motion = *scene.motion.scripted;
  if (motion.kind == ScriptedMotion::Kind::line)
    motion.duration_s = (motion.to_m - motion.from_m).norm() / motion.speed_m_per_s;
  if (motion.kind == ScriptedMotion::Kind::circle) settle_circle(table, motion);
  if (scene.motion.is_rate_open()) return;
  const bool is_line = motion.kind == ScriptedMotion::Kind::line;
  refuse_too_many_ticks(table, is_line ? "speed_m_per_s" : "duration_s", motion.duration_s,
                        scene.motion.rate_hz);
}

}  // namespace fingerpad
