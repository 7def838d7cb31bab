#include "view/view_input.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "contact/triangle_tree.hpp"
#include "scene/scene_file.hpp"
#include "touch/contact_choice.hpp"
#include "touch/world.hpp"
#include "trace/trace.hpp"
#include "view/left_out_ticks.hpp"
#include "view/run_title.hpp"

namespace fingerpad {
namespace {

/// A trace's surfaces come without trees; the stick region is laid onto a surface that can be searched.
std::shared_ptr<const World> with_trees(World world) {
  for (Surface& surface : world.surfaces) {
    if (surface.part && !surface.tree) surface.tree = std::make_shared<const TriangleTree>(surface.part);
  }
  return std::make_shared<const World>(std::move(world));
}

}  // namespace

ViewInput view_of_trace(Trace trace, const std::string& path) {
  ViewInput input;
  input.title = run_title(trace.info, path);
  input.every = ticks_a_row(trace);
  input.every_is_told = input.every == trace.info.every;
  input.world = std::move(trace.world);
  input.rows = std::move(trace.rows);
  if (input.world) input.world = with_trees(*input.world);
  input.file = path;
  input.recording = path;
  input.changes = std::move(trace.info.changes);
  if (!trace.info.contact_method.empty())
    input.contact_words = trace.info.contact_method + " " + trace.info.contact_normals;
  if (trace.info.scene_text.empty()) {
    if (!input.world)
      input.notice = "The parts are not shown: a trace in CSV has neither scene nor meshes (HDF5 has both).";
    return input;
  }
  // The trace was recorded elsewhere perhaps: a scene whose files are gone costs its labels, not the picture.
  try {
    input.scene = read_recorded_scene(trace.info.scene_text, trace.info.profile_text, path);
    // Of a recording at a rate of its own the scene says none.
    if (trace.info.rate_hz > 0) input.scene->motion.rate_hz = trace.info.rate_hz;
    if (!input.world) input.world = load_world(*input.scene);
  } catch (const Error& error) {
    if (!input.world) input.notice = fmt::format("The parts are not shown: {}", error.what());
  }
  return input;
}

std::string subtitle_of(const ViewInput& input, const std::string& beside) {
  std::vector<std::string> words;
  if (input.world && !input.world->surfaces.empty()) {
    const Surface& first = input.world->surfaces.front();
    const std::filesystem::path mesh = std::filesystem::path(first.mesh).filename();
    std::string name = shown_name(first);
    const std::size_t more = input.world->surfaces.size() - 1;
    if (more > 0) name += fmt::format(" and {} more", more);
    const bool named = first.part && more == 0 &&
                       (beside == mesh.stem().string() || beside.find(mesh.string()) != std::string::npos);
    if (!named) words.push_back(name);
  }
  if (!input.scene) return fmt::format("{}", fmt::join(words, ", "));
  words.push_back(input.scene->friction.law);
  if (input.world && !input.world->surfaces.empty()) {
    const SurfaceProperties& surface = input.world->surfaces.front().properties;
    words.push_back(
        fmt::format("mu {}/{}", rounded_text(surface.mu_static, 3), rounded_text(surface.mu_dynamic, 3)));
    const ContactChoice contact = settled_contact(*input.scene, *input.world);
    words.push_back(input.contact_words.empty()
                        ? fmt::format("{} {}", method_in(*input.world, contact.method), contact.normals->name)
                        : input.contact_words);
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string window_name(const ViewInput& input) {
  const std::string name = std::filesystem::path(input.file).filename().string();
  const std::string varies = varied_words(input.title), with = subtitle_of(input, name);
  const std::string how = varies.empty() ? with : varies;
  return fmt::format("{}{}{} - fingerpad", name.empty() ? input.title : name, how.empty() ? "" : ": ", how);
}

}  // namespace fingerpad
