#include "scene/motion_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/unit.hpp"
#include "motion/farthest.hpp"
#include "motion/field_format.hpp"
#include "scene/scene_key_makers.hpp"
#include "scene/scene_values.hpp"

namespace fingerpad {
namespace {

void take_kind(Scene& scene, std::size_t word) {
  constexpr std::array kinds{ScriptedMotion::Kind::line, ScriptedMotion::Kind::sine,
                             ScriptedMotion::Kind::circle};
  if (word == kinds.size()) {
    scene.motion.laid.emplace();
  } else {
    scene.motion.scripted.emplace().kind = kinds[word];
  }
}

void take_shape(Scene& scene, std::size_t word) {
  constexpr std::array shapes{SurfaceMotion::Shape::line, SurfaceMotion::Shape::circle,
                              SurfaceMotion::Shape::spiral};
  scene.motion.laid->shape = shapes[word];
}

void take_frame(Scene& scene, std::size_t word) {
  scene.motion.placement.in_part = word == 1;
}

void take_recording_unit(Scene& scene, std::size_t word) {
  scene.motion.format.says_unit = true;
  scene.motion.format.metres_per_unit = length_units[word].metres;
}

void take_time_unit(Scene& scene, std::size_t word) {
  scene.motion.format.says_time_unit = true;
  scene.motion.format.seconds_per_unit = time_units[word].seconds;
}

void take_force_unit(Scene& scene, std::size_t word) {
  scene.motion.format.says_force_unit = true;
  scene.motion.format.newtons_per_unit = force_units[word].newtons;
}

void take_normal_force(Scene& scene, std::size_t word) {
  scene.motion.format.reads_normal_force = word == 1;
}

void take_force_on(Scene& scene, std::size_t word) {
  scene.motion.format.forces_on_surface = word == 1;
}

/// A normal force may be a component of the force.
bool may_share_a_column(std::size_t one, std::size_t other) {
  const auto is_force = [](std::string_view key) { return key == "fx" || key == "fy" || key == "fz"; };
  return (recording_columns[one].key == "fn" && is_force(recording_columns[other].key)) ||
         (recording_columns[other].key == "fn" && is_force(recording_columns[one].key));
}

/// Whether the program is to choose a number. Throws Error (refused) for another word than that.
bool is_automatic(const SceneKey& row, const TomlTable& table) {
  const TomlNode& value = *table.value(row.key);
  if (!value.is(TomlNode::Type::text)) return false;
  if (value.text == automatic_method) return true;
  throw table.error(row.key, fmt::format("{} must be a number or \"{}\", not \"{}\"", table.name(row.key),
                                         automatic_method, value.text));
}

MotionSettings& motion_of(Scene& scene) {
  return scene.motion;
}

}  // namespace

void read_motion_file(const SceneKey& row, const TomlTable& motion, Scene& scene) {
  scene.motion.file = text_that_is_there(row, motion);
  scene.motion.file_path = resolved_path(scene.path, scene.motion.file);
}

void read_recording_columns(const SceneKey& row, const TomlTable& motion, Scene& scene) {
  const TomlNode& value = *motion.value(row.key);
  if (!value.is(TomlNode::Type::table)) {
    throw motion.error(row.key,
                       fmt::format("{} must be a table such as {{ t = \"time\", x = \"X\" }}, not {}",
                                   motion.name(row.key), type_text(value.type)));
  }
  const SceneTable& rows = scene_table("motion.columns");
  const TomlTable columns = open_table(value, motion.file(), rows);
  read_keys(rows, columns, scene);
  const auto& headers = scene.motion.format.headers;
  for (std::size_t i = 0; i < headers.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (headers[i].empty() || headers[i] != headers[k] || may_share_a_column(i, k)) continue;
      throw columns.error(recording_columns[i].key, fmt::format("{} and '{}' are both the column '{}'",
                                                                columns.name(recording_columns[i].key),
                                                                recording_columns[k].key, headers[i]));
    }
  }
}

void read_recording_column(const SceneKey& row, const TomlTable& columns, Scene& scene) {
  const std::string name = text_that_is_there(row, columns);
  if (name != trimmed(name))
    throw columns.error(row.key,
                        columns.name(row.key) + " has blanks around it, which headers are read without");
  const auto is_it = [&row](const RecordingColumn& column) { return column.key == row.key; };
  const auto found = std::find_if(recording_columns.begin(), recording_columns.end(), is_it);
  scene.motion.format.headers[static_cast<std::size_t>(found - recording_columns.begin())] = name;
}

void read_separator(const SceneKey& row, const TomlTable& motion, Scene& scene) {
  constexpr std::array<std::pair<std::string_view, char>, 7> words{{{"auto", found_separator},
                                                                    {",", ','},
                                                                    {";", ';'},
                                                                    {"tab", '\t'},
                                                                    {"\t", '\t'},
                                                                    {"space", ' '},
                                                                    {" ", ' '}}};
  const std::string text = motion.text(row.key, "");
  const auto found =
      std::find_if(words.begin(), words.end(), [&text](const auto& word) { return word.first == text; });
  if (found == words.end()) {
    throw motion.error(row.key,
                       motion.name(row.key) +
                           " must be \"auto\", \",\", \";\", \"tab\" or \"space\", the mark between cells");
  }
  scene.motion.format.dialect.separator = found->second;
}

