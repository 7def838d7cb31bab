#pragma once

#include <vtkNew.h>

#include <chrono>
#include <string>
#include <utility>

#include "view/event_queue_vtk.hpp"
#include "view/event_script_vtk.hpp"
#include "view/input_event.hpp"
#include "view/parts_panel_vtk.hpp"
#include "view/stage_vtk.hpp"
#include "view/window.hpp"
#include "view/window_commands_vtk.hpp"
#include "view/window_handlers.hpp"
#include "view/window_mouse_vtk.hpp"

class vtkObject;
class vtkRenderWindowInteractor;

namespace fingerpad {

/// Opens a stage's window and passes events on until it is closed. A frame is drawn when something changed,
/// at most 60 a second.
class WindowLoop {
 public:
  WindowLoop(Stage& stage, const WindowOptions& options, WindowHandlers handlers);
  ~WindowLoop();
  WindowLoop(const WindowLoop&) = delete;
  WindowLoop& operator=(const WindowLoop&) = delete;

  void run();
  void close();
  /// Shows some words for a moment.
  void tell(const std::string& words);
  /// When the event that is being handled was made; now, outside of handlers. Steady [s].
  double event_s() const { return queue_.event_s(); }

 private:
  void observe();
  bool taken_at_once(InputEvent event);
  void handle_events();
  bool on_key(vtkObject*, unsigned long, void*);
  bool on_mouse(vtkObject*, unsigned long event, void*);
  bool swallow(vtkObject*, unsigned long, void*) { return true; }
  bool on_timer(vtkObject*, unsigned long, void*);
  bool on_drop(vtkObject*, unsigned long, void* paths);
  bool on_camera(vtkObject*, unsigned long, void*);
  void render();
  std::pair<int, int> mouse_px();
  WindowReport report(double now_s);

  Stage& stage_;
  const WindowOptions& options_;
  WindowHandlers handlers_;
  EventQueue queue_;
  vtkNew<vtkRenderWindowInteractor> interactor_;
  EventScript script_;
  PartsPanel parts_;
  WindowMouse mouse_;
  WindowCommands commands_;
  std::chrono::steady_clock::time_point opened_;
  double last_frame_s_ = 0;
  long frames_ = 0;
  bool changed_ = true;
  bool closing_ = false;
  std::string told_;
  double told_until_s_ = 0;  ///< what was told stays so long
};

}  // namespace fingerpad
