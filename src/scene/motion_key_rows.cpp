#include <fmt/format.h>

#include <limits>

#include "motion/farthest.hpp"
#include "scene/motion_values.hpp"
#include "scene/scene_key_makers.hpp"
#include "scene/scene_key_rows.hpp"
#include "scene/scene_values.hpp"

namespace fingerpad {
namespace {

// Where the keys of the table go.
MotionSettings& motion(Scene& scene) {
  return scene.motion;
}
ScriptedMotion& script(Scene& scene) {
  return *scene.motion.scripted;
}
SurfaceMotion& laid(Scene& scene) {
  return *scene.motion.laid;
}
MotionPlacement& placement(Scene& scene) {
  return scene.motion.placement;
}

/// How a motion's file is to be read, and what is to be made of it.
std::vector<SceneKey> recording_keys() {
  using M = MotionSettings;
  std::vector<SceneKey> keys = {
      table_key("columns", "", read_recording_columns),
      recording_unit_key("unit"),
      time_unit_key("time_unit"),
      force_unit_key("force_unit"),
      text_key("separator", "\"auto\"", "or \",\", \";\", \"tab\", \"space\", between the file's cells",
               read_separator),
      text_key("decimal", "\".\"", "or \",\", in the file's numbers", read_decimal),
      number_key<motion, &M::encoder_m>("encoder_m", 0, 1, "position quantum; 0: positions are not rounded"),
      number_key<motion, &M::smoothing_hz>("smoothing_hz", 0, 1e6,
                                           "low pass without delay that halves this; 0: none"),
      normal_force_key("normal_force"),
      field_format_key("format"),
      text_key("positions", "\"position.csv\"", "where a format has them in a file of their own",
               read_positions_file),
      force_on_key("force_on"),
      chosen_rows_key("subject", "of a table of several, by its column", read_chosen_subject),
      chosen_rows_key("trial", "likewise", read_chosen_trial),
  };
  for (SceneKey& key : keys) key = beside("file", std::move(key));
  return keys;
}

std::vector<SceneKey> scripted_keys() {
  using M = ScriptedMotion;
  return {
      motion_kind_key("kind"),
      only_with({"line"}, required(vector_key<script, &M::from_m>("from_m", ""))),
      only_with({"line"}, required(vector_key<script, &M::to_m>("to_m", ""))),
      only_with({"line", "on_surface"}, required(speed_key("speed_m_per_s"))),
      only_with({"sine", "circle"}, required(vector_key<script, &M::centre_m>("centre_m", ""))),
      only_with({"circle"}, direction_key<script, &M::normal>("normal", "")),
      only_with({"sine", "circle"}, direction_key<script, &M::direction>("direction", "")),
      only_with({"sine"}, required(number_key<script, &M::amplitude_m>("amplitude_m", 0, farthest_m, ""))),
      only_with({"circle"}, required(number_key<script, &M::amplitude_m>("radius_m", 0, farthest_m, ""))),
      only_with({"sine", "circle"},
                required(number_key<script, &M::frequency_hz>("frequency_hz", 0, 1e9, ""))),
      only_with({"sine", "circle"},
                required(number_key<script, &M::duration_s>("duration_s", 1e-9, 1e9, ""))),
  };
}

/// Of a motion laid on the first part.
std::vector<SceneKey> laid_keys() {
  using L = SurfaceMotion;
  std::vector<SceneKey> keys = {
      shape_key("shape"),
      whole_key<laid, &L::place>("place", 0, std::numeric_limits<std::int64_t>::max(),
                                 "which random place and direction"),
      required(number_key<laid, &L::size_m>("size_m", 1e-9, farthest_m,
                                            "length of the line, radius of the circle and the spiral")),
      number_key<laid, &L::turns>("turns", 1e-3, 100, "of the circle and the spiral; strokes of the line"),
      number_key<laid, &L::depth_m>("depth_m", 0, farthest_m, "pressed in so deep; or"),
      number_key<laid, &L::normal_force_n>("normal_force_n", 0, 1e9, "pressed in with so much"),
  };
  for (SceneKey& key : keys) key = only_with({"on_surface"}, std::move(key));
  return keys;
}

std::vector<SceneKey> placement_keys() {
  using P = MotionPlacement;
  return {
      frame_key("frame"),
      vector_key<placement, &P::position_m>("position_m", "where the motion's own origin lies in it"),
      table_key("rotation", "", read_motion_rotation),
  };
}

}  // namespace

std::vector<SceneKey> recording_column_keys() {
  std::vector<SceneKey> keys;
  keys.reserve(recording_columns.size());
  for (const RecordingColumn& column : recording_columns)
    keys.push_back(text_key(column.key, fmt::format("\"{}\"", column.header), "", read_recording_column));
  return keys;
}

std::vector<SceneKey> motion_keys() {
  return joined_keys(
      {{rate_key("rate_hz"),
        text_key("file", "\"motions/rub.csv\"",
                 "t_s,x_m,y_m,z_m and optionally dx,dy,dz or qw,qx,qy,qz; or a trace", read_motion_file)},
       recording_keys(),
       scripted_keys(),
       laid_keys(),
       placement_keys()});
}

}  // namespace fingerpad
