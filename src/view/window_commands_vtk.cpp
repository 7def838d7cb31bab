#include "view/window_commands_vtk.hpp"

#include <vtkRenderWindow.h>

#include "base/error.hpp"
#include "view/png_vtk.hpp"
#include "view/screenshot.hpp"
#include "view/view_keys.hpp"

namespace fingerpad {

WindowCommands::WindowCommands(Stage& stage, PartsPanel& parts, Window window)
    : stage_(stage), parts_(parts), window_(std::move(window)) {}

bool WindowCommands::act(KeyAction action) {
  ViewState& state = stage_.state();
  if (toggle(action, state)) return true;
  switch (action) {
    case KeyAction::leave:
      leave();
      return true;
    case KeyAction::close:
      window_.close();
      return true;
    case KeyAction::first_view:
      stage_.reset_camera();
      stage_.charts().show_all();
      window_.tell("as at first");
      return true;
    case KeyAction::nearer:
    case KeyAction::farther:
      stage_.zoom(action == KeyAction::nearer ? 1.15 : 1 / 1.15);
      return true;
    case KeyAction::colouring:
      state.colouring = state.colouring == PathColouring::phase ? PathColouring::force : PathColouring::phase;
      return true;
    case KeyAction::all_in_sight:
      stage_.look_at_all();
      return true;
    case KeyAction::parts:
      parts_.toggle();
      return true;
    case KeyAction::mark:
      mark();
      return true;
    case KeyAction::screenshot:
      take_screenshot();
      return true;
    default:
      return look(action);
  }
}

bool WindowCommands::look(KeyAction action) {
  const auto preset = preset_look(action);
  if (!preset) return false;
  stage_.look(preset->from);
  window_.tell(preset->words);
  return true;
}

/// What lies over the scene, else the window.
void WindowCommands::leave() {
  if (!stage_.state().help) window_.close();
  stage_.state().help = false;
}

/// Under the mouse.
void WindowCommands::mark() {
  const auto [x, y] = window_.mouse_px();
  const auto [near, far] = stage_.line_of_sight(x, y);
  const bool had_any = !marks_.places_W().empty();
  const bool marked = marks_.mark(stage_.world().first_hit(near, far));
  // Of a mark that is there what was told before is no longer true.
  window_.tell(marked ? "" : had_any ? "no part under the mouse: marks are gone" : "no part under the mouse");
  stage_.show_marks(marks_);
}

/// As the window stands, without what was told last.
void WindowCommands::take_screenshot() {
  stage_.words().message.clear();
  stage_.render();
  try {
    const std::string path = next_screenshot_name(stage_.input());
    write_png(stage_.window(), path);
    window_.tell("wrote " + path);
  } catch (const Error& error) {
    window_.tell(std::string("no screenshot: ") + error.what());
  }
}

}  // namespace fingerpad
