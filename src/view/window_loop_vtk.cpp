#include "view/window_loop_vtk.hpp"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "touch/world.hpp"
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
constexpr const char* parts_panel = "parts";
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
  from->AddObserver(vtkCommand::DropFilesEvent, this, &WindowLoop::on_drop, before_the_style);
  from->AddObserver(vtkCommand::ConfigureEvent, this, &WindowLoop::on_camera, before_the_style);
  from->AddObserver(vtkCommand::ExposeEvent, this, &WindowLoop::on_camera, before_the_style);
}

void WindowLoop::run() {
  stage_.window()->SetWindowName("fingerpad");
  interactor_->Initialize();
  queue_.emplace(interactor_, stage_.window());
  queue_->refuse_smaller(least_window_width_px, least_window_height_px);
  opened_ = std::chrono::steady_clock::now();
  render();
  name_window();
  if (queue_->is_known()) {
    handle_events();
    return;
  }
  interactor_->CreateRepeatingTimer(frame_ms);
  interactor_->Start();
}

/// By what it shows. Only now: who looks for a window by its name finds one that listens.
void WindowLoop::name_window() {
  const ViewInput& input = stage_.input();
  const std::string name = std::filesystem::path(input.file).filename().string();
  const std::string how = subtitle_of(input);
  stage_.window()->SetWindowName(
      fmt::format("{}{}{} - fingerpad", name.empty() ? input.title : name, how.empty() ? "" : ": ", how)
          .c_str());
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
    case KeyAction::parts:
      show_parts(!stage_.panels().shows(parts_panel));
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

void WindowLoop::show_parts(bool shown) {
  const auto& world = stage_.input().world;
  if (!shown || !world) return stage_.panels().hide(parts_panel);
  SidePanel panel{parts_panel, "parts", {}};
  constexpr std::size_t most_rows = 24;  // that a window has room for
  const std::size_t count = world->surfaces.size();
  for (std::size_t i = 0; i < std::min(count, most_rows); ++i) {
    const Surface& surface = world->surfaces[i];
    const std::string name =
        surface.part ? std::filesystem::path(surface.mesh).filename().string() : std::string("plane");
    panel.rows.push_back(
        {PanelRow::Kind::check, fmt::format("{}  {}", i, name), "", stage_.world().is_shown(i), false});
  }
  panel.rows.push_back({PanelRow::Kind::note,
                        count > most_rows ? fmt::format("and {} more, not listed", count - most_rows)
                                          : "hidden parts are felt all the same",
                        "", false, false});
  stage_.panels().show(std::move(panel));
}

void WindowLoop::on_panel(const PanelHit& hit) {
  if (hit.panel != parts_panel) {
    if (handlers_.panel) handlers_.panel(hit);
    return;
  }
  const auto row = static_cast<std::size_t>(hit.row);
  if (hit.row < 0 || row >= stage_.input().world->surfaces.size()) return;
  stage_.world().show_surface(row, !stage_.world().is_shown(row));
  show_parts(true);
}

/// The place of a part under the mouse; a third one begins anew.
void WindowLoop::mark() {
  const int* at = interactor_->GetEventPosition();
  const auto [near, far] = stage_.line_of_sight(at[0], at[1]);
  const auto hit = stage_.world().first_hit(near, far);
  if (marks_W_.size() == 2) marks_W_.clear();
  if (hit) {
    marks_W_.push_back(hit->point_W);
  } else {
    marks_W_.clear();
    tell("no part under the mouse: marks are gone");
  }
  stage_.show_marks(marks_W_);
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
  if (on_panels(event, at[0], at[1])) {
    changed_ = true;
    return true;
  }
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

/// What the mouse does on a panel goes no further; a button pressed beside it is not its.
bool WindowLoop::on_panels(unsigned long event, int x, int y) {
  const auto hit = stage_.panels().hit(stage_.layout(), x, y);
  switch (event) {
    case vtkCommand::LeftButtonPressEvent:
      on_panel_ = hit.has_value();
      beside_panels_ = !on_panel_;
      if (hit) on_panel(*hit);
      return on_panel_;
    case vtkCommand::LeftButtonReleaseEvent:
      beside_panels_ = false;
      return std::exchange(on_panel_, false);
    case vtkCommand::MouseMoveEvent:
      return on_panel_ || (hit && !beside_panels_);
    default:
      break;
  }
  if (!hit) return false;
  if (hit->panel != parts_panel) {
    PanelHit turned = *hit;
    turned.steps = event == vtkCommand::MouseWheelForwardEvent ? 1 : -1;
    on_panel(turned);
  }
  return true;
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
    stage_.charts().ask_again();
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
