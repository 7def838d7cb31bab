#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "view/window.hpp"

class vtkRenderWindowInteractor;

namespace fingerpad {

/// Keys and mouse that a program makes in a window, each at its time.
class EventScript {
 public:
  /// @param events      kept by reference
  /// @param interactor  what they go to
  EventScript(const std::vector<WindowEvent>& events, vtkRenderWindowInteractor* interactor)
      : events_(events), interactor_(interactor) {}

  /// All that are due; `goes_on` is asked before each.
  void play(double now_s, const std::function<bool()>& goes_on);

 private:
  void play(const WindowEvent& event);

  const std::vector<WindowEvent>& events_;
  vtkRenderWindowInteractor* interactor_;
  std::size_t next_ = 0;
  double late_s_ = 0;
};

}  // namespace fingerpad
