#include "view/window_loop_vtk.hpp"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "view/png_vtk.hpp"
#include "view/screenshot.hpp"

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
  const ViewInput& input = stage_.input();
  const std::string name = std::filesystem::path(input.file).filename().string();
  const std::string how = subtitle_of(input);
  stage_.window()->SetWindowName(
      fmt::format("{}{}{} - fingerpad", name.empty() ? input.title : name, how.empty() ? "" : ": ", how)
          .c_str());
  interactor_->Initialize();
  queue_.emplace(interactor_, stage_.window());
  queue_->refuse_smaller(least_window_width_px, least_window_height_px);
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

void WindowLoop::tell(const std::string& words) {
  constexpr double told_s = 4;
  stage_.tell(words);
  told_ = words;
  told_until_s_ = last_frame_s_ + told_s;
  changed_ = true;
}

bool WindowLoop::act(KeyAction action) {
  ViewState& state = stage_.state();
  const struct {
    KeyAction action;
    bool* flag;
  } toggles[] = {{KeyAction::path, &state.path},           {KeyAction::finger, &state.finger},
                 {KeyAction::forces, &state.forces},       {KeyAction::frame, &state.frame},
                 {KeyAction::close_up, &state.close_up},   {KeyAction::creases, &state.creases},
                 {KeyAction::wireframe, &state.wireframe}, {KeyAction::dark, &state.dark},
                 {KeyAction::readings, &state.hud},        {KeyAction::help, &state.help}};
  for (const auto& toggle : toggles) {
    if (action != toggle.action) continue;
    *toggle.flag = !*toggle.flag;
    return true;
  }
  switch (action) {
    case KeyAction::leave:
      if (!state.help) close();
      state.help = false;
      return true;
    case KeyAction::close:
      close();
      return true;
    case KeyAction::first_view:
      stage_.reset_camera();
      stage_.charts().show_all();
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
    case KeyAction::screenshot:
      take_screenshot();
      return true;
    default:
      return look(action);
  }
}

bool WindowLoop::look(KeyAction action) {
  constexpr std::pair<KeyAction, std::string_view> names[] = {
      {KeyAction::front, "front"},        {KeyAction::back, "back"}, {KeyAction::left, "left"},
      {KeyAction::right, "right"},        {KeyAction::top, "top"},   {KeyAction::bottom, "bottom"},
      {KeyAction::isometric, "isometric"}};
  for (const auto& [preset, name] : names) {
    if (preset != action) continue;
    stage_.look(*named_look(name));
    tell(fmt::format("from {}{}", action == KeyAction::isometric ? "" : "the ",
                     action == KeyAction::isometric ? "askew" : name));
    return true;
  }
  return false;
}

/// As the window stands, without what was told last.
void WindowLoop::take_screenshot() {
  stage_.tell("");
  stage_.render();
  try {
    const std::string path = next_screenshot_name(stage_.input().file, stage_.input().title);
    write_png(stage_.window(), path);
    tell("wrote " + path);
  } catch (const Error& error) {
    tell(std::string("no screenshot: ") + error.what());
  }
}

bool WindowLoop::on_key(vtkObject*, unsigned long, void*) {
  const char* symbol = interactor_->GetKeySym();
  const auto action = action_of(symbol != nullptr ? symbol : "", handlers_.window);
  if (action && ((handlers_.act && handlers_.act(*action)) || act(*action))) changed_ = true;
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
      // All over the charts' column the wheel is theirs: beside a panel it does nothing.
      const bool on_charts = charts.visible() && stage_.layout().charts.holds(at[0], at[1]);
      const bool theirs =
          charts.wheel(at[0], at[1], steps) || on_charts || (handlers_.wheel && handlers_.wheel(steps));
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
  if (told_until_s_ > 0 && now_s > told_until_s_) {
    stage_.tell("");
    told_.clear();
    told_until_s_ = 0;
    changed_ = true;
  }
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
    vtkCamera* const camera = stage_.scene()->GetActiveCamera();
    report.towards_eye_W = -Vec3(camera->GetDirectionOfProjection());
    report.half_height_mm = camera->GetParallelScale();
    report.message = told_;
    report.arrow_force_n = stage_.arrow_scale().force_n();
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
