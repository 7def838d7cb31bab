#include "view/window_loop_vtk.hpp"

#include <vtkCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>

namespace fingerpad {
namespace {

/// The trackball without its grip on the focus: that would keep timers and keys from us while it turns.
class SharingTrackball : public vtkInteractorStyleTrackballCamera {
 public:
  static SharingTrackball* New();
  vtkTypeMacro(SharingTrackball, vtkInteractorStyleTrackballCamera);

  void OnLeftButtonDown() override {
    if (find_renderer()) this->StartRotate();
  }
  void OnMiddleButtonDown() override {
    if (find_renderer()) this->StartPan();
  }
  void OnRightButtonDown() override {
    if (find_renderer()) this->StartDolly();
  }

 private:
  bool find_renderer() {
    const int* at = this->Interactor->GetEventPosition();
    this->FindPokedRenderer(at[0], at[1]);
    return this->CurrentRenderer != nullptr;
  }
};
vtkStandardNewMacro(SharingTrackball);

constexpr int frame_ms = 16;
constexpr float before_the_style = 10;  // the priority of observers that may keep events from the camera

}  // namespace

std::vector<std::string> common_help() {
  return {"left drag: turn the view",
          "middle drag: move the view",
          "right drag, wheel: zoom",
          "wheel on a chart: zoom; drag: move along",
          "mouse over a curve: its value",
          "r: view and charts as at first",
          "c: colour the path by phase or by force",
          "p, f, a, n: show path, finger, forces, tangent frame",
          "i, e, o: show close-up, edges, readings",
          "h: this page",
          "q, Escape: close"};
}

WindowLoop::WindowLoop(Stage& stage, const WindowOptions& options, WindowHandlers handlers)
    : stage_(stage), options_(options), handlers_(std::move(handlers)) {
  interactor_->SetRenderWindow(stage_.window());
  vtkNew<SharingTrackball> style;
  style->SetMotionFactor(8);
  interactor_->SetInteractorStyle(style);
  interactor_->EnableRenderOff();  // frames are the timer's
  stage_.set_pace(Stage::Pace::smooth);
  observe();
}

WindowLoop::~WindowLoop() = default;

void WindowLoop::observe() {
  vtkRenderWindowInteractor* const from = interactor_;
  from->AddObserver(vtkCommand::KeyPressEvent, this, &WindowLoop::on_key, before_the_style);
  // The style's own letters (wireframe, stereo, exit) are not ours.
  from->AddObserver(vtkCommand::CharEvent, this, &WindowLoop::swallow, before_the_style);
  for (const auto event :
       {vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent, vtkCommand::MouseMoveEvent,
        vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent}) {
    from->AddObserver(event, this, &WindowLoop::on_mouse, before_the_style);
  }
  from->AddObserver(vtkCommand::TimerEvent, this, &WindowLoop::on_timer, before_the_style);
  for (const auto event : {vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent}) {
    from->GetInteractorStyle()->AddObserver(event, this, &WindowLoop::on_camera, before_the_style);
  }
  from->AddObserver(vtkCommand::ConfigureEvent, this, &WindowLoop::on_camera, before_the_style);
  from->AddObserver(vtkCommand::ExposeEvent, this, &WindowLoop::on_camera, before_the_style);
}

void WindowLoop::run() {
  stage_.window()->SetWindowName("fingerpad");
  interactor_->Initialize();
  queue_.emplace(interactor_, stage_.window());
  opened_ = std::chrono::steady_clock::now();
  render();
  if (queue_->is_known()) {
    handle_events();
    return;
  }
  interactor_->CreateRepeatingTimer(frame_ms);
  interactor_->Start();
}

/// All events that wait, then a frame: the newest is never drawn late for those before it.
void WindowLoop::handle_events() {
  using Clock = std::chrono::steady_clock;
  Clock::time_point next_frame = Clock::now();
  while (!closing_ && !interactor_->GetDone()) {
    while (!closing_ && !interactor_->GetDone() && queue_->pass_on()) {
    }
    const double early_s = std::chrono::duration<double>(next_frame - Clock::now()).count();
    if (early_s > 0) {
      queue_->wait(early_s);
      continue;
    }
    next_frame = Clock::now() + std::chrono::milliseconds(frame_ms);
    on_timer(nullptr, 0, nullptr);
  }
}

void WindowLoop::close() {
  closing_ = true;
  interactor_->TerminateApp();
}

bool WindowLoop::common_key(const std::string& key) {
  ViewState& state = stage_.state();
  const struct {
    const char* key;
    bool* flag;
  } toggles[] = {{"p", &state.path},     {"f", &state.finger},  {"a", &state.forces}, {"n", &state.frame},
                 {"i", &state.close_up}, {"e", &state.creases}, {"o", &state.hud},    {"h", &state.help}};
  for (const auto& toggle : toggles) {
    if (key != toggle.key) continue;
    *toggle.flag = !*toggle.flag;
    return true;
  }
  if (key == "q" || (key == "Escape" && !state.help)) {
    close();
  } else if (key == "Escape") {
    state.help = false;
  } else if (key == "r") {
    stage_.reset_camera();
    stage_.charts().show_all();
  } else if (key == "c") {
    const bool phase = state.colouring == PathColouring::phase;
    state.colouring = phase ? PathColouring::force : PathColouring::phase;
  } else {
    return false;
  }
  return true;
}

bool WindowLoop::on_key(vtkObject*, unsigned long, void*) {
  const char* symbol = interactor_->GetKeySym();
  const std::string key = symbol != nullptr ? symbol : "";
  if ((handlers_.key && handlers_.key(key)) || common_key(key)) changed_ = true;
  return true;
}

bool WindowLoop::on_mouse(vtkObject*, unsigned long event, void*) {
  const int* at = interactor_->GetEventPosition();
  ChartBoard& charts = stage_.charts();
  bool taken = false;
  switch (event) {
    case vtkCommand::LeftButtonPressEvent:
      // All of a chart that is not zoomed is in sight: there is nowhere to move it.
      taken = charts.zoomed() && charts.press(at[0], at[1]);
      taken = (handlers_.press && handlers_.press(at[0], at[1])) || taken;
      break;
    case vtkCommand::MouseMoveEvent:
      if (charts.move(at[0], at[1])) changed_ = true;
      taken = handlers_.move && handlers_.move(at[0], at[1]);
      break;
    case vtkCommand::LeftButtonReleaseEvent:
      taken = charts.release(at[0], at[1]);
      taken = (handlers_.release && handlers_.release()) || taken;
      break;
    case vtkCommand::MouseWheelForwardEvent:
    case vtkCommand::MouseWheelBackwardEvent: {
      const int steps = event == vtkCommand::MouseWheelForwardEvent ? 1 : -1;
      const bool theirs = charts.wheel(at[0], at[1], steps) || (handlers_.wheel && handlers_.wheel(steps));
      if (!theirs) stage_.zoom(steps > 0 ? 1.15 : 1 / 1.15);
      taken = true;
      break;
    }
    default:
      break;
  }
  changed_ = changed_ || taken;
  return taken;
}

bool WindowLoop::on_camera(vtkObject*, unsigned long, void*) {
  changed_ = true;
  return false;
}

void WindowLoop::render() {
  stage_.render();
  ++frames_;
}

bool WindowLoop::on_timer(vtkObject*, unsigned long, void*) {
  if (closing_) return true;
  const double now_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - opened_).count();
  const double elapsed_s = now_s - last_frame_s_;
  last_frame_s_ = now_s;
  if (handlers_.frame && handlers_.frame(elapsed_s)) changed_ = true;
  play_events(now_s);
  const int* size = stage_.window()->GetSize();
  if (size[0] != static_cast<int>(stage_.layout().window.width) ||
      size[1] != static_cast<int>(stage_.layout().window.height)) {
    stage_.resize(size[0], size[1]);
    changed_ = true;
  }
  if ((changed_ || stage_.has_come_to_rest()) && !closing_) {
    changed_ = false;
    render();
  }
  if (options_.on_frame) {
    WindowReport report;
    report.state = stage_.state();
    report.frames = frames_;
    report.since_open_s = now_s;
    const ChartPlace charts = stage_.charts().place();
    report.chart_from = charts.x_min;
    report.chart_to = charts.x_max;
    report.chart_tells = stage_.charts().told();
    if (handlers_.report) handlers_.report(report);
    options_.on_frame(report);
  }
  return true;
}

void WindowLoop::play_events(double now_s) {
  while (!closing_ && next_event_ < options_.events.size()) {
    const WindowEvent& event = options_.events[next_event_];
    if (event.at_s + events_late_s_ > now_s) return;
    // A slow frame delays all that follow too: events never come closer together than they were meant.
    events_late_s_ = now_s - event.at_s;
    ++next_event_;
    play(event);
  }
}

void WindowLoop::play(const WindowEvent& event) {
  if (event.kind == WindowEvent::Kind::key) {
    interactor_->SetKeySym(event.key.c_str());
    interactor_->InvokeEvent(vtkCommand::KeyPressEvent);
    return;
  }
  constexpr vtkCommand::EventIds ids[] = {
      vtkCommand::KeyPressEvent,          vtkCommand::LeftButtonPressEvent,
      vtkCommand::MouseMoveEvent,         vtkCommand::LeftButtonReleaseEvent,
      vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent};
  interactor_->SetEventInformation(event.x, event.y);
  interactor_->InvokeEvent(ids[static_cast<int>(event.kind)]);
}

}  // namespace fingerpad
