#include "scene/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/near_file.hpp"
#include "base/unit.hpp"
#include "scene/pad_profile_file.hpp"
#include "scene/scene_reader.hpp"
#include "scene/scene_set.hpp"
#include "scene/toml_table.hpp"
#include "scene/toml_tree.hpp"
#include "scene/unread_keys.hpp"

namespace fingerpad {
namespace {

namespace fs = std::filesystem;

// Far above any scene, far below what would fill the memory.
constexpr std::size_t max_text_bytes = std::size_t{4} << 20;
constexpr InputKind scene_kind{"a scene file", max_text_bytes, true};
constexpr std::size_t max_job_text_bytes = std::size_t{512} << 20;

std::size_t count_jobs(const std::vector<SetEntry>& entries, const std::string& path,
                       std::size_t text_bytes) {
  std::size_t total = 0;
  for (const SetEntry& entry : entries) {
    total += job_count(entry);
    if (total > max_jobs || total * text_bytes > max_job_text_bytes) {
      throw refused(
          path, fmt::format("the set has over {} jobs; at most {} of this scene are run from one file",
                            total > max_jobs ? max_jobs : total - 1,
                            std::min(max_jobs, max_job_text_bytes / std::max<std::size_t>(text_bytes, 1))));
    }
  }
  return total;
}

/// The scene with the values of one combination put in; a refusal becomes the job's error.
SceneJob make_job(const TomlNode& root, const std::string& path, const SetEntry& entry,
                  const std::vector<std::size_t>& choice, UnreadKeys& unread_keys) {
  SceneJob job;
  TomlNode filled = root;
  for (std::size_t i = 0; i < entry.axes.size(); ++i) {
    const SetAxis& axis = entry.axes[i];
    const SetValue& value = axis.values[choice[i]];
    job.set_keys.emplace_back(axis.key, value.written);
    put_value(filled, axis.target, value.value);
  }
  unread_keys.look(filled);
  try {
    job.scene = read_scene(filled, path, Missing::nothing);
    job.scene.text = write_toml(filled);
  } catch (const Error& error) {
    job.error = error.what();
  }
  return job;
}

void add_jobs(SceneFile& file, const TomlNode& root, const std::string& path, const SetEntry& entry,
              UnreadKeys& unread_keys) {
  const std::size_t count = job_count(entry);
  for (std::size_t i = 0; i < count; ++i) {
    SceneJob job = make_job(root, path, entry, choice_of_job(entry, i), unread_keys);
    job.number = static_cast<int>(file.jobs.size()) + 1;
    if (!job.error.empty()) {
      job.scene = Scene();
      job.scene.name = file.scene.name;
      job.scene.path = path;
    }
    file.jobs.push_back(std::move(job));
  }
}

/// Reads a file with a set: its scene without it, and every job.
void read_jobs(SceneFile& file, TomlNode root, const std::string& path, UnreadKeys& unread_keys) {
  file.is_set = true;
  const std::vector<SetEntry> entries = read_set(*find_entry(root, "set"), path);
  std::erase_if(root.entries, [](const TomlEntry& entry) { return entry.key == "set"; });
  refuse_keys_without_table(root, entries, path);
  const auto gives_mesh = [](const SetEntry& entry) {
    return std::any_of(entry.axes.begin(), entry.axes.end(),
                       [](const SetAxis& axis) { return axis.target == "part.mesh"; });
  };
  const bool mesh_from_set = std::all_of(entries.begin(), entries.end(), gives_mesh);
  file.scene = read_scene(root, path, mesh_from_set ? Missing::mesh : Missing::nothing);
  file.scene.text = write_toml(root);
  file.jobs.reserve(count_jobs(entries, path, file.scene.text.size()));
  for (const SetEntry& entry : entries) add_jobs(file, root, path, entry, unread_keys);
}

bool is_missing(const std::string& path) {
  std::error_code ignored;
  return !stream_descriptor(path) && !fs::exists(path, ignored);
}

/// The scene file that a misspelled path may mean; "" if none is like it.
std::string near_scene_file(const fs::path& path) {
  const fs::path turned = fs::path(path).replace_extension(".toml");
  std::error_code ignored;
  for (const fs::path& ended : {fs::path(path).concat(".toml"), turned})
    if (fs::exists(ended, ignored)) return ended.string();
  return near_file(turned).string();
}

constexpr const char* what_a_scene_is =
    "is it a scene? That is a .toml file, which names its mesh ([[part]] mesh) and its recording ([motion] "
    "file)";

void refuse_profile_of(const TomlNode& root, const std::string& path) {
  if (!is_profile(root)) return;
  throw refused(
      path,
      fmt::format("is the profile of a finger pad, not a scene: a scene names it, with profile = \"{}\" in "
                  "[finger], which is a path from the scene's own folder",
                  std::filesystem::path(path).filename().string()));
}

bool begins_as_hdf5(const std::string& path) {
  constexpr InputKind any{"a file", std::numeric_limits<std::uint64_t>::max()};
  if (stream_descriptor(path) || why_unreadable(path, any)) return false;
  std::string start(8, '\0');
  return InputFile(path, any).read(start.data(), 8) == 8 && start == "\x89HDF\r\n\x1a\n";
}

}  // namespace

SceneFile read_scene_file(const std::string& path) {
  if (begins_as_hdf5(path)) {
    throw refused(
        path,
        "is a trace, a run that was made already: view, plot and export show it, and a scene follows "
        "its finger again by [motion] file");
  }
  try {
    return read_scene_text(read_whole_file(path, scene_kind), path);
  } catch (const Error& error) {
    const bool missing = is_missing(path);
    if (!missing && !stream_descriptor(path) && fs::path(path).extension() != ".toml")
      throw Error(error.kind(), "", fmt::format("{}; {}", error.what(), what_a_scene_is));
    // With its ending right, the error has said so.
    const std::string near = missing && fs::path(path).extension() != ".toml" ? near_scene_file(path) : "";
    if (near.empty()) throw;
    throw Error(error.kind(), path,
                fmt::format("cannot be read: there is no such file; did you mean {}?", near));
  }
}

void refuse_profile(const std::string& path) {
  if (!begins_as_hdf5(path)) refuse_profile_of(parse_toml(read_whole_file(path, scene_kind), path), path);
}

SceneFile read_scene_text(const std::string& text, const std::string& path, Unread unread) {
  if (text.size() > max_text_bytes) throw refused(path, "is larger than 4 MiB, which no scene file is");
  TomlNode root = parse_toml(text, path);
  refuse_profile_of(root, path);
  SceneFile file;
  UnreadKeys unread_keys;
  const TomlEntry* set = find_entry(root, "set");
  if (set == nullptr) {
    file.scene = read_scene(root, path, Missing::nothing);
    file.scene.text = text;
    file.jobs.push_back({file.scene, 0, {}, {}});
    unread_keys.look(root);
  } else {
    read_jobs(file, std::move(root), path, unread_keys);
  }
  if (unread == Unread::refused) unread_keys.refuse(path);
  return file;
}

std::vector<double> part_crease_degs(const std::string& text) {
  std::vector<double> angles;
  TomlNode root;
  try {
    root = parse_toml(text, "");
  } catch (const Error&) {
    return angles;
  }
  const TomlEntry* parts = find_entry(root, "part");
  if (parts == nullptr) return angles;
  for (const TomlNode& part : parts->value.items) {
    const TomlEntry* crease = find_entry(part, "crease_deg");
    angles.push_back(crease != nullptr ? crease->value.number : PartEntry().crease_deg);
  }
  return angles;
}

Scene read_recorded_scene(const std::string& scene_text, const std::string& profile_text,
                          const std::string& path) {
  TomlNode root = parse_toml(scene_text, path);
  for (TomlEntry& entry : root.entries) {
    if (entry.key != "finger") continue;
    std::erase_if(entry.value.entries, [](const TomlEntry& key) { return key.key == "profile"; });
  }
  Scene scene = read_scene(root, path, Missing::nothing);
  scene.text = scene_text;
  if (!profile_text.empty()) scene.friction.settings.profile = read_profile_text(profile_text, path);
  return scene;
}

Scene scene_of_mesh(const std::string& mesh_path, double metres) {
  TomlNode part;
  part.entries.push_back({"mesh", {}, toml_text(mesh_path)});
  for (const LengthUnit& unit : length_units) {
    if (unit.metres == metres) part.entries.push_back({"unit", {}, toml_text(std::string(unit.name))});
  }
  TomlNode parts;
  parts.type = TomlNode::Type::array;
  parts.items.push_back(std::move(part));
  TomlNode root;
  root.entries.push_back({"part", {}, std::move(parts)});

  Scene scene = read_scene(root, "", Missing::nothing);
  const std::string stem = fs::path(mesh_path).stem().string();
  if (!stem.empty()) scene.name = stem;
  scene.text = write_toml(root);
  scene.parts.front().metres_per_unit = metres;
  return scene;
}

}  // namespace fingerpad
