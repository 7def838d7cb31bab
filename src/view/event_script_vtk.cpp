#include "view/event_script_vtk.hpp"

#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>

namespace fingerpad {

void EventScript::play(double now_s, const std::function<bool()>& goes_on) {
  while (goes_on() && next_ < events_.size()) {
    const WindowEvent& event = events_[next_];
    if (event.at_s + late_s_ > now_s) return;
    // A slow frame delays all that follow too: events never come closer together than they were meant.
    late_s_ = now_s - event.at_s;
    ++next_;
    play(event);
  }
}

void EventScript::play(const WindowEvent& event) {
  if (event.kind == WindowEvent::Kind::key) {
    interactor_->SetKeySym(event.key.c_str());
    interactor_->InvokeEvent(vtkCommand::KeyPressEvent);
    return;
  }
  constexpr vtkCommand::EventIds ids[] = {vtkCommand::KeyPressEvent,
                                          vtkCommand::LeftButtonPressEvent,
                                          vtkCommand::MouseMoveEvent,
                                          vtkCommand::LeftButtonReleaseEvent,
                                          vtkCommand::MouseWheelForwardEvent,
                                          vtkCommand::MouseWheelBackwardEvent,
                                          vtkCommand::EnterEvent};
  interactor_->SetEventInformation(event.x, event.y);
  interactor_->InvokeEvent(ids[static_cast<int>(event.kind)]);
}

}  // namespace fingerpad
