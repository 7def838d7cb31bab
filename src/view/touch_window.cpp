#include "view/touch_window.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>

#include "touch/resting_finger.hpp"
#include "view/material_panel.hpp"
#include "view/recent_ticks.hpp"
#include "view/screen.hpp"
#include "view/tick_readings.hpp"
#include "view/touch_chart.hpp"
#include "view/touch_target.hpp"
#include "view/window_loop_vtk.hpp"

namespace fingerpad {
namespace {

constexpr double chart_s = 4;            // what the strip charts hold
constexpr double chart_period_s = 0.06;  // they need not follow each frame
constexpr const char* material_panel = "material";
constexpr const char* invitation = "hold the left button, or space, to press";

class TouchWindow {
 public:
  TouchWindow(const TouchWindowInput& input, const WindowOptions& options)
      : input_(input),
        history_(chart_s),
        stage_(input.view, options.width, options.height, true, false),
        target_(input.view.world, input.view.scene.value_or(Scene{}),
                0.05 * stage_.extent().everything().radius_m,
                resting_finger(*input.view.world, input.view.scene.value_or(Scene{}))),
        levels_(touch_levels(input.view)),
        loop_(stage_, options, handlers()) {
    if (input.swap != nullptr) material_.emplace(*input.swap, *input.view.world);
    stage_.show_hint("", help_lines(window_kind()));
    stage_.invite(invitation);
    stage_.keep_clear_of_readings();
    follow();
  }

  void run() { loop_.run(); }

 private:
  WindowHandlers handlers() {
    WindowHandlers handlers;
    handlers.window = window_kind();
    handlers.act = [this](KeyAction action) { return touch_key(action); };
    handlers.press = [this](int x, int y) {
      held_ = over_ = point_at(x, y);
      press();
      return held_;
    };
    handlers.move = [this](int x, int y) {
      over_ = point_at(x, y);
      // Off the edge of the part a held finger lifts until the pointer is back.
      if (over_ || held_) press();
      return over_ || held_;
    };
    handlers.release = [this] {
      const bool was_held = std::exchange(held_, false);
      press();
      return was_held;
    };
    handlers.wheel = [this](int steps) {
      target_.change_force(steps);
      tell();
      return true;
    };
    handlers.panel = [this](const PanelHit& hit) {
      if (hit.panel != material_panel || !material_) return;
      if (hit.steps != 0) return change_material(hit.row, hit.steps);
      if (hit.row >= 0 && hit.row < MaterialPanel::row_count) material_->select(hit.row);
      stage_.panels().show(material_->panel());
    };
    handlers.frame = [this](double elapsed_s) { return frame(elapsed_s); };
    handlers.report = [this](WindowReport& report) {
      report.t_s = history_.rows().empty() ? 0 : history_.rows().back().t_s;
      report.target_W = target_.pressed_W();
      report.pressing = target_.pressing();
      report.press_n = target_.press_n();
      report.invites = invites_;
    };
    return handlers;
  }

  /// False where there is nothing to touch under the mouse.
  bool point_at(int x, int y) {
    if (!stage_.layout().scene.holds(x, y)) return false;
    const auto [near, far] = stage_.line_of_sight(x, y);
    const auto hit = stage_.world().first_hit(near, far);
    if (!hit) return false;
    // Seen from the back of an open part the finger is on this side too.
    const bool from_behind = hit->normal_W.dot(far - near) > 0;
    target_.point_at(hit->point_W, from_behind ? Vec3(-hit->normal_W) : hit->normal_W, hit->surface);
    return true;
  }

  unsigned window_kind() const { return input_.set_stop ? windows::touch | windows::motors : windows::touch; }

  void change_material(int row, int steps) {
    const std::string told = material_->step(row, steps);
    if (!told.empty()) loop_.tell(told);
    stage_.panels().show(material_->panel());
    stage_.put(input_.swap->scene());
    levels_ = touch_levels(stage_.now());
  }

  /// Keys of the material, which also open its panel.
  bool material_key(KeyAction action) {
    if (!material_) return false;
    const bool shown = stage_.panels().shows(material_panel);
    switch (action) {
      case KeyAction::materials:
        shown ? stage_.panels().hide(material_panel) : stage_.panels().show(material_->panel());
        return true;
      case KeyAction::next_row:
        if (shown) material_->select((material_->selected() + 1) % MaterialPanel::row_count);
        stage_.panels().show(material_->panel());
        return true;
      case KeyAction::less:
      case KeyAction::more:
        change_material(material_->selected(), action == KeyAction::more ? 1 : -1);
        return true;
      default:
        return false;
    }
  }

