#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "scene/scene_change.hpp"
#include "touch/tick_record.hpp"

namespace fingerpad {

struct Trace;
struct World;

/// What a picture or a window shows: a mesh (world alone), a scene (world, scene, and rows once it was
/// replayed) or a trace.
struct ViewInput {
  std::string title;
  /// Of what is shown, as it was named: window titles and screenshots are named after it.
  std::string file = {};
  std::string contact_words = {};  ///< method and normals that served, where a trace says so
  std::string notice = {};         ///< what cannot be shown, and why; empty: all can
  std::shared_ptr<const World>
      world;                     ///< empty where the surfaces are not known: then the path alone is shown
  std::optional<Scene> scene;    ///< the law, the finger and its direction, where known
  std::vector<TickRecord> rows;  ///< in order of time; empty for a mesh
  std::vector<SceneChange> changes = {};  ///< made while it was touched
  std::string recording = {};  ///< the trace that is shown, or recorded meanwhile; screenshots go beside it
  std::uint64_t every = 1;     ///< rows are every so manieth tick, and the last
  bool every_is_told = true;   ///< by the trace; false: `every` is what the rows' times let one guess
};

/// What is touched and how, for a title: mesh, law, coefficients, method; "" where nothing is known of it.
/// @param beside  what stands beside it: a mesh that is named there is not named again
std::string subtitle_of(const ViewInput& input, const std::string& beside);

/// What a window on it is called: "bracket.h5: job 3, mu_static 0.3 - fingerpad".
std::string window_name(const ViewInput& input);

/// A trace with the scene that it holds. Surfaces that the trace has not embedded are loaded from the meshes
/// its scene names; where those cannot be read the world stays empty, and the notice says why.
/// @param path  of the trace: where relative paths of its scene start, and the title of a trace without name
ViewInput view_of_trace(Trace trace, const std::string& path);

}  // namespace fingerpad
