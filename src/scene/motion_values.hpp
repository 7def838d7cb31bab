#pragma once

#include "scene/scene_key.hpp"

namespace fingerpad {

// As scene_values.hpp, for the keys of [motion].

void read_motion_file(const SceneKey& row, const TomlTable& motion, Scene& scene);
void read_recording_columns(const SceneKey& row, const TomlTable& motion, Scene& scene);
void read_recording_column(const SceneKey& row, const TomlTable& columns, Scene& scene);
void read_separator(const SceneKey& row, const TomlTable& motion, Scene& scene);
void read_decimal(const SceneKey& row, const TomlTable& motion, Scene& scene);
void read_field_format(const SceneKey& row, const TomlTable& motion, Scene& scene);
void read_positions_file(const SceneKey& row, const TomlTable& motion, Scene& scene);
void read_chosen_subject(const SceneKey& row, const TomlTable& motion, Scene& scene);
void read_chosen_trial(const SceneKey& row, const TomlTable& motion, Scene& scene);

SceneKey rate_key(std::string_view key);
SceneKey motion_kind_key(std::string_view key);
SceneKey speed_key(std::string_view key);
SceneKey shape_key(std::string_view key);
SceneKey frame_key(std::string_view key);
SceneKey recording_unit_key(std::string_view key);
SceneKey time_unit_key(std::string_view key);
SceneKey force_unit_key(std::string_view key);
SceneKey normal_force_key(std::string_view key);
SceneKey field_format_key(std::string_view key);
SceneKey force_on_key(std::string_view key);
/// Of a table of several trials those rows alone.
SceneKey chosen_rows_key(std::string_view key, std::string_view doc,
                         void (*read)(const SceneKey&, const TomlTable&, Scene&));

/// Reads the [motion] of a scene into it.
void read_motion_settings(const TomlNode& table, Scene& scene);

}  // namespace fingerpad
