#include "view/window_loop_vtk.hpp"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>

#include <cstdint>
#include <optional>

#include "view/lost_window_vtk.hpp"
#include "view/sharing_trackball_vtk.hpp"

namespace fingerpad {
namespace {

constexpr int frame_ms = 16;
constexpr float before_the_style = 10;  // the priority of observers that may keep events from the camera

/// What may be answered at once of the mouse's events.
std::optional<InputEvent::Kind> kind_of(unsigned long event) {
  switch (event) {
    case vtkCommand::LeftButtonPressEvent:
      return InputEvent::Kind::press;
    case vtkCommand::LeftButtonReleaseEvent:
      return InputEvent::Kind::release;
    case vtkCommand::MouseMoveEvent:
    case vtkCommand::EnterEvent:
      return InputEvent::Kind::move;
    default:
      return std::nullopt;
  }
}

}  // namespace

WindowLoop::WindowLoop(Stage& stage, const WindowOptions& options, WindowHandlers handlers)
    : stage_(stage),
      options_(options),
      handlers_(std::move(handlers)),
      queue_(handlers_.at_once),
      script_(options.events, interactor_),
      parts_(stage.input().world, stage.panels(), stage.world()),
      mouse_(stage, handlers_, parts_),
      commands_(stage, parts_,
                {[this] { close(); }, [this](const std::string& words) { tell(words); },
                 [this] { return mouse_px(); }}) {
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
        vtkCommand::EnterEvent, vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent}) {
    from->AddObserver(event, this, &WindowLoop::on_mouse, before_the_style);
  }
  from->AddObserver(vtkCommand::TimerEvent, this, &WindowLoop::on_timer, before_the_style);
  for (const auto event : {vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent}) {
    from->GetInteractorStyle()->AddObserver(event, this, &WindowLoop::on_camera, before_the_style);
  }
  from->AddObserver(vtkCommand::DropFilesEvent, this, &WindowLoop::on_drop, before_the_style);
  from->AddObserver(vtkCommand::ConfigureEvent, this, &WindowLoop::on_camera, before_the_style);
  from->AddObserver(vtkCommand::ExposeEvent, this, &WindowLoop::on_camera, before_the_style);
}

void WindowLoop::run() {
  stage_.window()->SetWindowName("fingerpad");
  interactor_->Initialize();
  queue_.open(interactor_, stage_.window());
  std::optional<LostWindowWatch> watch;
  if (options_.on_loss && queue_.is_known()) {
    // VTK gives X's number of the window as a pointer.
    watch.emplace(reinterpret_cast<std::uintptr_t>(stage_.window()->GetGenericWindowId()), options_.on_loss);
  }
  queue_.refuse_smaller(least_window_width_px, least_window_height_px);
  opened_ = std::chrono::steady_clock::now();
  render();
  if (handlers_.has_opened) handlers_.has_opened();
  // Only now: who looks for a window by its name finds one that listens.
  stage_.window()->SetWindowName(window_name(stage_.input()).c_str());
  if (queue_.is_known()) {
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
  const auto is_over = [this] { return closing_ || interactor_->GetDone(); };
  while (!is_over()) {
    while (!is_over() && queue_.pass_on()) {
    }
    if (is_over()) return;  // a frame that is drawn now would open another window, and wait for its events
    const double early_s = std::chrono::duration<double>(next_frame - Clock::now()).count();
    if (early_s > 0) {
      queue_.wait(early_s);
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
  stage_.words().message = words;
  told_ = words;
  told_until_s_ = last_frame_s_ + told_s;
  changed_ = true;
}

/// What the window system sent was, or was not, when it came; what a program makes up is asked now.
bool WindowLoop::taken_at_once(InputEvent event) {
  if (queue_.is_passing()) return queue_.was_taken();
  event.t_s = event_s();
  return handlers_.at_once && handlers_.at_once(event);
}

bool WindowLoop::on_key(vtkObject*, unsigned long, void*) {
  const char* symbol = interactor_->GetKeySym();
  const std::string key = symbol != nullptr ? symbol : "";
  if (taken_at_once({.kind = InputEvent::Kind::key, .key = key})) {
    changed_ = true;
    return true;
  }
  const auto action = action_of(key, handlers_.window);
  if (action && ((handlers_.act && handlers_.act(*action)) || commands_.act(*action))) changed_ = true;
  return true;
}

bool WindowLoop::on_mouse(vtkObject*, unsigned long event, void*) {
  const int* at = interactor_->GetEventPosition();
  const auto kind = kind_of(event);
  const bool taken = kind && taken_at_once({*kind, static_cast<double>(at[0]), static_cast<double>(at[1])});
  const WindowMouse::Outcome outcome = mouse_.take(event, at[0], at[1], taken);
  changed_ = changed_ || outcome.new_to_see;
  return outcome.taken;
}

std::pair<int, int> WindowLoop::mouse_px() {
  const int* at = interactor_->GetEventPosition();
  return {at[0], at[1]};
}

/// The first of the files that were dropped.
bool WindowLoop::on_drop(vtkObject*, unsigned long, void* paths) {
  const auto* const files = static_cast<vtkStringArray*>(paths);
  if (files == nullptr || files->GetNumberOfValues() == 0) return true;
  if (!options_.on_drop) {
    tell("a touch goes on: drop the file onto a window of `view`");
    return true;
  }
  const std::string why = options_.on_drop(const_cast<vtkStringArray*>(files)->GetValue(0));
  if (why.empty()) {
    close();
  } else {
    tell(why);
  }
  return true;
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
    stage_.words().message.clear();
    told_.clear();
    told_until_s_ = 0;
    changed_ = true;
  }
  script_.play(now_s, [this] { return !closing_; });
  const int* size = stage_.window()->GetSize();
  if (size[0] != static_cast<int>(stage_.layout().window.width) ||
      size[1] != static_cast<int>(stage_.layout().window.height)) {
    stage_.resize(size[0], size[1]);
    changed_ = true;
  }
  if ((changed_ || stage_.has_come_to_rest()) && !closing_) {
    changed_ = false;
    render();
    stage_.charts().ask_again();
  }
  if (options_.on_frame) options_.on_frame(report(now_s));
  return true;
}

/// What the window shows, for those who are told after each frame.
WindowReport WindowLoop::report(double now_s) {
  WindowReport report;
  report.state = stage_.state();
  report.frames = frames_;
  report.since_open_s = now_s;
  vtkCamera* const camera = stage_.scene()->GetActiveCamera();
  report.towards_eye_W = -Vec3(camera->GetDirectionOfProjection());
  report.half_height_mm = camera->GetParallelScale();
  report.message = told_;
  report.alarm = stage_.words().alarm;
  report.arrow_force_n = stage_.arrow_scale().force_n();
  const ChartPlace charts = stage_.charts().place();
  report.chart_from = charts.x_min;
  report.chart_to = charts.x_max;
  report.chart_tells = stage_.charts().told();
  if (handlers_.report) handlers_.report(report);
  return report;
}

}  // namespace fingerpad
