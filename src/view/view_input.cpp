#include "view/view_input.hpp"

#include "base/error.hpp"
#include "contact/triangle_tree.hpp"
#include "scene/scene_file.hpp"
#include "touch/world.hpp"
#include "trace/trace.hpp"
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
  input.world = std::move(trace.world);
  input.rows = std::move(trace.rows);
  if (input.world) input.world = with_trees(*input.world);
  if (trace.info.scene_text.empty()) return input;
  // The trace was recorded elsewhere perhaps: a scene whose files are gone costs its labels, not the picture.
  try {
    input.scene = read_recorded_scene(trace.info.scene_text, trace.info.profile_text, path);
    if (!input.world) input.world = load_world(*input.scene);
  } catch (const Error&) {
  }
  return input;
}

}  // namespace fingerpad