void read_decimal(const SceneKey& row, const TomlTable& motion, Scene& scene) {
  const std::string text = motion.text(row.key, "");
  if (text != "." && text != ",")
    throw motion.error(row.key, motion.name(row.key) + " must be \".\" or \",\"");
  scene.motion.format.dialect.decimal = text.front();
}

SceneKey rate_key(std::string_view key) {
  SceneKey row = number_key<motion_of, &MotionSettings::rate_hz>(
      key, 1, 1e6, "the tick, or \"auto\"; where it is not written, a file's own rate");
  row.read = [](const SceneKey& self, const TomlTable& table, Scene& scene) {
    scene.motion.automatic_rate = is_automatic(self, table);
    if (scene.motion.automatic_rate) return;
    scene.motion.rate_hz = table.number(self.key, 0, self.range);
    scene.motion.rate_given = true;
  };
  return row;
}

SceneKey motion_kind_key(std::string_view key) {
  SceneKey row = choice_key<take_kind>(key, {"line", "sine", "circle", "on_surface"}, "", "");
  row.shown.clear();  // each kind is shown with its keys
  return row;
}

SceneKey speed_key(std::string_view key) {
  SceneKey row{key, KeyType::number, "", "0"};
  row.range = {1e-9, farthest_m, false};
  row.read = [](const SceneKey& self, const TomlTable& table, Scene& scene) {
    const double speed = table.number(self.key, 0, self.range);
    (scene.motion.laid ? scene.motion.laid->speed_m_per_s : scene.motion.scripted->speed_m_per_s) = speed;
  };
  return row;
}

SceneKey shape_key(std::string_view key) {
  return choice_key<take_shape>(key, {"line", "circle", "spiral"}, "line",
                                "drawn in the first part's surface at a random place that holds it");
}

SceneKey frame_key(std::string_view key) {
  return choice_key<take_frame>(key, {"world", "part"}, "world",
                                "in which the motion's coordinates are meant; part: the first one's");
}

SceneKey recording_unit_key(std::string_view key) {
  return choice_key<take_recording_unit>(key, length_unit_names(), "m", "of the file's positions");
}

SceneKey time_unit_key(std::string_view key) {
  std::vector<std::string> names;
  names.reserve(std::size(time_units));
  for (const TimeUnit& unit : time_units) names.emplace_back(unit.name);
  SceneKey row = choice_key<take_time_unit>(key, names, "s", "of the file's times");
  row.read = [](const SceneKey& self, const TomlTable& motion, Scene& scene) {
    const std::string said = motion.text(self.key, self.default_word);
    const auto named = std::ranges::find(self.words, listed_unit(Quantity::time, said));
    // What is no unit is refused where all choices are.
    take_time_unit(scene, named != self.words.end() ? static_cast<std::size_t>(named - self.words.begin())
                                                    : motion.choice(self.key, 0, self.words));
  };
  return row;
}

SceneKey force_unit_key(std::string_view key) {
  std::vector<std::string> names;
  names.reserve(std::size(force_units));
  for (const ForceUnit& unit : force_units) names.emplace_back(unit.name);
  return choice_key<take_force_unit>(key, names, "N", "of the file's forces");
}

void read_positions_file(const SceneKey& row, const TomlTable& motion, Scene& scene) {
  scene.motion.format.positions_path = resolved_path(scene.path, text_that_is_there(row, motion));
}

void read_field_format(const SceneKey& row, const TomlTable& motion, Scene& scene) {
  std::vector<std::string> names;
  for (const FieldFormat& format : field_formats()) names.emplace_back(format.name);
  scene.motion.format.name = names[motion.choice(row.key, 0, names)];
}

SceneKey field_format_key(std::string_view key) {
  static const std::string doc = [] {
    std::string others;
    for (const FieldFormat& format : field_formats().subspan(1))
      others += fmt::format("{}{}", others.empty() ? "or " : ", ", format.name);
    return others + ": as others save recordings";
  }();
  SceneKey row{key, KeyType::text, doc, fmt::format("\"{}\"", field_formats().front().name)};
  row.read = read_field_format;
  return row;
}

SceneKey force_on_key(std::string_view key) {
  return choice_key<take_force_on>(key, {"finger", "plate"}, "finger", "what the measured force acts on");
}

SceneKey chosen_rows_key(std::string_view key, std::string_view doc,
                         void (*read)(const SceneKey&, const TomlTable&, Scene&)) {
  SceneKey row{key, KeyType::whole, doc, "1"};
  row.least_whole = -1000000;
  row.most_whole = 1000000;
  row.read = read;
  return row;
}

void read_chosen_subject(const SceneKey& row, const TomlTable& motion, Scene& scene) {
  scene.motion.format.subject = static_cast<int>(motion.whole(row.key, 0, row.least_whole, row.most_whole));
}

void read_chosen_trial(const SceneKey& row, const TomlTable& motion, Scene& scene) {
  scene.motion.format.trial = static_cast<int>(motion.whole(row.key, 0, row.least_whole, row.most_whole));
}

SceneKey normal_force_key(std::string_view key) {
  return choice_key<take_normal_force>(key, {"model", "measured"}, "model",
                                       "the file's fn in place of the model's");
}

}  // namespace fingerpad