  bool touch_key(KeyAction action) {
    if (material_key(action)) return true;
    const double step_m = 0.004 * stage_.scene()->GetActiveCamera()->GetParallelScale() * 1e-3 * 2;
    const Vec3 up = Vec3(stage_.scene()->GetActiveCamera()->GetViewUp());
    const Vec3 right = Vec3(stage_.scene()->GetActiveCamera()->GetDirectionOfProjection()).cross(up);
    switch (action) {
      case KeyAction::stop:
      case KeyAction::give_back:
        input_.set_stop(action == KeyAction::stop);
        return true;
      case KeyAction::press:
        latched_ = !latched_;
        press();
        return true;
      case KeyAction::go_left:
      case KeyAction::go_right:
        target_.move_by(right * (action == KeyAction::go_left ? -step_m : step_m));
        break;
      case KeyAction::go_up:
      case KeyAction::go_down:
        target_.move_by(up * (action == KeyAction::go_down ? -step_m : step_m));
        break;
      case KeyAction::harder:
      case KeyAction::softer:
        target_.change_force(action == KeyAction::harder ? 1 : -1);
        break;
      default:
        return false;
    }
    tell();
    return true;
  }

  /// Whether, by the button and the key that latches; which is not ended by a pointer that goes elsewhere.
  void press() {
    target_.press(latched_ || (held_ && over_));
    tell();
  }

  /// Hands on what an event has changed, with the event's time: speeds are the pointer's, not the frames'.
  void tell() {
    if (target_.pressing()) invites_ = false;
    stage_.invite(invites_ ? invitation : "");
    if (input_.look_from)
      input_.look_from(-Vec3(stage_.scene()->GetActiveCamera()->GetDirectionOfProjection()));
    FingerSample target = target_.sample();
    target.t_s = loop_.event_s();
    input_.set_target(target);
  }

  bool frame(double elapsed_s) {
    if (input_.is_over && input_.is_over()) loop_.close();
    if (input_.alarm) stage_.show_alarm(input_.alarm());
    follow();
    since_chart_s_ += elapsed_s;
    if (since_chart_s_ >= chart_period_s) {
      since_chart_s_ = 0;
      stage_.show_chart(live_chart(history_.rows(), levels_));
      if (input_.timing) {
        const ServoTiming timing = input_.timing();
        stage_.show_readings(timing_readings(timing), tick_bars(timing.tick_times));
      }
    }
    return true;
  }

  void follow() {
    history_.gather(input_);
    if (history_.rows().empty()) return;
    const TickRecord& row = history_.rows().back();
    stage_.show(row, history_.speed_m_per_s());
    if (input_.is_stopped && input_.is_stopped()) {
      stage_.show_title_note("STOPPED: no force on the device   g gives it back   h help");
      return;
    }
    const std::string& note = stage_.has_alarm() ? no_note_ : input_.note;
    if (stage_.charts().zoomed()) {
      // What they are zoomed to is forgotten after a while; nothing is left to show then.
      if (stage_.charts().place().x_min < history_.rows().front().t_s)
        stage_.charts().show_all();
      else
        return stage_.show_title_note("charts held: r lets them run on   h help");
    }
    stage_.show_title_note(fmt::format("{}{}press {:.2f} N ({})   h help", note, note.empty() ? "" : "   ",
                                       target_.press_n(), target_.pressing() ? "pressing" : "hovering"));
  }

  const TouchWindowInput& input_;
  const std::string no_note_;
  RecentTicks history_;
  Stage stage_;
  TouchTarget target_;
  TouchLevels levels_;
  std::optional<MaterialPanel> material_;
  bool held_ = false, over_ = false, latched_ = false, invites_ = true;
  double since_chart_s_ = chart_period_s;
  WindowLoop loop_;
};

}  // namespace

void run_touch_window(const TouchWindowInput& input, const WindowOptions& options) {
  need_display();
  // Without a graphics card drawing takes every core there is. This thread and those that it starts to draw
  // with stand back for the servo's. A system that does not let them loses nothing else.
  constexpr int stand_back = 10;
  setpriority(PRIO_PROCESS, 0, stand_back);
  TouchWindow(input, options).run();
}

}  // namespace fingerpad
